"""The scope of a check, and the units into which its levels are cut.

A scope holds every option on which the counts and the verdict depend.  A level is all worlds with
one number of edges.  A unit is a piece of a level.  A shard is some of the units of every level, so
that several machines can share a job.  An extent is a class of maps with bounds on their size.
"""

import re
from collections.abc import Iterable, Iterator, Sequence
from heapq import heapreplace
from math import inf
from random import Random
from typing import Annotated, Any, ClassVar, Protocol, Self, TypeAlias

from msgspec import Struct
from msgspec.structs import force_setattr
from typing_extensions import override

from allworlds.documents.document import replace
from allworlds.engines.listeners import Listener
from allworlds.inputs.checks import InputError, an_integer, at_most, show
from allworlds.inputs.requests import RARE_SCOPE, Converted, Option, Request
from allworlds.judging.findings.finding import Finding, labelled
from allworlds.judging.rules import Rules
from allworlds.maps import combinatorial, count_source, counting
from allworlds.maps.classes import Extent
from allworlds.maps.enumeration import Gluing, prefixes, rooted_maps
from allworlds.notations.given import GivenMap, GivenMaps, MapWithPlaces
from allworlds.protocol.choices import Schedule
from allworlds.world.lighthouses.base import Lighthouse
from allworlds.world.lighthouses.composed import Nothing
from allworlds.world.world import World


class Unit(Protocol):
    """A piece of work for one worker; its content does not depend on the number of workers."""

    @property
    def key(self) -> str:
        """The name that this unit has among the units of one job."""


class Sum(Protocol):
    """The result of some units; such results can be added up in any order.

    The class of a result is a dataclass, because a run directory keeps its fields.
    """

    @property
    def worlds(self) -> int:
        """The number of worlds that the result is about."""

    def add(self, other: Any, /) -> None:
        """Add the result of other units, or of another part of a unit, to this result."""


class PartialResult(Struct, frozen=True):
    """A part of a unit's result.

    Attributes:
        unit: the unit.
        result: the part, which the receiver adds to the earlier parts of this unit.
        last: whether this is the last part of the unit's result.
        anew: whether the unit is begun anew, because a process was lost; the receiver must drop the
            earlier parts of the unit.
        walk: the number of the explorer's turns in the longest run in progress, and the largest
            legal number of traversals in that run; None if no run is in progress.
    """

    unit: Any
    result: Any
    last: bool
    anew: bool = False
    walk: tuple[int, int] | None = None


class UnitEngine(Protocol):
    """An engine computes the results of the units of a job."""

    def parts(self, unit: Any) -> Iterator[Any]:
        """Yield the result of a unit in one or more parts, whose sum is the whole result."""


class Transport(Protocol):
    """A transport brings units to engines; all work ends at the end of its ``with`` block."""

    def __enter__(self) -> Self: ...

    def __exit__(self, *_: object) -> None: ...

    def map(self, engine: Any, units: Iterable[Any], /) -> Iterator[PartialResult]:
        """Yield the parts of the units' results, in the order in which the parts are ready.

        Raises:
            TimeIsUp: when the time limit has been reached.
        """


class Shard(Struct, frozen=True):
    """One of several parts of a job; each unit of each level is dealt to one of these parts.

    The field ``coverage`` of a scope is a shard or a :class:`Sample`.  It says which worlds are
    tried: all worlds of a shard's units, or random worlds.  Both classes have the attributes
    ``drawn``, ``finished`` and ``min_edges``, so that code need not ask which of the two it has.

    Attributes:
        index: the number of this part, from 0 on.
        count: the number of parts.
        drawn: False, because no world is drawn at random.
        finished: the words by which reports name the finished worlds.
        min_edges: the least number of edges of a world.

    Raises:
        InputError: if the index or the count is no integer, or is out of range.
    """

    index: int
    count: int

    drawn: ClassVar[bool] = False
    finished: ClassVar[str] = "finished levels"
    min_edges: ClassVar[int] = 1

    @property
    def portion(self) -> "Shard":
        """The part of the units that is done: this shard itself."""
        return self

    def __post_init__(self) -> None:
        for name, key in (("K", "index"), ("N", "count")):
            force_setattr(self, key, an_integer(f"shard {name}", getattr(self, key)))
        if self.count < 1 or not 0 <= self.index < self.count:
            raise InputError(f"shard {self} is out of range; K/N needs 0 <= K < N, counted from 0")

    def __str__(self) -> str:
        return f"{self.index}/{self.count}"


WHOLE = Shard(0, 1)
"""The shard with all units of a job."""


def shard_numbers(text: str) -> tuple[int, int]:
    """The numbers K and N of a text of the form ``K/N``.

    Raises:
        InputError: for any other text.
    """
    match = re.fullmatch(r"([0-9]{1,9})/([0-9]{1,9})", text)
    if match is None:
        legal = f"counted from 0; N is at most {10**9 - 1}"
        raise InputError(f"shard {show(text)} is not of the form K/N, {legal}")
    return int(match[1]), int(match[2])


def a_shard(pair: object) -> Shard:
    """The shard that a value names: a pair ``(K, N)``, None for :data:`WHOLE`, or a shard.

    Raises:
        InputError: for any other value.
    """
    if pair is None:
        return WHOLE
    if isinstance(pair, Shard):
        return pair
    if not isinstance(pair, tuple | list) or len(pair) != 2:
        raise InputError(f"shard = {show(pair)} is not a pair (K, N)")
    return Shard(*pair)


class ShardOptions(Request):
    """The part of a request that names the shard."""

    shard: Annotated[
        Converted[tuple[int, int] | Shard | None, Shard],
        Option(
            RARE_SCOPE,
            "K/N",
            "Only the K-th of N parts of about equal weight, from 0.",
            parse=shard_numbers,
            default="0/1",
            apart=True,
        ),
    ] = Converted(a_shard, None)

    @property
    @override
    def in_effect(self) -> dict[str, Any]:
        return {**super().in_effect, "shard": str(self.shard)}


def dealt(weights: Sequence[int], shard: Shard) -> Iterator[int]:
    """The indices, in ascending order, of the units that belong to a shard.

    Item i of ``weights`` is the weight of unit i, such as its number of worlds.  The units are
    dealt from the heaviest to the lightest; each goes to the shard with the smallest weight so far.
    Of equally heavy units, and of equally heavy shards, the one with the smallest index comes
    first.
    """
    heaviest = sorted(range(len(weights)), key=lambda i: (-weights[i], i))
    loads = [(0, index) for index in range(min(shard.count, len(weights)))]
    mine = []
    for i in heaviest:
        load, index = loads[0]
        if index == shard.index:
            mine.append(i)
        heapreplace(loads, (load + weights[i], index))
    yield from sorted(mine)


MANY_WORLDS = 10_000_000
"""The number of worlds above which the user is told the size before the first level."""

COUNTABLE_WORLDS = 10**12
"""The number of worlds of a level above which even counting them takes long."""

_LONG = "this takes long, or does not end; an interrupt ends it with what is finished"


class LevelUnit(Struct, frozen=True):
    """All maps with ``edges`` edges whose first decisions are ``prefix``.

    The enumeration makes each map by a list of decisions.
    """

    edges: int
    prefix: tuple[int, ...]

    @property
    def key(self) -> str:
        """The name of the unit, in the form ``EDGES:DECISION,DECISION,...``."""
        return f"{self.edges}:{','.join(map(str, self.prefix))}"

    def maps(self, extent: Extent) -> Iterator[combinatorial.CombinatorialMap]:
        """The maps of the unit that are in the extent, rooted at dart 0, as they are enumerated."""
        return rooted_maps(self.edges, extent.map_class, extent.vertices, self.prefix, extent.where)

    def placed(self, extent: Extent, kind: type[Lighthouse]) -> Iterator[MapWithPlaces]:
        """The maps of the unit that are in the extent, each with all places of a lighthouse.

        ``kind`` is the kind of the lighthouse.
        """
        for map_ in self.maps(extent):
            yield map_, list(enumerate(kind.places(map_, 0)))

    def weight(self, extent: Extent) -> int:
        """The number of maps of the unit; in simple classes and under conditions an upper bound.

        ``extent`` holds the class and the condition of the maps.
        """
        gluing = Gluing(self.edges, extent.map_class, extent.vertices, extent.where)
        for decision in self.prefix:
            gluing.apply(decision)
        return count_source.completions(gluing)


DEPTHS = ((6, 1), (9, 2), (inf, 3))
"""Pairs of a number of edges and a number of decisions.

The first pair whose first number is larger than m holds for a level: the prefix of each unit of the
level has the second number of decisions.  The compiled engine needs some milliseconds for such a
unit; to keep the result of the unit takes less time.
"""

SIMPLE_DEPTHS = ((4, 1), (7, 2), (inf, 5))
"""Pairs as in :data:`DEPTHS`, for the simple classes.

In these classes the weights of units are upper bounds.  Smaller units have smaller errors, and the
errors of many units compensate each other.
"""


class GivenUnit(Struct, frozen=True):
    """Some of the maps that the user has given, all with ``edges`` edges.

    Attributes:
        edges: the number of edges of each map.
        number: the number of this unit among the units whose maps have ``edges`` edges, from 0 on.
        given: the maps.
    """

    edges: int
    number: int
    given: tuple[GivenMap, ...]

    @property
    def key(self) -> str:
        """The name of the unit, in the form ``EDGES/NUMBER``."""
        return f"{self.edges}/{self.number}"

    def maps(self, extent: Extent) -> Iterator[combinatorial.CombinatorialMap]:
        """The maps of the unit that are in the extent, once for each start."""
        return (map_ for map_, _ in self.placed(extent, Nothing))

    def placed(self, extent: Extent, kind: type[Lighthouse]) -> Iterator[MapWithPlaces]:
        """The maps of the unit that are in the extent, each with its places.

        A map whose lighthouse was given has only the place of that lighthouse; any other map has
        all places of a lighthouse of this kind.
        """
        for each in self.given:
            if extent.include(each.map):
                yield from each.placed(kind)


def units_of_level(
    extent: Extent, edges: int, portion: Shard = WHOLE, finer: int = 0
) -> Iterator[LevelUnit | GivenUnit]:
    """The units of a level that belong to a shard; they do not depend on the number of workers.

    Args:
        extent: the class of the maps, with bounds and perhaps a condition; or given maps.
        edges: the number of edges of the level.
        portion: the shard.  If there are several shards, the weights of all units are computed
            first, so that each shard gets about the same number of worlds.
        finer: the number of decisions by which the prefix of each unit is longer than usual; so a
            larger number makes smaller units.
    """
    given = extent.given
    if isinstance(given, GivenMaps):
        for number in dealt(given.weights(edges), portion):
            yield GivenUnit(edges, number, given.piece(edges, number))
        return
    depths = SIMPLE_DEPTHS if extent.map_class.simple else DEPTHS
    depth = next(depth for below, depth in depths if edges < below)
    histories = prefixes(edges, extent.map_class, extent.vertices, depth + finer, extent.where)
    units: Iterable[LevelUnit] = (LevelUnit(edges, prefix) for prefix in histories)
    if portion != WHOLE:
        every = list(units)
        units = (every[i] for i in dealt([unit.weight(extent) for unit in every], portion))
    yield from units


def drawn_units(extent: Extent, edges: int, most: int, draw: Random) -> Iterator[LevelUnit]:
    """Yield without end random units of a level, each with a weight of at most ``most``.

    The weight of a unit is its number of maps, or an upper bound of this number.  The probability
    of a unit is proportional to its weight; units of weight 0 are left out.  ``draw`` is the
    generator of random numbers.
    """
    while True:
        gluing, prefix = Gluing(edges, extent.map_class, extent.vertices, extent.where), list[int]()
        while not gluing.finished and (not prefix or count_source.completions(gluing) > most):
            following = [*gluing.successors()]
            weights = [count_source.completions(after) for _, after in following]
            if not any(weights):
                break
            ((decision, gluing),) = draw.choices(following, weights)
            prefix.append(decision)
        else:
            yield LevelUnit(edges, tuple(prefix))


def cells_of_level(extent: Extent, edges: int) -> dict[int, int]:
    """The number of rooted maps with ``edges`` edges by number of vertices, without making maps.

    If the extent has a condition, and the maps that meet the condition cannot be counted in this
    way, the numbers are upper bounds: those of the whole class.
    """
    cells = (count_source.source_of(extent) or counting.SOURCES[extent.map_class]).cells(edges)
    return {n: cells.get(n, 0) for n in range(1, extent.vertex_limit(edges) + 1)}


def is_counted(extent: Extent | None) -> bool:
    """Whether :func:`cells_of_level` returns the exact numbers of the extent, and no upper bounds.

    The result is also True if there is no extent.
    """
    return extent is None or count_source.source_of(extent) is not None


def level_size(extent: Extent, edges: int) -> int:
    """The number of rooted maps with ``edges`` edges in an extent.

    If :func:`cells_of_level` returns upper bounds, this number is an upper bound, too.
    """
    if extent.given is not None:
        return extent.given.starts.get(edges, 0)
    return sum(cells_of_level(extent, edges).values())


class SweptLevel(Struct, frozen=True):
    """A level of a study: units whose results the study uses once all of them are finished.

    In most studies these are all worlds with ``edges`` edges.  In a study of random worlds or of
    families, the worlds of a level may have different numbers of edges.

    Attributes:
        edges: the number of edges of each world; if they differ, the largest possible number.
        worlds: the number of worlds of the whole level, even if only a shard is done.
        units: the units of the level that this job does; each is made when it is needed.
        of: a value of the study's own, which the study reads when the level is finished; or None.
    """

    edges: int
    worlds: int
    units: Iterable[Unit]
    of: Any = None


def tell_of_size(extent: Extent, listener: Listener, shards: int = 1) -> None:
    """Tell the user, before the first level begins, if the number of worlds is large.

    Args:
        extent: the worlds of the job.
        listener: shows the user the message.
        shards: the number of shards of the job, of which this process does one.

    Cost: some milliseconds; the counting ends at the first level whose class has very many worlds.
    """
    if extent.given is not None:
        return  # the user knows
    last = extent.levels[-1]
    source = count_source.source_of(extent) or counting.SOURCES[extent.map_class]
    worlds = counted = 0
    for edges in extent.levels:
        counted, worlds = edges, worlds + level_size(extent, edges)
        if worlds // shards > MANY_WORLDS:
            listener.notice(
                f"there are over {MANY_WORLDS:,} worlds with up to {edges} edges, and {last} are "
                f"asked for: {_LONG}"
            )
            return
        if sum(source.cells(edges).values()) > min(MANY_WORLDS * shards, COUNTABLE_WORLDS):
            break
    if counted < last:
        listener.notice(f"all levels up to {last} edges are asked for: {_LONG}")


class UnitOfRuns(Unit, Protocol):
    """A unit that consists of runs."""

    def placed(self, extent: Extent, kind: type[Lighthouse]) -> Iterator[MapWithPlaces]:
        """Every map of the unit in the extent, with its places of a lighthouse, in a fixed order.

        ``kind`` is the kind of the lighthouse.
        """


class GivenWorlds(Struct, frozen=True):
    """A unit of chosen worlds, which the job holds already.

    Attributes:
        worlds: the worlds, each with the number of its lighthouse's place; each start is dart 0.
        key: the name of the unit.
    """

    worlds: tuple[tuple[World, int], ...]
    key: str = ""

    def placed(self, extent: Extent, kind: type[Lighthouse]) -> Iterator[MapWithPlaces]:  # noqa: ARG002  # they are all there
        """The maps of the worlds, each with its own place and lighthouse; no argument is used."""
        for world, place in self.worlds:
            yield world.map, [(place, world.lighthouse)]


ACROSS, TWICE = 4, 3
"""Two numbers of edges.

All runs in worlds with at most :data:`ACROSS` edges are played in two opposite orders, each order
by one process.  If all these worlds have at most :data:`TWICE` edges, the second process plays each
run twice, so that each run also follows itself.
"""


class AcrossUnit(Struct, frozen=True):
    """All runs with up to ``edges`` edges, played to find out whether one run changes a later run.

    The unit counts no world, because each world is counted in another unit.
    """

    edges: int

    @property
    def key(self) -> str:
        """The name of the unit: the number of edges, and the word ``across``."""
        return f"{self.edges} across"

    def placed(self, extent: Extent, kind: type[Lighthouse]) -> Iterator[MapWithPlaces]:
        """The maps with up to ``edges`` edges, each with all places of this kind of lighthouse."""
        for edges in extent.levels:
            if edges <= self.edges:
                for unit in units_of_level(extent, edges):
                    yield from unit.placed(extent, kind)


def across_level(extent: Extent, edges: int, portion: Shard) -> Iterator[AcrossUnit]:
    """Yield the unit of all runs with up to ``edges`` edges, if this level has such a unit.

    The level with 3 edges (:data:`TWICE`) has such a unit; in it the second process plays each run
    twice.  The level with 4 edges (:data:`ACROSS`) has such a unit, too; in it each process plays
    each run once.  If the extent has neither of these two levels, the largest of its levels with
    fewer edges has such a unit.  For any other level nothing is yielded.  If the job is cut into
    shards, only the shard with index 0 has these units.

    Args:
        extent: the worlds of the check.
        edges: the number of edges of the level.
        portion: the shard.
    """
    small = [each for each in extent.levels[:ACROSS] if each <= ACROSS]
    if portion.index == 0 and edges in small and (edges >= TWICE or edges == small[-1]):
        yield AcrossUnit(edges)


class NumberedRun(Struct, frozen=True):
    """A run of a unit, with its number in the unit.

    Attributes:
        number: the number of the run in the unit, from 0 on; a world in which the lighthouse has no
            place also has a number.
        map: the map, rooted at dart 0.
        place: the number of the lighthouse's place.
        lighthouse: the lighthouse; None if it has no place in this map.
        first: whether this is the first run of the unit in its rooted map.
    """

    number: int
    map: combinatorial.CombinatorialMap
    place: int
    lighthouse: Lighthouse | None
    first: bool


def numbered_runs(
    worlds: UnitOfRuns, extent: Extent, kind: type[Lighthouse]
) -> Iterator[NumberedRun]:
    """Yield the runs of a unit in a fixed order, so that a run has one number in all processes.

    Args:
        worlds: the unit.
        extent: the extent of the maps.
        kind: the kind of the lighthouse.
    """
    number = 0
    for map_, places in worlds.placed(extent, kind):
        for i, (place, lighthouse) in enumerate(places or [(0, None)]):
            yield NumberedRun(number, map_, place, lighthouse, i == 0)
            number += 1


MOST_RUNS = 10**12


class Sample(Struct, frozen=True):
    """Random worlds that are tried in place of all worlds.

    Attributes:
        runs: the number of random worlds.
        seed: the seed of the random numbers.
        min_edges: the least number of edges of a world.
        portion: the shard: the part of the random worlds that this job does.
        mix: names of ways to draw a map, which take turns; if empty, the class of maps determines
            the ways.
        drawn: True, because these worlds are drawn at random.
        finished: the words by which reports name the finished worlds.

    Raises:
        InputError: for numbers out of range.
    """

    runs: int
    seed: int = 0
    min_edges: int = 1
    portion: Shard = WHOLE
    mix: tuple[str, ...] = ()

    drawn: ClassVar[bool] = True
    finished: ClassVar[str] = "random worlds"

    def __post_init__(self) -> None:
        for name in ("runs", "seed", "min_edges"):
            force_setattr(self, name, an_integer(name, getattr(self, name)))
        at_most("runs", self.runs, MOST_RUNS)
        if self.seed < 0:
            raise InputError(f"seed = {show(self.seed)}, but seeds are 0, 1, 2, ...")
        if self.runs < 1:
            raise InputError(f"runs = {self.runs} is not positive")
        if self.min_edges < 1:
            raise InputError(f"min-edges = {show(self.min_edges)} is not positive")


Coverage: TypeAlias = Shard | Sample
"""The choice of the worlds of an extent that are tried: the units of a shard, or random worlds."""


class Scope(Struct, frozen=True):
    """The content of a check: the worlds that it tries, and the rules of its runs.

    Attributes:
        extent: the class and its bounds.
        rules: the rules by which each run is played and judged.
        schedules: ``one`` if the policy makes all choices; ``all`` if every sequence of choices is
            tried.
        coverage: the shard or the sample that says which worlds of the extent are tried.
    """

    extent: Extent
    rules: Rules
    schedules: Schedule = "one"
    coverage: Coverage = WHOLE

    @property
    def whole(self) -> bool:
        """Whether the check tries every map of its extent.

        It is False if the check does one of several shards, tries random worlds, or tries the maps
        that the user has given.  Only if it is True, the number of the worlds can be compared with
        a number computed in another way.
        """
        return self.coverage == WHOLE and self.extent.given is None

    def like(self, world: World) -> Iterable[World]:
        """The worlds given by the user that equal this world up to the numbering of darts.

        There are none if the user has given no worlds.
        """
        return () if self.extent.given is None else self.extent.given.like(world)

    def labelled(self, finding: Finding) -> Finding:
        """Copy the user's labels to the world of a finding; return the changed finding.

        The labels are those of the equal world that the user has given.  If the user has given no
        equal world, the finding does not change.  Here labels are the name of the world, the names
        of its vertices, and the positions of its vertices in a drawing.
        """
        world = finding.world
        return replace(finding, world=labelled(world, self.like(world)))

    @property
    def portion(self) -> Shard:
        """The part of the units that is done: the whole, or a shard."""
        return self.coverage.portion
