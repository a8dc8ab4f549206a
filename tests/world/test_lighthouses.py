"""The percepts under each lighthouse, and the places where it may stand."""

from dataclasses import dataclass
from math import prod
from random import Random
from types import SimpleNamespace
from typing import Annotated

import pytest
from msgspec import Meta

from allworlds.maps import named_map, rooted_maps
from allworlds.protocol.actions import Percept
from allworlds.world import (
    LIGHTHOUSES,
    Compass,
    Directional,
    InvalidWorld,
    Nothing,
    Position,
    Where,
    World,
)
from allworlds.world.lighthouses.base import WalkInAnswer
from allworlds.world.lighthouses.kinds import lighthouse_from_json, lighthouse_kind
from allworlds.world.lighthouses.marked import Cluster, Labels
from allworlds.world.lighthouses.options import options_of
from small import PATH, all_maps

KINDS = {"none": Nothing, "position": Position, "compass": Compass, "directional": Directional}
POOR = [Nothing, Position, Compass]  # lighthouses that do not settle where one is


def worlds(kind, largest=3):
    return [World(map_, place) for map_ in all_maps(largest) for place in kind.places(map_, 0)]


def turns(map_, dart, goal):
    """How many sigmas lead from a dart to another, counted one by one; None if none do."""
    count, other = 0, dart
    while other != goal:
        count, other = count + 1, map_.sigma[other]
        if other == dart:
            return None
    return count


def test_the_four_levels_of_information_are_lighthouses():
    for name, kind in KINDS.items():
        assert kind.kind == name
        assert LIGHTHOUSES[name] is kind
        assert lighthouse_kind(name).as_class is kind


@pytest.mark.parametrize("kind", POOR)
def test_only_a_directional_lighthouse_promises_a_bound_and_a_log_that_folds(kind):
    assert (kind.default_bound, kind.folds) == ("none", False)
    assert (Directional.default_bound, Directional.folds) == ("paper", True)


def test_without_a_lighthouse_only_the_degree_is_sensed():
    for world in worlds(Nothing):
        assert world.percepts == tuple(Percept(d, 0, None) for d in world.map.degree_at)


def test_position_is_one_mark_at_the_starts_vertex_and_no_bearing():
    for world in worlds(Position):
        for dart in world.map.darts:
            marks = int(turns(world.map, dart, world.start) is not None)
            assert world.percepts[dart] == Percept(world.map.degree_at[dart], marks, None)


def test_a_compass_gives_the_bearing_of_the_reference_dart_at_every_vertex_and_no_mark():
    for world in worlds(Compass):
        for dart in world.map.darts:
            norths = [turns(world.map, dart, north) for north in world.lighthouse.darts]
            (bearing,) = [north for north in norths if north is not None]
            assert world.percepts[dart] == Percept(world.map.degree_at[dart], 0, bearing)


def test_a_directional_lighthouse_senses_more_than_position_and_position_more_than_nothing():
    for world in worlds(Directional):
        position = World(world.map, Position(0)).percepts
        nothing = World(world.map, Nothing()).percepts
        for mine, poorer, poorest in zip(world.percepts, position, nothing, strict=True):
            assert Percept(mine.degree, mine.marks) == poorer
            assert Percept(poorer.degree) == poorest


@pytest.mark.parametrize("kind", KINDS.values())
def test_more_than_the_degree_is_sensed_where_the_level_says_and_nowhere_else(kind):
    level = kind.sensing
    for world in worlds(kind):
        v0 = world.map.vertex_of[world.start]
        for vertex, percept in zip(world.map.vertex_of, world.percepts, strict=True):
            here = {
                Where.NOWHERE: False,
                Where.AT_V0: vertex == v0,
                Where.EVERYWHERE: True,
            }[level.where]
            assert (percept.bearing is not None) == (here and level.bearing)
            assert percept.marks == (here and level.marks_v0)


@pytest.mark.parametrize("kind", [Nothing, Position])
def test_without_a_direction_there_is_one_place(kind):
    for map_ in all_maps(3):
        for start in map_.darts:
            (place,) = kind.places(map_, start)
            World(map_, place, start)


def test_up_to_three_edges_every_choice_of_reference_darts_is_a_place_of_a_compass():
    for map_ in all_maps(3):
        places = list(Compass.places(map_, 0))
        assert len(set(places)) == len(places) == prod(map_.degrees)


def test_beyond_three_edges_a_compass_has_one_place():
    for map_ in list(rooted_maps(4))[::7]:
        assert len(list(Compass.places(map_, 0))) == 1


@pytest.mark.parametrize("kind", KINDS.values())
@pytest.mark.parametrize("largest", [3, 4])
def test_places_have_the_same_order_whatever_the_darts_are_called(kind, largest):
    random = Random(largest)
    for map_ in all_maps(largest)[::5]:
        names = list(map_.darts)
        random.shuffle(names)
        renamed = [place.relabelled(names) for place in kind.places(map_, 0)]
        assert renamed == list(kind.places(map_.relabelled(names), names[0]))


@pytest.mark.parametrize("kind", KINDS.values())
def test_relabelling_the_darts_changes_no_percept(kind):
    random = Random(1)
    for world in worlds(kind)[::3]:
        names = list(world.map.darts)
        random.shuffle(names)
        renamed = world.relabelled(names)
        for dart in world.map.darts:
            assert renamed.percepts[names[dart]] == world.percepts[dart]


@pytest.mark.parametrize("kind", KINDS.values())
def test_json_goes_there_and_back(kind):
    for world in worlds(kind):
        again = World.from_json(world.to_json())
        assert again == world
        assert again.to_json() == world.to_json()


def test_two_position_lighthouses_at_one_vertex_are_equal():
    document = {**PATH.to_json(), "start": 1, "lighthouse": {"kind": "position", "dart": 2}}
    world = World.from_json(document)
    assert world == World(PATH, Position(1), 1)
    assert world.percepts == World(PATH, Position(1), 1).percepts
    assert world.to_json() == document


def test_a_lighthouse_without_a_place_stands_at_the_default_one():
    assert lighthouse_from_json({"kind": "none"}, PATH, 1) == Nothing()
    assert lighthouse_from_json({"kind": "position"}, PATH, 1).dart == 1
    assert lighthouse_from_json({"kind": "directional"}, PATH, 1) == Directional(1)
    assert lighthouse_from_json({"kind": "compass"}, PATH, 2) == Compass((0, 1, 3))


@pytest.mark.parametrize("kind", KINDS)
def test_a_world_without_a_lighthouse_gets_one_of_the_kind_that_is_asked_for(kind):
    assert World.from_json(PATH.to_json(), missing=kind).lighthouse.kind == kind
    named = {**PATH.to_json(), "lighthouse": {"kind": "none"}}
    assert World.from_json(named, missing=kind).lighthouse == Nothing()


def test_reference_darts_in_a_file_may_come_in_any_order():
    document = {"kind": "compass", "darts": [3, 2, 0]}
    assert lighthouse_from_json(document, PATH, 0) == Compass((0, 2, 3))


@pytest.mark.parametrize(
    ("lighthouse", "named"),
    [
        ({"kind": "position", "dart": 1}, "stand at dart 1 .*legal are 0"),
        ({"kind": "position", "dart": [0, 1]}, r"lighthouse.dart = \[0, 1\] is not an integer"),
        ({"kind": "position", "dart": None}, r"lighthouse.dart = None is not an integer"),
        ({"kind": "compass", "darts": 3}, r"must be a list of darts, not 3"),
        ({"kind": "compass", "darts": None}, r"must be a list of darts, not None"),
        ({"kind": "compass", "darts": [0, "1", 3]}, r"darts\[1\] = '1' is not an integer"),
        ({"kind": "compass", "darts": [0, True, 3]}, r"darts\[1\] = True is not an integer"),
        ({"kind": "compass", "darts": [0, 1, 4]}, r"\[0, 1, 4\]; legal is one dart of each vertex"),
        ({"kind": "compass", "darts": [-1, 1, 3]}, r"darts = \[-1, 1, 3\]; legal is one"),
        ({"kind": "compass", "darts": [0, 3]}, r"of \[\(0,\), \(1, 2\), \(3,\)\]"),
        ({"kind": "compass", "darts": [0, 1, 2, 3]}, "legal is one dart of each vertex"),
        ({"kind": "compass", "darts": [0, 0, 1, 3]}, "legal is one dart of each vertex"),
        ({"kind": "none:x=1"}, r"lighthouse.kind = 'none:x=1' is more than a name"),
    ],
)
def test_a_lighthouse_that_does_not_fit_is_named(lighthouse, named):
    with pytest.raises(InvalidWorld, match=named):
        World.from_json({**PATH.to_json(), "lighthouse": lighthouse})


def test_reference_darts_may_be_given_in_any_order():
    assert World(PATH, Compass((2, 0, 3))) == World(PATH, Compass((0, 2, 3)))
    assert World(PATH, Compass([0, 2, 3])).percepts == World(PATH, Compass((0, 2, 3))).percepts


def test_the_lighthouse_in_an_answer_is_in_the_direction_from_where_the_walk_began():
    map_ = named_map("k4")
    walk = SimpleNamespace(map=map_, trail=(4, 7, 11))
    for of, dart in ((Cluster, 2), (Directional, 2)):
        assert of(dart).believed(map_, 0, walk) == of(map_.turn(4, map_.offset(0, dart)))


def test_of_a_vertex_that_was_never_visited_the_first_dart_and_no_number_are_believed():
    """The walk stays at the end of a path; darts 1 and 2 are at a vertex that it has not seen."""
    walk = WalkInAnswer(PATH, [0], [Percept(1, 7, 0)])
    assert Compass((0, 2, 3)).believed(PATH, 0, walk) == Compass((0, 1, 3))
    assert Labels((0, 2, 3)).believed(PATH, 0, walk) == Labels((0, 1, 3), (7, 0, 0))


@pytest.mark.parametrize("dart", [2, 7])
def test_if_the_robot_starts_anywhere_the_lighthouse_of_an_answer_has_the_number_of_its_place(dart):
    map_, kind = named_map("k4"), lighthouse_kind("cluster:start=any").as_class
    number = [place.dart for place in kind.places(map_, 0)].index(dart)
    walk = SimpleNamespace(map=map_, trail=(4, 7, 11))
    believed = Cluster(dart, start="any").believed(map_, 0, walk)
    assert believed == [*kind.places(map_, 4)][number]
    assert believed.start == "any"


def test_the_limits_of_an_option_stand_in_whichever_note_has_them():
    @dataclass(frozen=True)
    class Several(Directional):
        many: Annotated[int, Meta(title="how many"), Meta(ge=2)] = 3

    assert options_of(Several)["many"].limits.ge == 2
