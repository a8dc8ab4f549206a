"""The worlds of one robot as a model: the same percepts, and the same runs."""

import pytest

from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.explorers.builtin.baselines import dudek91
from allworlds.inputs.checks import InputError
from allworlds.protocol.actions import Checkpoint, Move, Write
from allworlds.robots.models.table import model_of
from allworlds.robots.single_search import search
from allworlds.world import World
from allworlds.world.lighthouses.kinds import lighthouse_kind
from small import all_maps, slowest


def mapper(first):
    return (yield from algorithm1(first))


@pytest.mark.parametrize(("edges", "runs"), [(3, 309), slowest(4, 3684)])
def test_algorithm_1_has_as_many_runs_as_always(edges, runs):
    model, _ = model_of("lighthouse:directional")
    count = 0
    for map_ in all_maps(edges):
        found = search(map_, (0,), model, [mapper], "fsync")
        assert found.holds
        count += found.schedules
    assert count == runs


def scribbles(first):
    """Walk on, and write how often it was here."""
    seen = first
    for step in range(6):
        seen = yield Write((seen.marks + 1) % 2)
        seen = yield Move(step * step + seen.marks)


def played(world, explore):
    """The percepts of a run in a world."""
    state, run = world.initial, explore(world.first)
    percepts, action = [world.first], next(run)
    while True:
        try:
            while type(action) is Checkpoint:
                action = run.send(None)
            state, percept = world.step(state, action)
            percepts.append(percept)
            action = run.send(percept)
        except StopIteration:
            return percepts


@pytest.mark.parametrize(
    ("kind", "explore"),
    [("directional", mapper), ("movable", dudek91), ("compass+whiteboard:states=4", scribbles)],
)
def test_a_robot_senses_what_it_senses_in_the_world(kind, explore):
    model, _ = model_of(f"lighthouse:{kind}")
    for map_ in all_maps(2):
        asked = []

        def noted(first, asked=asked):
            percepts = [first]
            asked.append(percepts)
            run, reply = explore(first), None
            while True:
                try:
                    action = run.send(reply)
                except StopIteration as stop:
                    return stop.value
                reply = yield action
                if type(action) is not Checkpoint:
                    percepts.append(reply)

        found = search(map_, (0,), model, [noted], "fsync", budget=200)
        places = lighthouse_kind(kind).as_class.places(map_, 0)
        assert found.law in ("", "answer")
        worlds = [World(map_, place) for place in places]
        assert max(asked, key=len) in [played(world, explore) for world in worlds]


def test_it_is_a_model_of_one_robot():
    model, _ = model_of("lighthouse:position")
    with pytest.raises(InputError, match="lighthouse:position is a model of one robot, not of 2"):
        search(all_maps(1)[0], (0, 0), model, [walk] * 2, "fsync")


def walk(first):
    yield Move(1)
