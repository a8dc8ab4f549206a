"""Which worlds a fuzzing run visits: a function of its seed alone."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from random import Random

from allworlds.checker.scope import Placed, Scope
from allworlds.errors import InputError, an_integer
from allworlds.maps.build import lattice
from allworlds.maps.canonical import rooted_code
from allworlds.maps.classes import MapClass
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.enumeration import Gluing
from allworlds.maps.families import random_map

BATCH = 64
"""The runs that one worker does at a time."""


@dataclass(frozen=True, slots=True)
class Sample:
    """So many random worlds of a class with at most ``edges`` edges.

    Raises:
        InputError: for numbers that are not positive.
    """

    map_class: MapClass
    edges: int
    runs: int
    seed: int = 0

    def __post_init__(self) -> None:
        for name in ("edges", "runs", "seed"):
            object.__setattr__(self, name, an_integer(name, getattr(self, name)))
        if self.seed < 0:
            raise InputError(f"seed = {self.seed}, but seeds are 0, 1, 2, ...")
        for name in ("edges", "runs"):
            if getattr(self, name) < 1:
                raise InputError(f"{name} = {getattr(self, name)} is not positive")

    def to_json(self) -> dict[str, int]:
        """What the sample depends on, besides its class."""
        return {"edges": self.edges, "runs": self.runs, "seed": self.seed}

    def batches(self) -> Iterator[Batch]:
        """The sample in pieces; the same for any number of workers."""
        for first in range(0, self.runs, BATCH):
            yield Batch(self, first, min(first + BATCH, self.runs))


@dataclass(frozen=True, slots=True)
class Batch:
    """The runs ``first .. last - 1`` of a sample."""

    sample: Sample
    first: int
    last: int

    def placed(self, scope: Scope) -> Iterator[Placed]:
        """One world a run: a random map with a random place of the lighthouse.

        Under a class every map that is none of it is drawn again.
        """
        sample, kind = self.sample, scope.rules.kind
        generators = GENERATORS[sample.map_class]
        for run in range(self.first, self.last):
            random = Random(f"{sample.seed}/{run}")  # noqa: S311  # reproducible, not secret
            generator = generators[run % len(generators)]
            size = random.randint(1, sample.edges)
            map_ = generator(size, random)
            while not sample.map_class.includes(map_):
                map_ = generator(size, random)
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
    sizes = [
        (r, c)
        for r in range(1, edges + 2)
        for c in range(max(r, 2), edges + 2)
        if r * (c - 1) + c * (r - 1) <= edges
    ]
    rows, columns = random.choice(sizes[-4:])
    spare = rows * (columns - 1) + columns * (rows - 1) - (rows * columns - 1)
    total = rows * (columns - 1) + columns * (rows - 1)
    holes = random.randint(0, spare) / total
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
"""The generators of each class, taken in turn."""
