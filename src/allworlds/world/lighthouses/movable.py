"""Markers in the robot's hand, which the robot can lay down and perhaps take up again."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache
from typing import Annotated, Any, ClassVar

from typing_extensions import override

from allworlds.document import IfAny, Positive, about
from allworlds.inputs import integer, show
from allworlds.maps import CombinatorialMap, Dart
from allworlds.protocol import Action, Drop, Pick
from allworlds.world.lighthouses.base import InvalidWorld, PlacelessLighthouse
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
    keys: ClassVar[tuple[str, ...]] = ("markers", "pick", "distinct")
    leaves_marks: ClassVar[bool] = True
    usually: ClassVar[tuple[int, bool, bool]] = (1, True, False)

    @classmethod
    def with_options(cls, options: Mapping[str, str]) -> type[Movable]:
        """The kind with ``markers=K``, and ``pick`` and ``distinct`` each true or false."""
        hand = dict(zip(cls.keys, cls.usually, strict=True))
        for key, value in options.items():
            if key == "markers":
                hand[key] = _markers("option markers", _number(value))
            elif key not in hand:
                raise InvalidWorld(
                    f"the movable lighthouse has no option {show(key)}; "
                    f"legal are {', '.join(cls.keys)}"
                )
            elif value not in ("true", "false"):
                raise InvalidWorld(
                    f"option {key} = {show(value)} of the movable lighthouse is neither true "
                    "nor false"
                )
            else:
                hand[key] = value == "true"
        return _kind_with(*hand.values())

    @classmethod
    def with_its_options(cls) -> Movable:
        """The lighthouse with the options of the kind."""
        return Movable(*cls.usually)

    def check(self, map_: CombinatorialMap, start: Dart) -> None:  # noqa: ARG002  # any map
        """Raise InvalidWorld unless there is a marker; every map and every start will do."""
        _markers("lighthouse.markers", self.markers)
        for key in ("pick", "distinct"):
            if type(getattr(self, key)) is not bool:
                raise InvalidWorld(
                    f"lighthouse.{key} = {show(getattr(self, key))} is neither true nor false"
                )

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

    @override
    def to_json(self) -> dict[str, Any]:
        told = super(Movable, self).to_json()
        if not self.distinct:
            del told["distinct"]
        return told

    @classmethod
    @override
    def at(cls, **where: Any) -> Movable:
        return Movable(**{**dict(zip(cls.keys, cls.usually, strict=True)), **where})


@cache
def _kind_with(markers: int, pick: bool, distinct: bool) -> type[Movable]:
    """The kind whose usual lighthouse is this one."""
    hand = (markers, pick, distinct)
    if hand == Movable.usually:
        return Movable
    return type(Movable.__name__, (Movable,), {"usually": hand})


def _number(text: str) -> object:
    return int(text) if text.isascii() and text.isdecimal() and len(text) < 10 else text


def _markers(what: str, value: object) -> int:
    """The number of markers; raise InvalidWorld unless it is a positive integer."""
    try:
        markers = integer(value)
    except TypeError:
        raise InvalidWorld(f"{what} = {show(value)} is not an integer") from None
    if markers < 1:
        raise InvalidWorld(f"{what} = {show(markers)} is not positive; at least 1 is legal")
    return markers
