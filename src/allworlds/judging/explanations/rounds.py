"""A walk that comes to no end: where it begins to go round, or since when it finds nothing new."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass

from allworlds.judging.explanations.named_walk import Walked
from allworlds.words import plural

LONGEST = 200
"""Steps of the longest round that is looked for."""

TIMES = 3
"""So often a round must have been gone, to be called one."""


@dataclass(frozen=True, slots=True)
class Round:
    """The steps that a walk repeats until its end.

    Attributes:
        first: the first step of the first round.
        length: steps of a round.
        times: how often it was gone, the last time perhaps in part.
    """

    first: int
    length: int
    times: int


def round_at_the_end(steps: Sequence[Hashable]) -> Round | None:
    """The shortest round with which the steps end; steps are numbered from 1.  Cost: O(n LONGEST).

    None, if it is gone less than :data:`TIMES` times, or is not the greater part of the steps:
    whoever wanders goes round by chance, for a while.
    """
    for length in range(1, min(LONGEST, len(steps) // TIMES) + 1):
        first = len(steps) - length
        while first > 0 and steps[first - 1] == steps[first - 1 + length]:
            first -= 1
        if len(steps) - first >= max(TIMES * length, len(steps) / 2):
            return Round(first + 1, length, -(-(len(steps) - first) // length))
    return None


def tell_rounds(story: Walked) -> list[str]:
    """That the robot went round, or since when no edge was new; nothing of a short walk."""
    actions = story.transcript.actions
    found = round_at_the_end([*zip(actions, story.walked[1:], strict=True)])
    if found:
        steps = plural(found.length, "step")
        return [f"From step {found.first} on it went round: {steps}, {found.times} times over."]
    found_at = story.discoveries
    if not found_at:
        return []
    left = story.map.edge_count - len(found_at)
    rest = f"{plural(left, 'edge')} it never walked" if left else "it had walked every edge"
    return [f"After step {found_at[-1]} nothing was new to it; {rest}."]
