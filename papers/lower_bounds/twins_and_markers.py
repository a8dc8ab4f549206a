"""Claims about position, and about markers at one vertex: the smallest twins; who needs what."""

from __future__ import annotations

from collections import defaultdict
from itertools import product

from allworlds import Drop, Move, Pick, World, ambiguity, check
from allworlds.claims import Found, Means, Picture, Unfinished, of_check, truth
from allworlds.maps import (
    CombinatorialMap,
    MapClass,
    from_rotation,
    named_map,
    project,
    rooted_maps,
    unrooted_code,
)

SMALLEST = {MapClass.MAPS: 2, MapClass.SIMPLE: 6, MapClass.PLANAR_SIMPLE: 8}
"""The sizes that the sentences about the smallest worlds name."""


def _smallest(map_class: MapClass, edges: int, *pair: World) -> Found:
    """The first number of edges with two worlds that look alike; a pair that must be among them."""
    report = ambiguity.census(edges=edges, map_class=map_class)
    if report.exit_code:
        raise Unfinished(f"the census of {map_class} ended with exit code {report.exit_code}")
    ambiguous = [row for row in report.rows if row.classes]
    seen = {"marked worlds": sum(row.marked_worlds for row in report.rows)}
    if not ambiguous:
        return Found("refuted", seen)
    first = ambiguous[0]
    figures = {"edges": first.edges, "classes": first.classes or 0}
    below = sum(row.marked_worlds for row in report.rows if row.edges < first.edges)
    as_said = first.edges == SMALLEST[map_class] and (not pair or _of_size(first.edges, *pair))
    return Found(truth(as_said), {**seen, "smaller worlds, none ambiguous": below}, figures)


def _of_size(edges: int, one: World, other: World) -> bool:
    return one.map.edge_count == edges and ambiguity.twins(one, other).twins


def smallest_twins(_: Means, *, edges: int) -> Found:
    """Find the smallest of all maps: one vertex, its two loops side by side and crossed."""
    names = ("two-loops-plane", "two-loops-torus")
    one, other = (World(named_map(name), "position") for name in names)
    return _smallest(MapClass.MAPS, edges, one, other)


def smallest_simple_twins(_: Means, *, edges: int) -> Found:
    """Find the smallest simple ones: K4 in the plane, and on the torus with faces of 3 and 9."""
    torus = from_rotation([[1, 2, 3], [0, 2, 3], [0, 3, 1], [0, 1, 2]])
    return _smallest(
        MapClass.SIMPLE, edges, World(named_map("k4"), "position"), World(torus, "position")
    )


def smallest_planar_simple_twins(_: Means, *, edges: int) -> Found:
    """Find the smallest simple ones in the plane."""
    return _smallest(MapClass.PLANAR_SIMPLE, edges)


def cycle_needs_information(_: Means, *, edges: int) -> Found:
    """Each map with a cycle beside its double cover along an edge of that cycle."""
    covered = alike = 0
    for m in range(1, edges + 1):
        for map_ in rooted_maps(m):
            cover = double_cover(map_)
            if cover is None:
                continue
            covered += 1
            result = ambiguity.twins(World(map_, "none"), World(cover, "none"))
            alike += not result.distinguishable and cover.edge_count == 2 * map_.edge_count
    return Found(truth(covered == alike), {"worlds with a cycle": covered})


def double_cover(map_: CombinatorialMap) -> CombinatorialMap | None:
    """Two copies of the map that change places along one edge of a cycle; None for a tree."""
    if map_.edge_count < map_.vertex_count:
        return None
    size = len(map_.sigma)
    sigma = [d + size * i for i in range(2) for d in map_.sigma]
    for crossed in map_.darts:
        exchanged = {crossed, map_.alpha[crossed]}
        alpha = [
            other + size * (i ^ (dart in exchanged))
            for i in range(2)
            for dart, other in enumerate(map_.alpha)
        ]
        if _connected(sigma, alpha):
            return CombinatorialMap(sigma, alpha)
    raise Unfinished("a map with a cycle has no edge on it")


def _connected(sigma: list[int], alpha: list[int]) -> bool:
    seen = {0}
    for dart in (queue := [0]):
        for following in (sigma[dart], alpha[dart]):
            if following not in seen:
                seen.add(following)
                queue.append(following)
    return len(seen) == len(sigma)


def trees_need_none(_: Means, *, edges: int) -> Found:
    """All maps by what can be learnt without a marker: with a tree there is no other map."""
    alike: dict[object, set[object]] = defaultdict(set)
    trees = []
    compared = 0
    for m in range(1, edges + 1):
        for map_ in rooted_maps(m):
            labels = [0] * len(map_.sigma)
            quotient = project((map_, labels, 0)).quotient
            learnt = (quotient.sigma, quotient.alpha, quotient.degree)
            alike[learnt].add(unrooted_code(map_))
            compared += 1
            if map_.edge_count < map_.vertex_count:
                trees.append(learnt)
    alone = all(len(alike[learnt]) == 1 for learnt in trees)
    return Found(truth(alone), {"trees": len(trees), "maps": compared})


def markers_at_one_vertex(_: Means, *, markers: int, actions: int) -> Found:
    """Two loops, side by side and crossed: every list of motions, drops and pick-ups."""
    one, other = (
        World(named_map(name), f"movable:markers={markers}")
        for name in ("two-loops-plane", "two-loops-torus")
    )
    legal = [*(Move(k) for k in range(4)), Drop(), Pick()]
    lists = 0
    equal = one.first == other.first
    frontier = [(one.initial, other.initial)]
    for _step in range(actions):
        following = []
        for (a, b), action in product(frontier, legal):
            if (isinstance(action, Drop) and not a.hand) or (
                isinstance(action, Pick) and a.hand == markers
            ):
                continue
            (x, seen), (y, beside) = one.step(a, action), other.step(b, action)
            lists += 1
            equal = equal and seen == beside
            following.append((x, y))
        frontier = following
    different = unrooted_code(one.map) != unrooted_code(other.map)
    pictures = (Picture("side by side", one), Picture("crossed", other))
    return Found(truth(equal and different), {"lists of actions": lists}, {}, pictures)


def position_robot(means: Means, *, edges: int) -> Found:
    """The explorer ``quotient``: the map where only one looks so, else the quotient."""
    report = check("quotient", edges=edges, workers=means.workers)
    return of_check(report, "map", "ambiguous")
