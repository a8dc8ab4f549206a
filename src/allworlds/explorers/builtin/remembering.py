"""Algorithm 1 that never forgets, under its own order: oldest dart, oldest hypothesis."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import overload

from allworlds.explorers.builtin.algorithm1 import nobody, unseen
from allworlds.explorers.builtin.paths import Lazy
from allworlds.explorers.builtin.unforgetting import (
    Hypotheses,
    Settled,
    Spread,
    Test,
    Unforgetting,
    Walk,
)
from allworlds.protocol import Choices, Estimate, Percept


def remembering(
    first: Percept,
    *,
    choices: Choices | None = None,
    notice: Callable[[str], None] = nobody,
    settled: Settled = unseen,
) -> Walk[Estimate]:
    """Explore from a directional lighthouse; return an estimate equal to the world, pose included.

    Args:
        first: the percept at v0 before any motion; it has a bearing.
        choices: ``edge``: the dart that leaves U; cost: the shortest walk to its vertex through all
            known edges.  ``hypothesis``: the unrefuted one that is tested; cost:
            the length of its home word.  Options stand in the order in which they came into S.
            Default: first in, first out.
        notice: told of ``empty-H`` (no dart of U has the degree), ``case-1`` (a test that ends
            short of v0, or does not find it at its end), ``case-2`` (a test that comes to v0),
            ``loop`` and ``non-loop`` (how a pass ends).
        settled: told of S when it grows.

    Cost: at most (1) + (2) of Section VI traversals, for all choices.
    """
    return (yield from _Remembering(first, choices or Choices(), notice, settled).explore())


class _Remembering(Unforgetting):
    def __init__(
        self,
        first: Percept,
        choices: Choices,
        notice: Callable[[str], None],
        settled: Settled = unseen,
    ) -> None:
        super().__init__(first, notice, settled)
        self.choices = choices

    def next_dart(self, unexplored: list[int]) -> int:
        options = sorted(unexplored, key=self.place_in_s)

        def cost() -> list[int]:
            spread = Spread(self.log, self.log.node[self.here])
            return [len(spread.way_to(self.log.node[dart])) for dart in options]

        return self.choices.pick(options, of="edge", cost=Lazy(cost))

    def trial(self, entry: int, suspects: list[int]) -> Hypotheses:
        return _InOrder(self, entry, sorted(suspects, key=self.place_in_s))


class _InOrder(Hypotheses, Sequence[Test]):
    """The unrefuted hypotheses, in the order of S; each is checked when it is asked for."""

    def __init__(self, exploration: _Remembering, entry: int, suspects: list[int]) -> None:
        self._at, self._entry = exploration, entry
        self._alive: list[Test] = []
        self._left = suspects[::-1]

    def next_test(self) -> Test | None:
        if not self._reaches(1):
            return None
        cost = Lazy(lambda: [self._at.distance[self._at.log.node[test.dart]] for test in self])
        return self._at.choices.pick(self, of="hypothesis", cost=cost)

    def learned(self, done: Test) -> None:
        # What was alive may be refuted by now, and its word known further.
        self._left += [test.dart for test in reversed(self._alive) if test is not done]
        self._alive = []

    def __len__(self) -> int:
        self._reaches(len(self._alive) + len(self._left))
        return len(self._alive)

    @overload
    def __getitem__(self, index: int) -> Test: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[Test]: ...
    def __getitem__(self, index: int | slice) -> Test | Sequence[Test]:
        if not isinstance(index, int) or index < 0:
            return [*self][index]
        self._reaches(index + 1)
        return self._alive[index]

    def _reaches(self, count: int) -> bool:
        """Whether there are at least ``count`` unrefuted hypotheses."""
        at = self._at
        entry = at.log.canonical(self._entry)
        while self._left and len(self._alive) < count:
            dart = self._left.pop()
            if at.is_explored(dart):
                continue
            test = at.test_of(dart, at.nearer(entry, dart))
            if test and not at.log.contradicts(entry, dart):
                self._alive.append(test)
        return len(self._alive) >= count


__all__ = ["remembering"]
