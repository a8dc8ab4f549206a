"""The walk in an answer, traced back from its end."""

from allworlds import Move, Percept
from allworlds.judging.belief import believed_percepts, trail_to
from allworlds.judging.walk import Walk
from allworlds.maps import named_map
from allworlds.world import Compass, Directional, World
from small import EDGE, LOOP, TRIANGLE

THETA = named_map("theta")


def walk(world, *motions):
    return Walk.of(world, map(Move, motions))


def test_in_the_right_answer_the_walk_is_the_true_one():
    world = World(THETA, Directional(1), 0)
    log = walk(world, 1, 2, 0, 1)
    trail = log.darts
    assert len(trail) == 5
    assert trail_to(world.map, trail[-1], log) == trail
    assert believed_percepts(log, world.map, trail) == [
        log.first,
        *(percept for _, percept in log.steps),
    ]


def test_an_answer_without_a_place_for_the_marker_expects_nothing():
    world = World(THETA, Directional(2), 0)
    assert believed_percepts(walk(world), EDGE, [0]) is None


def test_a_compass_is_believed_where_it_was_first_sensed():
    # Round a triangle, which the answer takes for a loop: the first bearing is 1, so north is
    # the other dart than the one faced, and both arrivals are by that dart.
    world = World(TRIANGLE, Compass((1, 2, 5)), 0)
    log = walk(world, 0, 1)
    assert [log.first.bearing, *(percept.bearing for _, percept in log.steps)] == [1, 0, 1]
    expected = believed_percepts(log, LOOP, trail_to(LOOP, 1, log))
    assert [percept.bearing for percept in expected] == [1, 0, 0]


def test_a_believed_percept_has_the_believed_degree():
    world = World(THETA, Directional(0), 0)
    log = walk(world, 0)
    assert believed_percepts(log, EDGE, trail_to(EDGE, 1, log)) == [
        Percept(1, 1, 0),
        Percept(1),
    ]
