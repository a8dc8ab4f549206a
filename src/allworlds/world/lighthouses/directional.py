"""The directional lighthouse of the paper."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar

from typing_extensions import override

from allworlds.maps import CombinatorialMap, Dart
from allworlds.world.lighthouses.base import ReferenceLighthouse, StandsAt
from allworlds.world.lighthouses.place_checks import check_at_start
from allworlds.world.lighthouses.sensing import Sensing, Where


@dataclass(frozen=True, slots=True)
class Directional(ReferenceLighthouse):
    """One marker at the start vertex v0 that points to one of its darts.

    Sensed at v0: one mark, and the bearing of ``dart``; elsewhere only the degree.
    Source: Section IV of the paper.
    """

    dart: StandsAt

    kind: ClassVar[str] = "directional"
    sensing: ClassVar[Sensing] = Sensing(Where.AT_V0, bearing=True)
    default_bound: ClassVar[str] = "paper"
    folds: ClassVar[bool] = True

    @classmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Directional]:
        """One place for each bearing ``0..deg(v0)-1``."""
        for bearing in range(map_.degree_at[start]):
            yield cls(map_.turn(start, bearing))

    def check(self, map_: CombinatorialMap, start: Dart) -> None:
        """Raise InvalidWorld unless the pointed dart is one of the start's vertex."""
        check_at_start("points to", self.dart, map_, start)

    @override
    def references(self, map_: CombinatorialMap) -> tuple[Dart, ...]:
        return (self.dart,)
