"""Enumerating a class and counting what is there, beside what independent sources say."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from math import factorial
from typing import TYPE_CHECKING

from allworlds.engines import level_size, tell_of_size
from allworlds.maps import Extent, MapClass, automorphisms, prefixes, rooted_maps, source_for
from allworlds.outcome import SCHEMA, Exit, until_interrupted
from allworlds.progress import Listener, Silent

if TYPE_CHECKING:
    from allworlds import documents

SILENT = Silent()

TOLD_EVERY = 1000
"""Maps after which the listener is told."""

UNROOTED_LIMIT = 6
"""The largest number of edges for which unrooted maps are counted."""


@dataclass(slots=True)
class CountRow:
    """The maps with one number of edges.

    Attributes:
        edges: m.
        rooted: rooted maps.
        unrooted: maps up to orientation-preserving isomorphism; None past UNROOTED_LIMIT.
        by_vertices, by_genus: rooted maps.
        labelled: for simple classes the rotation systems on labelled vertices, by vertices.
        counted: rooted maps by vertices according to the independent source.
    """

    edges: int
    rooted: int = 0
    unrooted: int | None = None
    by_vertices: Counter[int] = field(default_factory=Counter)
    by_genus: Counter[int] = field(default_factory=Counter)
    labelled: dict[int, int] | None = None
    counted: dict[int, int] = field(default_factory=dict)

    @property
    def agrees(self) -> bool:
        """The enumeration and its source give the same count for every number of vertices."""
        return dict(self.by_vertices) == {n: count for n, count in self.counted.items() if count}

    def to_json(self) -> documents.CountRowDocument:
        """One row of the document."""
        row: documents.CountRowDocument = {
            "edges": self.edges,
            "rooted": self.rooted,
            "unrooted": self.unrooted,
            "by_vertices": {str(n): count for n, count in sorted(self.by_vertices.items())},
            "by_genus": {str(g): count for g, count in sorted(self.by_genus.items())},
        }
        if self.labelled is not None:
            row["labelled"] = {str(n): count for n, count in sorted(self.labelled.items())}
        return row


@dataclass(frozen=True, slots=True)
class Census:
    """Every level of a class, counted.

    Attributes:
        extent: class and bounds.
        source: the independent source that every row has been compared with.
        rows: one a number of edges, ascending.
        complete: False if the user has interrupted, and rows are missing.
    """

    extent: Extent
    source: str
    rows: tuple[CountRow, ...]
    complete: bool = True

    @property
    def exit_code(self) -> Exit:
        """0 counted, 4 nothing to count, 70 the source disagrees, 130 interrupted."""
        if not all(row.agrees for row in self.rows):
            return Exit.DISAGREES
        if not self.complete:
            return Exit.INTERRUPTED
        return Exit.ANSWERED if any(row.rooted for row in self.rows) else Exit.VACUOUS

    def to_json(self) -> documents.CountDocument:
        """The document of ``count --json``."""
        return {
            "schema": SCHEMA,
            "class": self.extent.map_class.value,
            "edges": self.extent.edges,
            "vertices": self.extent.vertices,
            "gate": {"source": self.source, "agrees": all(row.agrees for row in self.rows)},
            "complete": self.complete,
            "rows": [row.to_json() for row in self.rows],
        }


def count(
    *,
    edges: int | None = None,
    vertices: int | None = None,
    map_class: str = "maps",
    listener: Listener | None = None,
) -> Census:
    """Enumerate every rooted map of a class and count.

    Args:
        edges: the largest number of edges.
        vertices: the largest number of vertices; alone only for the simple classes.
        map_class: one of :class:`~allworlds.maps.classes.MapClass`.
        listener: is told of the progress, and if that will take long.

    Raises:
        InputError: naming the offending option and what would be legal.

    Cost: some microseconds a rooted map, in the class ``maps`` from 7 edges on less than
    100 ns; constant memory.
    """
    extent = Extent(MapClass.named(map_class), edges, vertices)
    heard = listener or Silent()
    tell_of_size(extent, heard)
    rows, complete = until_interrupted(
        _count_level(extent, level, heard) for level in extent.levels
    )
    return Census(extent, source_for(map_class).name, rows, complete)


def _count_level(extent: Extent, edges: int, listener: Listener) -> CountRow:
    listener.level(edges, level_size(extent, edges))
    if extent.map_class is MapClass.MAPS and edges > UNROOTED_LIMIT:
        row = count_compiled(extent, edges, listener)
    else:
        row = count_one_by_one(extent, edges, listener)
    limit = extent.vertex_limit(edges)
    cells = source_for(extent.map_class).cells(edges)
    row.counted = {n: cells.get(n, 0) for n in range(1, limit + 1)}
    return row


def count_compiled(extent: Extent, edges: int, listener: Listener = SILENT) -> CountRow:
    """A level of the class ``maps``, counted by the compiled enumeration.

    Cost: less than 100 ns a rooted map, after some seconds of compiling at the first use.
    """
    from allworlds.engines import by_vertices_and_faces

    row = CountRow(edges)
    limit = extent.vertex_limit(edges)
    for prefix in prefixes(edges, vertices=limit):
        before = row.rooted
        for (vertices, faces), maps in by_vertices_and_faces(edges, limit, prefix).items():
            row.rooted += maps
            row.by_vertices[vertices] += maps
            row.by_genus[(2 - vertices + edges - faces) // 2] += maps
        listener.progress(row.rooted - before)
    return row


def count_one_by_one(extent: Extent, edges: int, listener: Listener = SILENT) -> CountRow:
    """A level of any class, each map made, and each looked at."""
    row = CountRow(edges)
    darts_fixed = 0
    for map_ in rooted_maps(edges, extent.map_class, extent.vertices):
        row.rooted += 1
        row.by_vertices[map_.vertex_count] += 1
        row.by_genus[map_.genus] += 1
        if edges <= UNROOTED_LIMIT:
            darts_fixed += automorphisms(map_)
        if row.rooted % TOLD_EVERY == 0:
            listener.progress(TOLD_EVERY)
    listener.progress(row.rooted % TOLD_EVERY)
    if edges <= UNROOTED_LIMIT:
        # A map has 2m / |Aut| rootings, so its rootings weigh |Aut| / 2m each.
        row.unrooted = darts_fixed // (2 * edges)
    if extent.map_class.simple:
        row.labelled = {
            n: rooted * factorial(n) // (2 * edges) for n, rooted in row.by_vertices.items()
        }
    return row
