"""The purposes of the traversals of a walk."""

from __future__ import annotations

from msgspec import Struct

from allworlds.judging.explanations.named_walk import Walked
from allworlds.maps import Dart
from allworlds.protocol import Move


class Spending(Struct, frozen=True):
    """The traversals of a walk, and the edges that they found.

    Attributes:
        found: for each edge that was walked the traversal that first went along it, ascending.
        back: the traversals that take back the last one not yet taken back.
        cost: the number of all traversals.
        bound: the largest legal number.
    """

    found: tuple[int, ...]
    back: int
    cost: int
    bound: int


def spending(walked: Walked, bound: int) -> Spending:
    """The purposes of the traversals of a walk.  Cost: linear in the steps."""
    back, cost, found = 0, 0, []
    path: list[Dart] = []
    discoveries = set(walked.discoveries)
    for step, (action, before, arrived) in enumerate(
        zip(walked.transcript.actions, walked.walked, walked.walked[1:], strict=False), 1
    ):
        if type(action) is not Move:
            continue
        cost += 1
        if path and walked.map.turn(before, action.k) == path[-1]:
            path.pop()
            back += 1
        else:
            path.append(arrived)
        if step in discoveries:
            found.append(cost)
    return Spending(tuple(found), back, cost, bound)
