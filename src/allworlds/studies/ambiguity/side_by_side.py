"""The comparison of sensors: what can a robot tell apart under each lighthouse?

For each sensor the smallest worlds that look alike are found.  Of two sensors it is found out which
one tells more worlds apart.
"""

from collections.abc import Hashable, Sequence
from itertools import permutations
from typing import Annotated, Any

from msgspec import Struct, field
from typing_extensions import override

from allworlds import outcome
from allworlds.documents import document as doc
from allworlds.documents.report import Report
from allworlds.engines import units
from allworlds.inputs import checks, requests
from allworlds.maps import classes, count_source
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.quotient import classes_of_union
from allworlds.notations.given import GivenOptions
from allworlds.protocol.actions import Percept
from allworlds.studies.ambiguity.census_sweep import batches
from allworlds.studies.ambiguity.members import ensure_motions_decide
from allworlds.studies.ambiguity.sensed_classes import LitMap, matrices, named
from allworlds.studies.options import ListenerOptions
from allworlds.studies.scopes import FileDigests, GivenCount, TriedPlaces, as_scope
from allworlds.world.bisimulation import flaw
from allworlds.world.lighthouses import kinds, options
from allworlds.world.selection import WhereOptions, tried_kind
from allworlds.world.world import World

LEGAL = f"{checks.one_of(kinds.LIGHTHOUSES)}, {kinds.OWN}, or several with + between them"


def _kinds(given: object) -> tuple[kinds.LighthouseKind, ...]:
    if isinstance(given, str) or not isinstance(given, Sequence) or not given:
        raise checks.InputError(f"lighthouses = {checks.show(given)} names none; legal are {LEGAL}")
    return tuple(dict.fromkeys(map(tried_kind, given)))


class ManyWorldsOptions(ListenerOptions, WhereOptions, GivenOptions, classes.ExtentOptions):
    """The part of a request that names the worlds in which sensors are compared."""


class SensorsRequest(ManyWorldsOptions):
    """Request of ``ambiguity sensors``: the lighthouses, and the worlds."""

    lighthouses: Annotated[
        requests.Converted[Sequence[kinds.GivenLighthouse], tuple[kinds.LighthouseKind, ...]],
        requests.Argument("", "LIGHTHOUSE...", f"{LEGAL}.", repeated=True),
    ] = requests.Converted(_kinds, ())


class AlikePair(doc.Document):
    """Two worlds that no motion tells apart, with the proof.

    ``shown`` are the two worlds that the proof is about; their lighthouse may be a coarser sensor
    than that of ``worlds``.
    """

    worlds: Annotated[doc.Pair[World], doc.about("two maps, or one map with two starts")]
    sensed: Annotated[
        doc.Pair[doc.Some[Percept]], doc.about("for each world what is sensed at each dart")
    ]
    bisimulation: Annotated[
        doc.Pair[doc.Some[doc.Natural]], doc.about("for each world the class of each dart")
    ]
    shown: doc.NotInDocument[tuple[World, ...]] = ()

    @classmethod
    def of(cls, worlds: Sequence[World], shown: Sequence[World] = ()) -> "AlikePair":
        """Return two worlds with the proof that they look alike, after a check of the proof.

        Args:
            worlds: the two worlds.
            shown: the same two worlds with a coarser sensor as their lighthouse, if the proof is
                for this sensor; empty if the worlds look alike under their own lighthouses.

        Raises:
            Disagreement: if the proof is wrong.
        """
        seen = tuple(shown or worlds)
        proof = classes_of_union(*((world.map, world.percepts, world.start) for world in seen))
        if wrong := flaw(seen, proof):
            raise outcome.Disagreement(f"the proof about {seen} is wrong: {wrong}")
        sensed = tuple(world.percepts for world in seen)
        return cls(worlds=tuple(worlds), sensed=sensed, bisimulation=proof, shown=seen)


class SensorRow(doc.Document):
    """A sensor, and the worlds that look alike under this sensor."""

    lighthouse: Annotated[doc.Text, doc.about("`KIND[:key=value,...]`")]
    sufficient: Annotated[
        bool | None,
        doc.about("whether no two worlds of the scope look alike; null: it has no place in any"),
    ]
    first: Annotated[
        doc.Positive | None, doc.about("edges of the first worlds that look alike; null: none do")
    ]
    ambiguous: Annotated[
        doc.Natural, doc.about("rooted maps with so many edges at most that look like another one")
    ]
    twins: Annotated[doc.IfAny[AlikePair | None], doc.about("the smallest two that look alike")]
    worlds: Annotated[doc.Natural, doc.about("places of the lighthouse in all rooted maps")]
    places: Annotated[
        doc.Natural, doc.about("the number of the first sensor that has the same places")
    ]
    tried: TriedPlaces


@doc.with_options(ManyWorldsOptions)
class SensorsScope(doc.Document):
    """The scope of a comparison of sensors."""

    given: GivenCount
    sha256: FileDigests


class AmbiguitySensors(Report, kw_only=True):
    """Report of 'ambiguity sensors'.

    Sensors, compared in the same worlds.  A sensor does not suffice if two worlds look alike under
    it and their maps differ, or the worlds have the same map with two different starts.

    In each pair of ``dominates``, the first sensor tells apart all worlds that the second one tells
    apart, and perhaps more: two worlds that look alike under the first sensor also look alike under
    the second one.
    """

    scope: SensorsScope
    rows: Annotated[tuple[SensorRow, ...], doc.about("one a sensor, as they were named")]
    dominates: Annotated[
        tuple[doc.Pair[doc.Text], ...],
        doc.about("of two with equal places: worlds alike under the first are so under the second"),
    ]
    coarser: Annotated[
        tuple[doc.Pair[doc.Text], ...],
        doc.about(
            "of two with equal places: what the first senses at a dart follows from what the "
            "second senses there"
        ),
    ]
    minimal: Annotated[
        tuple[doc.Text, ...],
        doc.about("the sufficient ones to which no other sufficient one is strictly coarser"),
    ]
    extent: doc.NotInDocument[classes.Extent]

    @property
    @override
    def facts(self) -> outcome.Facts:
        return outcome.Facts(vacuous=not any(row.worlds for row in self.rows))


class Sensor(Struct):
    """A sensor, with its percepts in every world.

    Attributes:
        kind: the kind of lighthouse.
        worlds: the rooted maps, each with every place of the lighthouse.
        roots: for each world the number of its rooted map.
        places: for each world the number of its rooted map, and the place of the lighthouse.
        looks: for each world a text; two texts are equal if and only if the worlds look alike.
        names: for each world a text that is equal for isomorphic worlds.
        sensed: for each dart of each world the percept there; if the lighthouse tells the robot a
            value before the start, also this value.
    """

    kind: kinds.LighthouseKind
    worlds: list[LitMap] = field(default_factory=list)
    roots: list[int] = field(default_factory=list)
    places: list[Any] = field(default_factory=list)
    looks: list[str] = field(default_factory=list)
    names: list[str] = field(default_factory=list)
    sensed: list[Hashable] = field(default_factory=list)

    def meet(self, worlds: Sequence[LitMap], number: dict[CombinatorialMap, int]) -> None:
        """Add worlds that are no smaller than the earlier ones.

        ``number`` has the number of each rooted map that was met so far under any of the sensors;
        new maps of these worlds are added to ``number``.
        """
        arrays = matrices(worlds)
        in_order = zip(worlds, named(arrays), arrays.sensed.tolist(), strict=True)
        for (map_, lighthouse), found, sensed in in_order:
            root, told = number.setdefault(map_, len(number)), lighthouse.told(map_)
            self.worlds.append((map_, lighthouse))
            self.roots.append(root)
            self.places.append((root, _place(lighthouse)))
            self.looks.append(found.look)
            self.names.append(found.name)
            self.sensed += sensed if told is None else ((each, str(told)) for each in sensed)

    def row(self, edges: int, places: int) -> SensorRow:
        """The row of the sensor in the table of the report.

        Args:
            edges: the number of edges of the largest maps.
            places: the index, from 0 on, of a sensor in the table: of the first sensor whose
                lighthouse has the same places in all maps as the lighthouse of this sensor.  Two
                sensors are compared with each other only if their rows have the same index here.
        """
        first: dict[str, int] = {}
        fails, alike, roots = None, list[tuple[int, int]](), set[int]()
        for number, (map_, _) in enumerate(self.worlds):
            if fails is not None and map_.edge_count > fails:
                break
            one = first.setdefault(self.looks[number], number)
            if self.roots[one] != self.roots[number]:
                fails = map_.edge_count
                alike.append((one, number))
                roots |= {self.roots[one], self.roots[number]}
        # Two different maps are shown, if there are some, and not one from two starts.
        pair = min(alike, default=None, key=lambda two: len({self.names[i] for i in two}) < 2)
        return SensorRow(
            lighthouse=self.kind.name,
            sufficient=not alike if self.worlds else None,
            first=fails,
            ambiguous=len(roots),
            twins=AlikePair.of([World(*self.worlds[each], 0) for each in pair]) if pair else None,
            worlds=len(self.worlds),
            places=places,
            tried=self.kind.as_class.tried_in_maps_of(edges),
        )


def _place(lighthouse: Any) -> list[Any]:
    """Pairs (name, value) of the fields of a lighthouse that say where it stands.

    The kind of the lighthouse is not in the pairs: two lighthouses of different kinds that stand at
    the same place have equal pairs.
    """
    return [
        (key, getattr(part, key))
        for part in kinds.parts_of(lighthouse)
        for key in options.place_keys(type(part))
        if key not in options.options_of(type(part))
    ]


def compared(request: SensorsRequest) -> AmbiguitySensors:
    """Answer a request of ``ambiguity sensors``."""
    extent, number = request.extent, dict[CombinatorialMap, int]()
    found = [Sensor(request.lighthouse_of_given(kind)) for kind in request.lighthouses]
    for sensor in found:
        ensure_motions_decide(sensor.kind, "sensors are compared by motions alone")
    for edges in extent.levels:
        for sensor in found:
            for some in worlds_of_level(request, extent, edges, sensor.kind):
                sensor.meet(some, number)
    places = [sensor.places for sensor in found]
    rows = tuple(
        sensor.row(extent.levels[-1], places.index(places[i])) for i, sensor in enumerate(found)
    )
    beside = [(a, b) for a, b in permutations(found, 2) if a.places == b.places]
    dominates, coarser = (
        tuple((a.kind.name, b.kind.name) for a, b in pairs)
        for pairs in (
            [(a, b) for a, b in beside if _follows(b.looks, a.looks)],
            [(a, b) for a, b in beside if _follows(a.sensed, b.sensed)],
        )
    )
    enough = {row.lighthouse for row in rows if row.sufficient}
    finer = {b for a, b in coarser if a in enough and (b, a) not in coarser}
    return AmbiguitySensors(
        scope=as_scope(SensorsScope, request),
        rows=rows,
        dominates=dominates,
        coarser=coarser,
        minimal=tuple(row.lighthouse for row in rows if row.lighthouse in enough - finer),
        extent=extent,
    )


def _follows(one: Sequence[Hashable], other: Sequence[Hashable]) -> bool:
    """Whether ``one`` has equal values at two indices whenever ``other`` has equal values there."""
    return len({*zip(other, one, strict=True)}) == len({*other})


@requests.takes_fields(SensorsRequest, several="lighthouses", answered=compared)
def sensors(*lighthouses: kinds.GivenLighthouse, **asked: Any) -> AmbiguitySensors:
    """Compare sensors: which of them suffice in all small worlds?

    A sensor suffices if no two different rooted maps look alike to a robot, with the lighthouse at
    any of its places.  The keywords are the options of :class:`SensorsRequest`, such as ``edges``.

    Raises:
        InputError: naming the offending option and what would be legal.

    Cost: that of :func:`allworlds.studies.ambiguity.census` for each sensor, and 300 bytes of
    memory for each world of a sensor.
    """
    return compared(SensorsRequest(lighthouses=lighthouses, **asked))


def worlds_of_level(
    request: ListenerOptions, extent: classes.Extent, edges: int, kind: kinds.LighthouseKind
) -> list[list[LitMap]]:
    """The worlds with ``edges`` edges under a lighthouse of this kind, in batches.

    The number of rooted maps is compared with that of an independent source.  The listener of
    ``request`` is told of the progress.

    Raises:
        Disagreement: if the independent source gives another number of maps.
    """
    expected = units.level_size(extent, edges)
    request.listener.level(edges, expected)
    maps, found = 0, list[list[LitMap]]()
    for unit in units.units_of_level(extent, edges):
        for some, worlds in batches(unit, extent, kind):
            maps += some
            found.append(worlds)
            request.listener.progress(some)
    source = count_source.source_of(extent)
    if source and maps != expected:
        raise outcome.Disagreement(
            f"{maps} rooted maps with {edges} edges were met, but {source.name} counts {expected}"
        )
    return found
