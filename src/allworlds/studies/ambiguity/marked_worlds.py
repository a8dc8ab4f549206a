"""The census: every map with a marked vertex, and which of them cannot be told apart."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self, TypeAlias

from allworlds.engines import (
    ENDED,
    UNMERGEABLE,
    WHOLE,
    Dask,
    Identity,
    LevelUnit,
    Portion,
    Records,
    Shard,
    ThisThread,
    Transport,
    a_shard,
    gather,
    level_size,
    records_in,
    shards_of,
    shelf,
    tell_of_size,
    units_of_level,
)
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
from allworlds.outcome import SCHEMA, Exit, until_interrupted
from allworlds.progress import Listener, Silent
from allworlds.protocol import Percept
from allworlds.studies.ambiguity.marked_code import is_least_rooting
from allworlds.studies.ambiguity.members import projection_of, quotient_to_json
from allworlds.world import Position, World

if TYPE_CHECKING:
    from allworlds import documents

CORES = os.cpu_count() or 1
"""So many processes a cluster of this machine alone has."""

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
        sizes: how many ambiguity classes have 2, 3, ... members inside the class of maps; None
            of a shard, which may hold some members of a class and not others.
    """

    edges: int
    rooted: int = 0
    counted: int = 0
    marked_worlds: int = 0
    sizes: Counter[int] | None = field(default_factory=Counter)

    @property
    def ambiguous_worlds(self) -> int | None:
        """The members of all these classes; None of a shard."""
        if self.sizes is None:
            return None
        return sum(size * times for size, times in self.sizes.items())

    @property
    def classes(self) -> int | None:
        """Their number; None of a shard."""
        return None if self.sizes is None else sum(self.sizes.values())

    @property
    def largest_class(self) -> int | None:
        """The members of the largest one; 0 if there is none, None of a shard."""
        return None if self.sizes is None else max(self.sizes, default=0)

    def to_json(self) -> documents.CensusRowDocument:
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
        portion: which part of the maps was looked at.
    """

    extent: Extent
    source: str
    rows: tuple[CensusRow, ...]
    complete: bool = True
    portion: Portion = WHOLE

    @property
    def agrees(self) -> bool:
        """As many rooted maps were met as the source counts; of a shard no more than these."""
        if isinstance(self.portion, Shard):
            return all(row.rooted <= row.counted for row in self.rows)
        return all(row.rooted == row.counted for row in self.rows)

    @property
    def exit_code(self) -> Exit:
        """0 counted, 4 nothing to count, 70 the source disagrees, 130 interrupted."""
        if not self.agrees:
            return Exit.DISAGREES
        if not self.complete:
            return Exit.INTERRUPTED
        met = isinstance(self.portion, Shard) or any(row.marked_worlds for row in self.rows)
        return Exit.ANSWERED if met else Exit.VACUOUS

    def to_json(self) -> documents.AmbiguityCensusDocument:
        """The document of ``ambiguity census --json``."""
        return {
            "schema": SCHEMA,
            "class": self.extent.map_class.value,
            "edges": self.extent.edges,
            "vertices": self.extent.vertices,
            "lighthouse": Position.kind,
            "shard": str(self.portion),
            "gate": {"source": self.source, "agrees": self.agrees},
            "complete": self.complete,
            "rows": [row.to_json() for row in self.rows],
        }


def census(
    *,
    edges: int | None = None,
    vertices: int | None = None,
    map_class: str = MapClass.MAPS.value,
    shard: tuple[int, int] | None = None,
    run: str | Path | None = None,
    dask: str | None = None,
    listener: Listener | None = None,
) -> AmbiguityCensus:
    """Every map of a class with every choice of a marked vertex, up to isomorphism.

    Args:
        edges: the largest number of edges.
        vertices: the largest number of vertices; alone only for the simple classes.
        map_class: one of :class:`~allworlds.maps.classes.MapClass`.
        shard: ``(K, N)``: only the K-th of N parts of about equal weight, from 0.
        run: a directory that keeps what is finished; the same census goes on from there.
        dask: the address of a Dask scheduler, or ``local``: where the work is done.
        listener: told how far it is.

    Raises:
        InputError: naming the offending option and what would be legal.

    Cost: some 100 microseconds a rooted map; memory for the ambiguous quotients of a level.
    """
    task = _CensusTask(Extent(MapClass.named(map_class), edges, vertices), a_shard(shard))
    heard = listener or Silent()
    tell_of_size(task.extent, heard, shards_of(task.portion))
    if run is None and isinstance(task.portion, Shard):
        heard.notice(UNMERGEABLE)
    transport = ThisThread() if dask is None else Dask(dask, CORES)
    with records_in(run, task.identity, heard.notice) as records, transport as there:
        return task.census(there, Classify(task.extent), records, heard)


def merged_census(identity: Identity, records: Records, listener: Listener) -> AmbiguityCensus:
    """The census that others have made, from what they have kept.

    Raises:
        Gap: if something is missing.
    """
    told = identity.parameters
    extent = Extent(MapClass(told["class"]), told["edges"], told["vertices"])
    with ThisThread() as here:
        return _CensusTask(extent, WHOLE).census(here, None, records, listener)


@dataclass(frozen=True, slots=True)
class _CensusTask:
    """What is classified."""

    extent: Extent
    portion: Portion

    def identity(self) -> Identity:
        parameters = {
            "class": self.extent.map_class.value,
            "edges": self.extent.edges,
            "vertices": self.extent.vertices,
        }
        return Identity(
            verb="ambiguity census",
            parameters=parameters,
            explorer={"name": ""},
            shard=str(self.portion),
        )

    def census(
        self, transport: Transport[Any], engine: Any, records: Records, listener: Listener
    ) -> AmbiguityCensus:
        extent = self.extent
        kept = shelf(records, Met.from_json)

        def row(edges: int) -> CensusRow:
            size = level_size(extent, edges)
            listener.level(edges, size // shards_of(self.portion))
            met = Met()
            units = units_of_level(extent, edges, self.portion)
            gather(transport, engine, units, met, listener, kept)
            if isinstance(self.portion, Shard):
                return CensusRow(edges, met.worlds, size, met.marked_worlds, None)
            if extent.map_class is MapClass.MAPS:
                _check_sizes(met)
            sizes = Counter(members for _, members in met.ambiguous.values() if members > 1)
            return CensusRow(edges, met.worlds, size, met.marked_worlds, sizes)

        rows, complete = until_interrupted(row(edges) for edges in extent.levels)
        if complete:
            records.note("ended", ENDED)
        source = source_for(extent.map_class).name
        return AmbiguityCensus(extent, source, rows, complete, self.portion)


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

    def to_json(self) -> dict[str, Any]:
        """All of it, as it is kept in a run directory."""
        return {
            "worlds": self.worlds,
            "marked_worlds": self.marked_worlds,
            "ambiguous": [
                [quotient_to_json(quotient), quotient.sheets, members]
                for _, (quotient, members) in sorted(self.ambiguous.items())
            ],
        }

    @classmethod
    def from_json(cls, document: dict[str, Any]) -> Self:
        """The part of :meth:`to_json`'s document."""
        met = cls(document["worlds"], document["marked_worlds"])
        for told, sheets, members in document["ambiguous"]:
            degree = tuple(told["degree"])
            labels = tuple(map(Percept, degree, told["marks"]))
            sigma, alpha = tuple(told["sigma"]), tuple(told["alpha"])
            quotient = Quotient(sigma, alpha, degree, labels, sheets)
            met._count(_key(quotient), quotient, members)  # its own kind
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
