"""The walk of a run: each of its fields is what the world's steps make of it."""

import pytest

from allworlds.inputs.checks import InputError
from allworlds.judging.walk import Walk
from allworlds.maps import rooted_maps
from allworlds.protocol.actions import Drop, IllegalAction, Move, Percept, Pick, Transcript, Write
from allworlds.world import Directional, Movable, World
from allworlds.world.lighthouses.composed import Whiteboard
from small import LOLLIPOP, PATH


def test_the_trail_follows_the_motions_and_stays_where_there_is_none():
    walk = Walk.of(World(LOLLIPOP, Movable()), (Move(0), Drop(), Move(-2), Move(1)))
    # 0 -> 1; stay; sigma^-2(1) = 2, across to 3; sigma(3) = 1, across to 0.
    assert walk.darts == [0, 1, 1, 3, 0]
    assert walk.here == 0
    assert walk.arrivals == {0, 1, 3}
    assert walk.cost == 3
    assert len(walk) == len(walk.steps) == 4


def test_an_edge_is_crossed_first_where_it_is_first_walked_along():
    walk = Walk.of(World(LOLLIPOP, Movable()), (Drop(), Move(0), Move(0), Move(0), Move(1)))
    assert walk.crossed == {0: 1, 2: 4}
    assert walk.walked == {0, 2}
    assert walk.visited == {*LOLLIPOP.vertex_of}


def test_states_and_percepts_are_those_of_the_world():
    for map_ in (map_ for edges in (1, 2, 3) for map_ in rooted_maps(edges)):
        world, actions = World(map_, Whiteboard()), (Write(1), Move(1), Move(2), Write(1), Move(0))
        walk, state, percepts = Walk.begin(world), world.initial, [world.first]
        assert walk.states == [state]
        for action in actions:
            state, percept = world.step(state, action)
            percepts.append(percept)
            assert walk.step(action) == percept
            assert walk.states[-1] == state
            assert walk.here == state.dart
        assert walk.percepts == percepts
        assert walk.actions == [*actions]
        assert walk == Walk.of(world, actions)
        assert Walk.recorded(world, walk.transcript) == walk


def test_an_illegal_action_leaves_the_walk_as_it_was():
    walk = Walk.of(World(PATH, Movable()), [Move(0)])
    before = Walk.of(walk.world, walk.actions)
    with pytest.raises(IllegalAction):
        walk.step(Pick())
    assert walk == before


def test_a_transcript_that_is_no_walk_is_refused_by_its_first_wrong_step():
    world = World(PATH, Directional(0))
    right = Walk.of(world, [Move(0), Move(1)]).transcript
    wrong = Transcript(right.first, (right.steps[0], (Move(1), Percept(9))))
    with pytest.raises(InputError, match="at step 2 it has degree 9, where the world has degree 1"):
        Walk.recorded(world, wrong)
    with pytest.raises(InputError, match="no walk in its world: "):
        Walk.recorded(world, Transcript(right.first, ((Pick(), right.first),)))
