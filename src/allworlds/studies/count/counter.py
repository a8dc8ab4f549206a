"""Enumerating a class and counting what is there, beside what independent sources say."""

from __future__ import annotations

from collections import Counter
from math import factorial
from typing import Annotated

from allworlds.document import (
    UNSET,
    AllRows,
    Aside,
    Bounded,
    Document,
    Gate,
    Natural,
    Positive,
    Report,
    UnsetType,
    about,
    computed,
    key,
)
from allworlds.engines import Listener, Silent, level_size, tell_of_size
from allworlds.inputs import answers
from allworlds.maps import (
    Extent,
    MapClass,
    automorphisms,
    prefixes,
    rooted_maps,
    source_for,
)
from allworlds.outcome import Exit, until_interrupted
from allworlds.studies.count.count_request import CountRequest

SILENT = Silent()

TOLD_EVERY = 1000
"""Maps after which the listener is told."""

UNROOTED_LIMIT = 6
"""The largest number of edges for which unrooted maps are counted."""


class CountRow(Document):
    """The maps with one number of edges.

    ``counted`` holds the rooted maps by vertices according to the independent source.
    """

    edges: Positive
    rooted: Annotated[Natural, about("rooted maps")]
    unrooted: Annotated[
        Natural | None,
        about("maps up to orientation-preserving isomorphism; null beyond 6 edges"),
    ]
    by_vertices: Annotated[dict[int, Natural], about("rooted maps by vertices")]
    by_genus: Annotated[dict[int, Natural], about("rooted maps by genus")]
    labelled: Annotated[
        dict[int, Natural] | UnsetType,
        about("in simple classes: rotation systems on labelled vertices, by vertices"),
    ] = UNSET
    counted: Aside[dict[int, int]]

    @property
    def agrees(self) -> bool:
        """The enumeration and its source give the same count for every number of vertices."""
        return self.by_vertices == {n: count for n, count in self.counted.items() if count}


class Census(Report):
    """Report of 'count'.

    Every level of a class, counted.
    """

    map_class: Annotated[MapClass, about("the class of maps")] = key(name="class")
    edges: Bounded
    vertices: Bounded
    gate: Annotated[Gate, about("the comparison of every row with an independent source")] = (
        computed(lambda c: Gate(source=c.source, agrees=all(row.agrees for row in c.rows)))
    )
    complete: AllRows
    rows: Annotated[tuple[CountRow, ...], about("one a number of edges, ascending")]
    source: Aside[str]

    @property
    def exit_code(self) -> Exit:
        """0 counted, 4 nothing to count, 70 the source disagrees, 130 interrupted."""
        if not self.gate.agrees:
            return Exit.DISAGREES
        if not self.complete:
            return Exit.INTERRUPTED
        return Exit.ANSWERED if any(row.rooted for row in self.rows) else Exit.VACUOUS


@answers(CountRequest)
def count(request: CountRequest) -> Census:
    """Enumerate every rooted map of a class and count.

    Raises:
        InputError: naming the offending option and what would be legal.

    Cost: some microseconds a rooted map, in the class ``maps`` from 7 edges on less than
    100 ns; constant memory.
    """
    extent, heard = request.extent, request.listener
    tell_of_size(extent, heard)
    rows, complete = until_interrupted(
        _count_level(extent, level, heard) for level in extent.levels
    )
    return Census(
        map_class=extent.map_class,
        edges=extent.edges,
        vertices=extent.vertices,
        complete=complete,
        rows=rows,
        source=source_for(extent.map_class).name,
    )


def _count_level(extent: Extent, edges: int, listener: Listener) -> CountRow:
    listener.level(edges, level_size(extent, edges))
    if extent.map_class is MapClass.MAPS and edges > UNROOTED_LIMIT:
        return count_compiled(extent, edges, listener)
    return count_one_by_one(extent, edges, listener)


def count_compiled(extent: Extent, edges: int, listener: Listener = SILENT) -> CountRow:
    """A level of the class ``maps``, counted by the compiled enumeration.

    Cost: less than 100 ns a rooted map, after some seconds of compiling at the first use.
    """
    from allworlds.engines import by_vertices_and_faces

    cells: Counter[tuple[int, int]] = Counter()
    limit = extent.vertex_limit(edges)
    for prefix in prefixes(edges, vertices=limit):
        before = cells.total()
        for (vertices, faces), maps in by_vertices_and_faces(edges, limit, prefix).items():
            cells[vertices, (2 - vertices + edges - faces) // 2] += maps
        listener.progress(cells.total() - before)
    return _row(extent, edges, cells)


def count_one_by_one(extent: Extent, edges: int, listener: Listener = SILENT) -> CountRow:
    """A level of any class, each map made, and each looked at."""
    cells: Counter[tuple[int, int]] = Counter()
    rooted = darts_fixed = 0
    for map_ in rooted_maps(edges, extent.map_class, extent.vertices):
        rooted += 1
        cells[map_.vertex_count, map_.genus] += 1
        if edges <= UNROOTED_LIMIT:
            darts_fixed += automorphisms(map_)
        if rooted % TOLD_EVERY == 0:
            listener.progress(TOLD_EVERY)
    listener.progress(rooted % TOLD_EVERY)
    # A map has 2m / |Aut| rootings, so its rootings weigh |Aut| / 2m each.
    unrooted = darts_fixed // (2 * edges) if edges <= UNROOTED_LIMIT else None
    return _row(extent, edges, cells, unrooted)


def _row(
    extent: Extent, edges: int, cells: Counter[tuple[int, int]], unrooted: int | None = None
) -> CountRow:
    """The row of rooted maps by vertices and genus, beside what the source says."""
    by_vertices: Counter[int] = Counter()
    by_genus: Counter[int] = Counter()
    for (vertices, genus), maps in sorted(cells.items()):
        by_vertices[vertices] += maps
        by_genus[genus] += maps
    labelled = {n: maps * factorial(n) // (2 * edges) for n, maps in by_vertices.items()}
    counted = source_for(extent.map_class).cells(edges)
    return CountRow(
        edges=edges,
        rooted=cells.total(),
        unrooted=unrooted,
        by_vertices=dict(by_vertices),
        by_genus=dict(sorted(by_genus.items())),
        labelled=labelled if extent.map_class.simple else UNSET,
        counted={n: counted.get(n, 0) for n in range(1, extent.vertex_limit(edges) + 1)},
    )
