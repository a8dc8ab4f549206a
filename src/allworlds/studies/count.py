"""Counts of maps of a class, each made twice: by enumeration, and by an independent source.

The source computes the number of rooted maps without making the maps; under some conditions there
is no source (:mod:`allworlds.maps.count_source`).
"""

from collections import Counter
from collections.abc import Iterator
from math import factorial
from typing import Annotated

from msgspec import UNSET, Struct, UnsetType, field
from typing_extensions import override

from allworlds import outcome
from allworlds.documents import document as doc
from allworlds.engines import engine_table, sweep
from allworlds.engines.units import (
    WHOLE,
    LevelUnit,
    SweptLevel,
    cells_of_level,
    is_counted,
)
from allworlds.inputs import checks, requests
from allworlds.maps import classes, combinatorial
from allworlds.studies.scopes import as_scope
from allworlds.studies.swept import SweptOptions, SweptReport, ToldGate
from allworlds.world.selection import WhereOptions

TOLD_EVERY = 1000
"""The number of maps that are counted between two reports to the listener."""

UNROOTED_LIMIT = 6
"""The largest number of edges for which unrooted maps are counted."""


class CountRequest(SweptOptions, WhereOptions, classes.ExtentOptions):
    """Request of ``count``: a class of maps, its bounds, a condition, and options of the job.

    These options are shard, time limit, run directory, Dask cluster and listener.
    """


class CountRow(doc.Document, kw_only=True):
    """The numbers of maps with one number of edges.

    ``counted`` holds the numbers of rooted maps by vertices according to the independent source;
    None without a source. An entry of ``cells`` is a number of vertices, a genus, the number of
    rooted maps with this size and genus, and that of unrooted maps; the last number is None if it
    is not known. ``whole`` is false in a shard.
    """

    edges: doc.Edges
    rooted: Annotated[doc.Natural, doc.about("rooted maps")]
    unrooted: Annotated[
        doc.Natural | None,
        doc.about(
            "maps up to orientation-preserving isomorphism; null beyond 6 edges, or of a shard"
        ),
    ]
    up_to_reflection: Annotated[
        doc.Natural | None,
        doc.about(
            "maps up to any isomorphism; null if `unrooted` is, or under a condition of your own"
        ),
    ]
    chiral: Annotated[
        doc.Natural | None,
        doc.about(
            "unrooted maps unlike their mirror images, both of a pair; null if `unrooted` is"
        ),
    ]
    self_dual: Annotated[
        doc.Natural | None,
        doc.about("unrooted maps that are their dual, orientation kept; null if `unrooted` is"),
    ]
    by_vertices: Annotated[dict[int, doc.Natural], doc.about("rooted maps by vertices")]
    by_genus: Annotated[dict[int, doc.Natural], doc.about("rooted maps by genus")]
    labelled: Annotated[
        dict[int, doc.Natural] | UnsetType,
        doc.about("in simple classes: rotation systems on labelled vertices, by vertices"),
    ] = UNSET
    counted: doc.NotInDocument[dict[int, int] | None]
    cells: doc.NotInDocument[tuple[tuple[int, int, int, int | None], ...]]
    whole: doc.NotInDocument[bool] = True

    @property
    def agrees(self) -> bool:
        """Whether enumeration and source give equal counts for every number of vertices.

        Without a source this is True.  A shard agrees if the enumeration counts no more maps than
        the source.
        """
        return not self.miscounts

    @property
    def miscounts(self) -> list[tuple[int, int, int]]:
        """The numbers of vertices for which enumeration and source disagree.

        An entry is a number of vertices, the number of maps that were enumerated, and the number of
        the source.
        """
        if self.counted is None:
            return []
        sizes = sorted({*self.by_vertices, *self.counted})
        both = [(n, self.by_vertices.get(n, 0), self.counted.get(n, 0)) for n in sizes]
        return [each for each in both if each[1] > each[2] or (self.whole and each[1] < each[2])]


@doc.with_options(CountRequest)
class CountedScope(doc.Document):
    """The scope of a count."""

    shard: doc.WhichShard


class Census(SweptReport):
    """Report of 'count'.

    The numbers of maps of a class, for each number of edges.
    """

    rows: Annotated[tuple[CountRow, ...], doc.about("one for each number of edges, ascending")]

    @doc.computed
    def scope(self) -> CountedScope:
        """A description of all that was counted."""
        return as_scope(CountedScope, self.request)

    @doc.computed
    def gate(self) -> ToldGate:
        """The count gate; null if there is nothing to compare."""
        return self.compared

    @property
    @override
    def agrees(self) -> bool:
        return all(row.agrees for row in self.rows)

    @property
    @override
    def empty(self) -> bool:
        return not any(row.rooted for row in self.rows)


@requests.answers(CountRequest)
def count(request: CountRequest) -> Census:
    """Enumerate every rooted map of a class, and count the maps.

    Raises:
        InputError: naming the offending option and what would be legal.

    Cost: some microseconds for each rooted map; in the class ``maps``, from 7 edges on, some 150
    ns.  The memory is constant.
    """
    return CountSweep(request).answer(request.run)


class CountSweep(sweep.Sweep["Counted", Census]):
    """The sweep through the levels of a class; it counts the maps of each level."""

    verb, request_type = "count", CountRequest
    extent: classes.Extent

    def __init__(self, request: CountRequest) -> None:
        super().__init__(request, request.extent)
        self._rows: list[CountRow] = []

    @override
    def ready(self) -> engine_table.ReadyEngine:
        return engine_table.ReadyEngine(
            engine_table.local_or_dask(self.request.dask, self.deadline), Enumerate(self.extent)
        )

    @override
    def finish(self, level: SweptLevel, total: "Counted") -> None:
        self._rows.append(row_of(self.extent, level.edges, total, whole=self.portion == WHOLE))

    @override
    def report(self, ending: outcome.Ending) -> Census:
        return Census(**self.ended(ending), rows=tuple(self._rows))


class Counted(Struct):
    """Counts of the maps of a part of a level.

    The attributes ``fixed``, ``mirrored`` and ``dual`` are sums over the rooted maps.  A rooted map
    adds a number of isomorphisms; these need not preserve the root.  The sums give numbers of
    unrooted maps.  An unrooted map with m edges and ``a`` automorphisms has 2m / ``a`` rootings,
    and each of them adds ``a`` to ``fixed``.  So ``fixed`` divided by 2m is the number of unrooted
    maps.  In the same way, ``mirrored`` and ``dual`` give the numbers of those unrooted maps that
    are isomorphic to their mirror image, or to their dual (the map in which vertices and faces are
    exchanged).

    For maps with more than :data:`UNROOTED_LIMIT` edges the sums are not computed; they stay empty
    or 0.

    Attributes:
        cells: the number of rooted maps, for each pair (number of vertices, genus).
        fixed: the sum of the numbers of automorphisms, for each pair (number of vertices, genus).
        mirrored: the sum, over all maps, of the numbers of isomorphisms onto the mirror image.
        dual: the sum, over all maps, of the numbers of isomorphisms onto the dual.
    """

    cells: Counter[tuple[int, int]] = field(default_factory=Counter)
    fixed: Counter[tuple[int, int]] = field(default_factory=Counter)
    mirrored: int = 0
    dual: int = 0

    @property
    def worlds(self) -> int:
        """The number of rooted maps."""
        return self.cells.total()

    def add(self, other: "Counted") -> None:
        """Add the counts of other maps of the level."""
        self.cells.update(other.cells)
        self.fixed.update(other.fixed)
        self.mirrored += other.mirrored
        self.dual += other.dual


CountSweep.result = Counted


class Enumerate(Struct, frozen=True):
    """The engine that counts by enumeration."""

    extent: classes.Extent

    def parts(self, unit: LevelUnit) -> Iterator[Counted]:
        """Yield the counts of the unit's maps in parts; each map is counted in one part alone."""
        extent = self.extent
        plain = extent.map_class is classes.MapClass.MAPS and extent.where is None
        if plain and unit.edges > UNROOTED_LIMIT and not checks.lack_of(*engine_table.COMPILER):
            yield count_compiled(extent, unit)
        else:
            yield from count_one_by_one(extent, unit)


def count_compiled(extent: classes.Extent, unit: LevelUnit) -> Counted:
    """The counts of all maps of a unit of the class ``maps``, by the compiled enumeration.

    Cost: some 150 ns a rooted map, after some seconds of compiling at the first use.
    """
    from allworlds.engines.kernel.worlds import by_vertices_and_faces

    edges, counted = unit.edges, Counted()
    found = by_vertices_and_faces(edges, extent.vertex_limit(edges), unit.prefix)
    for (vertices, faces), maps in found.items():
        counted.cells[vertices, (2 - vertices + edges - faces) // 2] += maps
    return counted


def count_one_by_one(extent: classes.Extent, unit: LevelUnit) -> Iterator[Counted]:
    """Yield the counts of a unit's maps, of any class, in parts; a map is counted in one part."""
    counted = Counted()
    for met, map_ in enumerate(unit.maps(extent), 1):
        cell = map_.vertex_count, map_.genus
        counted.cells[cell] += 1
        if unit.edges <= UNROOTED_LIMIT:
            counted.fixed[cell] += combinatorial.automorphisms(map_)
            counted.mirrored += combinatorial.isomorphisms(map_, map_.mirrored())
            if len(map_.faces) == map_.vertex_count:
                counted.dual += combinatorial.isomorphisms(map_, map_.dual())
        if met % TOLD_EVERY == 0:
            yield counted
            counted = Counted()
    yield counted


def row_of(extent: classes.Extent, edges: int, total: Counted, *, whole: bool) -> CountRow:
    """The row of a level, or of the part of the level in a shard.

    If there is an independent source, the row also has its counts, always those of the whole level.

    Args:
        extent: the class of maps with its bounds.
        edges: the number of edges, which names the level.
        total: the counts by enumeration.
        whole: whether ``total`` is about the whole level, and not about a shard.
    """
    by_vertices: Counter[int] = Counter()
    by_genus: Counter[int] = Counter()
    for (vertices, genus), maps in sorted(total.cells.items()):
        by_vertices[vertices] += maps
        by_genus[genus] += maps
    # A map has 2m / |Aut| rootings, so its rootings weigh |Aut| / 2m each; and there are as many
    # isomorphisms onto its mirror image, or its dual, as automorphisms, or none.
    known = whole and edges <= UNROOTED_LIMIT
    both = extent.where is None or isinstance(extent.where, classes.NamedCondition)
    unrooted, same = total.fixed.total() // (2 * edges), total.mirrored // (2 * edges)
    labelled = {n: maps * factorial(n) // (2 * edges) for n, maps in by_vertices.items()}
    return CountRow(
        edges=edges,
        rooted=total.worlds,
        unrooted=unrooted if known else None,
        up_to_reflection=(unrooted + same) // 2 if known and both else None,
        chiral=unrooted - same if known else None,
        self_dual=total.dual // (2 * edges) if known else None,
        by_vertices=dict(by_vertices),
        by_genus=dict(sorted(by_genus.items())),
        labelled=labelled if whole and extent.map_class.simple else UNSET,
        counted=cells_of_level(extent, edges) if is_counted(extent) else None,
        cells=tuple(
            (*cell, maps, total.fixed[cell] // (2 * edges) if known else None)
            for cell, maps in sorted(total.cells.items())
        ),
        whole=whole,
    )
