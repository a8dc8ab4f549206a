"""Which worlds a fuzzing run visits: a function of its seed alone."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from random import Random

from allworlds.engines import Placed, Sample
from allworlds.maps import (
    CombinatorialMap,
    Extent,
    Gluing,
    MapClass,
    lattice,
    random_map,
    rooted_code,
)
from allworlds.world import Lighthouse

BATCH = 64
"""The runs that one worker does at a time."""

PATIENCE = 1000
"""So many maps of a generator are looked at before another is asked."""


def batches(sample: Sample) -> Iterator[Batch]:
    """The sample in pieces; the same for any number of workers."""
    for first in range(0, sample.runs, BATCH):
        last = min(first + BATCH, sample.runs)
        yield Batch(sample.seed, first, last, sample.min_edges)


@dataclass(frozen=True, slots=True)
class Batch:
    """The runs ``first .. last - 1`` of the sample with that seed and least number of edges."""

    seed: int
    first: int
    last: int
    min_edges: int = 1

    @property
    def key(self) -> str:
        """``SEED/FIRST``."""
        return f"{self.seed}/{self.first}"

    def placed(self, extent: Extent, kind: type[Lighthouse]) -> Iterator[Placed]:
        """One world a run: a random map with a random place of the lighthouse.

        Under a class every map that is none of it, or is too small, is drawn again; a generator
        that brings none for long gives way to the first, whose maps have the size that is asked.
        """
        map_class, edges = extent.map_class, extent.levels[-1]
        generators = GENERATORS.get(map_class, (glued(map_class),))
        for run in range(self.first, self.last):
            random = Random(f"{self.seed}/{run}")  # noqa: S311  # reproducible, not secret
            generator = generators[run % len(generators)]
            size = random.randint(self.min_edges, edges)
            map_, tries = generator(size, random), 1
            while map_.edge_count < self.min_edges or not map_class.includes(map_):
                if tries == PATIENCE:
                    generator = generators[0]
                map_, tries = generator(size, random), tries + 1
            places = list(enumerate(kind.places(map_, 0)))
            yield map_, [random.choice(places)] if places else []


Generator = Callable[[int, Random], CombinatorialMap]


def _rerooted(map_: CombinatorialMap, random: Random) -> CombinatorialMap:
    """The map with a random root, which becomes dart 0."""
    code = rooted_code(map_.sigma, map_.alpha, random.choice(map_.darts))
    return CombinatorialMap.trusted(*code)


def glued(map_class: MapClass) -> Generator:
    """Random histories of gluing, every decision uniform: any class, not a uniform map."""

    def generate(edges: int, random: Random) -> CombinatorialMap:
        while True:
            gluing = Gluing(edges, map_class)
            while not gluing.finished:
                following = list(gluing.successors())
                if not following:
                    break
                gluing = random.choice(following)[1]
            else:
                return gluing.finish()

    return generate


def a_lattice(edges: int, random: Random) -> CombinatorialMap:
    """A lattice with holes, with at most that many edges."""

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
    """Few vertices with many darts each: a random gluing with at most three vertices."""
    vertices = random.randint(1, 3)
    while True:
        map_ = random_map(edges, random)
        if map_.vertex_count <= vertices or edges + 1 < vertices:
            return map_


def looped_tree(edges: int, random: Random) -> CombinatorialMap:
    """A random plane tree some of whose edges are loops instead, at random corners."""
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
