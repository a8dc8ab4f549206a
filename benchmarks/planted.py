"""How soon random worlds refute planted slips: the mixture of ``fuzz`` beside the one before it.

    python benchmarks/planted.py [--edges M] [--runs R] [--seed S] [--old] [--mix NAMES] [--limit S]
    python benchmarks/planted.py --hard
    python benchmarks/planted.py --shrink M

Each slip is planted in three explorers: Algorithm 1, its variant for a marker cluster, and
Algorithm 1 depth first.  A line for each slip has the number of the first run that is wrong in
each; the last line has the rate that is found.  ``--old`` draws as ``fuzz`` did before the mixture.
``--limit`` ends the drawing for each explorer after so many seconds.

``--hard`` plants slips that the mixture seldom finds in some hundred worlds, and tells for each
whether the worlds that ``fuzz`` breeds from the first block of draws find it.

``--shrink`` makes findings smaller whose smallest world, of all with up to M edges, is known: a
line for each slip with the size of that world, the one that is reached from some 50 to 60 edges,
and seconds of the processor.

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
from allworlds.engines.lanes import workers_for
from allworlds.engines.limits import Limits
from allworlds.engines.units import Sample, Scope
from allworlds.explorers.builtin.algorithm1 import Algorithm1, Stage, TwoVertices
from allworlds.explorers.loading import in_process_subject
from allworlds.judging.episode import AroundExplorer
from allworlds.judging.findings.finding import place_of
from allworlds.judging.referee import Examiner
from allworlds.judging.rules import Rules
from allworlds.maps import build, families
from allworlds.maps.classes import Extent, MapClass
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.enumeration import rooted_maps
from allworlds.maps.mixture import default_mix, glued, lattice, rerooted
from allworlds.protocol import playing
from allworlds.protocol.actions import Estimate, Move, Percept
from allworlds.protocol.choices import Choices
from allworlds.studies.fuzz import breeding, sampling, shrinking
from allworlds.world.lighthouses import kinds
from allworlds.world.world import World

# ---------------------------------------------------------------- explorers


class Plain(Algorithm1):
    """Algorithm 1."""

    fits = rejected = length = 0
    passes: frozenset[tuple[int, ...]] = frozenset()

    def test_all(self, hypotheses: list[int]) -> Stage[int | None]:
        """Lines 7-17; of a pass that closes an edge it is noted how that came about."""
        self.rejected = self.length = 0
        partner = yield from super().test_all(hypotheses)
        if partner is not None:
            degree, vertices = self.s.expected[partner].degree, len(self.s.first)
            met = (degree, self.rejected, self.length, vertices // 4)
            self.passes |= {met}
            self.closes(*met)
        return partner

    def closes(self, degree: int, rejected: int, length: int, fours: int) -> None:
        """Hear of a pass that closes an edge."""

    def try_path(self, partner: int, path: list[int]) -> Stage[tuple[list[int], bool]]:
        """Lines 10-13; of a wrong hypothesis it is noted how many steps have fitted."""
        motions, matched = yield from super().try_path(partner, path)
        self.length = len(path)
        if not matched:
            self.rejected += 1
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
        def try_path(self, partner: int, path: list[int]) -> Stage[tuple[list[int], bool]]:
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


def wrong_behind(kind: type[Plain], met: tuple[int, ...]) -> type[Plain]:
    """The explorer that answers with a loop after a pass that meets four conditions."""

    class AnswersLoopBehind(kind):  # type: ignore[valid-type,misc]
        wrong = False

        def closes(self, degree: int, rejected: int, length: int, fours: int) -> None:
            if degree != met[0]:
                return
            if rejected != met[1]:
                return
            if length != met[2]:
                return
            if fours != met[3]:
                return
            self.wrong = True

        def answer(self) -> Estimate:
            right = super().answer()
            return Estimate(build.cycle(1), 0) if self.wrong else right

    return AnswersLoopBehind


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

LATE = (24, 32)
"""Numbers of fitting steps that are rare."""

BEHIND = ((8, 4, 2, 3), (7, 2, 5, 2), (8, 5, 4, 1), (9, 3, 3, 4), (6, 9, 6, 3), (5, 1, 5, 9))
"""Four conditions, each a line of its own: the degree, hypotheses rejected, the length of the test,
and the vertices by fours.  About one world of a thousand meets them."""

HARD: dict[str, Callable[[type[Plain]], type[Plain]]] = {
    **{f"belief after {n}": lambda kind, n=n: believing(kind, n) for n in LATE},  # type: ignore[misc]
    **{f"behind {met}": lambda kind, met=met: wrong_behind(kind, met) for met in BEHIND},  # type: ignore[misc]
}
"""Slips that are hard to find."""


def wrong_in(kind: type[Plain], world: World) -> set[str]:
    """The slips that show in a world, of those planted in an explorer."""
    played = list[Plain]()

    def explore(first: Percept, choices: Choices, *_: object, **__: object) -> Any:
        played.append(kind(first, choices))
        return (yield from played[0].explore())

    playing.play_run(AroundExplorer(world), explore, Choices(), 10**6, [0, 0])
    return (
        {f"belief after {n}" for n in (*BELIEFS, *LATE) if n <= played[0].fits}
        | {name for name, holds in PROPERTIES.items() if holds(world.map)}
        | {f"behind {met}" for met in BEHIND if met in played[0].passes}
    )


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
    least = getattr(options, "min_edges", 1)
    for batch in sampling.batches(Sample(options.runs, options.seed, least, mix=mix)):
        for map_, places in batch.placed(extent, kind):
            yield World(map_, places[0][1], 0) if places else None


def first_wrong(options: argparse.Namespace, name: str) -> tuple[dict[str, int], int]:
    """The first run in which each slip shows, of an explorer; and the number of runs."""
    kind, lighthouse = EXPLORERS[name]
    found: dict[str, int] = {}
    wanted = HARD if options.hard else SLIPS
    end, runs = time.monotonic() + options.limit, 0
    for runs, world in enumerate(sample(options, kinds.lighthouse_kind(lighthouse).as_class), 1):
        for slip in wrong_in(kind, world) & {*wanted} if world else ():
            found.setdefault(slip, runs)
        if len(found) == len(wanted) or time.monotonic() > end:
            break
    return found, runs


def found_by_breeding(options: argparse.Namespace, name: str, slip: str) -> bool:
    """Whether a world bred from the first block of the sample seems to refute."""
    kind, lighthouse = EXPLORERS[name]
    extent, rules = Extent(MapClass.MAPS, options.edges), Rules(lighthouse, bound="none")
    block = breeding.Bred(
        sampling.Batch(options.seed, 0, breeding.DRAWS_TRACED, default_mix(extent))
    )
    subject = in_process_subject(explorer(HARD[slip](kind)))
    return any(True for _ in breeding.bred(block, Scope(extent, rules), subject, Limits()))


def show_hard(options: argparse.Namespace) -> None:
    """A line for each hard slip: the first run that is wrong, and whether a bred world is."""
    block = breeding.DRAWS_PER_BLOCK
    more, bred, every = block + breeding.BRED_PER_BLOCK, [0, 0, 0], 0
    options.runs = more
    for name in options.only.split(",") if options.only else EXPLORERS:
        found, _ = first_wrong(options, name)
        for slip in HARD:
            run, by_breeding = found.get(slip, more + 1), found_by_breeding(options, name, slip)
            hits = run <= block, run <= more, run <= block or by_breeding
            bred, every = [a + b for a, b in zip(bred, hits, strict=True)], every + 1
            drawn = str(run) if run <= more else "-"
            print(f"{name:<12}{slip:<24}{drawn:>6}{'bred' if by_breeding else '-':>6}", flush=True)
    drawn, longer, both = bred
    print(
        f"of {every}: {block} draws {drawn}, {more} draws {longer}, {block} draws and bred {both}"
    )


# ---------------------------------------------------------------- shrinking


def smallest_worlds(name: str, edges: int) -> dict[str, tuple[int, int]]:
    """Edges and vertices of the smallest world in which each slip shows, of all with few edges."""
    kind, lighthouse = EXPLORERS[name]
    found: dict[str, tuple[int, int]] = {}
    for map_ in (map_ for m in range(1, edges + 1) for map_ in rooted_maps(m)):
        size = map_.edge_count, map_.vertex_count
        for place in kinds.lighthouse_kind(lighthouse).as_class.places(map_, 0):
            for slip in wrong_in(kind, World(map_, place, 0)):
                found[slip] = min(size, found.get(slip, size))
    return found


def shrunk(options: argparse.Namespace, name: str) -> Iterator[tuple[str, Any, Any, float, float]]:
    """Each slip whose smallest world is known, with the world at which the shrinker ends.

    It begins with the first large world of the sample that refutes.  Yielded are the slip, the
    smallest size, the one that is reached, and seconds of the processor and by the clock.
    """
    kind, lighthouse = EXPLORERS[name]
    least, limits = smallest_worlds(name, options.shrink), Limits(workers=1)
    rules = Rules(lighthouse, bound="none")
    for world in sample(options, rules.kind):
        for slip in sorted(wrong_in(kind, world) & {*least} & {*SLIPS} if world else ()):
            subject = in_process_subject(explorer(SLIPS[slip](kind)))
            examiner, size = Examiner(subject, rules), least.pop(slip)
            outcome = examiner.examine(world, Choices())
            finding = examiner.finding(world, place_of(world), outcome)
            began = time.process_time(), time.monotonic()
            with workers_for(subject, limits, None) as workers:
                scope = Scope(Extent(MapClass.MAPS, options.edges), rules)
                reached = shrinking.smallest_from(finding, workers, scope).key[:2]
            yield slip, size, reached, time.process_time() - began[0], time.monotonic() - began[1]


def show_shrunk(options: argparse.Namespace) -> None:
    """A line for each slip: its smallest world, and the one that is reached."""
    right = every = 0
    for name in options.only.split(",") if options.only else EXPLORERS:
        for slip, size, reached, seconds, _ in shrunk(options, name):
            right, every = right + (size == reached), every + 1
            print(f"{name:<12}{slip:<24}{size!s:>8}{reached!s:>9}{seconds:>8.1f} s", flush=True)
    print(f"{right} of {every} end at the smallest world: {right / max(every, 1):.0%}")


def main(line: list[str] | None = None) -> None:
    """The table."""
    parser = argparse.ArgumentParser(description="How soon are planted slips found?")
    parser.add_argument("--edges", type=int, default=60)
    parser.add_argument("--runs", type=int, default=1024)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--old", action="store_true", help="as before the mixture")
    parser.add_argument("--mix", help="as that of fuzz")
    parser.add_argument("--limit", type=float, default=1e9, help="seconds for each explorer")
    parser.add_argument("--shrink", type=int, metavar="M", help="slips with a world of M edges")
    parser.add_argument("--hard", action="store_true", help="slips that are hard to find")
    parser.add_argument("--only", help="these explorers")
    options = parser.parse_args(line)
    if options.hard:
        show_hard(options)
        return
    if options.shrink:
        options.min_edges = options.edges * 4 // 5
        show_shrunk(options)
        return
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
