"""An explorer for a robot that starts anywhere: it looks for v0, and starts another explorer there.

A word is a sequence of motions.  The explorer tries all words of up to 1 motion, then all words of
up to 2 motions, and so on, until a word leads to v0.  In each of these rounds the words are tried
in lexicographic order.  Before the next word the robot goes back only to the vertex at which the
two words begin to differ.  It knows the way back without a map: at each vertex it tries the darts
clockwise, and begins with the dart by which it arrived.  So after the last dart it leaves by the
next dart clockwise, and this is again the dart by which it arrived.

Cost of the search: less than 8 D^d traversals, for the distance d to v0 and the largest degree D,
at least 2.  Proof: all words of up to L motions cost at most T(L) = D (2 + T(L - 1)), with T(0) =
0: for each dart the way out, all shorter words behind the dart, and the way back.  So T(L) = 2D +
2D^2 + ... + 2D^L < 4 D^L, and the sum T(1) + ... + T(d) is less than 8 D^d.
"""

from collections.abc import Callable, Generator
from itertools import count
from typing import Any

from allworlds.explorers.builtin.algorithm1 import Stage
from allworlds.protocol.actions import Move, Percept
from allworlds.protocol.importing import signature_of


class FromElsewhere:
    """An explorer for a robot that starts anywhere: it goes to v0, where another explorer starts.

    Attributes:
        explorer: the generator function of the other explorer, which begins at v0.
    """

    def __init__(self, explorer: Callable[..., Generator[Any, Any, Any]]) -> None:
        self.explorer = explorer
        self.__signature__ = signature_of(explorer)

    def __call__(self, first: Percept, **keywords: Any) -> Stage[Any]:
        """Find v0, the vertex where one mark is sensed, and start the other explorer there.

        ``first`` is the percept at the start, and ``keywords`` are passed to the other explorer.
        """
        seen = first if first.marks == 1 else (yield from self.search(first))
        return (yield from self.explorer(seen, **keywords))

    def search(self, first: Percept) -> Stage[Percept]:
        """Walk to v0 by trying words of up to 1, 2, 3 ... motions; return the percept at v0.

        ``first`` is the percept at the start.
        """
        due = 0
        for longest in count(1):
            found, due = yield from self.tried(first.degree, longest, due)
            if found:
                return found
        raise AssertionError("lengths have no end")

    def tried(self, degree: int, longest: int, due: int) -> Stage[tuple[Percept | None, int]]:
        """Try every word of up to ``longest`` motions from the robot's vertex.

        The first dart to try is the dart by which the robot came to this vertex, or, at the start
        of the run, the dart that it faced.

        Args:
            degree: the degree of the vertex.
            longest: the largest number of motions; 0: try nothing.
            due: the ``k`` by which ``Move(k)`` leaves by the first dart to try.

        Returns:
            If a word leads to v0: the percept at v0, where the robot then is, and a 0 without a
                meaning.  Otherwise None, and the new ``k`` for the first dart to try: the robot is
                back at its vertex, but stands at the dart that it tried last.  The first dart to
                try is the next one clockwise, so ``k`` is 1; it is unchanged if nothing was tried.
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
