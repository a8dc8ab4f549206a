from collections import defaultdict

import pytest

import bruteforce
from allworlds.studies.ambiguity import census
from studies import test_census_sweep as quick
from studies.test_census_sweep import numbers


def second_route(edges, map_class):
    """The row from all permutations, and from percepts alone: words of motions are tried.

    Two starts are alike if all words up to a length give equal percepts; 4m motions are enough
    for two maps with 2m darts each, since each length that separates more splits a class.
    """
    marked = {}
    for map_ in bruteforce.rooted_maps_by_permutations(edges, map_class):
        at_v0 = map_.vertices[map_.vertex_of[0]]
        codes = []
        for dart in at_v0:
            order, seen = [dart], {dart}
            for x in order:
                for y in (map_.sigma[x], map_.alpha[x]):
                    if y not in seen:
                        seen.add(y)
                        order.append(y)
            number = {x: i for i, x in enumerate(order)}
            codes.append(
                (
                    [number[map_.sigma[x]] for x in order],
                    [number[map_.alpha[x]] for x in order],
                )
            )
        marked.setdefault(str(min(codes)), map_)
    colours = {}
    for key, map_ in marked.items():
        for d in map_.darts:
            colours[key, d] = (map_.degree_at[d], map_.vertex_of[d] == map_.vertex_of[0])
    for _ in range(4 * edges):
        names = {}
        colours = {
            (key, d): names.setdefault(
                (
                    colour,
                    *(
                        colours[key, marked[key].alpha[marked[key].turn(d, k)]]
                        for k in range(marked[key].degree_at[d])
                    ),
                ),
                len(names),
            )
            for (key, d), colour in colours.items()
        }
    groups = defaultdict(int)
    for key, map_ in marked.items():
        groups[frozenset(colours[key, d] for d in map_.vertices[map_.vertex_of[0]])] += 1
    sizes = [size for size in groups.values() if size > 1]
    return edges, len(marked), sum(sizes), len(sizes), max(sizes, default=0)


@pytest.mark.parametrize("map_class", ["maps", "simple", "planar", "planar-simple"])
def test_grouping_by_what_words_of_motions_show_gives_the_same_table(map_class):
    rows = census(edges=4, map_class=map_class).rows
    assert [numbers(row) for row in rows] == [second_route(m, map_class) for m in range(1, 5)]


@pytest.mark.slowest
def test_grouping_gives_the_same_table_with_five_edges():
    assert numbers(census(edges=5).rows[-1]) == second_route(5, "maps")


@pytest.mark.slowest
def test_the_smallest_planar_simple_ambiguous_worlds_have_eight_edges_and_seven_vertices():
    rows = census(edges=8, map_class="planar-simple").rows
    assert rows[7].classes > 0
    assert census(edges=8, vertices=6, map_class="planar-simple").rows[-1].classes == 0
    seven = census(edges=8, vertices=7, map_class="planar-simple").rows[-1]
    assert seven.classes == rows[7].classes


@pytest.mark.parametrize("edges", [7])
def test_no_planar_simple_world_with_fewer_than_eight_edges_is_ambiguous(edges):
    quick.test_no_planar_simple_world_with_fewer_than_eight_edges_is_ambiguous(edges)
