"""Markers in the robot's hand: it lays them down, and may take them up again."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Annotated, Any, ClassVar

from typing_extensions import override

from allworlds.document import Positive, about
from allworlds.inputs import integer, show
from allworlds.maps import CombinatorialMap, Dart
from allworlds.protocol import Action, Drop, Pick
from allworlds.world.lighthouses.base import InvalidWorld, Lighthouse
from allworlds.world.lighthouses.sensing import Sensing, Where


@dataclass(frozen=True, slots=True)
class Movable(Lighthouse):
    """No marker stands anywhere at the start; the robot has some in its hand.

    Sensed at a vertex: how many markers lie there, and the degree.  They point nowhere, and
    one is like the other.  The options are ``markers=K``, how many there are (1), and
    ``pick=false``: what has been dropped stays.
    Source: Section II of the paper (Dudek, Jenkin, Milios, Wilkes 1991: one, with ``pick``).
    """

    markers: Annotated[Positive, about("how many are in the hand at the start")] = 1
    pick: Annotated[bool, about("whether one that was dropped may be taken up again")] = True

    kind: ClassVar[str] = "movable"
    sensing: ClassVar[Sensing] = Sensing(Where.NOWHERE, bearing=False)
    default_bound: ClassVar[str] = "none"
    folds: ClassVar[bool] = False
    keys: ClassVar[tuple[str, ...]] = ("markers", "pick")
    hand: ClassVar[tuple[int, bool]] = (1, True)

    @classmethod
    def with_options(cls, options: Mapping[str, str]) -> type[Movable]:
        """The kind with ``markers=K`` and ``pick=true`` or ``pick=false``."""
        markers, pick = cls.hand
        for key, value in options.items():
            if key == "markers":
                markers = _markers("option markers", _number(value))
            elif key == "pick":
                if value not in ("true", "false"):
                    raise InvalidWorld(
                        f"option pick = {show(value)} of the movable lighthouse is neither true "
                        "nor false"
                    )
                pick = value == "true"
            else:
                raise InvalidWorld(
                    f"the movable lighthouse has no option {show(key)}; legal are markers, pick"
                )
        return _kind_with(markers, pick)

    @classmethod
    def places(
        cls,
        map_: CombinatorialMap,  # noqa: ARG003  # nothing stands anywhere
        start: Dart,  # noqa: ARG003
    ) -> Iterator[Movable]:
        """One place."""
        yield Movable(*cls.hand)

    def check(self, map_: CombinatorialMap, start: Dart) -> None:  # noqa: ARG002  # any map
        """At least one marker; every map and every start will do."""
        _markers("lighthouse.markers", self.markers)
        if type(self.pick) is not bool:
            raise InvalidWorld(f"lighthouse.pick = {show(self.pick)} is neither true nor false")

    def references(self, map_: CombinatorialMap) -> tuple[Dart, ...]:  # noqa: ARG002  # any map
        """None: before the robot drops one, no marker lies anywhere."""
        return ()

    @property
    def in_hand(self) -> int:
        """All of them."""
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
    def relabelled(self, names: Sequence[Dart]) -> Movable:
        return self

    @classmethod
    def from_json(
        cls,
        document: Mapping[str, Any],
        map_: CombinatorialMap,  # noqa: ARG003  # nothing stands anywhere
        start: Dart,  # noqa: ARG003
    ) -> Movable:
        """With what it does not say as usual."""
        markers, pick = cls.hand
        return Movable(document.get("markers", markers), document.get("pick", pick))


@cache
def _kind_with(markers: int, pick: bool) -> type[Movable]:
    """The kind whose usual lighthouse is this one."""
    if (markers, pick) == Movable.hand:
        return Movable
    return type(Movable.__name__, (Movable,), {"hand": (markers, pick)})


def _number(text: str) -> object:
    return int(text) if text.isascii() and text.isdecimal() and len(text) < 10 else text


def _markers(what: str, value: object) -> int:
    """The number of markers; else raises InvalidWorld."""
    try:
        markers = integer(value)
    except TypeError:
        raise InvalidWorld(f"{what} = {show(value)} is not an integer") from None
    if markers < 1:
        raise InvalidWorld(f"{what} = {show(markers)} is not positive; at least 1 is legal")
    return markers
