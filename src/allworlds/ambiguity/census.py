"""The census: every map with a marked vertex, and which of them cannot be told apart."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, TypeAlias

from allworlds.ambiguity.marked import is_least_rooting
from allworlds.ambiguity.members import projection_of
from allworlds.maps.classes import Extent, MapClass
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.counting import source_for
from allworlds.maps.criterion import Disagreement, class_size, is_ambiguous
from allworlds.maps.quotient import Quotient
from allworlds.outcome import SCHEMA, Exit, until_interrupted
from allworlds.progress import Listener, Silent
from allworlds.work import Here, LevelUnit, gather, level_size, tell_of_size, units_of_level
from allworlds.world import Position, World

if TYPE_CHECKING:
    from allworlds import documents

BATCH = 200
"""Maps after which a part of a unit is handed over."""

Key: TypeAlias = tuple[tuple[int, ...], tuple[int, ...], tuple[int, ...]]
"""Sigma, alpha and degree of a quotient, rooted so at its marked vertex that they are least."""


@dataclass(frozen=True, slots=True)
class CensusRow:
    """The marked maps with one number of edges.

    Attributes:
        edges: m.
        rooted: rooted maps met.
        counted: rooted maps according to the independent source.
        marked_worlds: maps with one marked vertex, up to isomorphism.
        sizes: how many ambiguity classes have 2, 3, ... members inside the class of maps.
    """

    edges: int
    rooted: int = 0
    counted: int = 0
    marked_worlds: int = 0
    sizes: Counter[int] = field(default_factory=Counter)

    @property
    def ambiguous_worlds(self) -> int:
        """The members of all these classes."""
        return sum(size * times for size, times in self.sizes.items())

    @property
    def classes(self) -> int:
        """Their number."""
        return sum(self.sizes.values())

    @property
    def largest_class(self) -> int:
        """The members of the largest one; 0 if there is none."""
        return max(self.sizes, default=0)

    def to_json(self) -> documents.CensusRow:
        """One row of the document."""
        return {
            "edges": self.edges,
            "marked_worlds": self.marked_worlds,
            "ambiguous_worlds": self.ambiguous_worlds,
            "classes": self.classes,
            "largest_class": self.largest_class,
        }


@dataclass(frozen=True, slots=True)
class AmbiguityCensus:
    """Every level of a class of maps.

    Attributes:
        extent: class and bounds; twins are looked for inside the class only.
        source: the independent source with which the numbers of rooted maps were compared.
        rows: one a number of edges, ascending.
        complete: False if the user has interrupted, and rows are missing.
    """

    extent: Extent
    source: str
    rows: tuple[CensusRow, ...]
    complete: bool = True

    @property
    def agrees(self) -> bool:
        """As many rooted maps were met as the source counts."""
        return all(row.rooted == row.counted for row in self.rows)

    @property
    def exit_code(self) -> Exit:
        """0 counted, 4 nothing to count, 70 the source disagrees, 130 interrupted."""
        if not self.agrees:
            return Exit.DISAGREES
        if not self.complete:
            return Exit.INTERRUPTED
        return Exit.ANSWERED if any(row.marked_worlds for row in self.rows) else Exit.VACUOUS

    def to_json(self) -> documents.AmbiguityCensusReport:
        """The document of ``ambiguity census --json``."""
        return {
            "schema": SCHEMA,
            "class": self.extent.map_class.value,
            "edges": self.extent.edges,
            "vertices": self.extent.vertices,
            "lighthouse": Position.kind,
            "gate": {"source": self.source, "agrees": self.agrees},
            "complete": self.complete,
            "rows": [row.to_json() for row in self.rows],
        }


def census(
    *,
    edges: int | None = None,
    vertices: int | None = None,
    map_class: str = MapClass.MAPS.value,
    listener: Listener | None = None,
) -> AmbiguityCensus:
    """Every map of a class with every choice of a marked vertex, up to isomorphism.

    Args:
        edges: the largest number of edges.
        vertices: the largest number of vertices; alone only for the simple classes.
        map_class: one of :class:`~allworlds.maps.classes.MapClass`.
        listener: told how far it is.

    Raises:
        InputError: naming the offending option and what would be legal.

    Cost: some 100 microseconds a rooted map; memory for the ambiguous quotients of a level.
    """
    extent = Extent(MapClass.named(map_class), edges, vertices)
    heard = listener or Silent()
    tell_of_size(extent, heard)
    with Here() as here:
        rows, complete = until_interrupted(
            _level(here, extent, level, heard) for level in extent.levels
        )
    return AmbiguityCensus(extent, source_for(map_class).name, rows, complete)


@dataclass(slots=True)
class Met:
    """What a part of a level holds.

    Attributes:
        worlds: rooted maps.
        marked_worlds: maps with one marked vertex, up to isomorphism.
        ambiguous: the ambiguous ones by their quotient, with one of the quotients.
    """

    worlds: int = 0
    marked_worlds: int = 0
    ambiguous: dict[Key, tuple[Quotient, int]] = field(default_factory=dict)

    def add(self, other: Met) -> None:
        """Take in another part."""
        self.worlds += other.worlds
        self.marked_worlds += other.marked_worlds
        for key, (quotient, members) in other.ambiguous.items():
            self._count(key, quotient, members)

    def meet(self, map_: CombinatorialMap) -> None:
        """Take in one rooted map; of those that differ in the root at v0 alone only one counts."""
        self.worlds += 1
        if not is_least_rooting(map_):
            return
        self.marked_worlds += 1
        # A marked vertex of degree 1 has one dart, so k = 1: never ambiguous.
        if map_.sigma[0] != 0:
            quotient = projection_of(World(map_, Position(0), 0)).quotient
            if is_ambiguous(quotient):
                self._count(_key(quotient), quotient, 1)

    def _count(self, key: Key, quotient: Quotient, members: int) -> None:
        first, before = self.ambiguous.get(key, (quotient, 0))
        self.ambiguous[key] = (first, before + members)


@dataclass(frozen=True, slots=True)
class Classify:
    """The engine of the census."""

    extent: Extent

    def parts(self, unit: LevelUnit) -> Iterator[Met]:
        """The maps of the unit, classified, some at a time."""
        met = Met()
        for map_ in unit.maps(self.extent):
            met.meet(map_)
            if met.worlds == BATCH:
                yield met
                met = Met()
        yield met


def _level(here: Here, extent: Extent, edges: int, listener: Listener) -> CensusRow:
    size = level_size(extent, edges)
    listener.level(edges, size)
    met = Met()
    gather(here, Classify(extent), units_of_level(extent, edges), met, listener)
    if extent.map_class is MapClass.MAPS:
        _check_sizes(met)
    members = (members for _, members in met.ambiguous.values() if members > 1)
    return CensusRow(edges, met.worlds, size, met.marked_worlds, Counter(members))


def _key(quotient: Quotient) -> Key:
    rooted = [quotient.rerooted(q) for q in quotient.vertices[0]]
    return min((q.sigma, q.alpha, q.degree) for q in rooted)


def _check_sizes(met: Met) -> None:
    """Nothing, if as many worlds were met of each class as Burnside's count says."""
    for quotient, members in met.ambiguous.values():
        if members != class_size(quotient):
            raise Disagreement(
                f"{members} worlds were met of a class of {class_size(quotient)}, "
                f"with the quotient {quotient}"
            )
