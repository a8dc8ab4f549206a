"""The census: every map with a marked vertex, and which of them cannot be told apart."""

from __future__ import annotations

from typing import Annotated, Any, TypeAlias

from msgspec.structs import asdict
from typing_extensions import override

from allworlds.document import (
    Aside,
    Document,
    Edges,
    IfAny,
    Natural,
    Vertices,
    WhichShard,
    about,
    computed,
)
from allworlds.engines import (
    GATE,
    WHOLE,
    ReadyEngine,
    Sweep,
    SweptLevel,
    SweptReport,
    ToldGate,
    TriedPlaces,
    from_kept,
    here_or,
    told_scope,
    tried_places,
)
from allworlds.inputs import answers
from allworlds.maps import Extent, MapClass
from allworlds.outcome import Ending
from allworlds.studies.ambiguity.ambiguity_requests import CensusRequest
from allworlds.studies.ambiguity.sensed_worlds import (
    PartBySensing,
    SensedParts,
    SizeCounts,
    ensure_stands,
)
from allworlds.world import LighthouseKind, Position, World

MarkedWorlds: TypeAlias = Annotated[
    Natural, about("maps with a lighthouse in them, as one marked vertex, up to isomorphism")
]
AmbiguousWorlds: TypeAlias = Annotated[
    Natural | None, about("those with a twin in the class of maps; null: of a shard")
]
Classes: TypeAlias = Annotated[
    Natural | None,
    about("ambiguity classes of two or more worlds in the class of maps; null: of a shard"),
]
LargestClass: TypeAlias = Annotated[
    Natural | None,
    about("the size of the largest of these classes; 0: there is none, null: of a shard"),
]


class CensusRow(Document):
    """The marked maps with one number of edges.

    ``rooted`` is the number of rooted maps found, ``counted`` the number according to the
    independent source. A shard may hold some members of a class and not others.
    """

    edges: Edges
    marked_worlds: MarkedWorlds
    ambiguous_worlds: AmbiguousWorlds = None
    classes: Classes = None
    largest_class: LargestClass = None
    rooted: Aside[int]
    counted: Aside[int]

    def agrees(self, *, whole: bool) -> bool:
        """Whether as many rooted maps were met as the source counts; of a shard at most so many."""
        return self.rooted == self.counted if whole else self.rooted <= self.counted


class CensusCell(Document):
    """The marked maps of one size."""

    edges: Edges
    vertices: Vertices
    marked_worlds: MarkedWorlds
    ambiguous_worlds: AmbiguousWorlds = None
    classes: Classes = None
    largest_class: LargestClass = None


class CensusScope(Document, of=CensusRequest):
    """The scope of a census."""

    places: TriedPlaces
    shard: WhichShard


class AmbiguityCensus(SweptReport):
    """Report of 'ambiguity census'.

    Every level of a class of maps; twins are looked for inside the class only.
    """

    scope: Annotated[CensusScope, about("what was classified")] = computed(
        lambda c: told_scope(CensusScope, c.request, places=c.places, shard=str(c.portion))
    )
    gate: ToldGate = GATE
    rows: Annotated[tuple[CensusRow, ...], about("one a number of edges, ascending")]
    by_vertices: Annotated[
        tuple[CensusCell, ...], about("one for each (edges, vertices) with a world, ascending")
    ]
    pair: Annotated[
        IfAny[tuple[World, ...]], about("the smallest worlds that are not told apart")
    ] = ()
    bisimulation: Annotated[
        IfAny[tuple[tuple[Natural, ...], ...]],
        about("of that pair: for each world the class of each dart"),
    ] = ()

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


@answers(CensusRequest)
def census(request: CensusRequest) -> AmbiguityCensus:
    """Classify every map of a class with every choice of a marked vertex, up to isomorphism.

    Raises:
        InputError: naming the offending option and what would be legal.

    Cost: some 100 microseconds a rooted map; memory for the ambiguous quotients of a level.
    """
    return CensusSweep(request).answer(request.run)


class CensusSweep(Sweep[SensedParts, AmbiguityCensus]):
    """A census on its way."""

    verb, asked = "ambiguity census", CensusRequest
    extent: Extent

    def __init__(self, request: CensusRequest) -> None:
        super().__init__(request, request.extent)
        self._levels: list[tuple[SweptLevel, int]] = []
        self._met = SensedParts()
        self.kind: LighthouseKind = request.lighthouse
        ensure_stands(self.kind)

    @override
    def ready(self) -> ReadyEngine:
        engine = PartBySensing(self.extent, self.kind)
        return ReadyEngine(here_or(self.request.cluster, self.deadline), engine)

    @override
    def empty(self) -> SensedParts:
        return SensedParts()

    @override
    def read(self, kept: Any) -> SensedParts:
        return from_kept(kept, SensedParts)

    @override
    def finish(self, level: SweptLevel, total: SensedParts) -> None:
        all_maps = self.extent.map_class is MapClass.MAPS and self.extent.where is None
        if self.portion == WHOLE and all_maps and self.kind.name == Position.kind:
            total.ensure_counted()
        self._levels.append((level, total.worlds))
        # Worlds of different sizes may look alike.
        self._met.add(total)

    @override
    def report(self, ending: Ending) -> AmbiguityCensus:
        whole = self.portion == WHOLE
        by_edges = self._met.counts(lambda size: size[0])
        by_size = self._met.counts(lambda size: size)
        pair = self._met.smallest_pair() if whole else None
        return AmbiguityCensus(
            **self.ended(ending),
            rows=tuple(
                CensusRow(
                    edges=level.edges,
                    rooted=rooted,
                    counted=level.worlds,
                    **_told(by_edges.get(level.edges, SizeCounts()), whole=whole),
                )
                for level, rooted in self._levels
            ),
            by_vertices=tuple(
                CensusCell(edges=edges, vertices=vertices, **_told(counts, whole=whole))
                for (edges, vertices), counts in sorted(by_size.items())
            ),
            pair=pair.worlds if pair else (),
            bisimulation=(pair and pair.bisimulation) or (),
        )


def _told(counts: SizeCounts, *, whole: bool) -> dict[str, int]:
    """The keys of the counts; of a shard those that do not depend on other shards."""
    return asdict(counts) if whole else {"marked_worlds": counts.marked_worlds}
