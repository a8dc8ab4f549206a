"""Pictures at given positions: straight edges, in the order of the map, or another picture."""

from cmath import phase
from itertools import pairwise
from math import tau
from random import Random

import pytest

from allworlds.maps import CombinatorialMap, from_cycles
from allworlds.reports.drawing.layout import DISC, layout, points_of
from allworlds.reports.drawing.positions import at_positions, laid_out
from allworlds.reports.drawing.svg import draw
from allworlds.reports.parts import scene_of
from allworlds.world import Labelling, World
from curves import crossings, flat

SQUARE = ((0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0))


def by_angle(positions, edges):
    """The map of straight edges between positions, given by the two ends of each."""
    darts = {v: [] for v in range(len(positions))}
    for i, (a, b) in enumerate(edges):
        darts[a].append((2 * i, b))
        darts[b].append((2 * i + 1, a))
    sigma = [0] * (2 * len(edges))
    for v, around in darts.items():
        turned = [(phase(complex(*positions[w]) - complex(*positions[v])), d) for d, w in around]
        order = [d for _, d in sorted(turned, reverse=True)]
        for here, after in zip(order, order[1:] + order[:1], strict=True):
            sigma[here] = after
    map_ = CombinatorialMap(sigma, [d ^ 1 for d in range(len(sigma))])
    owner = {d: v for v, around in darts.items() for d, _ in around}
    return map_, tuple(positions[owner[vertex[0]]] for vertex in map_.vertices)


def goes_round(map_, drawn):
    """Whether the darts leave every vertex in the clockwise order of the map."""
    for around in map_.vertices:
        angles = [phase(drawn.along(dart)) for dart in around]
        steps = [(b - a) % tau for a, b in pairwise([*angles, angles[0]])]
        if len(steps) > 1 and abs(sum(steps) - tau) > 1e-6:
            return False
    return True


def test_a_plan_is_drawn_as_it_lies():
    map_, positions = by_angle(SQUARE, [(0, 1), (1, 2), (2, 3), (3, 0), (0, 2)])
    drawn = at_positions(map_, positions)
    assert goes_round(map_, drawn)
    origin, right = drawn.vertices[0], drawn.vertices[1]
    scale = (right - origin).real / (positions[1][0] - positions[0][0])
    for centre, (x, y) in zip(drawn.vertices, positions, strict=True):
        there = complex(x - positions[0][0], -(y - positions[0][1])) * scale
        assert centre - origin == pytest.approx(there)
    for way in drawn.ways:  # straight
        for point in points_of(way):
            assert abs(phase((point - way[0]) / (way[-1] - way[0]))) < 1e-9 or point == way[0]


def test_random_drawings_with_crossings_are_drawn_in_their_order_or_not_at_all():
    draw_ = Random(1)
    drawn = 0
    for _ in range(60):
        positions = [(draw_.uniform(0, 3), draw_.uniform(0, 3)) for _ in range(5)]
        pairs = [(a, b) for a in range(5) for b in range(a)]
        edges = [(v, draw_.randrange(v)) for v in range(1, 5)]
        edges += [pair for pair in draw_.sample(pairs, 3) if pair not in edges]
        map_, places = by_angle(positions, edges)
        if (made := at_positions(map_, places)) is not None:
            drawn += 1
            assert goes_round(map_, made)
            others = [a for a in made.vertices if a != made.vertices[0]]
            assert min(abs(a - made.vertices[0]) for a in others) > 2 * DISC
    assert drawn > 15


BENT = ((0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (-2.0, 0.3))


def bent(first, last):
    """Three parallel edges to one vertex, two to another one that has no other neighbour."""
    return from_cycles([[*first], [*"cbay"], [*"yx"], [*last]])


@pytest.mark.parametrize("last", ["qp", "pq"])
@pytest.mark.parametrize("at", range(7))
def test_parallel_edges_and_loops_are_bent_and_cross_nothing(at, last):
    first = [*"abcpqx"]
    drawn = at_positions(bent(first, last), BENT)
    assert goes_round(bent(first, last), drawn)
    first[at:at] = ["loop", "loop"]
    with_loop = bent(first, last)
    drawn = at_positions(with_loop, BENT)
    assert goes_round(with_loop, drawn)
    ways = [flat(points_of(drawn.ways[dart])) for dart, _ in with_loop.edges]
    # A loop between the two parallel edges of a vertex without another neighbour may.
    assert [*crossings(ways)] == [] or at == 4
    for dart, other in enumerate(with_loop.alpha):
        assert drawn.ways[dart] == pytest.approx(drawn.ways[other][::-1])


LINE = ((0.0, 0.0), (1.0, 0.0), (2.0, 0.0))


@pytest.mark.parametrize(
    ("vertices", "positions"),
    [
        (["abe", "acd", "bdf", "cef"], SQUARE),  # K4 in another order
        (["adx", "aby", "bcx", "cdy"], ((0, 0), (2, 1), (2, 0), (0, 1))),  # likewise
        (["axbw", "bay", "wxy"], ((0, 0), (2, 0), (2, 2))),  # parallel edges, not side by side
        (["ab", "ac", "bc"], LINE),  # an edge would run through a vertex
        (["ab", "ac", "bc"], ((0, 0), (1, 0), (1, 0))),  # two vertices at one place
        (["ab", "ac", "bc"], ((0, 0), (1e-9, 0), (1, 1))),  # no room
        (["a", "ab", "b"], ((0, 0), (20, 0), (21, 0))),  # none for the numbers of darts
        (["lalb", "ac", "bc"], ((0, 0), (2, 0), (-2, -1.5))),  # a loop round another edge
        (["a", "a"], ((0, 0), (1, 0))),  # fewer than three vertices
        (["aa"], ((0, 0),)),
    ],
)
def test_positions_that_do_not_fit_give_way_to_the_usual_picture(vertices, positions):
    map_ = from_cycles([[*vertex] for vertex in vertices])
    assert at_positions(map_, positions) is None
    world = World(map_, "none", labels=Labelling("", (), positions))
    assert laid_out(scene_of(world)) == layout(map_, 0)


@pytest.mark.parametrize("far", [1e300, 1e-300])
def test_positions_may_be_large_or_small(far):
    positions = tuple((x * far, y * far) for x, y in ((0, 0), (0.5, 0.9), (1, 0)))
    map_ = from_cycles([[*"ab"], [*"bc"], [*"ca"]])
    near = at_positions(map_, ((0, 0), (0.5, 0.9), (1, 0)))
    assert at_positions(map_, positions).vertices == pytest.approx(near.vertices)


def test_pictures_of_a_world_with_positions_use_them():
    map_ = from_cycles([[*"ab"], [*"bc"], [*"ca"]])
    labels = Labelling("", (), ((0.0, 0.0), (0.5, 0.9), (1.0, 0.0)))
    world = World(map_, "none", labels=labels)
    assert laid_out(scene_of(world)) == at_positions(map_, labels.positions)
    assert draw(world).svg != draw(World(map_, "none")).svg
    mirrored = laid_out(scene_of(world.mirrored()))
    assert goes_round(world.mirrored().map, mirrored)
    other = laid_out(scene_of(world)).vertices
    assert [-point.conjugate() for point in mirrored.vertices] == pytest.approx(other)
