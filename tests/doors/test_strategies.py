import re
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest
from hypothesis import find, given, settings
from hypothesis.strategies import tuples

from allworlds import strategies
from allworlds.explorers.builtin.algorithm1 import Algorithm1
from allworlds.inputs.checks import InputError
from allworlds.judging.episode import Answered, play
from allworlds.judging.laws.bounds import paper_bound
from allworlds.judging.laws.finished_run import Case
from allworlds.judging.laws.law_table import LAWS, judge
from allworlds.maps import CombinatorialMap, MapClass, rooted_code, rooted_maps
from allworlds.world import Directional, World
from bruteforce import rooted_maps_by_permutations as all_rooted_maps
from page_blocks import blocks
from schedules import schedules
from small import EDGE, LOOP, TORUS

OF_CLASS = {
    MapClass.MAPS: strategies.maps,
    MapClass.SIMPLE: strategies.simple_maps,
    MapClass.PLANAR: strategies.planar_maps,
    MapClass.PLANAR_SIMPLE: strategies.planar_simple_maps,
}
CLASSES = pytest.mark.parametrize("map_class", list(OF_CLASS))


def drawn(strategy, examples=300):
    """At most ``examples`` examples of a strategy, the same every time."""
    found = []

    @settings(max_examples=examples)
    @given(strategy)
    def collect(example):
        found.append(example)

    collect()
    return found


@cache
def sample(map_class, edges, examples=300):
    return drawn(OF_CLASS[map_class](max_edges=edges), examples)


def smallest(strategy, condition):
    return find(strategy, condition, settings=settings(max_examples=2000))


# ---------------------------------------------------------------- maps


@pytest.mark.slow
@pytest.mark.no_cover
@CLASSES
def test_every_map_of_at_most_three_edges_is_drawn(map_class):
    expected = {m for edges in (1, 2, 3) for m in all_rooted_maps(edges, map_class)}
    assert set(sample(map_class, 3)) == expected


@pytest.mark.slow
@pytest.mark.no_cover
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


@pytest.mark.no_cover
def test_one_that_never_draws_a_handle_would_be_noticed():
    assert set(sample(MapClass.PLANAR, 3)) < set(sample(MapClass.MAPS, 3))


@pytest.mark.slow
@pytest.mark.no_cover
@CLASSES
@pytest.mark.parametrize("edges", [6, 14])
def test_what_is_drawn_is_a_valid_map_of_the_class_in_canonical_numbering(map_class, edges):
    for map_ in sample(map_class, edges):
        assert CombinatorialMap(map_.sigma, map_.alpha) == map_
        assert map_class.includes(map_)
        assert map_.edge_count <= edges
        assert rooted_code(map_.sigma, map_.alpha, 0) == (map_.sigma, map_.alpha)


@pytest.mark.slow
@pytest.mark.no_cover
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


@pytest.mark.slow
@pytest.mark.no_cover
@pytest.mark.parametrize("strategy", OF_CLASS.values())
def test_the_number_of_edges_is_kept_between_its_bounds(strategy):
    assert {m.edge_count for m in drawn(strategy(3, 5))} == {3, 4, 5}


@pytest.mark.parametrize("strategy", OF_CLASS.values())
@pytest.mark.parametrize(
    ("least", "most", "message"),
    [
        (0, 3, "min_edges = 0, but a map has at least 1 edge"),
        (4, 3, "max_edges = 3 is less than min_edges = 4"),
    ],
)
def test_impossible_bounds_are_refused_at_once(strategy, least, most, message):
    with pytest.raises(InputError, match=message):
        strategy(least, most)


# ---------------------------------------------------------------- shrinking


@pytest.mark.slow
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


@pytest.mark.slow
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


# ---------------------------------------------------------------- worlds


@pytest.mark.no_cover
def test_every_start_and_every_bearing_of_a_small_map_is_drawn():
    found = {
        (world.map, world.start, world.lighthouse.dart)
        for world in drawn(strategies.worlds(strategies.maps(max_edges=2)), 1500)
    }
    expected = {
        (m, start, m.turn(start, bearing))
        for edges in (1, 2)
        for m in all_rooted_maps(edges)
        for start in m.darts
        for bearing in range(m.degree_at[start])
    }
    assert found == expected


def test_a_world_shrinks_to_start_0_and_a_marker_that_points_ahead():
    found = smallest(strategies.worlds(), lambda world: world.map.genus == 1)
    assert found == World(TORUS, Directional(0), 0)


def test_a_start_and_a_marker_that_matter_are_kept():
    found = smallest(
        strategies.worlds(strategies.simple_maps()),
        lambda world: world.start and world.lighthouse.dart != world.start,
    )
    assert (found.map.edge_count, found.map.vertex_count) == (2, 3)
    assert found.first.degree == 2


def test_a_lighthouse_that_is_none_is_refused_at_once():
    with pytest.raises(InputError, match="'lamp' is not one of"):
        strategies.worlds(lighthouse="lamp")


# ---------------------------------------------------------------- choices and motions


def asked(choices, *widths):
    """The answers of the choices to questions with these numbers of options."""
    return [choices.pick(range(width), of="edge") for width in widths]


@given(strategies.choices())
def test_every_answer_is_one_of_the_options_and_is_recorded(choices):
    answers = asked(choices, 1, 2, 3, 4, 5)
    assert all(0 <= answer < width for answer, width in zip(answers, range(1, 6), strict=True))
    assert choices.record == answers


@pytest.mark.no_cover
def test_every_short_run_of_answers_is_drawn():
    found = {tuple(asked(choices, 2, 3)) for choices in drawn(strategies.choices())}
    assert found == {(a, b) for a in range(2) for b in range(3)}


def test_choices_shrink_to_first_in_first_out():
    found = smallest(strategies.choices(), lambda _: True)
    assert asked(found, 3, 3, 3) == [0, 0, 0]


def test_only_the_choice_that_matters_is_not_0():
    def third(choices):
        return asked(choices, 4, 4, 4, 4)[2] == 3

    found = smallest(strategies.choices(), third)
    assert found.record == [0, 0, 3, 0]


def test_after_the_last_drawn_answer_the_first_option_is_taken():
    for choices in drawn(strategies.choices(max_size=3), 50):
        assert asked(choices, *[7] * 10)[3:] == [0] * 7


@pytest.mark.slow
def test_motions_shrink_to_none_and_to_few():
    assert smallest(strategies.motions(), lambda _: True) == []
    assert smallest(strategies.motions(), lambda ks: len(ks) >= 2) == [0, 0]
    assert smallest(strategies.motions(), lambda ks: any(k < 0 for k in ks)) == [-1]
    assert max(map(len, drawn(strategies.motions(4)))) == 4


# ---------------------------------------------------------------- for whoever tests an explorer


def violation(world, choices, kind=Algorithm1):
    def player(first, choices, told):
        return kind(first, choices).explore()

    bound = paper_bound(world.map.vertex_count, world.map.edge_count)
    episode = play(world, player, choices, 8 * bound + 100)
    if not isinstance(episode.ending, Answered):
        return episode.ending.law
    case = Case(
        world.map,
        world.start,
        episode.transcript,
        episode.checkpoints,
        episode.ending.answer,
        bound,
    )
    return getattr(judge(case, [law.check for law in LAWS.values()]), "law", None)


@pytest.mark.no_cover
@given(strategies.worlds(strategies.maps(max_edges=10)), strategies.choices())
def test_algorithm_1_holds_in_every_world_that_is_drawn(world, choices):
    assert violation(world, choices) is None


@pytest.mark.slow
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


def test_importing_the_package_does_not_load_hypothesis():
    code = "import allworlds, sys; print('hypothesis' in sys.modules)"
    code += "; from allworlds import strategies; print('hypothesis' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["False", "True"]


@pytest.mark.slow
def test_the_examples_of_the_page_for_users_pass():
    page = Path(__file__).parents[2] / "docs" / "how-to" / "pytest.md"
    text = page.read_text(encoding="utf-8")
    names = {}
    (block,) = (block for block in blocks(text, "python") if block.title == "test_properties.py")
    exec(block.body, names)  # as a user would paste it
    tests = [names[name] for name in names if name.startswith("test_")]
    assert len(tests) == 2
    for test in tests:
        test()


def test_the_page_for_users_lists_every_strategy_with_its_defaults():
    page = Path(__file__).parents[2] / "docs" / "how-to" / "pytest.md"
    listed = re.findall(r"^\| `(\w+)\(", page.read_text(encoding="utf-8"), re.MULTILINE)
    assert sorted(listed) == strategies.__all__
