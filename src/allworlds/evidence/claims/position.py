"""Section III: without a marker, with a marker that points nowhere, with directions alone."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator
from itertools import combinations, product

from allworlds.evidence.claims.claim_types import (
    Checks,
    Found,
    Means,
    Picture,
    Unfinished,
    of_check,
    smallest,
    truth,
)
from allworlds.maps import (
    CombinatorialMap,
    Dart,
    Labelled,
    MapClass,
    cycle,
    named_map,
    project,
    rooted_maps,
    unrooted_code,
)
from allworlds.protocol import Action, Drop, Move, Pick
from allworlds.studies.ambiguity import census, sensed, twins
from allworlds.studies.check import check
from allworlds.world import Compass, Directional, Movable, Nothing, Position, World, own_corpus

FIGURE_1 = ("fig1-left", "fig1-right")
CAPTION = (1, 1, 2, 2, 1)
SENSED_IN_CAPTION = ("3A", "3A", "3A", "3A", "4P")

SMALLEST = {MapClass.MAPS: 2, MapClass.SIMPLE: 6, MapClass.PLANAR_SIMPLE: 8}
"""The sizes that the sentences about the smallest worlds name."""


def _cycles(lighthouse: Callable[[int], World], length: int) -> Iterator[tuple[World, World]]:
    return combinations([lighthouse(n) for n in range(1, length + 1)], 2)


def _plain(n: int) -> World:
    return World(cycle(n), Nothing())


def _marked(n: int) -> World:
    return World(cycle(n), Position(0))


def _north(n: int) -> World:
    """Every reference dart points on along the cycle, so that directions are global."""
    map_ = cycle(n)
    dart, darts = 0, []
    for _ in range(n):
        darts.append(dart)
        dart = map_.sigma[map_.alpha[dart]]
    return World(map_, Compass(tuple(sorted(darts))))


def _compared(lighthouse: Callable[[int], World], length: int, *, apart: bool) -> Found:
    pairs = as_said = 0
    for one, other in _cycles(lighthouse, length):
        pairs += 1
        as_said += twins(one, other).distinguishable == apart
    pictures = tuple(Picture(f"the cycle of {n}", lighthouse(n)) for n in (3, 4) if n <= length)
    return Found(truth(pairs == as_said), {"pairs": pairs}, {}, pictures)


def _walked_together(one: World, other: World) -> tuple[int, bool]:
    """Pairs of darts reached by equal motions, and whether both always sense the same.

    No partition and no certificate: motions are tried until two percepts differ, or until no
    new pair of darts comes.
    """
    met = {(one.start, other.start)}
    for x, y in (queue := [(one.start, other.start)]):
        if one.percepts[x] != other.percepts[y]:
            return len(met), False
        for k in range(one.percepts[x].degree):
            pair = (one.map.alpha[one.map.turn(x, k)], other.map.alpha[other.map.turn(y, k)])
            if pair not in met:
                met.add(pair)
                queue.append(pair)
    return len(met), True


def no_information(_: Means, *, length: int) -> Found:
    """Walk all motions at once in two cycles without a marker; as a control with one."""
    plain = [_walked_together(*pair) for pair in _cycles(_plain, length)]
    control = [_walked_together(*pair) for pair in _cycles(_marked, length)]
    witnesses = {
        "pairs": len(plain),
        "pairs of darts": sum(met for met, _ in plain),
        "told apart with a marker": sum(not alike for _, alike in control),
    }
    pictures = tuple(Picture(f"the cycle of {n}", _plain(n)) for n in (3, 4) if n <= length)
    return Found(truth(all(alike for _, alike in plain)), witnesses, {}, pictures)


def two_door_rooms(_: Means, *, length: int) -> Found:
    """A cycle with all that looks alike taken together is one class of darts, of degree 2."""
    quotients = [
        project(Labelled(w.map, w.percepts, 0)).quotient for w in map(_plain, range(1, length + 1))
    ]
    alike = all((q.sigma, q.alpha, q.degree) == ((0,), (0,), (2,)) for q in quotients)
    return Found(truth(alike), {"cycles": len(quotients)})


def orientation_alone(_: Means, *, length: int) -> Found:
    """Two cycles with global directions: no motion tells them apart."""
    return _compared(_north, length, apart=False)


def position_tells_cycles(_: Means, *, length: int) -> Found:
    """Two cycles with one marked vertex each: some motion tells them apart."""
    return _compared(_marked, length, apart=True)


def _figure_1() -> tuple[World, World]:
    one, other = (World(named_map(name), Position(0)) for name in FIGURE_1)
    return one, other


def _figure_1_pictures() -> tuple[Picture, ...]:
    return tuple(
        Picture(f"{side} graph", world)
        for side, world in zip(("left", "right"), _figure_1(), strict=True)
    )


def figure_1_alike(_: Means) -> Found:
    """Walk all motions at once from each dart of v0; as a control with a direction there."""
    one, other = _figure_1()
    starts = [one.map.turn(0, k) for k in range(one.first.degree)]
    walked = [_walked_together(World(one.map, Position(dart), dart), other) for dart in starts]
    pointed = World(other.map, Directional(0))
    control = [
        _walked_together(World(one.map, Directional(0), dart), pointed)
        for dart in one.map.vertices[one.map.vertex_of[0]]
    ]
    witnesses = {
        "starts": len(starts),
        "pairs of darts": sum(met for met, _ in walked),
        "told apart with a direction": sum(not alike for _, alike in control),
    }
    return Found(truth(all(alike for _, alike in walked)), witnesses, {}, _figure_1_pictures())


def figure_1_different(_: Means) -> Found:
    """No dart of the right graph gives the code of the left one."""
    one, other = _figure_1()
    different = unrooted_code(one.map) != unrooted_code(other.map)
    sizes = [one.map.edge_count, one.map.vertex_count, one.map.genus, other.map.genus]
    rootings = len(one.map.sigma) + len(other.map.sigma)
    figures = {"edges vertices genus genus": sizes}
    return Found(truth(different), {"rootings": rootings}, figures, _figure_1_pictures())


def figure_1_caption(_: Means) -> Found:
    """Compare the percepts of the caption's motions with the caption, on both graphs."""
    one, other = _figure_1()
    walks = [
        tuple(
            f"{p.degree}{'P' if p.marks else 'A'}"
            for p in sensed(World(world.map, Position(dart), dart), CAPTION)[1:]
        )
        for world in (one, other)
        for dart in (world.map.turn(0, k) for k in range(world.first.degree))
    ]
    return Found(
        truth(set(walks) == {SENSED_IN_CAPTION}),
        {"walks": len(walks)},
        {"percepts": list(walks[0])},
        _figure_1_pictures(),
    )


def position_is_not_enough(_: Means, *, pairs: list[str]) -> Found:
    """Pairs of different maps that no motion tells apart with the position marked."""
    compared = [twins(*pair_of_corpus(name)) for name in pairs]
    pictures = tuple(
        Picture(f"{name}, the {which}", world)
        for name, result in zip(pairs, compared, strict=True)
        for which, world in zip(("one", "other"), result.worlds, strict=True)
    )
    alike = [
        result.twins and unrooted_code(result.worlds[0].map) != unrooted_code(result.worlds[1].map)
        for result in compared
    ]
    return Found(truth(all(alike)), {"pairs": len(compared)}, {}, pictures)


def pair_of_corpus(name: str) -> tuple[World, World]:
    """The two worlds of that pair, their position marked."""
    corpus = own_corpus()
    one, other = corpus.document(corpus.named(name))["worlds"]
    return World.from_json(one), World.from_json(other)


def _smallest(map_class: MapClass, edges: int, *pair: World) -> Found:
    """The first number of edges with two worlds that look alike; a pair that must be among them."""
    report = census(edges=edges, map_class=map_class)
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
    return one.map.edge_count == edges and twins(one, other).twins


def smallest_maps(_: Means, *, edges: int) -> Found:
    """Find the smallest of all maps: one vertex, its two loops side by side and crossed."""
    names = ("two-loops-plane", "two-loops-torus")
    one, other = (World(named_map(name), Position(0)) for name in names)
    return _smallest(MapClass.MAPS, edges, one, other)


def smallest_simple(_: Means, *, edges: int) -> Found:
    """Find the smallest simple ones: K4 in the plane and on the torus."""
    return _smallest(MapClass.SIMPLE, edges, *pair_of_corpus("pair-k4"))


def smallest_planar_simple(_: Means, *, edges: int) -> Found:
    """Find the smallest simple ones in the plane."""
    return _smallest(MapClass.PLANAR_SIMPLE, edges)


def cycles_need_information(_: Means, *, edges: int) -> Found:
    """Each map with a cycle beside its double cover along an edge of that cycle."""
    covered = alike = 0
    for m in range(1, edges + 1):
        for map_ in rooted_maps(m, MapClass.MAPS):
            cover = double_cover(map_)
            if cover is None:
                continue
            covered += 1
            result = twins(World(map_, Nothing()), World(cover, Nothing()))
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


def _connected(sigma: list[Dart], alpha: list[Dart]) -> bool:
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
        for map_ in rooted_maps(m, MapClass.MAPS):
            labels = [0] * len(map_.sigma)
            quotient = project(Labelled(map_, labels, 0)).quotient
            learnt = (quotient.sigma, quotient.alpha, quotient.degree)
            alike[learnt].add(unrooted_code(map_))
            compared += 1
            if map_.edge_count < map_.vertex_count:
                trees.append(learnt)
    alone = all(len(alike[learnt]) == 1 for learnt in trees)
    return Found(truth(alone), {"trees": len(trees), "maps": compared})


def movable_marker_simple(means: Means, *, edges: int) -> Found:
    """Run the explorer of Dudek et al. in every simple world."""
    report = check("dudek91", edges=edges, map_class="simple", workers=means.workers)
    return of_check(report, "new-vertex", "back-link")


def movable_marker_maps(means: Means, *, edges: int) -> Found:
    """Run that explorer where loops and parallel edges are allowed."""
    report = check("dudek91", edges=edges, workers=means.workers)
    return of_check(report, **smallest(report))


def markers_at_one_vertex(_: Means, *, markers: int, actions: int) -> Found:
    """Two loops, side by side and crossed: every list of motions, drops and pick-ups."""
    one, other = (
        World(named_map(name), Movable(markers)) for name in ("two-loops-plane", "two-loops-torus")
    )
    legal: list[Action] = [*(Move(k) for k in range(4)), Drop(), Pick()]
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


def position_robot_knows_its_class(means: Means, *, edges: int) -> Found:
    """The explorer ``quotient``: the map where only one looks so, else the quotient."""
    report = check("quotient", edges=edges, workers=means.workers)
    return of_check(report, "map", "ambiguous")


CHECKS: Checks = {
    "cycles": no_information,
    "two-door-rooms": two_door_rooms,
    "orientation-alone": orientation_alone,
    "position-tells-cycles": position_tells_cycles,
    "fig1": figure_1_alike,
    "fig1-different": figure_1_different,
    "fig1-caption": figure_1_caption,
    "position-not-enough": position_is_not_enough,
    "smallest-twins": smallest_maps,
    "smallest-simple-twins": smallest_simple,
    "smallest-planar-simple-twins": smallest_planar_simple,
    "cycle-needs-information": cycles_need_information,
    "trees-need-none": trees_need_none,
    "movable-marker": movable_marker_simple,
    "movable-marker-multigraphs": movable_marker_maps,
    "markers-at-one-vertex": markers_at_one_vertex,
    "position-robot": position_robot_knows_its_class,
}
