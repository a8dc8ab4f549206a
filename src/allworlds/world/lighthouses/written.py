"""Room for numbers that the robot writes: on vertices, or on darts."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from typing import Annotated, ClassVar

from typing_extensions import override

from allworlds.document import Meta, about
from allworlds.maps import CombinatorialMap, Dart
from allworlds.protocol import Action, Write
from allworlds.world.lighthouses.base import PlacelessLighthouse
from allworlds.world.state import State

LEAST, MOST = 2, 2**31
"""The numbers of numbers that there can be room for."""


class NumberRoom(PlacelessLighthouse):
    """A lighthouse under which ``Write(k)`` is legal, with k from 0 to states - 1.

    Attributes:
        states: how many numbers there are.
    """

    states: int

    leaves_marks: ClassVar[bool] = True

    @abstractmethod
    def place_of_number(self, map_: CombinatorialMap, dart: Dart) -> int:
        """Where a robot writes and reads that has arrived by this dart."""

    @override
    def refusal(self, action: Action, lying: int, hand: int) -> str:
        if type(action) is not Write:
            return "a Move or Write"
        return (
            "" if 0 <= action.k < self.states else f"a Write(k) with k from 0 to {self.states - 1}"
        )

    @override
    def acted(self, map_: CombinatorialMap, state: State, action: Action) -> State:
        assert type(action) is Write
        return state.with_number(self.place_of_number(map_, state.dart), action.k)

    @override
    def left_marks(self, map_: CombinatorialMap, state: State) -> int:
        return state.number_at(self.place_of_number(map_, state.dart))


HowMany = Annotated[int, Meta(ge=LEAST, le=MOST), about("how many numbers there are")]


@dataclass(frozen=True, slots=True)
class Whiteboard(NumberRoom):
    """At every vertex room for one number, which the robot writes there and reads there.

    Sensed at a vertex: the number that was last written there (0 at first) as marks, and the
    degree.  The option is ``states=K``: the numbers are 0 to K-1 (2).
    """

    states: HowMany = LEAST

    kind: ClassVar[str] = "whiteboard"

    @override
    def place_of_number(self, map_: CombinatorialMap, dart: Dart) -> int:
        return map_.vertex_of[dart]


@dataclass(frozen=True, slots=True)
class Ports(NumberRoom):
    """At every dart room for one number, which the robot writes and reads when it comes by it.

    Sensed: the number that was last written on the dart by which the robot has arrived (0 at
    first) as marks, and the degree.  The option is ``states=K``: the numbers are 0 to K-1 (2).
    """

    states: HowMany = LEAST

    kind: ClassVar[str] = "ports"

    @override
    def place_of_number(self, map_: CombinatorialMap, dart: Dart) -> int:
        return dart
