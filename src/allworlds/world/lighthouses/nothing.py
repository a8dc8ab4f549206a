"""No lighthouse at all."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import ClassVar

from typing_extensions import override

from allworlds.maps import CombinatorialMap, Dart
from allworlds.world.lighthouses.base import Lighthouse
from allworlds.world.lighthouses.sensing import Sensing, Where


@dataclass(frozen=True, slots=True)
class Nothing(Lighthouse):
    """No marker and no direction: only the degree is sensed.

    Source: Section III of the paper ('lacking any position and orientation information').
    """

    kind: ClassVar[str] = "none"
    sensing: ClassVar[Sensing] = Sensing(Where.NOWHERE, bearing=False)
    default_bound: ClassVar[str] = "none"
    folds: ClassVar[bool] = False
    keys: ClassVar[tuple[str, ...]] = ()

    @classmethod
    def places(
        cls,
        map_: CombinatorialMap,  # noqa: ARG003  # nothing stands anywhere
        start: Dart,  # noqa: ARG003
    ) -> Iterator[Nothing]:
        """One place."""
        yield cls()

    def check(self, map_: CombinatorialMap, start: Dart) -> None:
        """Every map and every start will do."""

    @override
    def references(self, map_: CombinatorialMap) -> tuple[Dart, ...]:
        return ()

    @override
    def relabelled(self, names: Sequence[Dart]) -> Nothing:
        return self
