"""A world as a table: what a player walks in is what the world's own steps say."""

import inspect

import pytest
from msgspec.structs import force_setattr

from allworlds import check, run
from allworlds.engines.judge import table_of
from allworlds.judging.episode import AroundExplorer
from allworlds.judging.walk import Walk
from allworlds.maps import rooted_maps
from allworlds.protocol.actions import BeyondRecord, Move, Percept
from allworlds.protocol.playing import Record, TableWorld, numbers_of
from allworlds.world import LIGHTHOUSES, World
from allworlds.world.lighthouses.base import ACTING, Lighthouse
from allworlds.world.lighthouses.composed import Composed, Movable, Nothing

STATIC = {name: kind for name, kind in LIGHTHOUSES.items() if kind.static}


def test_these_kinds_change_by_what_the_robot_does_and_no_others():
    assert {*LIGHTHOUSES} - {*STATIC} == {"movable", "whiteboard", "doormarks"}
    assert Composed((Nothing(),)).static
    assert not Composed((Nothing(), Movable())).static


@pytest.mark.parametrize("name", ACTING)
def test_a_kind_with_one_acting_method_of_its_own_is_not_static(name):
    assert not type("Own", (Nothing,), {name: lambda *_: 1}).static
    assert type("Own", (Nothing,), {"sensed": lambda *_: 1}).static


def test_every_method_that_looks_at_a_state_or_an_action_is_an_acting_one():
    looks = {
        name
        for name, method in inspect.getmembers(Lighthouse, inspect.isfunction)
        if {"state", "action"} & {*inspect.signature(method).parameters}
    }
    assert looks == {*ACTING} - {"in_hand"}


@pytest.mark.parametrize("kind", STATIC.values(), ids=STATIC)
@pytest.mark.parametrize("edges", [1, 2, 3])
def test_every_motion_in_a_table_is_that_of_the_world(kind, edges):
    tried = 0
    for map_ in rooted_maps(edges):
        for place in kind.places(map_, 0):
            world = World(map_, place, 0)
            table = table_of(world)
            # From each dart each motion: the shortest walk to the dart, and one step more.
            ways = {world.start: ()}
            for dart, way in (queue := [*ways.items()]):
                for k in range(map_.degree_at[dart]):
                    walk, moved = Walk.of(world, map(Move, (*way, k))), TableWorld(table, None)
                    assert moved.first == world.first
                    assert [moved.move(each) for each in (*way, k)] == walk.percepts[1:]
                    if walk.here not in ways:
                        ways[walk.here] = (*way, k)
                        queue.append((walk.here, ways[walk.here]))
                    tried += 1
            assert len(ways) == len(map_.sigma)
    assert tried or kind.kind in ("cluster", "natural")


def test_each_percept_is_an_object_of_its_own_in_every_play():
    """What an explorer that compares by identity does, it does in each play of a run."""
    (map_,) = [each for each in rooted_maps(1) if each.vertex_count == 2]
    world = World(map_, Nothing(), 0)
    walk = Walk.of(world, [Move(0)] * 3)
    recorded = Record(numbers_of(walk.percepts), None)
    for around in (TableWorld(table_of(world), None), recorded, AroundExplorer(world)):
        assert around.first == world.first
        assert around.first is not world.first
        given = [around.first, *(around.move(0) for _ in range(3))]
        assert len({*map(id, given)}) == 4


def test_a_record_is_over_at_its_end_if_the_run_is_and_has_no_more_percepts():
    numbers = numbers_of([Percept(2), Percept(3, 1)])
    for over in (True, False):
        record = Record(numbers, None, over)
        assert not record.over
        assert record.move(1) == Percept(3, 1)
        assert record.over == over
        with pytest.raises(BeyondRecord):
            record.act(Move(0))


def test_a_percept_that_one_explorer_spoils_is_none_of_the_next_ones():
    def spoils(first):
        force_setattr(first, "degree", 9)
        yield Move(0)

    assert check(spoils, edges=1).verdict == "refuted"
    assert check("algorithm1", edges=1, engine="python").verdict == "holds"
    assert run("algorithm1", "theta").exit_code == 0
