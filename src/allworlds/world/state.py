"""Where the robot is, and where its markers are."""

from __future__ import annotations

from dataclasses import dataclass

from allworlds.maps import Dart


@dataclass(frozen=True, slots=True)
class State:
    """All of a world that the robot's actions change.

    Attributes:
        dart: by which the robot has arrived; at the start the one it faces.
        lying: the vertices at which markers lie that the robot has dropped, ascending; one that
            has several stands there several times.
        hand: the number of markers in the robot's hand.
    """

    dart: Dart
    lying: tuple[int, ...] = ()
    hand: int = 0


_WITHOUT_MARKERS = tuple(State(dart) for dart in range(256))


def without_markers(dart: Dart) -> State:
    """The state of a robot that has no markers; equal small ones are one object."""
    return _WITHOUT_MARKERS[dart] if dart < len(_WITHOUT_MARKERS) else State(dart)
