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
    """An explorer for a robot that starts anywhere: it goes to v0, and starts another one there.

    Attributes:
        explorer: the generator function of the other explorer, which begins at v0.
    """

    def __init__(self, explorer: Callable[..., Generator[Any, Any, Any]]) -> None:
        self.explorer = explorer
        self.__signature__ = signature_of(explorer)

    def __call__(self, first: Percept, **keywords: Any) -> Stage[Any]:
        """Find v0, the vertex where one mark is sensed, and start the other explorer there."""
        seen = first if first.marks == 1 else (yield from self.search(first))
        return (yield from self.explorer(seen, **keywords))

    def search(self, first: Percept) -> Stage[Percept]:
        """Walk to v0 by trying words of up to 1, 2, 3 ... motions; return the percept at v0."""
        due = 0
        for longest in count(1):
            found, due = yield from self.tried(first.degree, longest, due)
            if found:
                return found
        raise AssertionError("lengths have no end")

    def tried(self, degree: int, longest: int, due: int) -> Stage[tuple[Percept | None, int]]:
        """Try every word of up to ``longest`` motions from the robot's vertex.

        Args:
            degree: the degree of the vertex.
            longest: the largest number of motions.
            due: the ``k`` of the robot's next motion ``Move(k)``.

        Returns:
            The percept at v0, if a word leads there; the robot is then at v0.  Otherwise None, and
            the ``k`` of the next motion: with it the robot leaves by the dart of its first arrival.
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
