"""Levels: all rooted maps with one number of edges, and the pieces into which they are cut."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from random import Random

from allworlds.engines.progress import Listener
from allworlds.engines.units.shards import WHOLE, Portion, Shard, dealt
from allworlds.maps import (
    CombinatorialMap,
    Extent,
    Gluing,
    completions,
    prefixes,
    rooted_maps,
    source_for,
)

MANY_WORLDS = 10_000_000
"""Whoever asks for more of them is told so at once."""

COUNTABLE_WORLDS = 10**12
"""Levels with more of them take long to be counted, too."""


@dataclass(frozen=True, slots=True)
class LevelUnit:
    """All maps of a level whose history begins with ``prefix``."""

    edges: int
    prefix: tuple[int, ...]

    @property
    def key(self) -> str:
        """``EDGES:DECISION,DECISION,...``."""
        return f"{self.edges}:{','.join(map(str, self.prefix))}"

    def maps(self, extent: Extent) -> Iterator[CombinatorialMap]:
        """The maps, rooted at dart 0, in the order of the enumeration."""
        return rooted_maps(self.edges, extent.map_class, extent.vertices, self.prefix)

    def weight(self, extent: Extent) -> int:
        """How many maps these are, counted; of the simple classes an upper bound."""
        gluing = Gluing(self.edges, extent.map_class, extent.vertices)
        for decision in self.prefix:
            gluing.apply(decision)
        return completions(gluing)


DEPTHS = ((6, 1), (9, 2))
"""Below so many edges the first so many decisions make a unit; a unit is worth some milliseconds
of the compiled engine, so that to keep its result costs little."""

DEPTH = 3
"""The same for all larger ones."""

SIMPLE_DEPTHS, SIMPLE_DEPTH = ((4, 1), (7, 2)), 5
"""The same in the simple classes: weights are upper bounds there, which are wrong by less the
smaller the units are, and the errors of many make up for each other."""


def depth_of(extent: Extent, edges: int) -> int:
    """How many decisions make a unit of a level."""
    simple = extent.map_class.simple
    depths, last = (SIMPLE_DEPTHS, SIMPLE_DEPTH) if simple else (DEPTHS, DEPTH)
    return next((depth for below, depth in depths if edges < below), last)


def units_of_level(extent: Extent, edges: int, portion: Portion = WHOLE) -> Iterator[LevelUnit]:
    """The pieces of a level, or those of a shard; the same for any number of workers.

    A shard gets about as many worlds as any other: the weights are counted beforehand.
    """
    units = (
        LevelUnit(edges, prefix)
        for prefix in prefixes(edges, extent.map_class, extent.vertices, depth_of(extent, edges))
    )
    if isinstance(portion, Shard):
        every = list(units)
        units = (every[i] for i in dealt([unit.weight(extent) for unit in every], portion))
    yield from units


def drawn_units(extent: Extent, edges: int, most: int, draw: Random) -> Iterator[LevelUnit]:
    """Pieces of a level with so many maps at most, without end, drawn as its maps are met.

    A piece is drawn the more often the more maps it has; pieces without a map are left out.
    """
    while True:
        gluing, prefix = Gluing(edges, extent.map_class, extent.vertices), list[int]()
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
    """The rooted maps of a level by vertices, as the independent source counts them."""
    cells = source_for(extent.map_class).cells(edges)
    return {n: cells.get(n, 0) for n in range(1, extent.vertex_limit(edges) + 1)}


def level_size(extent: Extent, edges: int) -> int:
    """Their sum."""
    return sum(cells_of_level(extent, edges).values())


def tell_of_size(extent: Extent, listener: Listener, shards: int = 1) -> None:
    """Tell before the first level is begun if there are too many worlds to be soon done with.

    Cost: some milliseconds; a level of which most worlds lie beyond the extent ends the counting.
    """
    last = extent.levels[-1]
    source = source_for(extent.map_class)
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
