"""The fewest traversals that suffice, bracketed from both sides by compiled searches.

From below: whether t traversals are enough, for t = 0, 1, ...  From above: narrow searches, which
try few motions in each state, for strategies that need less and less.  They take turns, so that
both bounds are known whenever the time is up.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence

from allworlds.engines import MinimaxSearch, PlaceTable, tables_of
from allworlds.studies.optimum.knowledge import Known

WIDEST = 3
"""The largest number of motions that a narrow search tries in each state."""


class Bracket:
    """Bounds on the fewest traversals that suffice from each of some states of knowledge.

    Attributes:
        at_least: no strategy needs less in the worst case.
        at_most: the strategy found needs no more; None where none is found.

    Args:
        table: of the places.
        starts: the states.
        at_least: see above.
        enough: a number of traversals for which there is a strategy.
    """

    def __init__(
        self, table: PlaceTable, starts: Sequence[Known], at_least: int, enough: int
    ) -> None:
        self.at_least = at_least
        self.at_most: int | None = None
        self._starts = sorted(starts, key=len, reverse=True)
        self._tables = tables_of(table)
        self._enough = enough
        self._searches = [MinimaxSearch(self._tables)]
        self._best: MinimaxSearch | None = None

    @property
    def closed(self) -> bool:
        """Whether the bounds are equal."""
        return self.at_least == self.at_most

    @property
    def states(self) -> int:
        """The number of states that were looked into."""
        return sum(search.states for search in self._searches)

    def close(self, tick: Callable[[], None]) -> None:
        """Search until the bounds are equal; ``tick`` is called now and then, and may raise."""
        below, above = self._from_below(), self._from_above()
        while not self.closed:
            tick()
            next(below, None)
            # Where the bounds differ by one, the search from below decides by itself.
            if self.at_most is None or self.at_most - self.at_least > 1:
                next(above, None)

    def motion(self, known: Known, most: int) -> tuple[int, int] | None:
        """A number of traversals, at most ``most``, that is enough from a state, and a motion.

        None if there is none in the best strategy found.
        """
        assert self._best is not None
        return self._best.motion(known, most, lambda: None)

    def _from_below(self) -> Generator[None, None, None]:
        exact = self._searches[0]
        while not (yield from self._all_within(exact, self.at_least)):
            self.at_least += 1
        self._found(exact, self.at_least)

    def _from_above(self) -> Generator[None, None, None]:
        for width in range(1, WIDEST + 1):
            search = MinimaxSearch(self._tables, width)
            self._searches.append(search)
            refuted = -1
            while True:
                target = self._enough
                refuted = max(refuted, self.at_least - 1)
                if self.at_most is not None:
                    target = self.at_most - max(1, (self.at_most - refuted) // 4)
                if target <= refuted:
                    break
                if (yield from self._all_within(search, target)):
                    self._found(search, target)
                else:
                    refuted = target

    def _found(self, search: MinimaxSearch, most: int) -> None:
        if self.at_most is None or most < self.at_most:
            self.at_most, self._best = most, search

    def _all_within(self, search: MinimaxSearch, most: int) -> Generator[None, None, bool]:
        for known in self._starts:
            answer = search.ask(known, most)
            while answer is None:
                yield
                answer = search.go_on()
            if not answer:
                return False
        return True
