"""Maps, worlds and what a robot senses, for the checkers: the definitions, read off as code.

A map is a pair of lists ``(sigma, alpha)`` over the darts ``0..2m-1``: sigma the next dart
clockwise round the vertex, alpha the other end of the edge.  Motion k takes a robot from dart d
to ``alpha(sigma^k(d))``; so whatever sigma and alpha keep, every motion keeps.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from lrat import Refused

Map = tuple[Sequence[int], Sequence[int]]
Code = tuple[tuple[int, ...], tuple[int, ...]]


@dataclass(frozen=True)
class World:
    """A map, the dart that the robot faces at the start, and what it can sense.

    Attributes:
        lighthouse: ``none``, ``position``, ``directional``, ``compass`` or ``natural``.
        darts: the reference darts: any dart of v0 (position), the pointed dart of v0
            (directional), one at every vertex (compass), a dart from v0 to v1 (natural).
    """

    sigma: Sequence[int]
    alpha: Sequence[int]
    start: int
    lighthouse: str
    darts: tuple[int, ...]

    @property
    def map(self) -> Map:
        """The map alone."""
        return self.sigma, self.alpha


def orbit(permutation: Sequence[int], dart: int) -> list[int]:
    """The cycle of a dart, from it."""
    found = [dart]
    while permutation[found[-1]] != dart:
        found.append(permutation[found[-1]])
    return found


def cycle_count(permutation: Sequence[int]) -> int:
    """The number of cycles."""
    return sum(min(orbit(permutation, dart)) == dart for dart in range(len(permutation)))


def require_map(sigma: Sequence[int], alpha: Sequence[int]) -> None:
    """Raise Refused, saying why, unless the two lists are a connected map."""
    darts = list(range(len(sigma)))
    if not darts or sorted(sigma) != darts or sorted(alpha) != darts:
        raise Refused("sigma or alpha is no permutation of the darts")
    if any(alpha[d] == d or alpha[alpha[d]] != d for d in darts):
        raise Refused("alpha is no involution without fixed points")
    if len(numbering(sigma, alpha, 0)) != len(darts):
        raise Refused("the map is not connected")


def numbering(sigma: Sequence[int], alpha: Sequence[int], root: int) -> list[int]:
    """The darts as a breadth-first walk from the root meets them, sigma before alpha."""
    order = [root]
    for dart in order:
        order += [e for e in dict.fromkeys((sigma[dart], alpha[dart])) if e not in order]
    return order


def code(sigma: Sequence[int], alpha: Sequence[int], root: int) -> Code:
    """Equal exactly for the same rooted map: sigma and alpha in the walk's numbers."""
    order = numbering(sigma, alpha, root)
    number = {dart: i for i, dart in enumerate(order)}
    return tuple(number[sigma[d]] for d in order), tuple(number[alpha[d]] for d in order)


def vertex_count(map_: Map) -> int:
    """The number of vertices, n."""
    return cycle_count(map_[0])


def is_planar(map_: Map) -> bool:
    """Euler's formula: n - m + f = 2."""
    sigma, alpha = map_
    faces = cycle_count([sigma[e] for e in alpha])
    return cycle_count(sigma) - len(sigma) // 2 + faces == 2


def is_simple(map_: Map) -> bool:
    """No loop, and as many joined pairs of vertices as edges."""
    sigma, alpha = map_
    vertex = [min(orbit(sigma, d)) for d in range(len(sigma))]
    joined = {frozenset((vertex[d], vertex[e])) for d, e in enumerate(alpha)}
    return all(len(ends) == 2 for ends in joined) and len(joined) == len(sigma) // 2


def rooted_maps(
    edges: int,
    *,
    simple: bool = False,
    most: int | None = None,
    degrees: tuple[int, int] | None = None,
) -> Iterator[Map]:
    """Every map with so many edges (and at most ``most`` vertices), once for each root, dart 0.

    ``degrees``: that of the root's vertex, and that of all others, where they are fixed.
    The oldest dart without a partner gets one: another such dart, or the first dart of a new
    vertex of any degree.  Every rooted map comes about in exactly one such way.
    """
    limit = edges + 1 if most is None else most
    alpha: list[int] = []
    owner: list[int] = []

    def grown(vertex: int) -> Iterator[Map]:
        if -1 not in alpha:
            if len(alpha) == 2 * edges:
                yield _clockwise(owner), alpha[:]
            return
        old = alpha.index(-1)
        for new in range(old + 1, len(alpha)):
            if alpha[new] == -1 and not (simple and _joined(owner[old], owner[new])):
                alpha[old], alpha[new] = new, old
                yield from grown(vertex)
                alpha[old] = alpha[new] = -1
        if vertex < limit:
            for degree in legal(2 * edges - len(alpha), 1):
                alpha[old] = len(alpha)
                yield from with_vertex(vertex, degree, old)
                alpha[old] = -1

    def with_vertex(vertex: int, degree: int, partner: int) -> Iterator[Map]:
        size = len(alpha)
        alpha.extend([partner] + [-1] * (degree - 1))
        owner.extend([vertex] * degree)
        yield from grown(vertex + 1)
        del alpha[size:], owner[size:]

    def _joined(u: int, v: int) -> bool:
        return u == v or any(
            owner[d] == u and e != -1 and owner[e] == v for d, e in enumerate(alpha)
        )

    def legal(largest: int, place: int) -> Iterator[int]:
        for degree in range(1, largest + 1):
            if degrees is None or degrees[place] == degree:
                yield degree

    for degree in legal(2 * edges, 0):
        yield from with_vertex(0, degree, -1)


def _clockwise(owner: list[int]) -> list[int]:
    """sigma, where the darts of a vertex are consecutive."""
    return [
        d + 1 if d + 1 < len(owner) and owner[d + 1] == v else owner.index(v)
        for d, v in enumerate(owner)
    ]


def percepts(world: World) -> list[tuple[Any, ...]]:
    """For each dart what is sensed there: the degree, and what the lighthouse shows.

    none: nothing.  position: whether the vertex is that of the start.  natural: nothing (the
    degrees themselves are the lighthouse).  compass: the bearing of the vertex's reference
    dart.  directional: at the marked vertex the bearing of the pointed dart.

    Raises:
        Refused: if there is no such lighthouse.
    """
    home = orbit(world.sigma, world.start)
    sensed: list[tuple[Any, ...]] = []
    for d in range(len(world.sigma)):
        around = orbit(world.sigma, d)
        bearings = [place for place, e in enumerate(around) if e in world.darts]
        match world.lighthouse:
            case "none" | "natural":
                shown: list[Any] = []
            case "position":
                shown = [d in home]
            case "directional" | "compass":
                shown = bearings
            case other:
                raise Refused(f"there is no lighthouse {other!r}")
        sensed.append((len(around), *shown))
    return sensed


def world_code(world: World) -> tuple[Code, tuple[int, ...]]:
    """Equal exactly for worlds that are the same but for the start.

    Where v0 is marked, or known by its degree, v0 must go to v0; where a direction is sensed,
    reference darts must go to reference darts.
    """
    somewhere = world.lighthouse in {"none", "compass"}
    pointed = world.darts if world.lighthouse in {"directional", "compass"} else ()
    entries = []
    for start in range(len(world.sigma)) if somewhere else orbit(world.sigma, world.start):
        order = numbering(*world.map, start)
        marks = tuple(sorted(order.index(dart) for dart in pointed))
        entries.append((code(*world.map, start), marks))
    return min(entries)


def quotient_code(world: World) -> tuple[Any, ...]:
    """Equal exactly for worlds that no motion tells apart."""
    return look(world.map, percepts(world), world.start)


def look(map_: Map, sensed: Sequence[tuple[Any, ...]], start: int) -> tuple[Any, ...]:
    """Equal exactly for maps, with what is sensed at each dart, that no motion tells apart.

    Darts that sense the same are split until sigma and alpha keep the classes; then the
    classes are numbered by a walk from the start's.  Values that are sensed have an order.
    """
    sigma, alpha = map_
    names = {percept: i for i, percept in enumerate(sorted(set(sensed)))}
    label = [names[percept] for percept in sensed]
    count = 0
    while count < len(set(label)):
        count = len(set(label))
        keys = [(label[d], label[sigma[d]], label[alpha[d]]) for d in range(len(sigma))]
        order = {key: i for i, key in enumerate(sorted(set(keys)))}
        label = [order[key] for key in keys]
    some = {c: d for d, c in enumerate(label)}
    step, cross = ([label[p[some[c]]] for c in range(count)] for p in (sigma, alpha))
    walk = numbering(step, cross, label[start])
    number = {c: i for i, c in enumerate(walk)}
    return tuple((sensed[some[c]], number[step[c]], number[cross[c]]) for c in walk)


def require_bisimulation(pair: Sequence[World], classes: Sequence[Sequence[int]]) -> None:
    """Raise Refused unless the classes show that no motion tells the two worlds apart.

    The starts are in one class, sigma and alpha take each class to one class, and the darts
    of a class sense the same.
    """
    if len(pair) != 2 or len(classes) != 2:
        raise Refused("not two worlds with their classes")
    facts: dict[int, tuple[Any, ...]] = {}
    for world, label in zip(pair, classes, strict=True):
        sigma, alpha = world.map
        if len(label) != len(sigma):
            raise Refused("not one class for each dart")
        for d, percept in enumerate(percepts(world)):
            fact = (percept, label[sigma[d]], label[alpha[d]])
            if facts.setdefault(label[d], fact) != fact:
                raise Refused(f"dart {d} does not behave as its class {label[d]}")
    if classes[0][pair[0].start] != classes[1][pair[1].start]:
        raise Refused("the starts are in different classes")


def twins_among(worlds: Iterator[World]) -> tuple[int, list[World] | None]:
    """How many worlds there were, and two different ones that no motion tells apart, if any."""
    first: dict[tuple[Any, ...], tuple[Any, World]] = {}
    count = 0
    for world in worlds:
        count += 1
        mine = world_code(world)
        other, twin = first.setdefault(quotient_code(world), (mine, world))
        if other != mine:
            return count, [twin, world]
    return count, None


def rooted_world(map_: Map, lighthouse: str) -> World:
    """The map started at its root, which is the reference dart."""
    return World(*map_, 0, lighthouse, (0,))


def moved(map_: Map, dart: int, motion: int) -> int:
    """Where a motion leads from a dart."""
    sigma, alpha = map_
    around = orbit(sigma, dart)
    return alpha[around[motion % len(around)]]


def replay(world: World, start: int, motions: Sequence[int]) -> list[tuple[Any, ...]]:
    """The percepts after each motion of a walk from a dart."""
    sensed, dart, seen = percepts(world), start, []
    for motion in motions:
        dart = moved(world.map, dart, motion)
        seen.append(sensed[dart])
    return seen
