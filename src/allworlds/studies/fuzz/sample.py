"""Selection of the worlds of a fuzzing run, by its seed alone."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import count
from random import Random

from msgspec import Struct

from allworlds.engines.scope import Sample
from allworlds.engines.units import Placed, Shard
from allworlds.inputs.checks import InputError, show
from allworlds.maps.build import lattice
from allworlds.maps.canonical import rooted_code
from allworlds.maps.classes import Condition, Extent, MapClass, narrowing
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.enumeration import Gluing
from allworlds.maps.families import random_map
from allworlds.world.lighthouses.base import Lighthouse

BATCH = 64
"""The runs that one worker does at a time."""

PATIENCE = 1000
"""The number of maps of one generator that are rejected before another one is used."""

LONGEST = 2 * PATIENCE
"""The number of maps that are rejected before a condition is refused."""

DEAD_ENDS = 5
"""The number of histories under a condition that may come to nothing."""


def batches(sample: Sample, shards: int) -> Iterator[Batch]:
    """The sample in pieces, or its part for a shard: run numbers, dealt out evenly.

    They do not depend on the number of workers.

    Args:
        sample: the whole, or the part of a shard.
        shards: the number of parts, each of which is cut by itself.
    """
    parts = [sample.portion.index] if isinstance(sample.portion, Shard) else range(shards)
    for part in parts:
        first, end = (at * sample.runs // shards for at in (part, part + 1))
        for begin in range(first, end, BATCH):
            yield Batch(sample.seed, begin, min(begin + BATCH, end), sample.min_edges)


class Batch(Struct, frozen=True):
    """The runs ``first .. last - 1`` of the sample with that seed and least number of edges."""

    seed: int
    first: int
    last: int
    min_edges: int = 1

    @property
    def key(self) -> str:
        """Key of the batch in a run directory: ``SEED/FIRST``."""
        return f"{self.seed}/{self.first}"

    def placed(self, extent: Extent, kind: type[Lighthouse]) -> Iterator[Placed]:
        """One world a run: a random map with a random place of the lighthouse.

        Under a class every map that is none of it, or is too small, is drawn again; a generator
        that brings none for long gives way to the first, whose maps have the size that is asked.
        """
        generators = _generators(extent)
        for run in range(self.first, self.last):
            random = Random(f"{self.seed}/{run}")  # noqa: S311  # reproducible, not secret
            in_turn = generators[run % len(generators)], generators[0]
            map_ = self._drawn(extent, in_turn, random)
            places = list(enumerate(kind.places(map_, 0)))
            yield map_, [random.choice(places)] if places else []

    def _drawn(
        self, extent: Extent, generators: tuple[Generator, Generator], random: Random
    ) -> CombinatorialMap:
        """A map of the extent; by the second generator where the first one brings none for long.

        Raises:
            InputError: if the second one brings none for long that the condition admits.
        """
        size = random.randint(self.min_edges, extent.levels[-1])
        for tries in count():
            map_ = generators[tries >= PATIENCE](size, random)
            large = map_.edge_count >= self.min_edges
            if large and extent.map_class.includes(map_) and extent.admits(map_):
                return map_
            if extent.where is not None:
                if tries == LONGEST:
                    break
                size = random.randint(self.min_edges, extent.levels[-1])
        assert extent.where is not None
        raise InputError(
            f"where {show(extent.where.name)}: {tries + 1} maps of the class {extent.map_class} "
            f"with {self.min_edges} to {extent.levels[-1]} edges were drawn, and it is true of "
            "none; legal is one that is true of more of them"
        )


Generator = Callable[[int, Random], CombinatorialMap]


def _generators(extent: Extent) -> tuple[Generator, ...]:
    """The generators of an extent; of a condition with a name its own histories alone."""
    map_class, where = extent.map_class, extent.where
    if narrowing(where):
        return (glued(map_class, where),)
    return GENERATORS.get(map_class, (glued(map_class),))


def _rerooted(map_: CombinatorialMap, random: Random) -> CombinatorialMap:
    """The map with a random root, which becomes dart 0."""
    code = rooted_code(map_.sigma, map_.alpha, random.choice(map_.darts))
    return CombinatorialMap.trusted(*code)


def glued(map_class: MapClass, where: Condition | None = None) -> Generator:
    """Draw a random sequence of gluings, every decision uniform: any class, not a uniform map.

    Where a condition lets no map with that many edges begin, it is another map of the class.
    """

    def generate(edges: int, random: Random) -> CombinatorialMap:
        for tries in count():
            gluing = Gluing(edges, map_class, where=where if tries < DEAD_ENDS else None)
            while not gluing.finished:
                following = list(gluing.successors())
                if not following:
                    break
                gluing = random.choice(following)[1]
            else:
                return gluing.finish()
        raise AssertionError  # it goes on for ever

    return generate


def a_lattice(edges: int, random: Random) -> CombinatorialMap:
    """Draw a lattice with holes, with at most that many edges."""

    def size(rows: int, columns: int) -> int:
        return rows * (columns - 1) + columns * (rows - 1)

    sizes = [
        (r, c)
        for r in range(1, edges + 2)
        for c in range(max(r, 2), edges + 2)
        if size(r, c) <= edges
    ]
    rows, columns = random.choice(sizes[-4:])
    total = size(rows, columns)
    # What is left must be connected.
    holes = random.randint(0, total - (rows * columns - 1)) / total
    return _rerooted(lattice(rows, columns, holes, random.getrandbits(32)), random)


def dense(edges: int, random: Random) -> CombinatorialMap:
    """Draw a gluing with at most three vertices, which have many darts each."""
    vertices = random.randint(1, 3)
    while True:
        map_ = random_map(edges, random)
        if map_.vertex_count <= vertices or edges + 1 < vertices:
            return map_


def looped_tree(edges: int, random: Random) -> CombinatorialMap:
    """Draw a random plane tree in which some edges are loops instead, at random corners."""
    rotations: list[list[int]] = [[]]
    alpha: list[int] = []
    for _ in range(edges):
        dart = len(alpha)
        alpha += [dart + 1, dart]
        vertex = random.choice(rotations)
        vertex.insert(random.randint(0, len(vertex)), dart)
        other = vertex if random.random() < 1 / 3 else []
        if other is not vertex:
            rotations.append(other)
        other.insert(random.randint(0, len(other)), dart + 1)
    sigma = [0] * len(alpha)
    for vertex in rotations:
        for d, following in zip(vertex, [*vertex[1:], *vertex[:1]], strict=True):
            sigma[d] = following
    return _rerooted(CombinatorialMap(sigma, alpha), random)


GENERATORS: dict[MapClass, tuple[Generator, ...]] = {
    MapClass.MAPS: (random_map, looped_tree, glued(MapClass.PLANAR), a_lattice, dense),
    MapClass.PLANAR: (glued(MapClass.PLANAR), a_lattice),
    MapClass.SIMPLE: (glued(MapClass.SIMPLE), a_lattice, glued(MapClass.PLANAR_SIMPLE)),
    MapClass.PLANAR_SIMPLE: (glued(MapClass.PLANAR_SIMPLE), a_lattice),
}
"""The generators of a class, taken in turn; of one that has none here, its random histories."""
