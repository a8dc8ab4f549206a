"""The explorers that the paper compares with, and those that do without tests."""

from collections import Counter

import pytest

import allworlds
from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.explorers.builtin.quotient import ClassTable, _Learner
from allworlds.maps import MapClass, named_map, rooted_code, rooted_maps
from allworlds.protocol.actions import Ambiguous, Drop, Estimate, Move, Pick
from allworlds.studies.ambiguity import class_of
from allworlds.world import Position, World
from allworlds.world.lighthouses.kinds import lighthouse_kind
from small import EDGE, LOOP, all_maps


def explored(name, map_, start=0):
    """The answer of a built-in explorer, the robot's dart, and its actions, played by hand."""
    own = BUILT_IN[name]
    events = []
    place = next(lighthouse_kind(own.lighthouse).as_class.places(map_, start))
    world = World(map_, place, start)
    walk, reply = own.explore(world.first, notice=events.append), None
    state, actions = world.initial, []
    while True:
        try:
            message = walk.send(reply)
        except StopIteration as stop:
            return stop.value, state.dart, actions, events
        reply = None
        if isinstance(message, (Move, Drop, Pick)):
            state, reply = world.step(state, message)
            actions.append(message)


def right(map_, answer, dart):
    found = answer.map
    return rooted_code(found.sigma, found.alpha, answer.here) == rooted_code(
        map_.sigma, map_.alpha, dart
    )


def cost(actions):
    return sum(isinstance(action, Move) for action in actions)


# ---------------------------------------------------------------- one movable marker


@pytest.mark.parametrize("most", [4])
def test_with_one_marker_every_simple_world_is_mapped_within_the_bound(most):
    for m in range(1, most + 1):
        for map_ in rooted_maps(m, MapClass.SIMPLE):
            answer, dart, actions, events = explored("dudek91", map_)
            n, degree = map_.vertex_count, max(map_.degrees)
            assert right(map_, answer, dart)
            new = sum(3 * s for s in range(1, n))
            assert cost(actions) <= new + (m - n + 1) * (5 * n + 2 * degree - 4)
            assert Counter(events) == +Counter({"new-vertex": n - 1, "back-link": m - n + 1})


def ends(map_):
    """The ends of each edge; one vertex if it is a loop."""
    vertices = map_.vertex_of
    return [frozenset({vertices[dart], vertices[map_.alpha[dart]]}) for dart in map_.darts]


def test_with_one_marker_a_loop_at_each_vertex_is_mapped_within_the_bound_of_the_theorem():
    """``movable_marker_is_right`` counts moves, drops and picks."""
    loops = 0
    for map_ in all_maps(4):
        if max(Counter(ends(map_)).values()) > 2:  # each edge has two darts
            continue
        answer, dart, actions, _ = explored("dudek91", map_)
        assert right(map_, answer, dart)
        most = 5 * map_.vertex_count + 2 * max(map_.degrees)
        assert len(actions) <= map_.edge_count * most
        loops += len(min(ends(map_), key=len)) == 1
    assert loops == 119


def test_the_marker_is_in_the_hand_again_at_the_end():
    for map_ in all_maps(2):
        _, _, actions, events = explored("dudek91", map_)
        kinds = Counter(map(type, actions))
        assert (
            kinds[Drop] == kinds[Pick] == events.count("new-vertex") + 2 * events.count("back-link")
        )


def test_two_loops_at_a_vertex_are_taken_wrongly_in_one_of_two_worlds():
    answers = []
    for name in ("two-loops-plane", "two-loops-torus"):
        map_ = named_map(name)
        answer, dart, _, _ = explored("dudek91", map_)
        answers.append(right(map_, answer, dart))
    assert sorted(answers) == [False, True]


# ---------------------------------------------------------------- labels


def test_with_labels_every_world_is_mapped_and_no_edge_is_walked_three_times():
    for map_ in all_maps(4):
        answer, dart, actions, events = explored("dfs", map_)
        assert right(map_, answer, dart)
        assert map_.edge_count <= cost(actions) <= 2 * map_.edge_count
        assert Counter(events)["unknown"] == map_.vertex_count - 1


# ---------------------------------------------------------------- position only


@pytest.mark.parametrize("most", [3])
def test_under_position_the_answer_is_a_map_exactly_where_only_one_looks_so(most):
    for map_ in all_maps(most):
        answer, dart, _, _ = explored("quotient", map_)
        alone = class_of(World(map_, Position(0))).size == 1
        assert isinstance(answer, Estimate if alone else Ambiguous)
        if alone:
            assert right(map_, answer, dart)


def test_worlds_that_look_alike_get_one_answer_after_one_walk():
    for map_ in all_maps(2):
        members = class_of(World(map_, Position(0))).worlds
        found = [explored("quotient", member.map, member.start) for member in members]
        assert len({repr((answer, actions)) for answer, _, actions, _ in found}) == 1


@pytest.mark.parametrize("map_", [EDGE, LOOP, named_map("cycle-3"), named_map("theta")])
def test_a_known_world_is_told_for_what_it_is(map_):
    answer, _, _, events = explored("quotient", map_)
    alone = class_of(World(map_, Position(0))).size == 1
    assert events == ["map" if alone else "ambiguous"]
    assert isinstance(answer, Estimate if alone else Ambiguous)


@pytest.mark.parametrize("word", ["a", "sas", "ssasa", "asasa"])
def test_a_word_back_leads_from_where_a_word_led(word):
    map_ = named_map("k4")
    learner = _Learner(None)
    learner.table = ClassTable(map_.sigma, map_.alpha, (), 0)
    back = learner._back((*word,), [*map_.degree_at])
    assert learner.table.after((*word, *back)) == 0 != learner.table.after((*word,))


def test_it_brings_a_step_budget_and_another_can_be_named():
    dear = named_map("theta")
    assert allworlds.run("quotient", World(dear, Position(0))).rules.step_budget == 100_000
    found = allworlds.run("quotient", World(dear, Position(0)), step_budget=3)
    assert found.finding.law == "budget"


# ---------------------------------------------------------------- folding alone


@pytest.mark.parametrize("name", ["folding", "folding-oldest"])
def test_a_log_without_open_darts_is_the_map(name):
    for map_ in all_maps(3):
        answer, dart, _, events = explored(name, map_)
        assert right(map_, answer, dart)
        # Each cycle beyond a tree is closed by an arrival that makes nodes one.
        assert len(events) >= map_.edge_count - map_.vertex_count + 1


def test_the_two_ways_are_two_and_going_home_is_not_the_cheaper_one():
    costs = [
        tuple(cost(explored(name, map_)[2]) for name in ("folding", "folding-oldest"))
        for map_ in all_maps(3)
    ]
    assert all(a >= b for a, b in costs)
    assert any(a > b for a, b in costs)


def test_an_unfair_way_never_ends():
    report = allworlds.check("allworlds.corpus.explorers:nearest_only", edges=3)
    assert report.findings[0].law == "budget"
    assert report.findings[0].world.map.edge_count == 3
