"""Conditions that narrow a class of maps, compared with all permutations."""

import networkx as nx
import pytest

from allworlds.inputs.checks import InputError
from allworlds.maps import MapClass, girth, rooted_code, rooted_maps
from allworlds.maps.classes import AND, CONDITIONS, AllOf, Extent, condition_named
from allworlds.maps.count_source import source_of
from allworlds.maps.enumeration import prefixes
from bruteforce import rooted_maps_by_permutations
from small import all_maps

NAMES = [
    *("cubic", "regular:2", "regular:4", "eulerian", "trees", "girth:2", "girth:3"),
    *("genus:0", "genus:1", "triangulation", "quadrangulation"),
]


def graph_girth(map_):
    """The girth by networkx; loops and parallel edges are what that does not know."""
    ends = [tuple(sorted(map_.vertex_of[d] for d in edge)) for edge in map_.edges]
    if any(a == b for a, b in ends):
        return 1
    if len({*ends}) < len(ends):
        return 2
    length = nx.girth(nx.Graph(ends))
    return None if length == float("inf") else length


def by_definition(name, map_):
    kind, _, number = name.partition(":")
    faces = {len(face) for face in map_.faces}
    return {
        "cubic": lambda: all(degree == 3 for degree in map_.degrees),
        "regular": lambda: all(degree == int(number) for degree in map_.degrees),
        "eulerian": lambda: nx.is_eulerian(nx.MultiGraph(ends(map_))),
        "trees": lambda: nx.is_tree(nx.MultiGraph(ends(map_))),
        "girth": lambda: (graph_girth(map_) or 100) >= int(number),
        "genus": lambda: (
            2 - 2 * int(number) == map_.vertex_count - map_.edge_count + len(map_.faces)
        ),
        "triangulation": lambda: faces == {3},
        "quadrangulation": lambda: faces == {4},
    }[kind]()


def ends(map_):
    return [tuple(map_.vertex_of[d] for d in edge) for edge in map_.edges]


TOGETHER = [
    *("cubic and girth:2", "eulerian and genus:0", "trees and regular:3"),
    *("triangulation and quadrangulation", "triangulation and genus:0", "triangulation and cubic"),
]


@pytest.mark.parametrize("edges", [1, 2, 3])
@pytest.mark.parametrize("name", TOGETHER)
def test_several_conditions_leave_what_each_of_them_leaves(name, edges):
    parts = [condition_named(part) for part in name.split(AND)]
    both = AllOf(tuple(parts))
    assert both.name == str(both) == name
    whole = rooted_maps(edges) if edges < 6 else rooted_maps(edges, where=parts[0])
    left = [map_ for map_ in whole if all(part.holds(map_) for part in parts)]
    assert sorted(map(code, rooted_maps(edges, where=both))) == sorted(map(code, left))
    grown = {
        code(m)
        for p in prefixes(edges, where=both)
        for m in rooted_maps(edges, prefix=p, where=both)
    }
    assert grown == {*map(code, left)}
    # A false cousin: one of them alone leaves more, at some size.
    assert len(left) <= min(sum(1 for _ in rooted_maps(edges, where=part)) for part in parts)


@pytest.mark.parametrize("edges", [1, 2, 3])
@pytest.mark.parametrize("name", NAMES)
def test_a_condition_leaves_what_filtering_all_permutations_leaves(name, edges):
    condition = condition_named(name)
    met = [*rooted_maps(edges, where=condition)]
    every = [map_ for map_ in rooted_maps_by_permutations(edges) if by_definition(name, map_)]
    assert len(met) == len(every)
    codes = [sorted(rooted_code(m.sigma, m.alpha, 0) for m in maps) for maps in (met, every)]
    assert codes[0] == codes[1]


def code(map_):
    return rooted_code(map_.sigma, map_.alpha, 0)


@pytest.mark.parametrize("map_class", list(MapClass))
@pytest.mark.parametrize("name", [*NAMES, "girth:4", "regular:1", "genus:2"])
def test_what_is_cut_off_is_none_of_these_maps(name, map_class):
    condition = condition_named(name)
    for edges in (1, 2, 3, 4):
        for vertices in (None, 2, 3):
            every = [
                map_
                for map_ in rooted_maps(edges, map_class, vertices)
                if by_definition(name, map_)
            ]
            met = [*rooted_maps(edges, map_class, vertices, where=condition)]
            if condition.dual:
                assert sorted(map(code, met)) == sorted(map(code, every))
            else:
                assert met == every


@pytest.mark.parametrize("name", NAMES)
def test_the_pieces_of_a_condition_are_its_maps(name):
    condition = condition_named(name)
    whole = [*rooted_maps(4, where=condition)]
    for depth in (1, 2, 3):
        pieces = prefixes(4, depth=depth, where=condition)
        assert whole == [
            map_ for piece in pieces for map_ in rooted_maps(4, prefix=piece, where=condition)
        ]


@pytest.mark.parametrize("name", ["cubic", "regular:4", "trees", "triangulation"])
def test_hardly_a_history_of_a_narrow_condition_comes_to_nothing(name):
    condition = condition_named(name)
    dead = maps = 0
    for piece in prefixes(6, depth=99, where=condition):
        maps += 1
        dead += not any(rooted_maps(6, prefix=piece, where=condition))
    assert maps == sum(1 for _ in rooted_maps(6, where=condition)) > 0
    assert dead == 0


def test_a_condition_of_the_users_cuts_nothing_off():
    class Own:
        name = "trees"

        def holds(self, map_):
            return map_.edge_count == map_.vertex_count - 1

    own, ours = Own(), condition_named("trees")
    assert [*rooted_maps(4, where=own)] == [*rooted_maps(4, where=ours)]
    assert [*prefixes(4, where=own)] == [*prefixes(4)]
    assert len([*prefixes(4, where=ours)]) < len([*prefixes(4)])
    assert source_of(Extent(MapClass.MAPS, 4, None, own)) is None


def test_every_condition_is_tried_here():
    assert {name.partition(":")[0] for name in NAMES} == set(CONDITIONS)


def test_the_girth_is_that_of_the_graph():
    assert all(girth(map_) == graph_girth(map_) for map_ in all_maps(4))


def test_as_many_trees_as_catalan_numbers_and_as_many_cubic_maps_as_are_known():
    trees, cubic = condition_named("trees"), condition_named("cubic")
    assert [sum(map(trees.holds, rooted_maps(m))) for m in range(1, 5)] == [1, 2, 5, 14]
    # Rooted planar cubic maps with 3 edges: 4 (Tutte 1962: 2^(2n+1) (3n)!! / ((n+2)! n!!), n = 1);
    # and the torus has one.
    assert [m.genus for m in filter(cubic.holds, rooted_maps(3))].count(0) == 4
    assert [m.genus for m in filter(cubic.holds, rooted_maps(3))].count(1) == 1


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("regular", "takes a number from 1 on"),
        ("regular:0", "takes a number from 1 on"),
        ("girth:x", "takes a number from 1 on"),
        ("genus:-1", "takes a number from 0 on"),
        ("cubic:3", "cubic takes no number"),
    ],
)
def test_a_number_that_is_missing_or_none_is_refused(name, said):
    with pytest.raises(InputError, match=said):
        condition_named(name)


def test_an_extent_includes_what_its_condition_admits():
    extent = Extent(MapClass.MAPS, 3, None, condition_named("trees"))
    assert sum(map(extent.include, all_maps(3))) == 1 + 2 + 5


@pytest.mark.parametrize(("edges", "pieces"), [(1, 0), (2, 1), (3, 6)])
def test_nothing_is_begun_that_has_no_room_for_the_handles(edges, pieces):
    assert len([*prefixes(edges, depth=1, where=condition_named("genus:1"))]) == pieces
