"""Lower bounds: what testers need in corridors, what every explorer needs there and in bouquets."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import pairwise
from math import comb, prod
from random import Random
from typing import NamedTuple

from adversary import against
from allworlds import CombinatorialMap, World
from allworlds.claims import Found, Means, Unfinished, truth
from allworlds.maps import family
from corridors import Dart, Shape, usual_shape
from playing import run_here


def paper_bound(vertices: int, edges: int) -> int:
    """The sum of (1) and (2) of the paper on minimal information, Section VI."""
    n, m = vertices, edges
    growing = sum(s + 2 * (s - 1) * (2 * m - 2 * (s - 1)) for s in range(1, n))
    left = (2 * m - 2 * (n - 1) - 2 * (i - 1) for i in range(1, m - n + 2))
    return growing + sum(n + 2 * (n - 1) * darts for darts in left)


def order_exact(_: Means, *, far: int, explorers: list[str]) -> Found:
    """Play testers against the adversary of corridors, and look for what its proof rests on.

    The bounds of the theorem and (1)+(2) must hold, the world that is left must give the same
    walk, and both lemmas on home words must hold in it.
    """
    costs: dict[str, list[int]] = {name: [] for name in explorers}
    excluded = walks = pairs = 0
    holds = True
    for size in range(1, far + 1):
        shape = usual_shape(size)
        for name in explorers:
            made = against(name, shape, 1)
            costs[name].append(made.cost)
            excluded += made.deciding.excluded
            enough = made.cost >= shape.bound_of_testers
            enough &= made.deciding.excluded >= shape.excluded_by_testers
            bound = paper_bound(shape.hubs + 1, shape.edges)
            holds &= enough and made.same and not made.run.finding and made.cost <= bound
        map_ = family(f"corridor:{size}", seed=1)
        words = [*home_words(map_, shape)]
        seen = [wrong_walkers(map_, shape, y, word) for y, word in words]
        walks += len(seen) * (size * shape.degree - 1)
        pairs += len(words)
        holds &= not any(seen) and longest_common_prefix(words) <= size
    figures = {f"cost of {name}": some for name, some in costs.items()}
    witnesses = {"pairs excluded": excluded, "wrong walkers": walks, "home words": pairs}
    return Found(truth(holds), witnesses, figures)


Word = tuple[int, ...]


def home_words(map_: CombinatorialMap, shape: Shape) -> Iterator[tuple[Dart, Word]]:
    """Far darts with words of simple paths home: every way through far hubs, every way down."""
    for dart in map_.darts:
        if _level(dart, shape) > shape.near:
            for word in _ways(map_, shape, dart, frozenset()):
                yield dart, word


def _ways(
    map_: CombinatorialMap, shape: Shape, dart: Dart, avoided: frozenset[int]
) -> Iterator[Word]:
    here = _level(dart, shape)
    if not here:
        yield ()
        return
    hub = 2 + (here - 1) * shape.degree
    straight = hub - dart, hub + 1 - dart
    motions: Iterable[int] = range(shape.degree) if here > shape.near else straight
    for motion in motions:
        there = map_.alpha[map_.turn(dart, motion)]
        level = _level(there, shape)
        if (level >= shape.near or level < here <= shape.near) and level not in avoided | {here}:
            for word in _ways(map_, shape, there, avoided | {here}):
                yield (motion % shape.degree, *word)


def _level(dart: Dart, shape: Shape) -> int:
    """The number of the dart's vertex: 0, or that of its hub."""
    return 0 if dart < 2 else 1 + (dart - 2) // shape.degree


def wrong_walkers(map_: CombinatorialMap, shape: Shape, own: Dart, word: Word) -> int:
    """The number of other far darts from which a home word leads to v0, at any time."""
    walkers = [d for d in map_.darts if _level(d, shape) > shape.near and d != own]
    for motion in word:
        walkers = [map_.alpha[map_.turn(d, motion)] for d in walkers]
        if any(d < 2 for d in walkers):
            return sum(d < 2 for d in walkers)
    return 0


def longest_common_prefix(words: list[tuple[Dart, Word]]) -> int:
    """The largest number of first letters that words of different darts share."""
    longest = 0
    for (word, y), (other, z) in pairwise(sorted((word, y) for y, word in words)):
        if y != z:
            same = [a == b for a, b in zip(word, other, strict=False)]
            longest = max(longest, [*same, False].index(False))
    return longest


class _Skeleton(NamedTuple):
    """A corridor with a near hub and a far hub of some degree; the free darts are open."""

    sigma: tuple[Dart, ...]
    alpha: tuple[Dart, ...]
    free: tuple[Dart, ...]


def every_explorer_mn_log(_: Means, *, degree: int, explorers: list[str]) -> Found:
    """Count the logs of explorers in every corridor with one near and one far hub.

    The logs must differ, none may begin another, and the returns from the far hub must tell each;
    so the longest has at least as many motions as the count says.
    """
    given = [*_corridors(_skeleton(degree))]
    pairs = (degree - 2) // 2
    number, needed = prod(range(1, 2 * pairs, 2)), 0
    while sum(comb(needed, y) * 2**y for y in range(needed // 4 + 1)) < number:
        needed += 1
    holds, longest, returns = len(given) == number, list[int](), 0
    for name in explorers:
        logs = [_walked(name, world) for world in given]
        sensed = {tuple(log) for log, _ in logs}
        told = {far for _, far in logs}
        returns += sum(len(far) for far in told)
        ordered = sorted(sensed)
        begun = any(b[: len(a)] == a for a, b in pairwise(ordered))
        holds &= len(sensed) == len(told) == number and not begun
        holds &= all(4 * len(far) <= len(log) for log, far in logs)
        longest.append(max(len(log) - 1 for log in sensed))
    witnesses = {"worlds": number, "returns from the far hub": returns}
    figures = {"motions needed": needed, "motions of each": longest}
    return Found(truth(holds and min(longest) >= needed), witnesses, figures)


def _skeleton(degree: int) -> _Skeleton:
    """Vertex 0, then a near hub whose out-darts are its last two, then a far hub."""
    near, far = 2, 2 + degree
    sigma = [1, 0]
    for hub in (near, far):
        sigma += [*range(hub + 1, hub + degree), hub]
    alpha = [*range(2 + 2 * degree)]
    joined = [(0, near), (1, near + 1), (near + degree - 2, far), (near + degree - 1, far + 1)]
    loops = [*range(near + 2, near + degree - 2)]
    Random(1).shuffle(loops)  # noqa: S311  # reproducible
    for d, e in (*joined, *zip(loops[::2], loops[1::2], strict=True)):
        alpha[d], alpha[e] = e, d
    return _Skeleton(tuple(sigma), tuple(alpha), tuple(range(far + 2, far + degree)))


def _corridors(skeleton: _Skeleton) -> Iterator[World]:
    """Every world of a skeleton."""
    if not skeleton.free:
        yield World(CombinatorialMap(skeleton.sigma, skeleton.alpha), "directional")
        return
    d, *others = skeleton.free
    for e in others:
        alpha = list(skeleton.alpha)
        alpha[d], alpha[e] = e, d
        rest = tuple(x for x in others if x != e)
        yield from _corridors(_Skeleton(skeleton.sigma, tuple(alpha), rest))


def _walked(name: str, world: World) -> tuple[list[int], tuple[tuple[int, int], ...]]:
    """The bearings of a run, -1 at hubs; and its far returns: when, and with which bearing."""
    told = run_here(name, world)
    if told.finding:
        raise Unfinished(f"{name} breaks a law in {world}")
    state, sensed, far, been = world.initial, [0], list[tuple[int, int]](), False
    degree = (len(world.map.sigma) - 2) // 2
    for time, action in enumerate(told.transcript.actions, 1):
        state, percept = world.step(state, action)
        sensed.append(-1 if percept.bearing is None else percept.bearing)
        been = been or state.dart >= 2 + degree
        if percept.marks:
            if been:
                far.append((time, sensed[-1]))
            been = False
    return sensed, tuple(far)
