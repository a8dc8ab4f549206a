"""The walk in an answer, traced back from its end."""

from allworlds import CombinatorialMap, Move, Percept
from allworlds.checker.belief import believed_percepts, believed_trail, true_trail
from allworlds.maps import named_map
from allworlds.protocol import Transcript
from allworlds.world import Directional, World
from allworlds.world.lighthouses import Compass

THETA = named_map("theta")
EDGE = CombinatorialMap([0, 1], [1, 0])


def walk(world, *motions):
    dart, steps = world.start, []
    for k in motions:
        dart, percept = world.step(dart, Move(k))
        steps.append((Move(k), percept))
    return Transcript(world.first, tuple(steps))


def test_in_the_right_answer_the_walk_is_the_true_one():
    world = World(THETA, Directional(1), 0)
    log = walk(world, 1, 2, 0, 1)
    trail = true_trail(world, log)
    assert len(trail) == 5
    assert believed_trail(world.map, trail[-1], log) == trail
    assert believed_percepts(world, world.map, trail[-1], log) == [
        log.first,
        *(percept for _, percept in log.steps),
    ]


def test_an_answer_without_a_place_for_the_marker_expects_nothing():
    world = World(THETA, Directional(2), 0)
    assert believed_percepts(world, EDGE, 0, Transcript(world.first)) is None


def test_a_compass_is_believed_where_it_was_first_sensed():
    # In the edge's map both vertices have degree 1; a theta's robot sensed bearing 2 first.
    world = World(THETA, Compass((2, 4)), 0)
    log = walk(world, 0)
    here = true_trail(world, log)[-1]
    sensed = [log.first, *(percept for _, percept in log.steps)]
    assert believed_percepts(world, THETA, here, log) == sensed
    turned = believed_percepts(world, THETA, THETA.turn(here, 1), log)
    assert turned == sensed, "a robot believes its first look at every vertex"


def test_a_believed_percept_has_the_believed_degree():
    world = World(THETA, Directional(0), 0)
    assert believed_percepts(world, EDGE, 1, walk(world, 0)) == [Percept(1, 1, 0), Percept(1)]
