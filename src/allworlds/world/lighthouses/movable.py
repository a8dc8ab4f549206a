"""Markers in the robot's hand, which the robot can lay down and perhaps take up again."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated, ClassVar

from typing_extensions import override

from allworlds.document import IfAny, Positive, about
from allworlds.maps import CombinatorialMap
from allworlds.protocol import Action, Drop, Pick
from allworlds.world.lighthouses.base import PlacelessLighthouse
from allworlds.world.state import State


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
