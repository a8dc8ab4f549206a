"""The state of a walk in a world: the robot's dart, the dropped markers, the written numbers."""

from __future__ import annotations

from dataclasses import dataclass, replace

from allworlds.documents.document import Natural
from allworlds.maps.combinatorial import Dart


@dataclass(frozen=True, slots=True)
class State:
    """The part of a world that the robot's actions change.

    Attributes:
        dart: the robot's dart of arrival; at the start the dart that it faces.
        lying: the vertices of the markers that the robot has dropped, ascending; a vertex occurs
            once for each of its markers.
        hand: the number of markers in the robot's hand.
        written: pairs of a vertex and the number written there, ascending, or, under some
            lighthouses, pairs of a dart and such a number.  Pairs with the number 0 are left out.
    """

    dart: Dart
    lying: tuple[int, ...] = ()
    hand: Natural = 0
    written: tuple[tuple[int, int], ...] = ()

    def number_at(self, where: int) -> int:
        """The number that is written at the vertex or dart ``where``; 0 if there is no number."""
        return dict(self.written).get(where, 0)

    def with_number(self, where: int, number: int) -> State:
        """The state after ``number`` has been written at the vertex or dart ``where``."""
        written = {**dict(self.written), where: number}
        kept = tuple(sorted((at, each) for at, each in written.items() if each))
        return replace(self, written=kept)
