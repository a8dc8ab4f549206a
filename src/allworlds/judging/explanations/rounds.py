"""An endless walk: the step where it begins to go round, or to find no new edge."""

from __future__ import annotations

from collections.abc import Hashable, Sequence

from msgspec import Struct

from allworlds.judging.explanations.named_walk import Walked
from allworlds.protocol import Move
from allworlds.words import plural

LONGEST = 200
"""The number of steps of the longest round that is looked for."""

TIMES = 3
"""The least number of times that a round is gone."""

WAY_BACK = (
    "motions a, b, c are undone by 0, -c, -b, and then the robot stands at the dart by which it "
    "left, a darts clockwise of the one where it stood before"
)
"""The rule of ways back: a wrong one is a likely cause of a walk without an end."""


class Round(Struct, frozen=True):
    """The steps that a walk repeats until its end.

    Attributes:
        first: the first step of the first round.
        length: steps of a round.
        times: the number of times, the last one perhaps in part.
    """

    first: int
    length: int
    times: int


def round_at_the_end(steps: Sequence[Hashable]) -> Round | None:
    """The shortest round with which the steps end; steps are numbered from 1.  Cost: O(n LONGEST).

    None if it is gone less than :data:`TIMES` times, or is not the greater part of the steps: a
    wandering robot goes round by chance, for a while.
    """
    for length in range(1, min(LONGEST, len(steps) // TIMES) + 1):
        first = len(steps) - length
        while first > 0 and steps[first - 1] == steps[first - 1 + length]:
            first -= 1
        if len(steps) - first >= max(TIMES * length, len(steps) / 2):
            return Round(first + 1, length, -(-(len(steps) - first) // length))
    return None


def tell_rounds(story: Walked) -> list[str]:
    """Tell that the robot went round, or since when no edge was new; skip short walks."""
    actions = story.transcript.actions
    found = round_at_the_end([*zip(actions, story.walked[1:], strict=True)])
    if found:
        steps = plural(found.length, "step")
        told = f"From step {found.first} on it repeated {steps} {found.times} times"
        return [f"{told}, until the end.", *_tell_ways_back(story, found.first + found.length - 1)]
    found_at = story.discoveries
    if not found_at:
        return []
    left = story.map.edge_count - len(found_at)
    step = f"After step {found_at[-1]}"
    if left:
        told = f"{step} it met no new edge; {plural(left, 'edge')} it never met."
        return [told, *_tell_ways_back(story, len(actions))]
    why = (
        "Either it takes a vertex or an edge that it knows for a new one, or the robot is not "
        "where the explorer believes."
    )
    return [
        f"{step} it had walked every edge of the world, and yet it went on.",
        why,
        f"Look at its ways back: {WAY_BACK}.",
    ]


def _tell_ways_back(story: Walked, end: int) -> list[str]:
    """Tell how a way back is walked, where one may begin before that step."""
    actions, turns = story.transcript.actions[:end], story.sensed
    back = (i for i, action in enumerate(actions) if i and action == Move(0))
    may_begin = any(turns[i].degree > 1 for i in back)
    if not may_begin or all(action == Move(0) for action in actions):
        return []
    return [f"Look at its ways back: {WAY_BACK}."]
