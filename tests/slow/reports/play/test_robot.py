"""The page's robot senses and does what the worlds say, and its notes are those of the log."""

import pytest

from allworlds import Move
from allworlds.maps import rooted_maps
from allworlds.reports.web.play import world_data
from allworlds.world import LIGHTHOUSES, World
from reports.play.test_robot import MARKING, action_json, reachable, state_json, true_answer


def worlds_of(kind, most):
    for edges in range(1, most + 1):
        for map_ in rooted_maps(edges):
            for place in kind.places(map_, 0):
                yield World(map_, place, 0)


def up_to_three_edges():
    """Every lighthouse with the most edges; doormarks have very many worlds with three."""
    for name, kind in LIGHTHOUSES.items():
        if name == "doormarks":
            yield pytest.param(kind, 2, id=name)
            yield pytest.param(kind, 3, id=f"{name}, three edges", marks=pytest.mark.slowest)
        else:
            yield pytest.param(kind, 3, id=name)


@pytest.mark.parametrize(("kind", "most"), [*up_to_three_edges()])
def test_every_step_in_every_world_of_up_to_three_edges_is_that_of_the_world(kind, most, ask):
    worlds = 0
    for world in worlds_of(kind, most):
        worlds += 1
        data = world_data(world)
        assert ask(what="begin", world=data) == [state_json(world.initial), world.first.to_json()]
        asked = [
            (state, action)
            for state in reachable(world)
            for action in (*map(Move, range(-1, world.sensed(state).degree + 1)), *MARKING)
        ]
        given = [[state_json(state), action_json(action)] for state, action in asked]
        assert ask(what="steps", world=data, asked=given) == [
            true_answer(world, state, action) for state, action in asked
        ]
    assert worlds > 0
