"""A plan that may be wrong: a passage was walled up, or none; how many are there?

The robot is told the number of passages in the plan.  Who walks knows better than who reads.

Source: D. Dereniowski, A. Pelc, Drawing maps with advice, Journal of Parallel and Distributed
Computing 72, 132-143 (2012), for robots that are told of a map; a wrong one is ours.

    $ allworlds check wrong_plan.py:walks --lighthouse labels+wrong_plan.py:Plan --task count:m --edges 3
    HOLDS
    $ allworlds check wrong_plan.py:reads --lighthouse labels+wrong_plan.py:Plan --task count:m --edges 3
    REFUTED
"""

from dataclasses import dataclass

from allworlds import Lighthouse, Move


@dataclass(frozen=True)
class Plan(Lighthouse):
    """The plan: it has so many passages that are no more."""

    walled: int
    gives_marks = False
    gives_bearings = False

    @classmethod
    def places(cls, map_, start):
        """Every wrong plan, and the right one."""
        yield from (cls(0), cls(1))

    def told(self, map_):
        """Return the number of passages in the plan."""
        return map_.edge_count + self.walled


def reads(first, *, told):
    """Believe the plan."""
    return told
    yield


def walks(first, *, told):
    """Go through every door, depth first, and count them."""
    doors, known = first.degree, {first.marks}

    def visit(left):
        nonlocal doors
        for _ in range(left):
            room = yield Move(1)
            if room.marks in known:
                yield Move(0)
            else:
                doors += room.degree
                known.add(room.marks)
                yield from visit(room.degree - 1)
                yield Move(1)

    yield from visit(first.degree)
    return doors // 2
