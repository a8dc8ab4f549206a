"""The census: every map with a marked vertex, and which of them cannot be told apart."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from typing import Any, Protocol, TypeAlias

from allworlds.ambiguity.criterion import Disagreement, class_size, is_ambiguous
from allworlds.ambiguity.marked import is_least_rooting
from allworlds.ambiguity.members import projection_of
from allworlds.errors import InputError
from allworlds.maps.classes import Bounds, MapClass
from allworlds.maps.counting import source_for
from allworlds.maps.enumeration import rooted_maps
from allworlds.maps.quotient import Quotient
from allworlds.world import Position, World

Key: TypeAlias = tuple[tuple[int, ...], tuple[int, ...], tuple[int, ...]]
"""Sigma, alpha and degree of a quotient, rooted so at its marked vertex that they are least."""


class Listener(Protocol):
    """Told how far the census is."""

    def level(self, edges: int, worlds: int) -> None:
        """A level begins, with so many rooted maps."""

    def progress(self, worlds: int) -> None:
        """So many more rooted maps are done."""


class Silent:
    """Tells nobody."""

    def level(self, edges: int, worlds: int) -> None:
        """Nothing."""

    def progress(self, worlds: int) -> None:
        """Nothing."""


@dataclass(slots=True)
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

    def to_json(self) -> dict[str, int]:
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
        bounds: class and bounds; twins are looked for inside the class only.
        source: the independent source with which the numbers of rooted maps were compared.
        rows: one a number of edges, ascending.
    """

    bounds: Bounds
    source: str
    rows: tuple[CensusRow, ...]

    @property
    def agrees(self) -> bool:
        """As many rooted maps were met as the source counts."""
        return all(row.rooted == row.counted for row in self.rows)

    @property
    def exit_code(self) -> int:
        """0 counted, 4 nothing to count, 70 the source disagrees."""
        if not self.agrees:
            return 70
        return 0 if any(row.marked_worlds for row in self.rows) else 4

    def to_json(self) -> dict[str, Any]:
        """The document of ``ambiguity census --json``."""
        return {
            "schema": 1,
            "class": self.bounds.map_class.value,
            "edges": self.bounds.edges,
            "vertices": self.bounds.vertices,
            "lighthouse": Position.kind,
            "gate": {"source": self.source, "agrees": self.agrees},
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
        map_class: ``maps``, ``simple``, ``planar`` or ``planar-simple``.
        listener: told how far it is.

    Raises:
        InputError: naming the offending option and what would be legal.

    Cost: some 100 microseconds a rooted map; memory for the ambiguous quotients of a level.
    """
    if map_class not in list(MapClass):
        raise InputError(f"class {map_class!r} is none of {', '.join(MapClass)}")
    bounds = Bounds(MapClass(map_class), edges, vertices)
    heard = listener or Silent()
    rows = tuple(_level(bounds, level, heard) for level in bounds.levels)
    return AmbiguityCensus(bounds, source_for(map_class).name, rows)


def _level(bounds: Bounds, edges: int, listener: Listener) -> CensusRow:
    cells = source_for(bounds.map_class).cells(edges)
    limit = bounds.vertex_limit(edges)
    row = CensusRow(edges, counted=sum(count for n, count in cells.items() if n <= limit))
    listener.level(edges, row.counted)
    met: dict[Key, list[Quotient]] = {}
    for map_ in rooted_maps(edges, bounds.map_class, bounds.vertices):
        row.rooted += 1
        listener.progress(1)
        if not is_least_rooting(map_):
            continue
        row.marked_worlds += 1
        # A marked vertex of degree 1 has one dart, so k = 1: never ambiguous.
        if map_.sigma[0] != 0:
            quotient = projection_of(World(map_, Position(0), 0)).quotient
            if is_ambiguous(quotient):
                met.setdefault(_key(quotient), []).append(quotient)
    if bounds.map_class is MapClass.MAPS:
        _check_sizes(met)
    row.sizes.update(len(members) for members in met.values() if len(members) > 1)
    return row


def _key(quotient: Quotient) -> Key:
    rooted = [quotient.rerooted(q) for q in quotient.vertices[0]]
    return min((q.sigma, q.alpha, q.degree) for q in rooted)


def _check_sizes(met: dict[Key, list[Quotient]]) -> None:
    """Nothing, if as many worlds were met of each class as Burnside's count says."""
    for members in met.values():
        if len(members) != class_size(members[0]):
            raise Disagreement(
                f"{len(members)} worlds were met of a class of {class_size(members[0])}, "
                f"with the quotient {members[0]}"
            )
