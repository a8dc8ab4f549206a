"""Levels: all rooted maps with one number of edges, and the pieces into which they are cut."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from random import Random
from typing import Any

from msgspec import Struct

from allworlds.engines.progress import Listener
from allworlds.engines.units.shards import WHOLE, Portion, Shard, dealt
from allworlds.engines.units.unit import Unit
from allworlds.maps import (
    CombinatorialMap,
    Extent,
    Gluing,
    completions,
    prefixes,
    rooted_maps,
    source_for,
    source_of,
)

MANY_WORLDS = 10_000_000
"""The number of worlds above which the user is told the size at once."""

COUNTABLE_WORLDS = 10**12
"""The number of worlds above which the counting of a level takes long, too."""


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
        bounds = (self.edges, extent.map_class, extent.vertices)
        return rooted_maps(*bounds, self.prefix, extent.where)

    def weight(self, extent: Extent) -> int:
        """The number of these maps, counted; in simple classes and under conditions at most."""
        gluing = Gluing(self.edges, extent.map_class, extent.vertices, extent.where)
        for decision in self.prefix:
            gluing.apply(decision)
        return completions(gluing)


DEPTHS = ((6, 1), (9, 2))
"""The number of decisions that make a unit, below each number of edges; a unit takes some
milliseconds of the compiled engine, so that keeping its result costs little."""

DEPTH = 3
"""The number of decisions that make a unit of all larger levels."""

SIMPLE_DEPTHS, SIMPLE_DEPTH = ((4, 1), (7, 2)), 5
"""The numbers of decisions in the simple classes: weights are upper bounds there, with smaller
errors for smaller units, and the errors of many units make up for each other."""


def depth_of(extent: Extent, edges: int) -> int:
    """The number of decisions that make a unit of a level."""
    simple = extent.map_class.simple
    depths, last = (SIMPLE_DEPTHS, SIMPLE_DEPTH) if simple else (DEPTHS, DEPTH)
    return next((depth for below, depth in depths if edges < below), last)


def units_of_level(extent: Extent, edges: int, portion: Portion = WHOLE) -> Iterator[LevelUnit]:
    """The pieces of a level, or those of a shard; independent of the number of workers.

    A shard gets about as many worlds as any other: the weights are counted beforehand.
    """
    bounds = (edges, extent.map_class, extent.vertices)
    histories = prefixes(*bounds, depth_of(extent, edges), extent.where)
    units = (LevelUnit(edges, prefix) for prefix in histories)
    if isinstance(portion, Shard):
        every = list(units)
        units = (every[i] for i in dealt([unit.weight(extent) for unit in every], portion))
    yield from units


def drawn_units(extent: Extent, edges: int, most: int, draw: Random) -> Iterator[LevelUnit]:
    """An endless sequence of pieces of a level, of at most ``most`` maps, drawn as its maps are.

    A piece is drawn the more often the more maps it has; pieces without a map are left out.
    """
    while True:
        bounds = (edges, extent.map_class, extent.vertices, extent.where)
        gluing, prefix = Gluing(*bounds), list[int]()
        while not gluing.finished and (not prefix or completions(gluing) > most):
            following = [(decision, after) for decision, after in gluing.successors()]
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
    cells = (source_of(extent) or source_for(extent.map_class)).cells(edges)
    return {n: cells.get(n, 0) for n in range(1, extent.vertex_limit(edges) + 1)}


def is_counted(extent: Extent | None) -> bool:
    """Whether the worlds of an extent are counted beforehand, and not at most so many."""
    return extent is None or source_of(extent) is not None


def level_size(extent: Extent, edges: int) -> int:
    """The number of all rooted maps of the level; under a condition without a source at most."""
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


def levels_of(extent: Extent, portion: Portion = WHOLE) -> Iterator[SweptLevel]:
    """The levels of all maps of an extent."""
    for edges in extent.levels:
        yield SweptLevel(edges, level_size(extent, edges), units_of_level(extent, edges, portion))


def tell_of_size(extent: Extent, listener: Listener, shards: int = 1) -> None:
    """Tell before the first level is begun if there are too many worlds to be soon done with.

    Cost: some milliseconds; a level of which most worlds lie beyond the extent ends the counting.
    """
    last = extent.levels[-1]
    source = source_of(extent) or source_for(extent.map_class)
    worlds = counted = 0
    for edges in extent.levels:
        everywhere = sum(source.cells(edges).values())
        counted, worlds = edges, worlds + level_size(extent, edges)
        if worlds // shards > MANY_WORLDS:
            listener.notice(
                f"there are over {MANY_WORLDS:,} worlds with up to {edges} edges, and {last} are "
                f"asked for: {_LONG}"
            )
            return
        if everywhere > min(MANY_WORLDS * shards, COUNTABLE_WORLDS):
            break
    if counted < last:
        listener.notice(f"all levels up to {last} edges are asked for: {_LONG}")


_LONG = "this takes long, or does not end; an interrupt ends it with what is finished"
