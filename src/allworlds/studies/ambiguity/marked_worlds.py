"""The census: every map with a marked vertex, and which of them cannot be told apart."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Annotated, Any

from typing_extensions import override

from allworlds.document import (
    Aside,
    Document,
    Edges,
    IfAny,
    Natural,
    Positive,
    WhichShard,
    about,
    computed,
    replace,
    taken,
)
from allworlds.engines import (
    GATE,
    WHOLE,
    Form,
    LevelUnit,
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
from allworlds.maps import (
    CombinatorialMap,
    Disagreement,
    Extent,
    MapClass,
    Quotient,
    class_size,
    is_ambiguous,
)
from allworlds.outcome import Ending
from allworlds.protocol import Percept
from allworlds.studies.ambiguity.ambiguity_requests import CensusRequest
from allworlds.studies.ambiguity.marked_code import is_least_rooting
from allworlds.studies.ambiguity.members import SensedQuotient, projection_of
from allworlds.studies.ambiguity.sensed_worlds import PartBySensing, SensedParts, ensure_stands
from allworlds.studies.ambiguity.telling_apart import ComparedWorlds
from allworlds.world import LighthouseKind, Position, World

BATCH = 200
"""Maps after which a part of a unit is handed over."""


class CensusRow(Document):
    """The marked maps with one number of edges.

    ``rooted`` is the number of rooted maps found, ``counted`` the number according to the
    independent source. A shard may hold some members of a class and not others.
    """

    edges: Edges
    marked_worlds: Annotated[Natural, about("maps with one marked vertex, up to isomorphism")]
    ambiguous_worlds: Annotated[
        Natural | None, about("marked maps with a twin in the class of maps; null: of a shard")
    ] = None
    classes: Annotated[
        Natural | None,
        about("ambiguity classes with two or more members in the class; null: of a shard"),
    ] = None
    largest_class: Annotated[
        Natural | None,
        about("the size of the largest of these classes; 0: there is none, null: of a shard"),
    ] = None
    rooted: Aside[int]
    counted: Aside[int]

    def agrees(self, *, whole: bool) -> bool:
        """Whether as many rooted maps were met as the source counts; of a shard at most so many."""
        return self.rooted == self.counted if whole else self.rooted <= self.counted


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
    pair: Annotated[
        IfAny[tuple[World, ...]],
        about("under other lighthouses than position: the smallest that are not told apart"),
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


class CensusSweep(Sweep["Met | SensedParts", AmbiguityCensus]):
    """A census on its way."""

    verb, asked = "ambiguity census", CensusRequest
    extent: Extent

    def __init__(self, request: CensusRequest) -> None:
        super().__init__(request, request.extent)
        self._rows: list[CensusRow] = []
        self._smallest: ComparedWorlds | None = None
        self.kind: LighthouseKind = request.lighthouse
        ensure_stands(self.kind)
        # Maps with a marked vertex have quotients that are counted faster.
        self._marked = self.kind.name == Position.kind

    @override
    def ready(self) -> ReadyEngine:
        marked, kind = Classify(self.extent), self.kind
        engine = marked if self._marked else PartBySensing(self.extent, kind)
        return ReadyEngine(here_or(self.request.cluster, self.deadline), engine)

    @override
    def empty(self) -> Met | SensedParts:
        return Met() if self._marked else SensedParts.none()

    @override
    def read(self, kept: Any) -> Met | SensedParts:
        return from_kept(kept, Met) if self._marked else from_kept(kept, SensedParts)

    @override
    def finish(self, level: SweptLevel, total: Met | SensedParts) -> None:
        row = CensusRow(
            edges=level.edges,
            marked_worlds=total.marked_worlds,
            rooted=total.worlds,
            counted=level.worlds,
        )
        if self.portion == WHOLE:
            plain = self.extent.map_class is MapClass.MAPS and self.extent.where is None
            if isinstance(total, Met) and plain:
                _check_sizes(total)
            self._smallest = self._smallest or total.smallest_pair()
            sizes = [members for members in total.sizes if members > 1]
            row = replace(
                row,
                ambiguous_worlds=sum(sizes),
                classes=len(sizes),
                largest_class=max(sizes, default=0),
            )
        self._rows.append(row)

    @override
    def report(self, ending: Ending) -> AmbiguityCensus:
        return AmbiguityCensus(
            **self.ended(ending),
            rows=tuple(self._rows),
            pair=self._smallest.worlds if self._smallest else (),
            bisimulation=(self._smallest and self._smallest.bisimulation) or (),
        )


def _to_kept(quotient: Quotient) -> Any:
    return [SensedQuotient.of(quotient).to_json(), quotient.sheets]


def _from_kept(told: object) -> Quotient:
    q, sheets = taken(told, tuple[SensedQuotient, Positive], "a quotient")
    return Quotient(q.sigma, q.alpha, q.degree, tuple(map(Percept, q.degree, q.marks)), sheets)


@dataclass(slots=True)
class Met:
    """Counts and quotients of a part of a level.

    Attributes:
        worlds: rooted maps.
        marked_worlds: maps with one marked vertex, up to isomorphism.
        ambiguous: how many of these are ambiguous, by their quotient: see :func:`_least`.
    """

    worlds: Natural = 0
    marked_worlds: Natural = 0
    ambiguous: Counter[Annotated[Quotient, Form(_to_kept, _from_kept)]] = field(
        default_factory=Counter
    )

    def add(self, other: Met) -> None:
        """Add the counts of another part."""
        self.worlds += other.worlds
        self.marked_worlds += other.marked_worlds
        self.ambiguous.update(other.ambiguous)

    @property
    def sizes(self) -> list[int]:
        """How many members each class of the ambiguous has."""
        return [*self.ambiguous.values()]

    def smallest_pair(self) -> ComparedWorlds | None:
        """Return None, because ``ambiguity class`` lists the members."""
        return None

    def meet(self, map_: CombinatorialMap) -> None:
        """Count one rooted map. Of the maps that differ only in the root at v0 one is counted."""
        self.worlds += 1
        if not is_least_rooting(map_):
            return
        self.marked_worlds += 1
        # A marked vertex of degree 1 has one dart, so k = 1: never ambiguous.
        if map_.sigma[0] != 0:
            quotient = projection_of(World(map_, Position(0), 0)).quotient
            if is_ambiguous(quotient):
                self.ambiguous[_least(quotient)] += 1


@dataclass(frozen=True, slots=True)
class Classify:
    """The engine of the census."""

    extent: Extent

    def parts(self, unit: LevelUnit) -> Iterator[Met]:
        """Classify the maps of the unit, and yield results from time to time."""
        met = Met()
        for map_ in unit.maps(self.extent):
            met.meet(map_)
            if met.worlds == BATCH:
                yield met
                met = Met()
        yield met


def _least(quotient: Quotient) -> Quotient:
    """The quotient rooted at the marked vertex, where its code is least."""
    return min((quotient.rerooted(q) for q in quotient.vertices[0]), key=_code)


def _code(quotient: Quotient) -> tuple[tuple[int, ...], tuple[int, ...], tuple[int, ...]]:
    return quotient.sigma, quotient.alpha, quotient.degree


def _check_sizes(met: Met) -> None:
    """Raise Disagreement unless each class has as many worlds as Burnside's count says."""
    for quotient, members in met.ambiguous.items():
        if members != class_size(quotient):
            raise Disagreement(
                f"{members} worlds were met of a class of {class_size(quotient)}, "
                f"with the quotient {quotient}"
            )
