"""An endless walk: the step where it begins to go round, or to find no new edge."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass

from allworlds.judging.explanations.named_walk import Walked
from allworlds.words import plural

LONGEST = 200
"""The number of steps of the longest round that is looked for."""

TIMES = 3
"""The least number of times that a round is gone."""


@dataclass(frozen=True, slots=True)
class Round:
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
        return [f"From step {found.first} on it went round: {steps}, {found.times} times over."]
    found_at = story.discoveries
    if not found_at:
        return []
    left = story.map.edge_count - len(found_at)
    step = f"After step {found_at[-1]}"
    if left:
        return [f"{step} it met no new edge; {plural(left, 'edge')} it never met."]
    went_on = "mostly such an explorer takes a vertex or an edge that it knows for a new one"
    return [f"{step} it had walked every edge of the world, and yet it went on: {went_on}."]
