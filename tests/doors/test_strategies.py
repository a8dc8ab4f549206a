import re
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest
from hypothesis import find, given, settings

from allworlds import strategies
from allworlds.explorers.builtin.algorithm1 import Algorithm1
from allworlds.inputs.checks import InputError
from allworlds.judging.episode import Answered, play
from allworlds.judging.laws.bounds import paper_bound
from allworlds.judging.laws.law_table import LAWS, Case, first_broken
from allworlds.maps import MapClass
from allworlds.world import Directional, World
from bruteforce import rooted_maps_by_permutations as all_rooted_maps
from small import TORUS

OF_CLASS = {
    MapClass.MAPS: strategies.maps,
    MapClass.SIMPLE: strategies.simple_maps,
    MapClass.PLANAR: strategies.planar_maps,
    MapClass.PLANAR_SIMPLE: strategies.planar_simple_maps,
}


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


def test_one_that_never_draws_a_handle_would_be_noticed():
    assert set(sample(MapClass.PLANAR, 3)) < set(sample(MapClass.MAPS, 3))


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


# ---------------------------------------------------------------- worlds


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


def test_no_world_is_drawn_of_a_map_without_a_place_for_the_lighthouse():
    found = drawn(strategies.worlds(strategies.maps(max_edges=2), lighthouse="natural"), 50)
    assert {*found}


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


# ---------------------------------------------------------------- for whoever tests an explorer


def violation(world, choices, kind=Algorithm1):
    def player(first, choices, told):
        return kind(first, choices).explore()

    bound = paper_bound(world.map.vertex_count, world.map.edge_count)
    episode = play(world, player, choices, 8 * bound + 100)
    if not isinstance(episode.ending, Answered):
        return episode.ending.law
    case = Case(episode.walk, episode.checkpoints, episode.ending.answer, bound)
    return getattr(first_broken(case, [law.check for law in LAWS.values()]), "law", None)


@given(strategies.worlds(strategies.maps(max_edges=10)), strategies.choices())
def test_algorithm_1_holds_in_every_world_that_is_drawn(world, choices):
    assert violation(world, choices) is None


def test_importing_the_package_does_not_load_hypothesis():
    code = "import allworlds, sys; print('hypothesis' in sys.modules)"
    code += "; from allworlds import strategies; print('hypothesis' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["False", "True"]


def test_the_page_for_users_lists_every_strategy_with_its_defaults():
    page = Path(__file__).parents[2] / "docs" / "how-to" / "pytest.md"
    listed = re.findall(r"^\| `(\w+)\(", page.read_text(encoding="utf-8"), re.MULTILINE)
    assert sorted(listed) == strategies.__all__


def test_a_map_has_no_fewer_vertices_than_its_edges_need():
    """Complete graphs, and in the plane triangulations."""
    fewest = {
        MapClass.MAPS: [1] * 16,
        MapClass.SIMPLE: [2, 3, 3, 4, 4, 4, 5, 5, 5, 5, 6, 6, 6, 6, 6, 7],
        MapClass.PLANAR_SIMPLE: [2, 3, 3, 4, 4, 4, 5, 5, 5, 6, 6, 6, 7, 7, 7, 8],
    }
    for map_class, known in fewest.items():
        found = [strategies._fewest_vertices(map_class, m) for m in range(1, 17)]
        assert found == known


@pytest.mark.parametrize("picked", [0, -1])
def test_a_map_grows_to_the_size_that_was_asked_for(picked):
    for edges, vertices in ((1, 1), (3, 1), (3, 2), (3, 4)):
        map_ = strategies.grow(
            MapClass.MAPS, edges, vertices, lambda options: range(len(options))[picked]
        )
        assert (map_.edge_count, map_.vertex_count) == (edges, vertices)


@pytest.mark.parametrize("strategy", OF_CLASS.values())
def test_the_least_bounds_are_one_edge(strategy):
    strategy(1, 1)
    strategy(3, 3)


def test_a_failing_example_shows_the_answers_to_its_choices():
    assert repr(strategies.Answers([2, 0])) == "Answers([2, 0])"
