"""The walk as a log tells it: the edges that it discovers."""

from allworlds import Move
from allworlds.judging.explanations.story import Walked
from allworlds.judging.walk import Walk
from allworlds.protocol.actions import Drop, Pick
from allworlds.world import world_named


def walked(world, *actions):
    return Walked(Walk.of(world, actions))


def test_an_edge_is_discovered_by_the_first_step_along_it():
    world = world_named("k4", "directional")

    def steps(*actions):
        return [*walked(world, *actions).discoveries.values()]

    assert steps() == []
    assert steps(Move(1), Move(0), Move(0)) == [1]
    assert steps(Move(1), Move(1), Move(1), Move(1)) == [1, 2, 3]


def test_who_drops_the_marker_walks_along_no_edge():
    world = world_named("k4", "movable")
    told = walked(world, Drop(), Move(1), Move(0), Pick(), Move(0))
    edge = world.map.sigma[world.start]
    assert told.discoveries == {min(edge, world.map.alpha[edge]): 2}
