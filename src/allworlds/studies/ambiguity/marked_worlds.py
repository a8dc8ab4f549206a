"""Every marked world of a class, and which of them look alike."""

import json
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Annotated, Any, TypeAlias, TypeVar

from msgspec import Struct, field
from msgspec.structs import asdict
from typing_extensions import override

from allworlds import document as doc, outcome
from allworlds.engines import limits, sweep, units
from allworlds.engines.engine_table import ReadyEngine, local_or_dask
from allworlds.inputs import checks, requests
from allworlds.maps import classes, combinatorial
from allworlds.maps.quotient import Quotient, class_size, is_ambiguous
from allworlds.notations.given import GivenOptions
from allworlds.studies.ambiguity.members import (
    ComparedWorlds,
    is_least_rooting,
    projection_of,
    standing,
    twins,
)
from allworlds.world.lighthouses import kinds, options
from allworlds.world.lighthouses.composed import Nothing
from allworlds.world.lighthouses.marked import Position
from allworlds.world.selection import WhereOptions, tried_kind
from allworlds.world.world import World

BATCH = 200
"""Maps after which a part of a unit is handed over."""


class CensusRequest(
    limits.ListenerOptions,
    limits.ClusterOptions,
    limits.RunDirectoryOptions,
    limits.TimeLimitOptions,
    units.ShardOptions,
    WhereOptions,
    GivenOptions,
    classes.ExtentOptions,
):
    """Request of ``ambiguity census``: a class, its bounds and the effort."""

    lighthouse: Annotated[
        requests.Converted[kinds.GivenLighthouse, kinds.LighthouseKind],
        requests.Option(
            requests.SCOPE,
            "KIND",
            f"KIND[:key=value,...]: {checks.one_of(kinds.LIGHTHOUSES)}, or {kinds.OWN}.",
            document_type=Annotated[doc.Text, doc.about("`KIND[:key=value,...]`")],
        ),
    ] = requests.Converted(tried_kind, Position.kind)


Size: TypeAlias = tuple[int, int]
"""The numbers of edges and of vertices."""

Key = TypeVar("Key")


class SizeCounts(Struct):
    """Counts of the worlds of some sizes.

    Attributes:
        marked_worlds: maps with a lighthouse in them, up to isomorphism.
        ambiguous_worlds: those with a twin, of any size.
        classes: parts with two or more members, one of which is among these worlds.
        largest_class: the number of members of the largest of these parts; 0: there is none.
    """

    marked_worlds: int = 0
    ambiguous_worlds: int = 0
    classes: int = 0
    largest_class: int = 0

    def add(self, members: int, of: int) -> None:
        """Add some worlds that are members of one part with ``of`` members."""
        self.marked_worlds += members
        if of > 1:
            self.ambiguous_worlds += members
            self.classes += 1
            self.largest_class = max(self.largest_class, of)


class SensedParts(Struct):
    """Counts and quotients of some worlds.

    Attributes:
        worlds: rooted maps.
        alone: by size, how many worlds there are of which it is known that they have no twin.
        parts: for each quotient the other maps, with what is sensed in them, that have it: the
            document of a world of each, up to isomorphism.
    """

    worlds: doc.Natural = 0
    alone: Counter[tuple[int, int]] = field(default_factory=Counter)
    parts: dict[str, dict[str, dict[str, Any]]] = field(default_factory=dict)

    def add(self, other: "SensedParts") -> None:
        """Add the counts of another part."""
        self.worlds += other.worlds
        self.alone.update(other.alone)
        for quotient, worlds in other.parts.items():
            mine = self.parts.setdefault(quotient, {})
            for key, world in worlds.items():
                mine.setdefault(key, world)

    def meet(self, world: World) -> None:
        """Take in one world: a start of the map, with the lighthouse at a place."""
        key = _code(world, projection_of(world).quotient)
        self.parts.setdefault(key, {}).setdefault(_code(world, world.map), world.to_json())

    def meet_marked(self, map_: combinatorial.CombinatorialMap) -> None:
        """Take in a map with its root's vertex marked; of all roots there one is taken in.

        Of such worlds the quotient alone tells whether there is a twin.
        """
        if not is_least_rooting(map_):
            return
        world = World(map_, Position(0), 0)
        # A marked vertex of degree 1 is alone at what is sensed there, and so is every other one.
        if map_.sigma[0] != 0 and is_ambiguous(projection_of(world).quotient):
            self.meet(world)
        else:
            self.alone[map_.edge_count, map_.vertex_count] += 1

    def counts(self, name: Callable[[Size], Key]) -> dict[Key, SizeCounts]:
        """The counts of the worlds of each size, or of those whose sizes have one name."""
        found: dict[Key, SizeCounts] = {}
        for size, number in self.alone.items():
            found.setdefault(name(size), SizeCounts()).marked_worlds += number
        for worlds in self.parts.values():
            names = Counter(name(_size(world)) for world in worlds.values())
            for each, members in names.items():
                found.setdefault(each, SizeCounts()).add(members, of=len(worlds))
        return found

    def smallest_pair(self) -> ComparedWorlds | None:
        """Two worlds of one part, with the proof that no motion tells them apart."""
        pairs = [
            sorted((_size(world), code, world) for code, world in worlds.items())[:2]
            for worlds in self.parts.values()
            if len(worlds) > 1
        ]
        if not pairs:
            return None
        one, other = min(pairs, key=lambda pair: pair[::-1])
        return _apart(World.from_json(one[2]), World.from_json(other[2]))

    def ensure_counted(self) -> None:
        """Raise Disagreement unless each class has as many members as Burnside's count says.

        It counts all maps with a marked vertex that look alike.
        """
        for worlds in self.parts.values():
            world = World.from_json(next(iter(worlds.values())))
            quotient = projection_of(world).quotient
            if len(worlds) != class_size(quotient):
                raise outcome.Disagreement(
                    f"{len(worlds)} worlds were met of a class of {class_size(quotient)}, "
                    f"with the quotient {quotient}"
                )


class PartBySensing(Struct, frozen=True):
    """The engine of the census."""

    extent: classes.Extent
    kind: kinds.LighthouseKind

    def parts(self, unit: units.LevelUnit | units.GivenUnit) -> Iterator[SensedParts]:
        """The maps of the unit, some at a time."""
        met, marked = SensedParts(), self.kind.name == Position.kind and self.extent.given is None
        for map_, places in unit.placed(self.extent, Nothing if marked else self.kind.as_class):
            met.worlds += 1
            if marked:
                met.meet_marked(map_)
            else:  # given ones may be the same: each world is known by its code
                for _, place in places:
                    met.meet(World(map_, place, 0))
            if met.worlds == BATCH:
                yield met
                met = SensedParts()
        yield met


def _size(world: Mapping[str, Any]) -> Size:
    """The size of a world, by its document."""
    map_ = combinatorial.CombinatorialMap.trusted(tuple(world["sigma"]), tuple(world["alpha"]))
    return map_.edge_count, map_.vertex_count


def _code(world: World, of: combinatorial.CombinatorialMap | Quotient) -> str:
    """The map or the quotient of a world, what is sensed and told, whatever the start: a text."""
    labels: Sequence[Any] = of.labels if isinstance(of, Quotient) else world.percepts
    sensed = [[p.marks, -1 if p.bearing is None else p.bearing] for p in labels]
    if isinstance(of, Quotient):
        sensed = [[degree, *label] for degree, label in zip(of.degree, sensed, strict=True)]
    # Numbers with names stand in order.
    told = sorted(world.told.items()) if isinstance(world.told, Mapping) else world.told
    codes = (
        [
            combinatorial.rooted_code(of.sigma, of.alpha, dart),
            [sensed[d] for d in combinatorial.numbering(of.sigma, of.alpha, dart)],
            told,
        ]
        for dart in range(len(of.sigma))
    )
    return min(map(json.dumps, codes))


def _apart(one: World, other: World) -> ComparedWorlds:
    """The two compared, the second from the first start from which it looks the same.

    Where the lighthouse cannot stand in the same place from that start, it stands in another one
    in which the same is sensed and told.
    """
    code, kind = _code(other, other.map), other.lighthouse.as_kind
    for start in other.map.darts:
        for place in (other.lighthouse, *kind.places(other.map, start)):
            try:
                world = World(other.map, place, start)
            except options.InvalidWorld:  # the lighthouse cannot stand there when one starts here
                continue
            if _code(world, world.map) == code and (found := twins(one, world)).bisimulation:
                return found
    raise AssertionError(f"{one} and {other} have one quotient, and are told apart")


MarkedWorlds: TypeAlias = Annotated[
    doc.Natural,
    doc.about("maps with a lighthouse in them, as one marked vertex, up to isomorphism"),
]
AmbiguousWorlds: TypeAlias = Annotated[
    doc.Natural | None, doc.about("those with a twin in the class of maps; null: of a shard")
]
Classes: TypeAlias = Annotated[
    doc.Natural | None,
    doc.about("ambiguity classes of two or more worlds in the class of maps; null: of a shard"),
]
LargestClass: TypeAlias = Annotated[
    doc.Natural | None,
    doc.about("the size of the largest of these classes; 0: there is none, null: of a shard"),
]


class CensusRow(doc.Document, kw_only=True):
    """The marked maps with one number of edges.

    ``rooted`` is the number of rooted maps found, ``counted`` the number according to the
    independent source. A shard may hold some members of a class and not others.
    """

    edges: doc.Edges
    marked_worlds: MarkedWorlds
    ambiguous_worlds: AmbiguousWorlds = None
    classes: Classes = None
    largest_class: LargestClass = None
    rooted: doc.NotInDocument[int]
    counted: doc.NotInDocument[int]

    def agrees(self, *, whole: bool) -> bool:
        """Whether as many rooted maps were met as the source counts; of a shard at most so many."""
        return self.rooted == self.counted if whole else self.rooted <= self.counted


class CensusCell(doc.Document):
    """The marked maps of one size."""

    edges: doc.Edges
    vertices: doc.Vertices
    marked_worlds: MarkedWorlds
    ambiguous_worlds: AmbiguousWorlds = None
    classes: Classes = None
    largest_class: LargestClass = None


@doc.with_options(CensusRequest)
class CensusScope(doc.Document):
    """The scope of a census."""

    places: sweep.TriedPlaces
    given: sweep.GivenCount
    sha256: sweep.FileDigests
    shard: doc.WhichShard


class AmbiguityCensus(sweep.SweptReport):
    """Report of 'ambiguity census'.

    Every level of a class of maps; twins are looked for inside the class only.
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
        """All that was classified."""
        return sweep.told_scope(
            CensusScope, self.request, places=self.places, shard=str(self.portion)
        )

    @doc.computed
    def gate(self) -> sweep.ToldGate:
        """Count gate, if there is anything to compare."""
        return self.compared

    @property
    def places(self) -> str:
        """The places of the lighthouse that were tried, in words."""
        return sweep.tried_places(self.request.lighthouse, self.extent)

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
    """Classify every map of a class with every choice of a marked vertex, up to isomorphism.

    Raises:
        InputError: naming the offending option and what would be legal.

    Cost: some 100 microseconds a rooted map; memory for the ambiguous quotients of a level.
    """
    return CensusSweep(request).answer(request.run)


class CensusSweep(sweep.Sweep[SensedParts, AmbiguityCensus]):
    """A census on its way."""

    verb, asked, result = "ambiguity census", CensusRequest, SensedParts
    extent: classes.Extent

    def __init__(self, request: CensusRequest) -> None:
        super().__init__(request, request.extent)
        self._levels: list[tuple[units.SweptLevel, int]] = []
        self._met = SensedParts()
        self.kind: kinds.LighthouseKind = request.lighthouse_of_given(request.lighthouse)
        if self.kind.as_class.leaves_marks:
            raise checks.InputError(
                f"under the lighthouse {self.kind} the robot leaves marks itself, and a census is "
                f"of what motions alone can tell apart; legal are {standing()}"
            )

    @override
    def ready(self) -> ReadyEngine:
        engine = PartBySensing(self.extent, self.kind)
        return ReadyEngine(local_or_dask(self.request.dask, self.deadline), engine)

    @override
    def finish(self, level: units.SweptLevel, total: SensedParts) -> None:
        extent = self.extent
        all_maps = extent.map_class is classes.MapClass.MAPS and not (extent.where or extent.given)
        if self.portion == units.WHOLE and all_maps and self.kind.name == Position.kind:
            total.ensure_counted()
        self._levels.append((level, total.worlds))
        # Worlds of different sizes may look alike.
        self._met.add(total)

    @override
    def report(self, ending: outcome.Ending) -> AmbiguityCensus:
        whole = self.portion == units.WHOLE
        by_edges = self._met.counts(lambda size: size[0])
        by_size = self._met.counts(lambda size: size)
        pair = self._met.smallest_pair() if whole else None

        def shown(counts: SizeCounts) -> dict[str, int]:
            """Of a shard the counts that do not depend on other shards."""
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
