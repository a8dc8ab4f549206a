"""Units: the pieces into which a level is cut, and the shards to which they fall."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from heapq import heapify, heapreplace
from math import inf
from random import Random
from typing import Annotated, Any, Generic, Protocol, Self, TypeAlias, TypeVar

from msgspec import Struct

from allworlds.engines.progress import Listener
from allworlds.inputs.checks import InputError, an_integer, show
from allworlds.inputs.requests import RARE_SCOPE, Converted, Option, Request
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.count_source import completions, source_of
from allworlds.maps.counting import SOURCES
from allworlds.maps.enumeration import Gluing, prefixes, rooted_maps
from allworlds.notations.given import GivenMap, GivenMaps, Placed
from allworlds.world.lighthouses.base import Lighthouse
from allworlds.world.lighthouses.placeless import Nothing


class Unit(Protocol):
    """A piece of work, which does not depend on the workers or their number."""

    @property
    def key(self) -> str:
        """Its name among the units of one job."""


class Sum(Protocol):
    """A result whose parts can be added up in any order; a dataclass, kept by its fields."""

    @property
    def worlds(self) -> int:
        """The number of worlds in it."""

    def add(self, other: Any, /) -> None:
        """Take in another part."""


U = TypeVar("U", bound=Unit)
R = TypeVar("R")
E_contra = TypeVar("E_contra", contravariant=True)


class PartialResult(Struct, Generic[U, R], frozen=True):
    """A part of a unit's result; ``last``: whether it completes the unit."""

    unit: U
    result: R
    last: bool


class UnitEngine(Protocol):
    """The engine that does a unit."""

    def parts(self, unit: Any) -> Iterator[Any]:
        """Yield the unit's result in parts, at least one; they add up to the whole."""


class Transport(Protocol[E_contra]):
    """A transport brings units to engines; a context, after which no work goes on."""

    def __enter__(self) -> Self: ...

    def __exit__(self, *_: object) -> None: ...

    def map(self, engine: E_contra, units: Iterable[Any]) -> Iterator[PartialResult[Any, Any]]:
        """Yield the parts of all units, as they come.

        Raises:
            TimeIsUp: when the time limit has been reached.
        """


class Whole(Struct, frozen=True):
    """Every world of the extent."""

    def __str__(self) -> str:
        return "0/1"


class Shard(Struct, frozen=True):
    """The part of number ``index`` when every level is dealt out to ``count`` parts.

    Raises:
        InputError: naming what is out of range.
    """

    index: int
    count: int

    def __post_init__(self) -> None:
        for name, number in (("K", self.index), ("N", self.count)):
            an_integer(f"shard {name}", number)
        if self.count < 1 or not 0 <= self.index < self.count:
            raise InputError(f"shard {self} is out of range; K/N needs 0 <= K < N, counted from 0")

    def __str__(self) -> str:
        return f"{self.index}/{self.count}"


WHOLE = Whole()

Portion: TypeAlias = Whole | Shard
"""The part of the units of a job that is done."""


def shards_of(portion: object) -> int:
    """The number of parts of the job to which this part belongs."""
    return portion.count if isinstance(portion, Shard) else 1


def shard_numbers(text: str) -> tuple[int, int]:
    """The two numbers of ``K/N``."""
    match = re.fullmatch(r"([0-9]+)/([0-9]+)", text)
    if match is None:
        raise InputError(f"shard {show(text)} is not of the form K/N, counted from 0")
    if max(map(len, match.groups())) > 9:
        raise InputError(f"shard {show(text)} is too big; N is at most {10**9 - 1}")
    return int(match[1]), int(match[2])


def a_shard(pair: object) -> Portion:
    """The shard of ``(K, N)``; of one shard, and of None, the whole.

    Raises:
        InputError: for anything else.
    """
    if isinstance(pair, Whole | Shard):
        return pair
    if pair is None:
        return Whole()
    if not isinstance(pair, tuple | list) or len(pair) != 2:
        raise InputError(f"shard = {show(pair)} is not a pair (K, N)")
    shard = Shard(an_integer("shard K", pair[0]), an_integer("shard N", pair[1]))
    return Whole() if shard.count == 1 else shard


class ShardOptions(Request):
    """The part of a request that names the shard."""

    shard: Annotated[
        Converted[tuple[int, int] | Portion | None, Portion],
        Option(
            RARE_SCOPE,
            "K/N",
            "Only the K-th of N parts of about equal weight, from 0.",
            parse=shard_numbers,
            default="0/1",
            apart=True,
        ),
    ] = Converted(a_shard, None)


def dealt(weights: Sequence[int], shard: Shard) -> Iterator[int]:
    """The numbers of the units that fall to a shard, ascending.

    The heaviest unit that is left goes to the lightest shard; among equals the first to the first.
    """
    heaviest = sorted(range(len(weights)), key=lambda i: (-weights[i], i))
    loads = [(0, index) for index in range(min(shard.count, len(weights)))]
    heapify(loads)
    mine = []
    for i in heaviest:
        load, index = loads[0]
        if index == shard.index:
            mine.append(i)
        heapreplace(loads, (load + weights[i], index))
    yield from sorted(mine)


MANY_WORLDS = 10_000_000
"""The number of worlds above which the user is told the size at once."""

COUNTABLE_WORLDS = 10**12
"""The number of worlds above which the counting of a level takes long, too."""

_LONG = "this takes long, or does not end; an interrupt ends it with what is finished"


class LevelUnit(Struct, frozen=True):
    """All maps of a level whose history begins with ``prefix``."""

    edges: int
    prefix: tuple[int, ...]

    @property
    def key(self) -> str:
        """The name ``EDGES:DECISION,DECISION,...``."""
        return f"{self.edges}:{','.join(map(str, self.prefix))}"

    def maps(self, extent: Extent) -> Iterator[CombinatorialMap]:
        """The maps, rooted at dart 0, in the order of the enumeration."""
        return rooted_maps(self.edges, extent.map_class, extent.vertices, self.prefix, extent.where)

    def placed(self, extent: Extent, kind: type[Lighthouse]) -> Iterator[Placed]:
        """The maps, each with every place."""
        for map_ in self.maps(extent):
            yield map_, list(enumerate(kind.places(map_, 0)))

    def weight(self, extent: Extent) -> int:
        """The number of these maps, counted; in simple classes and under conditions at most."""
        gluing = Gluing(self.edges, extent.map_class, extent.vertices, extent.where)
        for decision in self.prefix:
            gluing.apply(decision)
        return completions(gluing)


DEPTHS = ((6, 1), (9, 2), (inf, 3))
"""The number of decisions that make a unit, below each number of edges; a unit takes some
milliseconds of the compiled engine, so that keeping its result costs little."""

SIMPLE_DEPTHS = ((4, 1), (7, 2), (inf, 5))
"""Numbers of decisions for the simple classes: weights are upper bounds there, with smaller errors
for smaller units, and the errors of many units make up for each other."""


class GivenUnit(Struct, frozen=True):
    """Some of the given maps of a level, with the number of the piece."""

    edges: int
    number: int
    given: tuple[GivenMap, ...]

    @property
    def key(self) -> str:
        """The name ``EDGES/NUMBER``."""
        return f"{self.edges}/{self.number}"

    def maps(self, extent: Extent) -> Iterator[CombinatorialMap]:
        """The maps of the extent, each from every start."""
        return (map_ for map_, _ in self.placed(extent, Nothing))

    def placed(self, extent: Extent, kind: type[Lighthouse]) -> Iterator[Placed]:
        """The same, each with every place that is left open."""
        for each in self.given:
            if extent.include(each.map):
                yield from each.placed(kind)


def units_of_level(
    extent: Extent, edges: int, portion: Portion = WHOLE
) -> Iterator[LevelUnit | GivenUnit]:
    """The pieces of a level, or those of a shard; independent of the number of workers.

    A shard gets about as many worlds as any other: the weights are counted beforehand.
    """
    given = extent.given
    if isinstance(given, GivenMaps):
        weights = given.weights(edges)
        mine = dealt(weights, portion) if isinstance(portion, Shard) else range(len(weights))
        for number in mine:
            yield GivenUnit(edges, number, given.piece(edges, number))
        return
    depths = SIMPLE_DEPTHS if extent.map_class.simple else DEPTHS
    depth = next(depth for below, depth in depths if edges < below)
    histories = prefixes(edges, extent.map_class, extent.vertices, depth, extent.where)
    units: Iterable[LevelUnit] = (LevelUnit(edges, prefix) for prefix in histories)
    if isinstance(portion, Shard):
        every = list(units)
        units = (every[i] for i in dealt([unit.weight(extent) for unit in every], portion))
    yield from units


def drawn_units(extent: Extent, edges: int, most: int, draw: Random) -> Iterator[LevelUnit]:
    """An endless sequence of pieces of a level, of at most ``most`` maps, drawn as its maps are.

    A piece is drawn the more often the more maps it has; pieces without a map are left out.
    """
    while True:
        gluing, prefix = Gluing(edges, extent.map_class, extent.vertices, extent.where), list[int]()
        while not gluing.finished and (not prefix or completions(gluing) > most):
            following = [*gluing.successors()]
            weights = [completions(after) for _, after in following]
            if not any(weights):
                break
            ((decision, gluing),) = draw.choices(following, weights)
            prefix.append(decision)
        else:
            yield LevelUnit(edges, tuple(prefix))


def cells_of_level(extent: Extent, edges: int) -> dict[int, int]:
    """The rooted maps of a level by vertices, as the independent source counts them.

    Under a condition without a source: at most so many, those of the class.
    """
    cells = (source_of(extent) or SOURCES[extent.map_class]).cells(edges)
    return {n: cells.get(n, 0) for n in range(1, extent.vertex_limit(edges) + 1)}


def is_counted(extent: Extent | None) -> bool:
    """Whether the worlds of an extent are counted beforehand, and not at most so many."""
    return extent is None or source_of(extent) is not None


def level_size(extent: Extent, edges: int) -> int:
    """The number of all rooted maps of the level; under a condition without a source at most."""
    if extent.given is not None:
        return extent.given.starts.get(edges, 0)
    return sum(cells_of_level(extent, edges).values())


class SweptLevel(Struct, frozen=True):
    """Units that are done as one: their result is reported if all of them are finished.

    Attributes:
        edges: of the largest of its worlds.
        worlds: the number of results that are counted in it; of a shard, those of the whole.
        units: those of this shard, made while they are asked for.
        of: further data by which the study knows it.
    """

    edges: int
    worlds: int
    units: Iterable[Unit]
    of: Any = None


def tell_of_size(extent: Extent, listener: Listener, shards: int = 1) -> None:
    """Tell before the first level is begun if there are too many worlds to be soon done with.

    Cost: some milliseconds; a level of which most worlds lie beyond the extent ends the counting.
    """
    if extent.given is not None:
        return  # the user knows
    last = extent.levels[-1]
    source = source_of(extent) or SOURCES[extent.map_class]
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
