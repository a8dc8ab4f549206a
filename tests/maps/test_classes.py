import pytest

import bruteforce
from allworlds.inputs.checks import InputError
from allworlds.maps import MapClass, named_map
from allworlds.maps.build import cycle, dense
from allworlds.maps.classes import Extent

SIMPLE = [MapClass.SIMPLE, MapClass.PLANAR_SIMPLE]
NOT_SIMPLE = [MapClass.MAPS, MapClass.PLANAR]


def test_the_classes_have_the_names_of_the_command_line():
    assert [str(map_class) for map_class in MapClass] == [
        "maps",
        "simple",
        "planar",
        "planar-simple",
    ]
    assert MapClass("planar-simple") is MapClass.PLANAR_SIMPLE


def test_each_class_says_what_it_excludes():
    assert [c for c in MapClass if c.simple] == SIMPLE
    assert [c for c in MapClass if c.planar] == [MapClass.PLANAR, MapClass.PLANAR_SIMPLE]


@pytest.mark.parametrize("edges", [1, 2, 3, 4])
@pytest.mark.parametrize("map_class", MapClass)
def test_a_map_is_in_the_class_exactly_if_trying_all_permutations_finds_it_there(map_class, edges):
    found = {
        map_ for map_ in bruteforce.rooted_maps_by_permutations(edges) if map_class.includes(map_)
    }
    assert found == set(bruteforce.rooted_maps_by_permutations(edges, map_class.value))


@pytest.mark.parametrize(
    ("map_", "classes"),
    [
        (named_map("edge"), set(MapClass)),
        (named_map("loop"), set(NOT_SIMPLE)),
        (cycle(2), set(NOT_SIMPLE)),
        (named_map("k4"), set(MapClass)),
        (dense(4), {MapClass.MAPS, MapClass.SIMPLE}),
        (named_map("two-loops-torus"), {MapClass.MAPS}),
    ],
)
def test_known_maps_are_in_the_classes_that_one_expects(map_, classes):
    assert {map_class for map_class in MapClass if map_class.includes(map_)} == classes


@pytest.mark.parametrize("edges", [0, -1])
def test_a_bound_below_one_edge_is_refused_by_name(edges):
    with pytest.raises(InputError, match=f"edges = {edges}, .* at least 1"):
        Extent(MapClass.MAPS, edges)


@pytest.mark.parametrize("vertices", [1, 0, -3])
@pytest.mark.parametrize("edges", [None, 4])
def test_a_bound_below_two_vertices_is_refused_by_name(vertices, edges):
    with pytest.raises(InputError, match=f"vertices = {vertices}, .* at least 2"):
        Extent(MapClass.SIMPLE, edges, vertices)


@pytest.mark.parametrize("map_class", NOT_SIMPLE)
def test_a_class_with_loops_may_be_bounded_to_one_vertex(map_class):
    assert Extent(map_class, 4, 1).vertex_limit(4) == 1
    with pytest.raises(InputError, match=r"vertices = 0, .* at least 1"):
        Extent(map_class, 4, 0)


@pytest.mark.parametrize("map_class", MapClass)
def test_no_bound_at_all_is_refused(map_class):
    with pytest.raises(InputError, match="needs a bound"):
        Extent(map_class, None)


@pytest.mark.parametrize("map_class", NOT_SIMPLE)
def test_vertices_alone_do_not_bound_a_class_with_loops(map_class):
    with pytest.raises(InputError) as refusal:
        Extent(map_class, None, 4)
    assert "vertices = 4 alone" in str(refusal.value)
    assert f"class '{map_class.value}' needs" in str(refusal.value)


@pytest.mark.parametrize("map_class", MapClass)
def test_the_levels_go_up_to_the_bound_on_the_edges(map_class):
    assert list(Extent(map_class, 1).levels) == [1]
    assert list(Extent(map_class, 4).levels) == [1, 2, 3, 4]
    assert list(Extent(map_class, 4, 2).levels) == [1, 2, 3, 4]


@pytest.mark.parametrize("map_class", SIMPLE)
@pytest.mark.parametrize("vertices", [2, 3, 4, 7])
def test_with_vertices_alone_the_levels_go_up_to_the_complete_graph(map_class, vertices):
    assert list(Extent(map_class, None, vertices).levels) == list(
        range(1, dense(vertices).edge_count + 1)
    )


def test_the_vertex_limit_is_that_of_trees_or_the_bound_if_it_is_lower():
    assert [Extent(MapClass.MAPS, 5).vertex_limit(m) for m in (1, 2, 5)] == [2, 3, 6]
    assert [Extent(MapClass.MAPS, 5, 3).vertex_limit(m) for m in (1, 2, 5)] == [2, 3, 3]


@pytest.mark.parametrize("edges", [1, 2, 3, 4])
@pytest.mark.parametrize("vertices", [None, 2, 3, 4, 9])
def test_the_vertex_limit_is_met_and_not_passed_by_the_maps_within_the_bounds(edges, vertices):
    bounds = Extent(MapClass.MAPS, 4, vertices)
    counts = {map_.vertex_count for map_ in bruteforce.rooted_maps_by_permutations(edges)}
    within = {n for n in counts if vertices is None or n <= vertices}
    assert bounds.vertex_limit(edges) == max(within)


@pytest.mark.parametrize(
    ("map_class", "name", "legal", "wrong", "told"),
    [
        ("maps", "edges", 1, 0, "edges = 0, but a map has at least 1 edge"),
        ("maps", "edges", 100_000, 100_001, "edges = 100001 is too big; at most 100,000 is legal"),
        ("maps", "vertices", 1, 0, "but a map of the class 'maps' has at least 1"),
        ("planar", "vertices", 1, 0, "but a map of the class 'planar' has at least 1"),
        ("simple", "vertices", 2, 1, "but a map of the class 'simple' has at least 2"),
        ("planar-simple", "vertices", 2, 1, "a map of the class 'planar-simple' has at least 2"),
        ("maps", "vertices", 100_000, 100_001, "vertices = 100001 is too big; at most 100,000"),
    ],
)
def test_numbers_of_edges_and_vertices_have_limits(map_class, name, legal, wrong, told):
    def extent(value):
        return Extent(MapClass.named(map_class), **{"edges": 3, name: value})

    assert getattr(extent(legal), name) == legal
    with pytest.raises(InputError, match=told):
        extent(wrong)


def test_a_level_has_at_most_a_vertex_more_than_edges():
    assert [Extent(MapClass.MAPS, 3).vertex_limit(edges) for edges in (1, 3)] == [2, 4]
    assert [Extent(MapClass.MAPS, 3, 3).vertex_limit(edges) for edges in (1, 2, 3)] == [2, 3, 3]
    assert [*Extent(MapClass.SIMPLE, None, 4).levels] == [1, 2, 3, 4, 5, 6]
