"""The part of a world that a step changes."""

from __future__ import annotations

from dataclasses import dataclass, replace

from allworlds.documents.document import Natural
from allworlds.maps.combinatorial import Dart


@dataclass(frozen=True, slots=True)
class State:
    """The part of a world that the robot's actions change.

    Attributes:
        dart: by which the robot has arrived; at the start the one it faces.
        lying: the vertices at which markers lie that the robot has dropped, ascending; one that
            has several stands there several times.
        hand: the number of markers in the robot's hand.
        written: where a number other than 0 stands, with the number, ascending.
    """

    dart: Dart
    lying: tuple[int, ...] = ()
    hand: Natural = 0
    written: tuple[tuple[int, int], ...] = ()

    def number_at(self, where: int) -> int:
        """The number that stands there."""
        return dict(self.written).get(where, 0)

    def with_number(self, where: int, number: int) -> State:
        """The state after that number was written there."""
        written = {**dict(self.written), where: number}
        kept = tuple(sorted((at, each) for at, each in written.items() if each))
        return replace(self, written=kept)
