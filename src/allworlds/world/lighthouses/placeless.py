"""Lighthouses of which nothing stands anywhere: what is told, and marks that the robot leaves."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Annotated, ClassVar, Literal, TypeAlias

from msgspec import Meta
from typing_extensions import override

from allworlds.document import Different, IfAny, Positive, about, narrowed
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol.actions import Action, Drop, Pick, Write
from allworlds.world.lighthouses.base import PlacelessLighthouse, State


@dataclass(frozen=True, slots=True)
class Nothing(PlacelessLighthouse):
    """No marker and no direction: only the degree is sensed.

    Source: Section III of the paper ('lacking any position and orientation information').
    """

    kind: ClassVar[str] = "none"


ToldName: TypeAlias = Literal["n", "m", "d", "g"]

TOLD: dict[ToldName, Callable[[CombinatorialMap], int]] = {
    "n": lambda map_: map_.vertex_count,
    "m": lambda map_: map_.edge_count,
    "d": lambda map_: map_.diameter,
    "g": lambda map_: map_.genus,
}
"""The numbers that can be told, by their names: of vertices, of edges, the diameter, the genus."""


@dataclass(frozen=True)
class Knowledge(PlacelessLighthouse):
    """A lighthouse without marks: the robot is told some numbers of the world.

    Sensed: the degree alone.  ``told`` holds the numbers by their names: n (vertices), m (edges),
    d (diameter), g (genus); n and m where none is named.
    """

    names: Annotated[
        Different[ToldName], narrowed(minItems=1), about("of the numbers: n, m, d, g")
    ] = ("n", "m")

    kind: ClassVar[str] = "told"

    def told(self, map_: CombinatorialMap) -> dict[str, int]:
        """The numbers by their names."""
        return {name: TOLD[name](map_) for name in self.names}


@dataclass(frozen=True, slots=True)
class Movable(PlacelessLighthouse):
    """No marker stands anywhere at the start; the robot has some in its hand.

    Sensed at a vertex: how many markers lie there, and the degree.  They point nowhere, and
    one is like the other.  The options are ``markers=K``, how many there are (1),
    ``pick=false``: what has been dropped stays, and ``distinct=true``: the markers are told
    apart. Marker i then counts as 2^i marks, and of several the first is dropped and taken up.
    Source: Section II of the paper (Dudek, Jenkin, Milios, Wilkes 1991: one, with ``pick``).
    """

    markers: Annotated[Positive, about("how many are in the hand at the start")] = 1
    pick: Annotated[bool, about("whether one that was dropped may be taken up again")] = True
    distinct: Annotated[IfAny[bool], about("whether they are told apart; else false")] = False

    kind: ClassVar[str] = "movable"
    leaves_marks: ClassVar[bool] = True

    @property
    def in_hand(self) -> int:
        """The number of all markers."""
        return self.markers

    @override
    def refusal(self, action: Action, lying: int, hand: int) -> str:
        if type(action) is Drop:
            return "" if hand else "a Drop only with a marker in hand"
        if type(action) is not Pick:
            return "a Move, Drop or Pick"
        if not self.pick:
            return "no Pick: under pick=false a marker stays where it was dropped"
        return "" if lying else "a Pick only where a marker lies"

    @override
    def acted(self, map_: CombinatorialMap, state: State, action: Action) -> State:
        here, lying = map_.vertex_of[state.dart], [*state.lying]
        after = state
        if type(action) is Drop:
            lying.append(here)
            if self.distinct:
                dropped = sum(bits for _, bits in state.written)
                first = ~dropped & (dropped + 1)
                after = state.with_number(here, state.number_at(here) | first)
        else:
            lying.remove(here)
            if self.distinct:
                bits = state.number_at(here)
                after = state.with_number(here, bits & (bits - 1))
        hand = state.hand + len(state.lying) - len(lying)
        return replace(after, lying=tuple(sorted(lying)), hand=hand)

    @override
    def left_marks(self, map_: CombinatorialMap, state: State) -> int:
        here = map_.vertex_of[state.dart]
        return state.number_at(here) if self.distinct else state.lying.count(here)


LEAST, MOST = 2, 2**31
"""The numbers of numbers that there can be room for."""


HowMany = Annotated[int, Meta(ge=LEAST, le=MOST), about("how many numbers there are")]


@dataclass(frozen=True, slots=True)
class Whiteboard(PlacelessLighthouse):
    """At every vertex room for one number, which the robot writes there and reads there.

    Sensed at a vertex: the number that was last written there (0 at first) as marks, and the
    degree.  The option is ``states=K``: the numbers are 0 to K-1 (2).
    """

    states: HowMany = LEAST

    kind: ClassVar[str] = "whiteboard"
    leaves_marks: ClassVar[bool] = True

    def place_of_number(self, map_: CombinatorialMap, dart: Dart) -> int:
        """Where a robot writes and reads that has arrived by this dart: at its vertex."""
        return map_.vertex_of[dart]

    @override
    def refusal(self, action: Action, lying: int, hand: int) -> str:
        if type(action) is not Write:
            return "a Move or Write"
        legal = 0 <= action.k < self.states
        return "" if legal else f"a Write(k) with k from 0 to {self.states - 1}"

    @override
    def acted(self, map_: CombinatorialMap, state: State, action: Action) -> State:
        assert type(action) is Write
        return state.with_number(self.place_of_number(map_, state.dart), action.k)

    @override
    def left_marks(self, map_: CombinatorialMap, state: State) -> int:
        return state.number_at(self.place_of_number(map_, state.dart))


@dataclass(frozen=True, slots=True)
class Ports(Whiteboard):
    """At every dart room for one number, which the robot writes and reads when it comes by it.

    Sensed: the number that was last written on the dart by which the robot has arrived (0 at
    first) as marks, and the degree.  The option is ``states=K``: the numbers are 0 to K-1 (2).
    """

    kind: ClassVar[str] = "ports"

    @override
    def place_of_number(self, map_: CombinatorialMap, dart: Dart) -> int:
        return dart
