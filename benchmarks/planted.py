"""How soon random worlds refute planted slips: the mixture of ``fuzz`` beside the one before it.

    python benchmarks/planted.py [--edges M] [--runs R] [--seed S] [--old] [--mix NAMES] [--limit S]

Each slip is planted in three explorers: Algorithm 1, its variant for a marker cluster, and
Algorithm 1 depth first.  A line for each slip has the number of the first run that is wrong in
each; the last line has the rate that is found.  ``--old`` draws as ``fuzz`` did before the mixture.
``--limit`` ends the drawing for each explorer after so many seconds.

Up to the first wrong belief a planted explorer does what the right one does.  So the right one is
run once in each world, and tells which slips would have been wrong: :func:`wrong_in`.
"""

from __future__ import annotations

import argparse
import time
from collections import Counter
from collections.abc import Callable, Iterator
from random import Random
from typing import Any

from allworlds.corpus.explorers import ConfirmedTooEarly
from allworlds.engines.units import Sample
from allworlds.explorers.builtin.algorithm1 import Algorithm1, TwoVertices, Walk
from allworlds.judging.episode import AroundExplorer
from allworlds.maps import build, families
from allworlds.maps.classes import Extent, MapClass
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.mixture import default_mix, glued, lattice, rerooted
from allworlds.protocol import playing
from allworlds.protocol.actions import Estimate, Move, Percept
from allworlds.protocol.choices import Choices
from allworlds.studies.fuzz import batches
from allworlds.world.lighthouses import kinds
from allworlds.world.world import World

# ---------------------------------------------------------------- explorers


class Plain(Algorithm1):
    """Algorithm 1."""

    fits = 0

    def try_path(self, partner: int, path: list[int]) -> Walk[tuple[list[int], bool]]:
        """Lines 10-13; of a wrong hypothesis it is noted how many steps have fitted."""
        motions, matched = yield from super().try_path(partner, path)
        if not matched:
            self.fits = max(self.fits, len(motions) - 1)
        return motions, matched


class DepthFirst(Plain):
    """Algorithm 1, which explores the newest dart."""

    def take_from_u(self) -> int:
        """Line 3: the newest."""
        return self.s.unexplored[-1]


class Cluster(Plain, TwoVertices):
    """Algorithm 1 for a marker cluster."""

    def __init__(self, first: Percept, choices: Choices) -> None:
        super().__init__(first, lambda s: s.marks == 1, lambda s: s.marks == 2, choices)


EXPLORERS: dict[str, tuple[type[Plain], str]] = {
    "algorithm1": (Plain, "directional"),
    "cluster": (Cluster, "cluster:single=true"),
    "depth-first": (DepthFirst, "directional"),
}
"""The explorers in which slips are planted, with their lighthouses."""


def believing(kind: type[Plain], steps: int) -> type[Plain]:
    """The explorer that believes a hypothesis after so many fitting steps."""

    class Believes(kind):  # type: ignore[valid-type,misc]
        def try_path(self, partner: int, path: list[int]) -> Walk[tuple[list[int], bool]]:
            if len(path) <= steps:
                return (yield from super().try_path(partner, path))  # type: ignore[no-any-return]
            motions, matched = yield from Algorithm1.try_path(self, partner, path[:steps])
            if matched:
                motions += yield from ConfirmedTooEarly.finish(self, path[steps - 1 :])
                if isinstance(self, TwoVertices):
                    came_by = Algorithm1.confirmed_at(self, partner, path)
                    self.turned = self.s.offset(came_by, self.pointed)
                    yield Move(self.turned)
                    yield Move(0)
            return motions, matched

    return Believes


def wrong_where(kind: type[Plain], holds: Callable[[CombinatorialMap], bool]) -> type[Plain]:
    """The explorer that answers with a loop in worlds with a property."""

    class AnswersLoop(kind):  # type: ignore[valid-type,misc]
        def answer(self) -> Estimate:
            right = super().answer()
            return Estimate(build.cycle(1), 0) if holds(right.map) else right

    return AnswersLoop


def explorer(kind: type[Plain]) -> Callable[..., Any]:
    """The generator function of a class."""

    def explore(first: Percept, *, choices: Choices | None = None) -> Any:
        return (yield from kind(first, choices or Choices()).explore())

    explore.__qualname__ = kind.__name__
    return explore


# ---------------------------------------------------------------- slips


def views(map_: CombinatorialMap, depth: int) -> list[Any]:
    """Of each dart a number that is that of another dart if they look alike to that depth."""
    seen: list[Any] = list(map_.degree_at)
    for _ in range(depth):
        # Round the vertex, from the dart on: what is seen beyond each.
        around = [[seen[map_.alpha[map_.turn(d, k)]] for k in range(map_.degree_at[d])]
                  for d in map_.darts]  # fmt: skip
        numbers: dict[Any, int] = {}
        seen = [numbers.setdefault((map_.degree_at[d], *around[d]), d) for d in map_.darts]
    return seen


def two_alike(map_: CombinatorialMap) -> bool:
    """Whether two vertices look alike to depth 3."""
    seen = views(map_, 3)
    first: dict[Any, int] = {}
    return any(first.setdefault(v, u) != u for v, u in zip(seen, map_.vertex_of, strict=True))


def parallel(map_: CombinatorialMap) -> int:
    """The largest number of edges with the same two ends."""
    owner = map_.vertex_of
    ends = Counter(frozenset((owner[d], owner[e])) for d, e in map_.edges if owner[d] != owner[e])
    return max(ends.values(), default=0)


def loops_at_v0(map_: CombinatorialMap) -> int:
    """The number of loops at the vertex of dart 0."""
    owner = map_.vertex_of
    return sum(owner[d] == owner[e] == owner[0] for d, e in map_.edges)


BELIEFS = range(1, 13)
"""The numbers of fitting steps after which a hypothesis is believed."""

PROPERTIES: dict[str, Callable[[CombinatorialMap], bool]] = {
    "a degree of 6": lambda m: max(m.degrees) >= 6,
    "3 parallel edges": lambda m: parallel(m) >= 3,
    "genus 2": lambda m: m.genus == 2,
    "two alike to depth 3": two_alike,
    "past 30 edges": lambda m: m.edge_count > 30,
    "a second loop at v0": lambda m: loops_at_v0(m) >= 2,
}
"""The properties of worlds in which alone an explorer is wrong."""

SLIPS: dict[str, Callable[[type[Plain]], type[Plain]]] = {
    **{f"belief after {n}": lambda kind, n=n: believing(kind, n) for n in BELIEFS},  # type: ignore[misc]
    **{name: lambda kind, h=holds: wrong_where(kind, h) for name, holds in PROPERTIES.items()},  # type: ignore[misc]
}
"""Every slip: plants it."""


def wrong_in(kind: type[Plain], world: World) -> set[str]:
    """The slips that show in a world, of those planted in an explorer."""
    played = list[Plain]()

    def explore(first: Percept, choices: Choices, *_: object, **__: object) -> Any:
        played.append(kind(first, choices))
        return (yield from played[0].explore())

    playing.play_run(AroundExplorer(world), explore, Choices(), 10**6, [0, 0])
    return {f"belief after {n}" for n in BELIEFS if n <= played[0].fits} | {
        name for name, holds in PROPERTIES.items() if holds(world.map)
    }


# ---------------------------------------------------------------- samples


def before(edges: int, run: int, random: Random) -> CombinatorialMap:
    """A map as ``fuzz`` drew it before the mixture."""
    return OLD[run % len(OLD)](edges, random)


def looped_tree(edges: int, random: Random) -> CombinatorialMap:
    """A random plane tree in which some edges are loops instead, at random corners."""
    rotations: list[list[int]] = [[]]
    for edge in range(edges):
        vertex = random.choice(rotations)
        vertex.insert(random.randint(0, len(vertex)), edge)
        other = vertex if random.random() < 1 / 3 else []
        if other is not vertex:
            rotations.append(other)
        other.insert(random.randint(0, len(other)), edge)
    return rerooted(build.from_cycles(rotations), random)


def few_vertices(edges: int, random: Random) -> CombinatorialMap:
    """A uniform map with at most three vertices."""
    vertices = random.randint(1, 3)
    while True:
        map_ = families.random_map(edges, random)
        if map_.vertex_count <= vertices or edges + 1 < vertices:
            return map_


OLD = (families.random_map, looped_tree, glued(MapClass.PLANAR), lattice, few_vertices)
"""The parts before the mixture."""


def sample(options: argparse.Namespace, kind: Any) -> Iterator[World | None]:
    """The worlds of a sample, in their order; None where the lighthouse has no place."""
    if options.old:
        for run in range(options.runs):
            random = Random(f"{options.seed}/{run}")  # reproducible
            map_ = before(random.randint(1, options.edges), run, random)
            places = [*kind.places(map_, 0)]
            yield World(map_, random.choice(places), 0) if places else None
        return
    extent = Extent(MapClass.MAPS, options.edges)
    mix = tuple(options.mix.split(",")) if options.mix else default_mix(extent)
    for batch in batches(Sample(options.runs, options.seed, mix=mix), 1):
        for map_, places in batch.placed(extent, kind):
            yield World(map_, places[0][1], 0) if places else None


def first_wrong(options: argparse.Namespace, name: str) -> tuple[dict[str, int], int]:
    """The first run in which each slip shows, of an explorer; and the number of runs."""
    kind, lighthouse = EXPLORERS[name]
    found: dict[str, int] = {}
    end, runs = time.monotonic() + options.limit, 0
    for runs, world in enumerate(sample(options, kinds.lighthouse_kind(lighthouse).as_class), 1):
        for slip in wrong_in(kind, world) if world else ():
            found.setdefault(slip, runs)
        if len(found) == len(SLIPS) or time.monotonic() > end:
            break
    return found, runs


def main(line: list[str] | None = None) -> None:
    """The table."""
    parser = argparse.ArgumentParser(description="How soon are planted slips found?")
    parser.add_argument("--edges", type=int, default=60)
    parser.add_argument("--runs", type=int, default=1024)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--old", action="store_true", help="as before the mixture")
    parser.add_argument("--mix", help="as that of fuzz")
    parser.add_argument("--limit", type=float, default=1e9, help="seconds for each explorer")
    options = parser.parse_args(line)
    tables = {name: first_wrong(options, name) for name in EXPLORERS}
    print(f"{'slip':<24}" + "".join(f"{name:>12}" for name in EXPLORERS))
    for slip in SLIPS:
        runs = [str(found.get(slip, "-")) for found, _ in tables.values()]
        print(f"{slip:<24}" + "".join(f"{run:>12}" for run in runs))
    print(f"{'runs':<24}" + "".join(f"{runs:>12}" for _, runs in tables.values()))
    hits, every = sum(len(found) for found, _ in tables.values()), len(SLIPS) * len(EXPLORERS)
    print(f"{hits} of {every} are found: {hits / every:.0%}")


if __name__ == "__main__":
    main()
