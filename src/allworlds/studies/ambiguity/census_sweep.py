"""The census of a class of maps: which maps with a lighthouse look alike to a robot."""

from collections import Counter
from collections.abc import Callable, Iterator
from typing import Annotated, TypeAlias, TypeVar

from msgspec import Struct, field
from msgspec.structs import asdict
from typing_extensions import override

from allworlds import outcome
from allworlds.documents import document as doc
from allworlds.engines import limits, sweep, units
from allworlds.engines.engine_table import ReadyEngine, local_or_dask
from allworlds.engines.kernel import capabilities
from allworlds.inputs import checks, requests
from allworlds.maps import classes
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.quotient import class_size
from allworlds.notations.given import GivenOptions
from allworlds.studies.ambiguity import sensed_classes as arrays
from allworlds.studies.ambiguity.members import (
    ComparedWorlds,
    ensure_motions_decide,
    projection_of,
    twins,
)
from allworlds.studies.options import ClusterOptions, ListenerOptions, RunDirectoryOptions
from allworlds.studies.scopes import FileDigests, GivenCount, TriedPlaces, as_scope, tried_places
from allworlds.studies.swept import SweptReport, ToldGate
from allworlds.world.lighthouses import kinds
from allworlds.world.lighthouses.marked import Position
from allworlds.world.selection import WhereOptions, tried_kind
from allworlds.world.world import World

BATCH = 2000
"""The number of worlds, or of maps, after which the engine yields a part of its result."""


class CensusRequest(
    ListenerOptions,
    ClusterOptions,
    RunDirectoryOptions,
    limits.TimeLimitOptions,
    units.ShardOptions,
    WhereOptions,
    GivenOptions,
    classes.ExtentOptions,
):
    """Request of ``ambiguity census``: a class of maps, its bounds, a lighthouse, and the job.

    The options of the job are time limit, shard, run directory, Dask cluster and listener.
    """

    lighthouse: Annotated[
        requests.Converted[kinds.GivenLighthouse, kinds.LighthouseKind],
        requests.Option(
            requests.SCOPE,
            "KIND",
            f"KIND[:key=value,...]: {checks.one_of(kinds.LIGHTHOUSES)}, or {kinds.OWN}.",
            document_type=Annotated[doc.Text, doc.about("`KIND[:key=value,...]`")],
        ),
    ] = requests.Converted(tried_kind, Position.kind)


SizePair: TypeAlias = tuple[int, int]
"""The numbers of edges and of vertices."""

Key = TypeVar("Key")

AnyUnit: TypeAlias = units.LevelUnit | units.GivenUnit


class SizeCounts(Struct):
    """Counts of the worlds of some sizes, and of their ambiguity classes.

    An ambiguity class is a set of worlds: all worlds that look alike from some starts.  A class
    counts here if it has two or more members, and at least one of them has one of the sizes.

    Attributes:
        marked_worlds: the number of maps with a lighthouse, up to isomorphism.
        ambiguous_worlds: the number of these worlds that have a twin.  The twin may have another
            size.
        classes: the number of ambiguity classes that count here.
        largest_class: the number of members of the largest of these classes; members of other sizes
            are included.  0 if there is no class.
    """

    marked_worlds: int = 0
    ambiguous_worlds: int = 0
    classes: int = 0
    largest_class: int = 0

    def add_class(self, members: int, of: int) -> None:
        """Count an ambiguity class.

        Args:
            members: the number of its worlds that have one of the counted sizes.
            of: the number of all its worlds.
        """
        self.ambiguous_worlds += members
        self.classes += 1
        self.largest_class = max(self.largest_class, of)


class SensedParts(Struct, forbid_unknown_fields=True):
    """The worlds of a part of a census, and the pairs of these worlds that look alike.

    A *look* is a text that stands for all that a robot can find out from a start.  A world can have
    several looks, one for each start.

    Attributes:
        worlds: the number of rooted maps.
        sizes: the numbers of edges and of vertices of each world, by the world's name.  Isomorphic
            worlds have the same name.
        looks: for each look the name of the smallest world with this look.
        alike: pairs of names of worlds that share a look, the smaller world first.
        counted: for some looks, the size of the ambiguity class of the worlds with this look,
            computed by Burnside's lemma.  Sizes are computed only in a census of all maps with the
            lighthouse ``position``.  There is no entry if motions tell all darts of a world with
            this look apart: then the world is its own quotient, and no other world has this
            quotient.
    """

    worlds: doc.Natural
    sizes: dict[str, SizePair] = field(default_factory=dict)
    looks: dict[str, str] = field(default_factory=dict)
    alike: set[tuple[str, str]] = field(default_factory=set)
    counted: dict[str, int] = field(default_factory=dict)

    def add(self, other: "SensedParts") -> None:
        """Add the worlds of another part of the census."""
        self.worlds += other.worlds
        self.sizes |= other.sizes
        self.alike |= other.alike
        self.counted |= other.counted
        for look, name in other.looks.items():
            self._meet(look, name)

    def meet(self, worlds: arrays.SensedWorlds, *, counted: bool) -> None:
        """Add worlds that have equally many edges.

        If ``counted``, the sizes of their ambiguity classes are computed by Burnside's lemma, too.
        """
        edges = worlds.sigma.shape[1] // 2
        for i, (look, name, sheets) in enumerate(arrays.named(worlds)):
            self.sizes[name] = edges, worlds.vertices[i]
            if counted and sheets > 1 and look not in self.counted:
                map_ = CombinatorialMap.trusted(*(each[i].tolist() for each in worlds[:2]))
                quotient = projection_of(World(map_, Position(0), 0)).quotient
                self.counted[look] = class_size(quotient)
            self._meet(look, name)

    def _meet(self, look: str, name: str) -> None:
        first = self.looks.setdefault(look, name)
        if first != name:
            # So the two smallest worlds of a look are a pair, in whatever order they come.
            pair = sorted((first, name), key=self._order)
            self.alike.add((pair[0], pair[1]))
            self.looks[look] = pair[0]

    def _order(self, name: str) -> tuple[SizePair, str]:
        return self.sizes[name], name

    def classes(self) -> Iterator[list[str]]:
        """Yield each class of two or more worlds, as the list of its members' names.

        Two worlds look alike if a start in one world and a start in the other world have the same
        look.  Two worlds are in one class if they look alike.  They are also in one class if a
        chain of worlds leads from one to the other, and each world of the chain looks like the next
        one; the starts may differ from step to step.
        """
        beside: dict[str, list[str]] = {}
        for one, other in self.alike:
            beside.setdefault(one, []).append(other)
            beside.setdefault(other, []).append(one)
        met = set[str]()
        for first in beside:
            found = [] if first in met else [first]
            met.add(first)
            for name in found:
                new = [each for each in beside[name] if each not in met]
                met.update(new)
                found += new
            if found:
                yield found

    def counts(self, name: Callable[[SizePair], Key]) -> dict[Key, SizeCounts]:
        """Count the worlds in groups; return the counts of each group, by the group's key.

        The function ``name`` makes the key of a world's group from the world's numbers of edges and
        of vertices.
        """
        found: dict[Key, SizeCounts] = {}
        for size, number in Counter(self.sizes.values()).items():
            found.setdefault(name(size), SizeCounts()).marked_worlds += number
        for members in self.classes():
            for each, some in Counter(name(self.sizes[one]) for one in members).items():
                found[each].add_class(some, of=len(members))
        return found

    def smallest_pair(self) -> tuple[str, ...]:
        """The names of the two smallest worlds that look alike from some starts.

        Empty if no two worlds look alike.
        """
        return min(self.alike, key=lambda pair: [*map(self._order, reversed(pair))], default=())

    def ensure_counted(self) -> None:
        """Raise Disagreement unless each class has as many worlds as Burnside's lemma counts.

        All worlds of a class have the same quotient.  Under the lighthouse ``position`` Burnside's
        lemma counts the worlds with this quotient (:func:`allworlds.maps.quotient.class_size`).
        Only classes whose looks are in :attr:`counted` are compared; under another lighthouse there
        are none.
        """
        members = Counter({one: len(found) for found in self.classes() for one in found})
        for look, counted in self.counted.items():
            met = members[self.looks[look]] or 1
            if met != counted:
                raise outcome.Disagreement(
                    f"{met} worlds were met of a class of {counted}, as that of the look {look}"
                )


class PartBySensing(Struct, frozen=True):
    """The engine of the census: it makes the worlds of a unit, and compares their looks.

    Attributes:
        extent: the class of maps with its bounds.
        kind: the kind of lighthouse.
        counted: whether sizes of ambiguity classes are also computed by Burnside's lemma.
    """

    extent: classes.Extent
    kind: kinds.LighthouseKind
    counted: bool

    def parts(self, unit: AnyUnit) -> Iterator[SensedParts]:
        """Yield the worlds of the unit in batches; each batch is a part of the census."""
        kind = self.kind.as_class
        if isinstance(unit, units.LevelUnit) and arrays.compiled_name(kind, self.extent):
            several = arrays.laid_out(unit, self.extent, kind)
        else:
            found = batches(unit, self.extent, self.kind)
            several = ((maps, arrays.matrices(worlds)) for maps, worlds in found)
        for maps, worlds in several:
            part = SensedParts(maps)
            part.meet(worlds, counted=self.counted)
            yield part


def batches(
    unit: AnyUnit, extent: classes.Extent, kind: kinds.LighthouseKind
) -> Iterator[tuple[int, list[arrays.LitMap]]]:
    """Yield the worlds of a unit in batches, each with the number of rooted maps in the batch.

    A world is a map of ``extent`` with a place of a lighthouse of this kind.  The last batch may be
    empty; it is yielded all the same.
    """
    maps, worlds = 0, list[arrays.LitMap]()
    for map_, places in unit.placed(extent, kind.as_class):
        maps += 1
        worlds += ((map_, lighthouse) for _, lighthouse in places)
        if max(maps, len(worlds)) >= BATCH:
            yield maps, worlds
            maps, worlds = 0, []
    yield maps, worlds


MarkedWorlds: TypeAlias = Annotated[
    doc.Natural,
    doc.about("maps with a lighthouse in them, as one marked vertex, up to isomorphism"),
]
AmbiguousWorlds: TypeAlias = Annotated[
    doc.Natural | None, doc.about("those with a twin in the class of maps; null: of a shard")
]
ClassCount: TypeAlias = Annotated[
    doc.Natural | None,
    doc.about("ambiguity classes of two or more worlds in the class of maps; null: of a shard"),
]
LargestClass: TypeAlias = Annotated[
    doc.Natural | None,
    doc.about("the size of the largest of these classes; 0: there is none, null: of a shard"),
]


class CensusRow(doc.Document, kw_only=True):
    """Counts of the maps with a lighthouse that have one number of edges.

    In a shard only the worlds are counted, since a shard may hold some members of an ambiguity
    class without the others.

    ``rooted`` is the number of rooted maps that the census has met.  ``counted`` is the number of
    rooted maps according to an independent source, a formula or recurrence that makes no map
    (:mod:`allworlds.maps.count_source`).  If there is no source, as under some conditions,
    ``counted`` is only an upper limit, such as the number of rooted maps in the class without the
    condition; then it is not compared with ``rooted``.
    """

    edges: doc.Edges
    marked_worlds: MarkedWorlds
    ambiguous_worlds: AmbiguousWorlds = None
    classes: ClassCount = None
    largest_class: LargestClass = None
    rooted: doc.NotInDocument[int]
    counted: doc.NotInDocument[int]

    def agrees(self, *, whole: bool) -> bool:
        """Whether the number of rooted maps is ``counted``, the number of the independent source.

        A shard, for which ``whole`` is false, agrees if it has no more maps than the source counts.
        """
        return self.rooted == self.counted if whole else self.rooted <= self.counted


class CensusCell(doc.Document):
    """Counts of the maps with a lighthouse that have one number of edges and one of vertices."""

    edges: doc.Edges
    vertices: doc.Vertices
    marked_worlds: MarkedWorlds
    ambiguous_worlds: AmbiguousWorlds = None
    classes: ClassCount = None
    largest_class: LargestClass = None


@doc.with_options(CensusRequest)
class CensusScope(doc.Document):
    """The scope of a census."""

    places: TriedPlaces
    given: GivenCount
    sha256: FileDigests
    shard: doc.WhichShard


class AmbiguityCensus(SweptReport):
    """Report of 'ambiguity census'.

    The counts of worlds that look alike, for each size. A twin outside the class of maps does not
    count.
    """

    rows: Annotated[tuple[CensusRow, ...], doc.about("one a number of edges, ascending")]
    by_vertices: Annotated[
        tuple[CensusCell, ...], doc.about("one for each (edges, vertices) with a world, ascending")
    ]
    pair: Annotated[
        doc.IfAny[tuple[World, ...]], doc.about("the smallest worlds that are not told apart")
    ] = ()
    bisimulation: Annotated[
        doc.IfAny[tuple[tuple[doc.Natural, ...], ...]],
        doc.about("of that pair: for each world the class of each dart"),
    ] = ()

    @doc.computed
    def scope(self) -> CensusScope:
        """A description of the worlds whose looks were compared."""
        return as_scope(CensusScope, self.request, places=self.places, shard=str(self.portion))

    @doc.computed
    def gate(self) -> ToldGate:
        """The count gate; null if there is nothing to compare."""
        return self.compared

    @property
    def places(self) -> str:
        """The places of the lighthouse that were tried, in words."""
        return tried_places(self.request.lighthouse, self.extent)

    @property
    @override
    def agrees(self) -> bool:
        return not self.source or all(row.agrees(whole=self.whole) for row in self.rows)

    @property
    @override
    def empty(self) -> bool:
        return not any(row.marked_worlds for row in self.rows)


@requests.answers(CensusRequest)
def census(request: CensusRequest) -> AmbiguityCensus:
    """Find the worlds of a class of maps that look alike.

    All worlds of the class within the bounds are compared: every map with every place of the
    lighthouse.  Isomorphic worlds count once.

    Raises:
        InputError: naming the offending option and what would be legal.

    Cost for each rooted map and place: 300 bytes of memory and some 30 microseconds, or 7 in
    compiled code.
    """
    return CensusSweep(request).answer(request.run)


class CensusSweep(sweep.Sweep[SensedParts, AmbiguityCensus]):
    """The sweep of a census: it goes through the worlds, level by level, and makes the report."""

    verb, request_type, result = "ambiguity census", CensusRequest, SensedParts
    extent: classes.Extent

    def __init__(self, request: CensusRequest) -> None:
        super().__init__(request, request.extent)
        self._levels: list[tuple[units.SweptLevel, int]] = []
        self._met = SensedParts(0)
        self.kind: kinds.LighthouseKind = request.lighthouse_of_given(request.lighthouse)
        ensure_motions_decide(self.kind, "a census is of what motions alone can tell apart")

    @override
    def ready(self) -> ReadyEngine:
        extent = self.extent
        if arrays.compiled_name(self.kind.as_class, extent):
            from allworlds.engines.kernel import compiling, engine as kernel

            if not compiling.is_compiled(kernel.lay_out):
                self.listener.notice(capabilities.COMPILING)
        every = extent.map_class is classes.MapClass.MAPS and not (extent.where or extent.given)
        engine = PartBySensing(extent, self.kind, every and self.kind.name == Position.kind)
        return ReadyEngine(local_or_dask(self.request.dask, self.deadline), engine)

    @override
    def empty(self) -> SensedParts:
        return SensedParts(0)

    @override
    def finish(self, level: units.SweptLevel, total: SensedParts) -> None:
        if self.portion == units.WHOLE:
            total.ensure_counted()
        self._levels.append((level, total.worlds))
        # Worlds of different sizes may look alike.
        self._met.add(total)

    @override
    def report(self, ending: outcome.Ending) -> AmbiguityCensus:
        whole = self.portion == units.WHOLE
        by_edges = self._met.counts(lambda size: size[0])
        by_size = self._met.counts(lambda size: size)
        pair = self._compared(self._met.smallest_pair()) if whole else None

        def shown(counts: SizeCounts) -> dict[str, int]:
            """The counts that a row of the report shows, by their keys in the row.

            A row of a shard shows only the number of worlds: the other counts need all shards.
            """
            return asdict(counts) if whole else {"marked_worlds": counts.marked_worlds}

        return AmbiguityCensus(
            **self.ended(ending),
            rows=tuple(
                CensusRow(
                    edges=level.edges,
                    rooted=rooted,
                    counted=level.worlds,
                    **shown(by_edges.get(level.edges, SizeCounts())),
                )
                for level, rooted in self._levels
            ),
            by_vertices=tuple(
                CensusCell(edges=edges, vertices=vertices, **shown(counts))
                for (edges, vertices), counts in sorted(by_size.items())
            ),
            pair=pair.worlds if pair else (),
            bisimulation=(pair and pair.bisimulation) or (),
        )

    def _compared(self, names: tuple[str, ...]) -> ComparedWorlds | None:
        """The two worlds whose names are ``names``, and the proof that no motion tells them apart.

        A world's name is :attr:`allworlds.studies.ambiguity.sensed_classes.NamedWorld.name`.
        Return None if ``names`` is empty; otherwise it has two names.
        """
        found: dict[str, dict[str, World]] = {}
        for edges in sorted({self._met.sizes[name][0] for name in names}):
            for unit in units.units_of_level(self.extent, edges):
                for _, worlds in batches(unit, self.extent, self.kind):
                    several = arrays.named(arrays.matrices(worlds))
                    for placed, (look, name, _) in zip(worlds, several, strict=True):
                        if name in names:
                            alike = found.setdefault(look, {})
                            alike.setdefault(name, World(*placed, 0))
                            if len(alike) == len(names):
                                return twins(*(alike[each] for each in names))
        return None
