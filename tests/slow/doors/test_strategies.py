from pathlib import Path

import pytest
from hypothesis.strategies import tuples

from allworlds import strategies
from allworlds.explorers.builtin.algorithm1 import Algorithm1
from allworlds.maps import CombinatorialMap, MapClass, rooted_code, rooted_maps
from bruteforce import rooted_maps_by_permutations as all_rooted_maps
from doors.test_strategies import OF_CLASS, drawn, sample, smallest, violation
from page_blocks import blocks
from schedules import schedules
from small import EDGE, LOOP, TORUS

CLASSES = pytest.mark.parametrize("map_class", list(OF_CLASS))


@CLASSES
def test_every_map_of_at_most_three_edges_is_drawn(map_class):
    expected = {m for edges in (1, 2, 3) for m in all_rooted_maps(edges, map_class)}
    assert set(sample(map_class, 3)) == expected


@CLASSES
@pytest.mark.parametrize("edges", [1, 2, 3, 4])
def test_every_way_to_grow_ends_in_a_map_and_every_map_can_be_grown(map_class, edges):
    grown = set()
    for vertices in range(strategies._fewest_vertices(map_class, edges), edges + 2):
        for choices in schedules():

            def pick(options, choices=choices):
                return choices.pick(range(len(options)), of="edge")

            map_ = strategies.grow(map_class, edges, vertices, pick)
            assert map_.vertex_count == vertices
            grown.add(map_)
    assert grown == set(all_rooted_maps(edges, map_class))


@pytest.mark.slowest
@CLASSES
@pytest.mark.parametrize("edges", [6, 14])
def test_what_is_drawn_is_a_valid_map_of_the_class_in_canonical_numbering(map_class, edges):
    for map_ in sample(map_class, edges):
        assert CombinatorialMap(map_.sigma, map_.alpha) == map_
        assert map_class.includes(map_)
        assert map_.edge_count <= edges
        assert rooted_code(map_.sigma, map_.alpha, 0) == (map_.sigma, map_.alpha)


@CLASSES
def test_every_size_is_drawn_and_nothing_in_vain(map_class):
    sizes = {(m.edge_count, m.vertex_count) for m in sample(map_class, 6)}
    possible = {
        (m.edge_count, m.vertex_count)
        for edges in range(1, 6)
        for m in rooted_maps(edges, map_class)
    }
    assert {size for size in sizes if size[0] < 6} == possible
    assert {edges for edges, _ in sizes} == set(range(1, 7))


@pytest.mark.parametrize("strategy", OF_CLASS.values())
def test_the_number_of_edges_is_kept_between_its_bounds(strategy):
    assert {m.edge_count for m in drawn(strategy(3, 5))} == {3, 4, 5}


@pytest.mark.parametrize(
    ("strategy", "condition", "expected"),
    [
        (strategies.maps(), lambda _: True, LOOP),
        (strategies.maps(), lambda m: m.loop_count, LOOP),
        (strategies.maps(), lambda m: m.vertex_count > 1, EDGE),
        (strategies.maps(), lambda m: m.genus == 1, TORUS),
        (strategies.simple_maps(), lambda _: True, EDGE),
        (strategies.planar_maps(), lambda _: True, LOOP),
        (strategies.planar_simple_maps(), lambda _: True, EDGE),
    ],
)
def test_the_smallest_example_is_the_smallest_map(strategy, condition, expected):
    assert smallest(strategy, condition) == expected


@pytest.mark.parametrize(
    ("map_class", "condition", "size"),
    [
        # Two loops twice through each other: m = 4 with one vertex.
        (MapClass.MAPS, lambda m: m.genus == 2, (4, 1)),
        (MapClass.MAPS, lambda m: m.parallel_count == 2, (3, 2)),
        (MapClass.PLANAR, lambda m: not m.is_simple and m.vertex_count == 3, (3, 3)),
        (MapClass.PLANAR, lambda m: len(m.faces) == 4, (3, 1)),
        # A cycle in a simple map: the triangle; a handle: K4 without one edge.
        (MapClass.SIMPLE, lambda m: m.edge_count >= m.vertex_count, (3, 3)),
        (MapClass.SIMPLE, lambda m: m.genus == 1, (5, 4)),
        # Three edges more than a tree in the plane: K4.
        (MapClass.PLANAR_SIMPLE, lambda m: m.edge_count >= m.vertex_count + 2, (6, 4)),
    ],
)
def test_examples_shrink_to_the_least_edges_and_then_to_the_least_vertices(
    map_class, condition, size
):
    found = smallest(OF_CLASS[map_class](max_edges=8), condition)
    assert (found.edge_count, found.vertex_count) == size


def test_motions_shrink_to_none_and_to_few():
    assert smallest(strategies.motions(), lambda _: True) == []
    assert smallest(strategies.motions(), lambda ks: len(ks) >= 2) == [0, 0]
    assert smallest(strategies.motions(), lambda ks: any(k < 0 for k in ks)) == [-1]
    assert max(map(len, drawn(strategies.motions(4)))) == 4


def test_an_explorer_that_is_wrong_after_one_choice_shrinks_to_that_choice():
    class WrongAfterTheLast(Algorithm1):
        def take_from_u(self):
            goal = super().take_from_u()
            self.wrong = len(self.choices.record) > 1 and self.choices.record[0] == 2
            return goal

        def augment_by_loop(self, goal, partner):
            super().augment_by_loop(goal, partner)
            if self.wrong:
                self.here = self.s.turn(self.here, 1)

    def refuted(run):
        world, choices = run
        return violation(world, choices, WrongAfterTheLast) is not None

    world, choices = smallest(tuples(strategies.worlds(), strategies.choices()), refuted)
    assert world.map.edge_count == 2
    assert choices.record[0] == 2
    assert not any(choices.record[1:])


def test_the_examples_of_the_page_for_users_pass():
    page = Path(__file__).parents[3] / "docs" / "how-to" / "pytest.md"
    text = page.read_text(encoding="utf-8")
    names = {}
    (block,) = (block for block in blocks(text, "python") if block.title == "test_properties.py")
    exec(block.body, names)  # as a user would paste it
    tests = [names[name] for name in names if name.startswith("test_")]
    assert tests
    for test in tests:
        test()
