"""The dearest worlds of a level: the compiled search over schedules as an engine."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from typing import Any

from allworlds.kernel import (
    Dearest,
    dearest_of_maps,
    dearest_of_unit,
    flag,
    is_compiled,
    search,
    take,
)
from allworlds.maps.classes import Extent, MapClass
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.work import LevelUnit
from allworlds.worst_case.one_world import Transit


@dataclass(slots=True)
class DearestWorlds:
    """What every schedule can cost, by the number of vertices; adds up in any order."""

    by_vertices: dict[int, Dearest] = field(default_factory=dict)

    @classmethod
    def of(cls, rows: Iterable[Dearest]) -> DearestWorlds:
        """The rows of a part."""
        return cls({row.vertices: row for row in rows})

    def __contains__(self, vertices: object) -> bool:
        return vertices in self.by_vertices

    @property
    def worlds(self) -> int:
        """Rooted maps."""
        return sum(row.rooted for row in self.by_vertices.values())

    def add(self, other: DearestWorlds) -> None:
        """Take in another part."""
        for vertices, row in other.by_vertices.items():
            mine = self.by_vertices.get(vertices)
            self.by_vertices[vertices] = _joined(mine, row) if mine else row


def _joined(a: Dearest, b: Dearest) -> Dearest:
    """Sums, maxima, and the least of the worlds that attain the worst cost."""
    dearest = min(
        (d for d in (a, b) if d.sigma), key=lambda d: (-d.worst, d.sigma, d.alpha), default=a
    )
    return replace(
        dearest,
        rooted=a.rooted + b.rooted,
        best=max(a.best, b.best),
        tests=a.tests + b.tests,
        wrong=a.wrong + b.wrong,
    )


@dataclass(frozen=True, slots=True)
class ScheduleSearch:
    """The engine; the maps of a class with a promise are made here, and searched one by one."""

    extent: Extent
    transit: Transit
    flag: Any = field(default_factory=flag)

    def halt(self) -> None:
        """Give up."""
        self.flag[0] = 1

    def is_compiled(self) -> bool:
        """An earlier use has left the compiled code behind."""
        return is_compiled(search if self._compiled else take)

    def parts(self, unit: LevelUnit) -> Iterator[DearestWorlds]:
        """The dearest worlds of the unit."""
        edges = unit.edges
        if self._compiled:
            rows = dearest_of_unit(edges, edges + 1, unit.prefix, self.transit, self.flag)
        else:
            maps = map(_degrees_and_partners, unit.maps(self.extent))
            rows = dearest_of_maps(edges, maps, self.transit)
        yield DearestWorlds.of(rows)

    @property
    def _compiled(self) -> bool:
        return self.extent.map_class is MapClass.MAPS


def _degrees_and_partners(map_: CombinatorialMap) -> tuple[list[int], list[int]]:
    """The map with its darts numbered vertex by vertex; dart 0 stays."""
    order: list[int] = []
    degrees = []
    seen: set[int] = set()
    for dart in map_.darts:
        if map_.vertex_of[dart] not in seen:
            seen.add(map_.vertex_of[dart])
            degrees.append(map_.degree_at[dart])
            order += [map_.turn(dart, i) for i in range(degrees[-1])]
    number = {dart: i for i, dart in enumerate(order)}
    return degrees, [number[map_.alpha[dart]] for dart in order]
