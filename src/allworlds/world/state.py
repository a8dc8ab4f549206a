"""Where the robot is, and what it has left where."""

from __future__ import annotations

from dataclasses import dataclass, replace

from allworlds.inputs.checks import are_plain
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
    hand: int = 0
    written: tuple[tuple[int, int], ...] = ()

    @property
    def is_plain(self) -> bool:
        """Whether it holds what it says: one made by code of the user's may hold anything."""
        pairs = self.written if type(self.written) is tuple else (None,)
        if type(self.lying) is not tuple or any(type(pair) is not tuple for pair in pairs):
            return False
        numbers = [number for pair in pairs for number in pair]  # type: ignore[union-attr]
        plain = are_plain([self.dart, *self.lying, self.hand, *numbers])
        return plain and self.hand >= 0 and all(len(pair) == 2 for pair in pairs)  # type: ignore[arg-type]

    def number_at(self, where: int) -> int:
        """The number that stands there."""
        return dict(self.written).get(where, 0)

    def with_number(self, where: int, number: int) -> State:
        """The state after that number was written there."""
        written = {**dict(self.written), where: number}
        kept = tuple(sorted((at, each) for at, each in written.items() if each))
        return replace(self, written=kept)


_WITHOUT_MARKERS = tuple(State(dart) for dart in range(256))


def without_markers(dart: Dart) -> State:
    """The state of a robot that has no markers; equal small ones are one object."""
    return _WITHOUT_MARKERS[dart] if dart < len(_WITHOUT_MARKERS) else State(dart)
