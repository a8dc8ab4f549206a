"""Markers in the robot's hand, and vertices with numbers of their own."""

from collections import Counter
from random import Random

import pytest

from allworlds.maps import CombinatorialMap, rooted_code
from allworlds.protocol.actions import Drop, Move, Percept, Pick
from allworlds.world import IllegalAction, InvalidWorld, Movable, Nothing, State, World
from allworlds.world.lighthouses.kinds import lighthouse_from_json, lighthouse_kind
from allworlds.world.lighthouses.marked import Labels
from small import EDGE, LOLLIPOP, LOOP, PATH, all_maps

# ---------------------------------------------------------------- movable


def actions(world, state):
    """The legal actions of the robot, found without the code of the lighthouse."""
    here = state.lying.count(world.map.vertex_of[state.dart])
    legal = [Move(k) for k in range(world.map.degree_at[state.dart])]
    legal += [Drop()] * (state.hand > 0)
    return legal + [Pick()] * (here > 0 and world.lighthouse.pick)


def a_walk(world, random, steps=30):
    """A random walk: states, actions and percepts."""
    state, walked = world.initial, []
    for _ in range(steps):
        action = random.choice(actions(world, state))
        state, percept = world.step(state, action)
        walked.append((action, state, percept))
    return walked


@pytest.mark.parametrize("markers", [1, 2, 3])
@pytest.mark.parametrize("pick", [True, False])
def test_a_marker_is_sensed_where_it_was_dropped_and_not_taken_up_and_nowhere_else(markers, pick):
    random = Random(markers)
    for map_ in all_maps(3):
        world = World(map_, Movable(markers, pick))
        assert world.first == Percept(map_.degree_at[0])
        assert world.initial == State(0, (), markers)
        lying, dart = Counter(), 0
        for action, state, percept in a_walk(world, random):
            if type(action) is Move:
                dart = map_.alpha[map_.turn(dart, action.k)]
            lying[map_.vertex_of[dart]] += (type(action) is Drop) - (type(action) is Pick)
            assert state.dart == dart
            assert Counter(state.lying) == +lying
            assert state.hand + len(state.lying) == markers
            assert percept == Percept(map_.degree_at[dart], lying[map_.vertex_of[dart]], None)


def test_markers_cannot_be_told_from_each_other_by_the_order_in_which_they_were_dropped():
    one = World(PATH, Movable(2))
    there = [Drop(), Move(0), Drop()]
    first_elsewhere = [Move(0), Drop(), Move(0), Drop(), Move(0)]
    ends = []
    for walk in (there, first_elsewhere):
        state = one.initial
        for action in walk:
            state, _ = one.step(state, action)
        ends.append(state)
    assert ends[0] == ends[1]


@pytest.mark.parametrize(
    ("lighthouse", "walk", "legal"),
    [
        (Movable(), [Drop(), Drop()], "a Drop only with a marker in hand"),
        (Movable(2), [Drop(), Move(0), Drop(), Drop()], "a Drop only with a marker in hand"),
        (Movable(), [Pick()], "a Pick only where a marker lies"),
        (Movable(), [Drop(), Move(0), Pick()], "a Pick only where a marker lies"),
        (Movable(), [Drop(), Pick(), Pick()], "a Pick only where a marker lies"),
        (Movable(1, pick=False), [Drop(), Pick()], "no Pick: .* stays where it was dropped"),
        (Movable(1, pick=False), [Pick()], "no Pick"),
        (Movable(), [None], "a Move, Drop or Pick"),
        (Nothing(), [Drop()], "the none lighthouse gives no markers"),
        (Labels((0, 1)), [Pick()], "the labels lighthouse gives no markers"),
    ],
)
def test_what_there_are_no_markers_for_is_refused_with_what_would_be_legal(lighthouse, walk, legal):
    world = World(EDGE, lighthouse)
    state = world.initial
    for action in walk[:-1]:
        state, _ = world.step(state, action)
    with pytest.raises(IllegalAction, match=legal):
        world.step(state, walk[-1])


@pytest.mark.parametrize("markers", [1, 2])
def test_relabelling_the_world_leaves_every_percept_of_a_walk_unchanged(markers):
    random = Random(markers)
    for map_ in all_maps(3)[::2]:
        world = World(map_, Movable(markers))
        names = list(map_.darts)
        random.shuffle(names)
        renamed = world.relabelled(names)
        state = renamed.initial
        for action, there, percept in a_walk(world, random):
            state, sensed = renamed.step(state, action)
            assert (sensed, state.dart, state.hand) == (percept, names[there.dart], there.hand)


@pytest.mark.parametrize(
    ("name", "markers", "pick"),
    [
        ("movable", 1, True),
        ("movable:markers=3", 3, True),
        ("movable:pick=false", 1, False),
        ("movable:pick=false,markers=2", 2, False),
        ("movable:markers=1,pick=true", 1, True),
    ],
)
def test_the_options_say_how_many_there_are_and_whether_they_may_be_taken_up(name, markers, pick):
    kind = lighthouse_kind(name).as_class
    assert list(kind.places(LOOP, 0)) == [Movable(markers, pick)]
    assert lighthouse_kind(name).as_class is kind
    document = {"kind": "movable", "markers": markers, "pick": pick}
    world = World.from_json(LOOP.to_json(), missing=name)
    assert world.to_json()["lighthouse"] == document
    assert World.from_json(world.to_json()) == world


def test_of_a_lighthouse_in_the_hand_a_file_may_leave_out_everything():
    assert lighthouse_from_json({"kind": "movable"}, PATH, 1) == Movable(1, pick=True)
    assert lighthouse_from_json({"kind": "movable", "markers": 4}, PATH, 1) == Movable(4)
    assert lighthouse_from_json({"kind": "movable", "pick": False}, PATH, 1) == Movable(
        1, pick=False
    )


@pytest.mark.parametrize(
    ("given", "named"),
    [
        ("movable:markers=0", "option markers = 0 is less than 1"),
        ("movable:markers=-1", "option markers = -1 is less than 1"),
        ("movable:markers=two", "option markers = 'two' is not an integer"),
        ("movable:markers=" + "9" * 5000, "option markers = '999.*is not an integer"),
        ("movable:pick=yes", "option pick = 'yes' is neither true nor false"),
        ("movable:dart=0", "no option 'dart'; legal: markers, pick, distinct"),
        ("labels:darts=1", "the lighthouse 'labels' has no option 'darts'; it has none"),
    ],
)
def test_an_option_that_is_none_is_named(given, named):
    with pytest.raises(InvalidWorld, match=named):
        lighthouse_kind(given)


@pytest.mark.parametrize(
    ("lighthouse", "named"),
    [
        ({"markers": 0}, "lighthouse.markers = 0 is less than 1"),
        ({"markers": True}, "lighthouse.markers = True is not an integer"),
        ({"markers": "1"}, "lighthouse.markers = '1' is not an integer"),
        ({"pick": 1}, "lighthouse.pick = 1 is neither true nor false"),
        ({"dart": 0}, "'dart' is no key of a movable lighthouse; legal are kind, markers, pick"),
    ],
)
def test_a_lighthouse_in_the_hand_that_is_none_is_named(lighthouse, named):
    with pytest.raises(InvalidWorld, match=named):
        World.from_json({**PATH.to_json(), "lighthouse": {"kind": "movable", **lighthouse}})


# ---------------------------------------------------------------- labels


def test_every_vertex_has_a_number_of_its_own_and_the_bearing_of_one_dart():
    for map_ in all_maps(3):
        (place,) = Labels.places(map_, 0)
        world = World(map_, place)
        numbers = {}
        for dart, percept in zip(map_.darts, world.percepts, strict=True):
            assert numbers.setdefault(map_.vertex_of[dart], percept.marks) == percept.marks
            assert map_.turn(dart, percept.bearing) == place.darts[percept.marks - 1]
            assert percept.degree == map_.degree_at[dart]
        assert sorted(numbers.values()) == list(range(1, map_.vertex_count + 1))
        assert world.first.marks == 1


def test_the_numbers_follow_the_canonical_numbering_from_the_start():
    for map_ in all_maps(3):
        for start in map_.darts:
            code = rooted_code(map_.sigma, map_.alpha, start)
            canonical = CombinatorialMap(*code)
            (there,) = Labels.places(canonical, 0)
            assert there.darts == tuple(vertex[0] for vertex in canonical.vertices)
            (here,) = Labels.places(map_, start)
            degrees = [map_.degree_at[dart] for dart in here.darts]
            assert degrees == [canonical.degree_at[dart] for dart in there.darts]


def test_a_file_names_the_darts_in_the_order_of_their_numbers():
    document = {**LOLLIPOP.to_json(), "lighthouse": {"kind": "labels", "darts": [3, 0]}}
    world = World.from_json(document)
    assert [percept.marks for percept in world.percepts] == [2, 1, 1, 1]
    assert world.to_json() == {**document, "start": 0}
    assert World.from_json(world.to_json()) == world


@pytest.mark.parametrize(
    ("darts", "named"),
    [
        ([0], "legal is one dart of each vertex"),
        ([0, 4], "legal is one dart of each vertex"),
        ([0, 0, 1], "legal is one dart of each vertex"),
        ("01", r"must be a list of darts"),
    ],
)
def test_labels_that_do_not_fit_are_named(darts, named):
    document = {**LOLLIPOP.to_json(), "lighthouse": {"kind": "labels", "darts": darts}}
    with pytest.raises(InvalidWorld, match=named):
        World.from_json(document)
