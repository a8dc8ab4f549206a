"""Units of runs: maps with the places of their lighthouse that are tried."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Protocol, TypeAlias

from msgspec import Struct

from allworlds.engines.units import LevelUnit
from allworlds.maps import CombinatorialMap, Extent
from allworlds.world import Lighthouse, World

Placed: TypeAlias = tuple[CombinatorialMap, list[tuple[int, Lighthouse]]]
"""A map rooted at dart 0, and the numbered places of its lighthouse that are tried."""


class UnitOfRuns(Protocol):
    """A unit that one worker does at a time."""

    @property
    def key(self) -> str:
        """Its name among the units of a check."""

    def placed(self, extent: Extent, kind: type[Lighthouse]) -> Iterator[Placed]:
        """Every map with its places, in a fixed order."""


class LevelRuns(LevelUnit, frozen=True):
    """All maps of a level whose history begins with ``prefix``, with every place."""

    def placed(self, extent: Extent, kind: type[Lighthouse]) -> Iterator[Placed]:
        """The maps in the order of the enumeration."""
        for map_ in self.maps(extent):
            yield map_, list(enumerate(kind.places(map_, 0)))


class GivenWorlds(Struct, frozen=True):
    """Chosen worlds, each with its own place; their start is dart 0."""

    worlds: tuple[tuple[World, int], ...]
    key: str = ""

    def placed(self, extent: Extent, kind: type[Lighthouse]) -> Iterator[Placed]:  # noqa: ARG002  # they are all there
        """The worlds as they are."""
        for world, place in self.worlds:
            yield world.map, [(place, world.lighthouse)]


class NumberedRun(Struct, frozen=True):
    """A run of a unit: its number there, and where it takes place.

    Attributes:
        number: from 0 on; a world without a place counts as one.
        map: rooted at dart 0.
        place: the number of the lighthouse's place.
        lighthouse: None if the world has no place for it.
        first: whether it is the first of its world.
    """

    number: int
    map: CombinatorialMap
    place: int
    lighthouse: Lighthouse | None
    first: bool


def numbered_runs(
    worlds: UnitOfRuns, extent: Extent, kind: type[Lighthouse]
) -> Iterator[NumberedRun]:
    """Every run of a unit, in its order, by which parent and worker speak of it."""
    number = 0
    for map_, places in worlds.placed(extent, kind):
        for i, (place, lighthouse) in enumerate(places or [(0, None)]):
            yield NumberedRun(number, map_, place, lighthouse, i == 0)
            number += 1
