"""An explorer for a robot that starts elsewhere: it looks for v0, and there another one begins.

All words of motions are tried, shorter ones first, of one length in the order of their letters;
each is taken back as far as the next one differs from it.  The way back is known by the edge by
which the robot has come: where every dart of a vertex was tried in turn, the next one is that edge.

Cost of the search: less than 8 D^d traversals, for a distance d to v0 and a largest degree D > 1.
For to try all words of up to L motions costs at most T(L) = D (2 + T(L - 1)) < 4 D^L.
"""

from collections.abc import Callable, Generator
from itertools import count
from typing import Any

from allworlds.explorers.builtin.algorithm1 import Walk
from allworlds.protocol.actions import Move, Percept
from allworlds.protocol.importing import signature_of


class FromElsewhere:
    """An explorer that begins at v0, wherever the robot starts.

    Attributes:
        explorer: the generator function that begins there.
    """

    def __init__(self, explorer: Callable[..., Generator[Any, Any, Any]]) -> None:
        self.explorer = explorer
        self.__signature__ = signature_of(explorer)

    def __call__(self, first: Percept, **keywords: Any) -> Walk[Any]:
        """Find v0, where one mark is sensed, and explore from there."""
        seen = first if first.marks == 1 else (yield from self.search(first))
        return (yield from self.explorer(seen, **keywords))

    def search(self, first: Percept) -> Walk[Percept]:
        """Find the percept at v0, by words of up to 1, 2, 3 ... motions; the robot is there."""
        due = 0
        for longest in count(1):
            found, due = yield from self.tried(first.degree, longest, due)
            if found:
                return found
        raise AssertionError("lengths have no end")

    def tried(self, degree: int, longest: int, due: int) -> Walk[tuple[Percept | None, int]]:
        """Try every word of up to ``longest`` motions at a vertex of that degree.

        Args:
            degree: of the vertex.
            longest: the number of motions.
            due: the turn after which the robot stands as if it had just come in.

        Returns:
            the percept at v0, where the robot is then, if a word leads there; else None, and the
            turn that is due.
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
