"""The engine that finds the most expensive worlds of a level, by a compiled search of schedules."""

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from msgspec import Struct, field

from allworlds.engines.kernel import engine, schedules
from allworlds.engines.units import GivenUnit, LevelUnit
from allworlds.maps.classes import Extent
from allworlds.maps.enumeration import history
from allworlds.studies.worst.every_schedule import Transit


class ScheduleCostsBySize(Struct):
    """Costs over every schedule, by the number of vertices; parts can be added in any order."""

    by_vertices: dict[int, schedules.ScheduleCosts] = field(default_factory=dict)

    @property
    def worlds(self) -> int:
        """The number of rooted maps."""
        return sum(row.rooted for row in self.by_vertices.values())

    def add(self, other: "ScheduleCostsBySize") -> None:
        """Add the costs of other worlds that have the same number of edges."""
        for vertices, row in other.by_vertices.items():
            mine = self.by_vertices.get(vertices)
            self.by_vertices[vertices] = _joined(mine, row) if mine else row


def _joined(a: schedules.ScheduleCosts, b: schedules.ScheduleCosts) -> schedules.ScheduleCosts:
    """The joint costs of two parts of the worlds: sums, maxima, and a most expensive world.

    Of two worlds with the worst cost, the one with the smaller code is taken.
    """
    most_expensive = min(
        (d for d in (a, b) if d.sigma), key=lambda d: (-d.worst, d.sigma, d.alpha), default=a
    )
    return most_expensive._replace(
        rooted=a.rooted + b.rooted,
        best=max(a.best, b.best),
        tests=a.tests + b.tests,
        wrong=a.wrong + b.wrong,
    )


class ScheduleSearch(Struct, frozen=True):
    """The engine that searches all schedules.

    The array ``flag`` is shared with the compiled search, and can stop this search.
    """

    extent: Extent
    transit: Transit
    flag: Any = field(default_factory=engine.flag)

    def halt(self) -> None:
        """Set the flag that ends the compiled search."""
        self.flag[0] = 1

    def parts(self, unit: LevelUnit | GivenUnit) -> Iterator[ScheduleCostsBySize]:
        """Yield costs in the unit's worlds: for each size the costs, and a most expensive world."""
        map_class = self.extent.map_class
        prefixes: Iterable[Sequence[int]]
        if isinstance(unit, GivenUnit):
            prefixes = map(history, unit.maps(self.extent))
        else:
            prefixes = [unit.prefix]
        for prefix in prefixes:
            costs = schedules.schedule_costs_of_unit(
                unit.edges,
                self.extent.vertex_limit(unit.edges),
                prefix,
                self.transit,
                self.flag,
                simple=map_class.simple,
                planar=map_class.planar,
            )
            yield ScheduleCostsBySize({each.vertices: each for each in costs})
