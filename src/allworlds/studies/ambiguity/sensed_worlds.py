"""The census of any lighthouse: all worlds, parted by what a robot could ever sense in them."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Self

from allworlds.document import Natural
from allworlds.engines import LevelUnit
from allworlds.inputs import InputError
from allworlds.maps import Extent, Labelled, Quotient, numbering, project, rooted_code
from allworlds.protocol import Percept
from allworlds.studies.ambiguity.telling_apart import ComparedWorlds, twins
from allworlds.world import InvalidWorld, LighthouseKind, World

BATCH = 200
"""Maps after which a part of a unit is handed over."""


@dataclass(slots=True)
class SensedParts:
    """Counts and quotients of a part of a level.

    Attributes:
        worlds: rooted maps.
        parts: for each quotient the maps, with what is sensed in them, that have it: the document
            of a world of each, up to isomorphism.
    """

    worlds: Natural
    parts: dict[str, dict[str, dict[str, Any]]]

    @classmethod
    def none(cls) -> Self:
        """Of no map."""
        return cls(0, {})

    def add(self, other: SensedParts) -> None:
        """Add the counts of another part."""
        self.worlds += other.worlds
        for quotient, worlds in other.parts.items():
            mine = self.parts.setdefault(quotient, {})
            for key, world in worlds.items():
                mine.setdefault(key, world)

    def meet(self, world: World) -> None:
        """Take in one world: a start of the map, with the lighthouse at a place."""
        quotient = project(Labelled(world.map, world.percepts, world.start)).quotient
        roots = (quotient.rerooted(q) for q in range(len(quotient.sigma)))
        told = world.told if not isinstance(world.told, Mapping) else sorted(world.told.items())
        key = json.dumps([min(map(_quotient_code, roots)), told])
        self.parts.setdefault(key, {}).setdefault(_world_code(world), world.to_json())

    @property
    def marked_worlds(self) -> int:
        """How many maps there are with a lighthouse in them, up to isomorphism."""
        return sum(self.sizes)

    @property
    def sizes(self) -> list[int]:
        """How many members each part has."""
        return [len(worlds) for worlds in self.parts.values()]

    def smallest_pair(self) -> ComparedWorlds | None:
        """Two worlds of one part, with the proof that no motion tells them apart."""
        pairs = [sorted(worlds.items())[:2] for worlds in self.parts.values() if len(worlds) > 1]
        if not pairs:
            return None
        (_, one), (_, other) = min(pairs)
        return _apart(World.from_json(one), World.from_json(other))


@dataclass(frozen=True, slots=True)
class PartBySensing:
    """The engine of the census of any lighthouse."""

    extent: Extent
    kind: LighthouseKind

    def parts(self, unit: LevelUnit) -> Iterator[SensedParts]:
        """The maps of the unit, some at a time."""
        met = SensedParts.none()
        for map_ in unit.maps(self.extent):
            met.worlds += 1
            for place in self.kind.as_class.places(map_, 0):
                met.meet(World(map_, place, 0))
            if met.worlds == BATCH:
                yield met
                met = SensedParts.none()
        yield met


def ensure_stands(kind: LighthouseKind) -> None:
    """Raise InputError for a lighthouse of which the robot makes the marks itself."""
    if kind.as_class.leaves_marks:
        raise InputError(
            f"under the lighthouse {kind} the robot leaves marks itself, and a census is of what "
            "motions alone can tell apart; legal are lighthouses that stand where they are"
        )


def _label(percept: Percept) -> list[int]:
    return [percept.marks, -1 if percept.bearing is None else percept.bearing]


def _quotient_code(quotient: Quotient) -> list[Any]:
    labels = [_label(label) for label in quotient.labels if isinstance(label, Percept)]
    return [list(quotient.sigma), list(quotient.alpha), list(quotient.degree), labels]


def _world_code(world: World) -> str:
    """The map and what is sensed in it, whatever the start: a canonical text."""
    map_ = world.map
    return min(
        json.dumps(
            [
                rooted_code(map_.sigma, map_.alpha, dart),
                [_label(world.percepts[d]) for d in numbering(map_.sigma, map_.alpha, dart)],
            ]
        )
        for dart in map_.darts
    )


def _apart(one: World, other: World) -> ComparedWorlds:
    """The two compared, the second from the first start from which it looks the same."""
    for start in other.map.darts:
        try:
            found = twins(one, World(other.map, other.lighthouse, start))
        except InvalidWorld:  # the lighthouse cannot stand there when one starts here
            continue
        if found.bisimulation:
            return found
    raise AssertionError(f"{one} and {other} have one quotient, and are told apart")
