"""The census: every map with a marked vertex, and which of them cannot be told apart."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Annotated, Any, Literal, Self

from allworlds.document import (
    AllRows,
    Aside,
    Bounded,
    Document,
    Gate,
    Natural,
    Positive,
    Report,
    WhichShard,
    about,
    computed,
    key,
    replace,
    taken,
)
from allworlds.engines import (
    ENDED,
    UNMERGEABLE,
    WHOLE,
    Dask,
    Identity,
    LevelUnit,
    Listener,
    Portion,
    Records,
    Shard,
    ThisThread,
    Transport,
    gather,
    level_size,
    records_in,
    shards_of,
    shelf,
    tell_of_size,
    units_of_level,
)
from allworlds.inputs import answers, meant, remembered
from allworlds.maps import (
    CombinatorialMap,
    Disagreement,
    Extent,
    MapClass,
    Quotient,
    class_size,
    is_ambiguous,
    source_for,
)
from allworlds.outcome import Exit, until_interrupted
from allworlds.protocol import Percept
from allworlds.studies.ambiguity.ambiguity_requests import CensusRequest
from allworlds.studies.ambiguity.marked_code import is_least_rooting
from allworlds.studies.ambiguity.members import SensedQuotient, projection_of
from allworlds.world import Position, World

CORES = os.cpu_count() or 1
"""So many processes a cluster of this machine alone has."""

BATCH = 200
"""Maps after which a part of a unit is handed over."""


class CensusRow(Document):
    """The marked maps with one number of edges.

    So many ``rooted`` maps were met, and the independent source ``counted``.  A shard may hold some
    members of a class and not others.
    """

    edges: Positive
    marked_worlds: Annotated[Natural, about("maps with one marked vertex, up to isomorphism")]
    ambiguous_worlds: Annotated[
        Natural | None, about("those with a twin inside the class of maps; null: of a shard")
    ] = None
    classes: Annotated[
        Natural | None,
        about("ambiguity classes with two members there, or more; null: of a shard"),
    ] = None
    largest_class: Annotated[
        Natural | None, about("the members of the largest; 0: there is none, null: of a shard")
    ] = None
    rooted: Aside[int]
    counted: Aside[int]


def _gate(census: AmbiguityCensus) -> Gate:
    """Whether as many rooted maps were met as the source counts; of a shard no more than these."""
    if census.whole:
        agrees = all(row.rooted == row.counted for row in census.rows)
    else:
        agrees = all(row.rooted <= row.counted for row in census.rows)
    return Gate(source=census.source, agrees=agrees)


class AmbiguityCensus(Report):
    """Report of 'ambiguity census'.

    Every level of a class of maps; twins are looked for inside the class only.
    """

    map_class: Annotated[MapClass, about("the class of maps")] = key(name="class")
    edges: Bounded
    vertices: Bounded
    lighthouse: Literal["position"] = "position"
    shard: WhichShard = str(WHOLE)
    gate: Annotated[Gate, about("the comparison of the rooted maps with an independent source")] = (
        computed(_gate)
    )
    complete: AllRows = True
    rows: Annotated[tuple[CensusRow, ...], about("one a number of edges, ascending")]
    source: Aside[str]

    @property
    def whole(self) -> bool:
        """It is not of a shard."""
        return self.shard == str(WHOLE)

    @property
    def exit_code(self) -> Exit:
        """0 counted, 4 nothing to count, 70 the source disagrees, 130 interrupted."""
        if not self.gate.agrees:
            return Exit.DISAGREES
        if not self.complete:
            return Exit.INTERRUPTED
        met = not self.whole or any(row.marked_worlds for row in self.rows)
        return Exit.ANSWERED if met else Exit.VACUOUS


@answers(CensusRequest)
def census(request: CensusRequest) -> AmbiguityCensus:
    """Every map of a class with every choice of a marked vertex, up to isomorphism.

    Raises:
        InputError: naming the offending option and what would be legal.

    Cost: some 100 microseconds a rooted map; memory for the ambiguous quotients of a level.
    """
    task = _CensusTask(request.extent, request.shard)
    run, dask, heard = request.run, request.dask, request.listener
    tell_of_size(task.extent, heard, shards_of(task.portion))
    if run is None and isinstance(task.portion, Shard):
        heard.notice(UNMERGEABLE)
    transport = ThisThread() if dask is None else Dask(dask, CORES)
    with records_in(run, lambda: _identity(request), heard.notice) as records, transport as there:
        return task.census(there, Classify(task.extent), records, heard)


def _identity(request: CensusRequest) -> Identity:
    return Identity(
        verb="ambiguity census",
        parameters=meant(request),
        explorer={"name": ""},
        shard=str(request.shard),
    )


def merged_census(identity: Identity, records: Records, listener: Listener) -> AmbiguityCensus:
    """The census that others have made, from what they have kept.

    Raises:
        Gap: if something is missing.
    """
    request = CensusRequest(**remembered(CensusRequest, identity.parameters))
    with ThisThread() as here:
        return _CensusTask(request.extent, WHOLE).census(here, None, records, listener)


@dataclass(frozen=True, slots=True)
class _CensusTask:
    """What is classified."""

    extent: Extent
    portion: Portion

    def census(
        self, transport: Transport[Any], engine: Any, records: Records, listener: Listener
    ) -> AmbiguityCensus:
        extent = self.extent
        kept = shelf(records, Met.from_json)

        def level(edges: int) -> CensusRow:
            size = level_size(extent, edges)
            listener.level(edges, size // shards_of(self.portion))
            met = Met()
            units = units_of_level(extent, edges, self.portion)
            gather(transport, engine, units, met, listener, kept)
            row = CensusRow(
                edges=edges, marked_worlds=met.marked_worlds, rooted=met.worlds, counted=size
            )
            if isinstance(self.portion, Shard):
                return row
            if extent.map_class is MapClass.MAPS:
                _check_sizes(met)
            sizes = [members for members in met.ambiguous.values() if members > 1]
            return replace(
                row,
                ambiguous_worlds=sum(sizes),
                classes=len(sizes),
                largest_class=max(sizes, default=0),
            )

        rows, complete = until_interrupted(level(edges) for edges in extent.levels)
        if complete:
            records.note("ended", ENDED)
        return AmbiguityCensus(
            map_class=extent.map_class,
            edges=extent.edges,
            vertices=extent.vertices,
            shard=str(self.portion),
            complete=complete,
            rows=rows,
            source=source_for(extent.map_class).name,
        )


class KeptMet(Document):
    """What a run directory keeps of a part of a level."""

    worlds: Natural
    marked_worlds: Natural
    ambiguous: Annotated[
        tuple[tuple[SensedQuotient, Positive, Positive], ...],
        about("the quotients, each with its sheets and with how many worlds were met of it"),
    ]


@dataclass(slots=True)
class Met:
    """What a part of a level holds.

    Attributes:
        worlds: rooted maps.
        marked_worlds: maps with one marked vertex, up to isomorphism.
        ambiguous: how many of these are ambiguous, by their quotient: see :func:`_least`.
    """

    worlds: int = 0
    marked_worlds: int = 0
    ambiguous: Counter[Quotient] = field(default_factory=Counter)

    def add(self, other: Met) -> None:
        """Take in another part."""
        self.worlds += other.worlds
        self.marked_worlds += other.marked_worlds
        self.ambiguous.update(other.ambiguous)

    def to_json(self) -> dict[str, Any]:
        """All of it, as it is kept in a run directory."""
        met = sorted(self.ambiguous.items(), key=lambda entry: _code(entry[0]))
        return KeptMet(
            worlds=self.worlds,
            marked_worlds=self.marked_worlds,
            ambiguous=tuple((SensedQuotient.of(q), q.sheets, members) for q, members in met),
        ).to_json()

    @classmethod
    def from_json(cls, document: object) -> Self:
        """The part of :meth:`to_json`'s document."""
        kept = taken(document, KeptMet, "a unit of a census")
        met = cls(kept.worlds, kept.marked_worlds)
        for q, sheets, members in kept.ambiguous:
            labels = tuple(map(Percept, q.degree, q.marks))
            met.ambiguous[_least(Quotient(q.sigma, q.alpha, q.degree, labels, sheets))] = members
        return met

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
                self.ambiguous[_least(quotient)] += 1


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


def _least(quotient: Quotient) -> Quotient:
    """The quotient, rooted so at its marked vertex that its code is least."""
    return min((quotient.rerooted(q) for q in quotient.vertices[0]), key=_code)


def _code(quotient: Quotient) -> tuple[tuple[int, ...], tuple[int, ...], tuple[int, ...]]:
    return quotient.sigma, quotient.alpha, quotient.degree


def _check_sizes(met: Met) -> None:
    """Nothing, if as many worlds were met of each class as Burnside's count says."""
    for quotient, members in met.ambiguous.items():
        if members != class_size(quotient):
            raise Disagreement(
                f"{members} worlds were met of a class of {class_size(quotient)}, "
                f"with the quotient {quotient}"
            )
