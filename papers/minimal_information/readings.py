"""Section IV: the two readings of 'the same signature', played side by side."""

from __future__ import annotations

from collections.abc import Generator
from typing import Any

from typing_extensions import override

from allworlds import Choices, Percept, World, worlds
from allworlds.claims import Found, Means, truth
from passes import POLICIES, Played, Watched, played


class WithoutDirection(Watched):
    """Algorithm 1 whose signatures are degree and marks, as the text of Sections IV and V says.

    What was sensed at v_u is then the first percept of a test, and is compared without a step.
    """

    sensed: Percept

    @override
    def hypotheses(self, goal: int, percept: Percept) -> list[int]:
        self.sensed = percept
        super().hypotheses(goal, percept)  # it notes where the pass is
        expected, wanted = self.s.expected, (percept.degree, percept.marks)
        seen = [d for d in self.s.unexplored if d != goal]
        return [d for d in seen if (expected[d].degree, expected[d].marks) == wanted]

    @override
    def try_path(
        self, partner: int, path: list[int]
    ) -> Generator[Any, Any, tuple[list[int], bool]]:
        if not self.agrees(partner):
            return [], False
        return (yield from super().try_path(partner, path))

    def agrees(self, partner: int) -> bool:
        """Whether the direction is the one that is expected there."""
        return self.s.expected[partner] == self.sensed


def signature_readings(_: Means, *, edges: int, policies: list[str]) -> Found:
    """Compare both readings in every run: steps, maps after each pass, answer; and count tests."""
    runs = same = with_it = without_it = 0
    for world in worlds(edges=edges, places="all"):
        for policy in policies:
            one, tests = _explored(Watched, world, policy)
            other, more = _explored(WithoutDirection, world, policy)
            runs += 1
            same += one == other
            with_it += tests
            without_it += more
    seen = {"runs": runs, "tests with it": with_it, "tests without it": without_it}
    return Found(truth(same == runs), seen)


def _explored(kind: type[Watched], world: World, policy: str) -> tuple[Played, int]:
    """A run, and how many tests it makes."""
    explorer = kind(world.first, Choices(POLICIES[policy]()))
    run = played(explorer.explore(), world, explorer)
    return run, sum(len(one.tests) for one in explorer.begun)
