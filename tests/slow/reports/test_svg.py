"""The pictures of maps, read back from the SVG."""

from cmath import exp
from itertools import combinations, pairwise
from math import inf, tau

import pytest

from allworlds.maps import named_map
from allworlds.maps.combinatorial import cycles
from allworlds.reports.drawing.planar import coordinates, mesh, planar
from reports import test_svg as quick
from reports.test_svg import (
    FEW,
    GENUS_2,
    MAPS,
    NAMED,
    NS,
    SMALL,
    crossings,
    drawn,
    edges,
    going_round_gives_sigma,
    stubs,
)

REST = [map_ for map_ in SMALL if map_ not in FEW]  # left to the slow tests


@pytest.mark.parametrize("map_", [*MAPS, *REST], ids=str)
def test_going_round_a_vertex_by_angle_gives_sigma(map_):
    going_round_gives_sigma(map_)


@pytest.mark.parametrize("map_", [*MAPS, *REST], ids=str)
def test_each_edge_begins_and_ends_along_the_two_darts_of_alpha(map_):
    svg = drawn(map_)
    beginnings = stubs(svg)
    seen = []
    for (dart, other), way in edges(svg):
        assert map_.alpha[dart] == other
        assert way[:2] == beginnings[dart]
        assert way[:-3:-1] == beginnings[other]
        seen += [dart, other]
    assert sorted(seen) == list(map_.darts)


@pytest.mark.parametrize("map_", [*NAMED, GENUS_2], ids=str)
def test_no_triangle_of_the_mesh_is_turned_over(map_):
    net = mesh(planar(map_))
    where = coordinates(net)
    assert len(cycles(planar(map_).sigma)) + net.first_vertex <= len(net.links)
    for point, link in enumerate(net.links):
        assert len(set(link)) == len(link) >= 3
        for one, other in zip(link, [*link[1:], link[0]], strict=True):
            a, b = where[one] - where[point], where[other] - where[point]
            assert (a.conjugate() * b).imag > 0


def strain(net, where, point, at, count):
    """How far the triangles round a point are from being alike, if it lay there.

    By the formula of the docstring, with areas and sides by their definition: S/A + R/A + A/R for
    a triangle with area A/2 and squares of sides of sum S, where R is four times as large at a
    vertex of the map, and for one with a corner on the ring a twentieth of 1/A alone.
    """
    total = 0.0
    centres = range(net.first_vertex, net.first_vertex + count)
    for one, other in pairwise([*net.links[point], net.links[point][0]]):
        corners = [at, where[one], where[other]]
        area = ((corners[1] - at).conjugate() * (corners[2] - at)).imag
        if area <= 0:
            return inf
        squares = sum(abs(p - q) ** 2 for p, q in combinations(corners, 2))
        on_the_ring = one in net.ring or other in net.ring
        wanted = 4 if {point, one, other} & {*centres} else 1
        total += 0.05 / area if on_the_ring else (squares + wanted) / area + area / wanted
    return total


@pytest.mark.parametrize("name", ["edge", "theta", "k4", "theta-torus"])
def test_no_point_of_the_mesh_would_lie_better_a_little_aside(name):
    map_ = named_map(name)
    net = mesh(planar(map_))
    where = coordinates(net)
    count = map_.vertex_count
    for point, at in enumerate(where[: len(net.links)]):
        aside = [at + 0.02 * exp(1j * tau * k / 8) for k in range(8)]
        here = strain(net, where, point, at, count)
        assert here < min(strain(net, where, point, there, count) for there in aside)


@pytest.mark.parametrize("map_", REST, ids=str)
def test_a_darts_number_stands_beside_its_vertex_in_the_darts_direction(map_):
    quick.test_a_darts_number_stands_beside_its_vertex_in_the_darts_direction(map_)


@pytest.mark.parametrize("map_", [*MAPS, *REST], ids=str)
def test_every_dart_and_every_vertex_is_named_once(map_):
    svg = drawn(map_)
    texts = [text.text for text in svg.iter(f"{NS}text")]
    names = [*map(str, map_.darts), *(f"v{v}" for v in range(map_.vertex_count))]
    assert sorted(texts) == sorted(names)


def test_edges_that_must_cross_do():
    for map_ in MAPS:
        if map_.genus:
            assert crossings(map_) >= 1
            assert planar(map_).unbent - planar(map_).own >= 4 * map_.genus
