"""An explorer for a robot that starts anywhere: it looks for v0, and starts another explorer there.

A word is a sequence of motions.  The explorer tries all words, shorter ones first, and words of one
length in lexicographic order.  Before the next word the robot goes back only to the point from
which the two words differ.  It knows the way back without a map: after it has tried all other darts
of a vertex in turn, the next dart is the one by which it arrived.

Cost of the search: less than 8 D^d traversals, for the distance d to v0 and the largest degree
D > 1, because all words of up to L motions cost at most T(L) = D (2 + T(L - 1)) < 4 D^L.
"""

from collections.abc import Callable, Generator
from itertools import count
from typing import Any

from allworlds.explorers.builtin.algorithm1 import Stage
from allworlds.protocol.actions import Move, Percept
from allworlds.protocol.importing import signature_of


class FromElsewhere:
    """An explorer that begins at v0, although the robot may start at any vertex.

    Attributes:
        explorer: the generator function that begins at v0.
    """

    def __init__(self, explorer: Callable[..., Generator[Any, Any, Any]]) -> None:
        self.explorer = explorer
        self.__signature__ = signature_of(explorer)

    def __call__(self, first: Percept, **keywords: Any) -> Stage[Any]:
        """Find v0, where one mark is sensed, and explore from there."""
        seen = first if first.marks == 1 else (yield from self.search(first))
        return (yield from self.explorer(seen, **keywords))

    def search(self, first: Percept) -> Stage[Percept]:
        """Find the percept at v0, by words of up to 1, 2, 3 ... motions; the robot is there."""
        due = 0
        for longest in count(1):
            found, due = yield from self.tried(first.degree, longest, due)
            if found:
                return found
        raise AssertionError("lengths have no end")

    def tried(self, degree: int, longest: int, due: int) -> Stage[tuple[Percept | None, int]]:
        """Try every word of up to ``longest`` motions at a vertex of that degree.

        Args:
            degree: the degree of the vertex.
            longest: the largest number of motions.
            due: the turn before the next motion, as if the robot had just arrived.

        Returns:
            the percept at v0, where the robot then is, if a word leads there; else None, and the
            turn that is then due.
        """
        for _ in range(degree if longest else 0):
            seen = yield Move(due)
            if seen.marks == 1:
                return seen, 0
            found, back = yield from self.tried(seen.degree, longest - 1, 0)
            if found:
                return found, 0
            yield Move(back)
            due = 1
        return None, due
