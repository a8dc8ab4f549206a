"""Lighthouses that are put together, what is told, and numbers that are written."""

import pickle

import pytest

from allworlds.documents.document import replace
from allworlds.protocol.actions import Drop, Move, Percept, Pick, Write
from allworlds.world import Directional, IllegalAction, InvalidWorld, World, worlds
from allworlds.world.lighthouses.kinds import kind_of, lighthouse_from_json, lighthouse_kind
from small import EDGE, LOLLIPOP, PATH, TORUS, TRIANGLE, all_maps


def one(name, map_):
    """The world with the lighthouse at its first place."""
    return World(map_, next(lighthouse_kind(name).as_class.places(map_, 0)))


def test_percepts_add_up_and_places_multiply():
    for map_ in all_maps(3):
        compass = [*lighthouse_kind("compass").as_class.places(map_, 0)]
        both = [*lighthouse_kind("cluster+compass").as_class.places(map_, 0)]
        clusters = [*lighthouse_kind("cluster").as_class.places(map_, 0)]
        assert len(both) == len(clusters) * len(compass)
        for place in both:
            cluster, north = place.parts
            world = World(map_, place)
            assert world.percepts == tuple(
                Percept(map_.degree_at[dart], a.marks, b.bearing)
                for dart, (a, b) in enumerate(
                    zip(cluster.percepts(map_), north.percepts(map_), strict=True)
                )
            )
            assert both[place.number(map_, 0)] == place
            assert World.from_json(world.to_json()) == world
            assert pickle.loads(pickle.dumps(place)) == place


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("position+movable", "position and movable both have marks"),
        ("whiteboard+doormarks", "whiteboard and doormarks both have marks"),
        ("compass+directional", "compass and directional both have bearings"),
        ("natural+told:n", "natural and told:n both tell something"),
        ("position+", "'' is not one of"),
        ("told:n,n", "names 'n'; legal are n, m, d, g, each once"),
        ("told:x", "names 'x'; legal are n, m, d, g"),
        ("told:n=3", "names 'n=3'; legal are n, m, d, g"),
        ("whiteboard:states=1", "option states = 1 is less than 2"),
        ("whiteboard:marks=3", "has no option 'marks'"),
        ("doormarks:states=many", "option states = 'many' is not an integer"),
        ("movable:distinct=1", "neither true nor false"),
    ],
)
def test_what_does_not_go_together_is_refused_with_the_reason(name, said):
    with pytest.raises(InvalidWorld, match=said) as error:
        lighthouse_kind(name)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("name", ["ports", "ports:states=3", "compass+ports"])
def test_the_old_name_of_doormarks_is_answered_by_both_that_may_be_meant(name):
    with pytest.raises(InvalidWorld, match=r"now called 'doormarks' .* port numbers, .* 'compass'"):
        lighthouse_kind(name)
    with pytest.raises(InvalidWorld, match="'ports' is now called 'doormarks'"):
        lighthouse_from_json({"kind": "ports", "states": 2}, EDGE, 0)


def test_parts_of_a_document_that_do_not_go_together_are_refused():
    for document in (
        {"kind": "position+movable", "parts": [{"kind": "position"}, {"kind": "movable"}]},
        {"kind": "position+told", "parts": [{"kind": "position"}, {"kind": "compass"}]},
        {"kind": "position", "parts": [{"kind": "position"}]},
        {"kind": "position+told", "parts": [{"kind": "position"}, 3]},
    ):
        with pytest.raises(InvalidWorld):
            World(EDGE, lighthouse_from_json(document, EDGE, 0))


@pytest.mark.parametrize(
    ("map_", "told"),
    [
        (EDGE, {"n": 2, "m": 1, "d": 1, "g": 0}),
        (PATH, {"n": 3, "m": 2, "d": 2, "g": 0}),
        (TRIANGLE, {"n": 3, "m": 3, "d": 1, "g": 0}),
        (TORUS, {"n": 1, "m": 2, "d": 0, "g": 1}),
        (LOLLIPOP, {"n": 2, "m": 2, "d": 1, "g": 0}),
    ],
)
def test_what_is_told_are_the_numbers_of_the_world(map_, told):
    assert one("position+told:n,m,d,g", map_).told == told
    assert one("told:g", map_).told == {"g": told["g"]}
    assert one("position", map_).told is None


def test_a_number_stays_where_it_was_written():
    world = one("whiteboard:states=3", PATH)
    state, sensed = world.step(world.initial, Write(2))
    assert sensed == Percept(1, 2)
    state, sensed = world.step(state, Move(0))
    assert sensed == Percept(2, 0)
    state, sensed = world.step(state, Write(1))
    state, sensed = world.step(state, Move(0))
    assert sensed == Percept(1, 2)
    state, sensed = world.step(state, Write(0))
    assert (sensed.marks, len(state.written)) == (0, 1)
    for number in (3, 10**9):
        with pytest.raises(IllegalAction, match=r"a Write\(k\) with k from 0 to 2"):
            world.step(state, Write(number))
    for action in (Drop(), Pick()):
        with pytest.raises(IllegalAction, match="a Move or Write"):
            world.step(state, action)


def test_on_darts_the_number_is_that_of_the_dart_one_came_by():
    world = one("doormarks", TRIANGLE)
    state, _ = world.step(world.initial, Move(0))  # round the triangle
    state, sensed = world.step(state, Write(1))
    assert sensed.marks == 1
    there = state.dart
    for _ in range(3):
        state, sensed = world.step(state, Move(1))
        assert sensed.marks == (state.dart == there)
    assert state.dart == there
    state, sensed = world.step(state, Move(0))
    state, sensed = world.step(state, Move(0))
    assert (state.dart, sensed.marks) == (there, 1)


def test_markers_that_are_distinct_are_told_apart():
    world = one("movable:markers=2,distinct=true", EDGE)
    state, sensed = world.step(world.initial, Drop())
    assert sensed.marks == 1
    state, _ = world.step(state, Move(0))
    state, sensed = world.step(state, Drop())
    assert sensed.marks == 2
    state, sensed = world.step(state, Pick())
    assert (sensed.marks, state.hand) == (0, 1)
    state, _ = world.step(state, Move(0))
    state, sensed = world.step(state, Drop())
    assert sensed.marks == 3
    state, sensed = world.step(state, Pick())
    assert (sensed.marks, state.hand) == (2, 1)
    assert World.from_json(world.to_json()) == world


def test_renaming_darts_changes_no_percept_of_a_composition():
    names = [3, 2, 1, 0]
    for name in ("compass+movable", "position+told:n", "whiteboard+compass"):
        for world in worlds(edges=2, lighthouse=name, places="all"):
            if world.map.edge_count == 2:
                other = world.relabelled(names)
                assert all(other.percepts[names[d]] == p for d, p in enumerate(world.percepts))
                assert str(kind_of(other.lighthouse)) == str(kind_of(world.lighthouse))


@pytest.mark.parametrize(
    ("name", "leaves_open", "folds"),
    [
        ("position+told:n,m", True, False),
        ("told:m+position", True, False),
        ("position+none", True, False),
        ("position+told:g", False, False),  # the worlds that look alike may differ in that
        ("position+told:n,d", False, False),
        ("position+compass", False, False),
        ("directional+none", False, True),
        ("directional+told:n", False, False),  # who is told more may stop sooner
        ("compass+movable", False, False),
    ],
)
def test_it_has_what_its_parts_allow_unless_another_part_adds_to_it(name, leaves_open, folds):
    kind = lighthouse_kind(name).as_class
    assert (kind.leaves_open, kind.folds) == (leaves_open, folds)
    place = next(kind.places(PATH, 0))
    assert place.as_kind.leaves_open == leaves_open
    assert place.as_kind.leaves_marks == kind.leaves_marks == ("movable" in name)


def test_a_part_that_cannot_stand_where_it_is_said_to_is_refused():
    composed = lighthouse_kind("position+told:n").as_class.usual(TRIANGLE, 0)
    composed.check(TRIANGLE, 0)
    with pytest.raises(InvalidWorld):
        replace(composed, parts=(Directional(99), *composed.parts[1:])).check(TRIANGLE, 0)


STATES = {2: True, 2**31: True, 1: False, 2**31 + 1: False, 10**18 - 1: False}


@pytest.mark.parametrize("kind", ["whiteboard", "doormarks"])
@pytest.mark.parametrize("states", STATES)
def test_there_are_from_2_to_2147483648_numbers(kind, states):
    name = f"{kind}:states={states}"
    if STATES[states]:
        world = one(name, EDGE)
        state, sensed = world.step(world.initial, Write(states - 1))
        assert sensed.marks == states - 1
        with pytest.raises(IllegalAction):
            world.step(state, Write(states))
    else:
        limit = "less than 2, the least one" if states < 2 else "more than 2147483648"
        with pytest.raises(InvalidWorld, match=f"states = {states} is {limit}$"):
            lighthouse_kind(name)


@pytest.mark.parametrize("told", [[], "n", 5, None])
def test_what_is_told_is_a_list_of_words(told):
    with pytest.raises(InvalidWorld, match="is no list of words; legal are n, m, d, g, each once"):
        lighthouse_from_json({"kind": "told", "names": told}, EDGE, 0)
