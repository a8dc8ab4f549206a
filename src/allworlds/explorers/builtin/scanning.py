"""Algorithm 1 for a robot that senses at v0 only a letter, which depends on the bearing.

A letter is the number of marks in a percept at v0.  The letter of a dart of v0 is the one that a
robot senses after its arrival by this dart.  The *word* of v0 consists of the letters at the
bearings 0, 1, 2, ..., in this order.  If exactly one dart of v0 has a letter other than 0, this
dart is called the *door*.

In the *scan* the robot learns the letters of v0: it leaves by each dart of v0 and comes back.  A
test that has come to v0 ends with *queries*: the robot goes out and back by darts whose letters
prove that it had entered v0 by the expected dart.  Such darts exist if the word is primitive, that
is, if it does not repeat a shorter word.  If there is a door, one query is enough.  After a query
the robot is at v0 again and has only turned, so a failed query needs no motions that undo it.

The paper does not have this algorithm.
"""

from collections.abc import Callable

from allworlds.explorers.builtin.algorithm1 import Algorithm1, Stage, nobody
from allworlds.protocol.actions import Estimate, Move, Percept
from allworlds.protocol.choices import Choices


def algorithm1_door(
    first: Percept, *, choices: Choices | None = None, notice: Callable[[str], None] = nobody
) -> Stage[Estimate]:
    """Explore from a door, a dart of v0 that a robot senses only when it arrives by this dart.

    The arguments, choices and events are those of
    :func:`~allworlds.explorers.builtin.algorithm1.algorithm1`.

    Cost: at most (1) + (2) traversals (the paper's Section VI), 2 more for each test, and
    2 (deg(v0) - 1) more for the search of the door.
    """
    explorer = Scanning(first, choices or Choices(), notice, one_letter=True)
    return (yield from explorer.explore())


def algorithm1_word(
    first: Percept, *, choices: Choices | None = None, notice: Callable[[str], None] = nobody
) -> Stage[Estimate]:
    """Explore from v0, where the robot senses a letter that depends on the dart of arrival.

    The estimate is right if the letters of v0 are a primitive word, and not all 0.  The arguments,
    choices and events are those of :func:`~allworlds.explorers.builtin.algorithm1.algorithm1`.

    Cost: at most (1) + (2) traversals (the paper's Section VI), and 2 (deg(v0) - 1) more for the
    scan and for each test.
    """
    return (yield from Scanning(first, choices or Choices(), notice).explore())


class Scanning(Algorithm1):
    """An exploration by Algorithm 1 in which v0 is recognised by its letters.

    Attributes:
        one_letter: whether only one dart has a letter other than 0; the scan ends at this dart.
        queries: for each dart of v0 the darts whose letters prove that the robot arrived by it;
            empty before the scan.
    """

    def __init__(
        self,
        first: Percept,
        choices: Choices,
        notice: Callable[[str], None] = nobody,
        *,
        one_letter: bool = False,
    ) -> None:
        super().__init__(first, choices, notice)
        self.one_letter = one_letter
        self.queries: list[list[int]] = []

    def explore(self) -> Stage[Estimate]:
        """Scan the letters, then explore by Algorithm 1."""
        yield from self.scan()
        return (yield from super().explore())

    def reads(self, percept: Percept) -> Percept:
        """The part of a percept that the algorithm compares: the degree and the letter."""
        return Percept(percept.degree, percept.marks)

    def scan(self) -> Stage[None]:
        """Read the letters of v0, clockwise from the dart faced at the start.

        If ``one_letter`` is true, the scan ends at the first letter other than 0.
        """
        first = self.s.expected[0]
        degree = first.degree
        letters = [first.marks] + [0] * (degree - 1)
        while self.here < degree - 1 and not (self.one_letter and any(letters)):
            yield Move(1)
            self.here += 1
            letters[self.here] = (yield Move(0)).marks
        self.s.expected = [Percept(degree, letter) for letter in letters]
        self.queries = [telling(letters, dart) for dart in range(degree)]

    def try_path(self, partner: int, path: list[int]) -> Stage[tuple[list[int], bool]]:
        """Lines 10-13, and then the queries at v0: out and back by certain darts of v0.

        These darts are those in ``queries`` for the dart by which the test should have arrived at
        v0.  After a query the robot stands at the dart by which it went out.  If a letter is not
        the expected one, the test has failed, and no further query is made.  The arguments and the
        result are those of :meth:`Algorithm1.try_path`; the motions of queries are not returned.
        """
        motions, matched = yield from super().try_path(partner, path)
        if matched:
            at = super().confirmed_at(partner, path)
            for dart in self.queries[at]:
                towards = self.s.offset(at, dart)
                yield Move(towards - self.turned)
                seen = yield Move(0)
                self.turned = towards
                if self.reads(seen) != self.s.expected[dart]:
                    return motions, False
        return motions, matched

    def confirmed_at(self, partner: int, path: list[int]) -> int:
        """The robot's dart in S after a test that has confirmed a hypothesis.

        This is the dart of v0 by which the robot has come back from the last query; without a query
        the dart of v0 at which the robot stands after the test.  The arguments are those of
        :meth:`Algorithm1.confirmed_at`.
        """
        return self.s.turn(super().confirmed_at(partner, path), self.turned)


def telling(letters: list[int], dart: int) -> list[int]:
    """A few darts of v0 whose letters prove that the robot came in by ``dart``.

    ``letters`` holds the letter of each dart of v0, clockwise.  The robot has sensed the letter of
    ``dart``, and expects the other letters of the list at the other darts.  If it came in by
    another dart of v0, it reads a cyclic shift of ``letters`` instead; at another vertex it reads
    only zeros.  The queries must exclude these wrong lists, but only those that have the right
    letter at the index ``dart``.  So each of them differs from ``letters`` at one of the returned
    darts at least.

    A wrong list that equals ``letters`` cannot be excluded: then ``letters`` repeats a shorter
    word, or is all 0.
    """
    shifts = [letters[k:] + letters[:k] for k in range(1, len(letters))]
    others = [word for word in ([0] * len(letters), *shifts) if word[dart] == letters[dart]]
    found: list[int] = []
    while others:
        left = [
            [word for word in others if word[each] == letter] for each, letter in enumerate(letters)
        ]
        best = min(range(len(letters)), key=lambda each: len(left[each]))
        if len(left[best]) == len(others):
            break
        found.append(best)
        others = left[best]
    return found
