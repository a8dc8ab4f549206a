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
    """The costs of all schedules in some worlds with one number of edges, by number of vertices.

    The costs in other worlds of the level can be added by :meth:`add`, in any order.
    """

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
    """The costs in the worlds of ``a`` and the worlds of ``b`` together; all have the same size.

    The numbers of worlds and of tests are added.  ``worst`` is the larger of the two values
    ``worst``.  ``best`` is the larger of the two values ``best``, too, because it is a maximum over
    worlds: the largest cost of a world's cheapest schedule.  The map in ``sigma`` and ``alpha`` is
    one with the cost ``worst``; of two such maps, the one with the smaller code.
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
    """The engine that searches all schedules of Algorithm 1 in the worlds of a unit.

    Attributes:
        extent: the class of the maps, with its bounds.
        transit: the paths by which Algorithm 1 may go to the next edge: ``shortest`` or ``simple``.
        flag: an array of one number, which the compiled search reads; the search ends once the
            number is not 0.
    """

    extent: Extent
    transit: Transit
    flag: Any = field(default_factory=engine.flag)

    def halt(self) -> None:
        """Set the flag that ends the compiled search."""
        self.flag[0] = 1

    def parts(self, unit: LevelUnit | GivenUnit) -> Iterator[ScheduleCostsBySize]:
        """Yield the costs in the worlds of a unit.

        For a unit of a class yield one item, with the costs in all worlds of the unit.  For a unit
        of given maps yield an item for each map.
        """
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
