"""Where the notes are drawn: a place stays where it was put, and none covers another."""

from math import atan2, cos, hypot, pi, sin
from random import Random

import pytest

from allworlds.maps import family, named_map
from allworlds.protocol.actions import Move
from allworlds.world import World


def drawn(ask, world, moves, conclusions=None):
    """The spots after each of these moves; conclusions by the number of moves made."""
    state, steps = world.initial, []
    for k in moves:
        state, percept = world.step(state, Move(k))
        steps.append({"action": {"move": k}, "percept": percept.to_json()})
    first = world.first.to_json()
    return ask(what="spots", first=first, steps=steps, conclusions=conclusions or {})


def walks():
    """Walks without a plan, in worlds of several kinds."""
    for text in ("lattice:4x4", "torus:3x3", "dense:6", "bouquet:5", "random:9", "cycle:12"):
        for seed in (1, 2):
            draw = Random(seed)
            yield World(family(text, seed=seed)), [draw.randrange(12) for _ in range(40)]


DART = 11
"""The radius of the circle of a dart."""


def apart(one, other):
    return hypot(one["x"] - other["x"], one["y"] - other["y"])


@pytest.mark.parametrize(("world", "moves"), [*walks()])
def test_a_place_stays_and_covers_no_other(world, moves, ask):
    before = {}
    for told in drawn(ask, world, moves):
        spots = told["spots"]
        assert {name: spots[name] for name in before} == before
        before = spots
        placed = [*spots.values()]
        for i, one in enumerate(placed):
            for other in placed[:i]:
                assert (
                    apart(one, other) >= one["far"] + other["far"] + 22
                )  # their darts are circles


@pytest.mark.parametrize(("world", "moves"), [*walks()])
def test_the_dart_by_which_one_came_looks_back_and_the_one_left_by_looks_there(world, moves, ask):
    degrees = degrees_of(world, moves)
    (*_, last) = drawn(ask, world, moves)
    for name, end in last["ends"]:
        if name == 0:
            continue
        parent, dart = map(int, end.split("."))
        here, there = last["spots"][str(name)], last["spots"][str(parent)]
        back = atan2(there["y"] - here["y"], there["x"] - here["x"])
        assert cos(back - here["turned"]) > 0.999
        # The place lies within a right angle of the dart that led to it.
        ahead = there["turned"] + 2 * pi * dart / degrees[parent]
        away = (here["x"] - there["x"]) * cos(ahead) + (here["y"] - there["y"]) * sin(ahead)
        assert away > -1


def degrees_of(world, moves):
    """The degrees that are sensed at the start and after each move."""
    state, degrees = world.initial, [world.first.degree]
    for k in moves:
        state, percept = world.step(state, Move(k))
        degrees.append(percept.degree)
    return degrees


def test_the_box_holds_every_place_with_its_darts(ask):
    for world, moves in walks():
        (*_, last) = drawn(ask, world, moves)
        left, top, wide, high = (last["box"][side] for side in ("left", "top", "width", "height"))
        for name, _ in last["ends"]:
            spot = last["spots"][str(name)]
            assert left + spot["far"] < spot["x"] < left + wide - spot["far"]
            assert top + spot["far"] < spot["y"] < top + high - spot["far"]


def test_a_place_that_a_conclusion_has_taken_comes_back_where_it_was(ask):
    # Round a theta: the third arrival is at the first place again.
    world, moves = World(named_map("theta"), "none"), [0, 1, 1]
    free = drawn(ask, world, moves)
    concluded = drawn(ask, world, moves, {"2": [[[2, 0], [0, 1]]]})
    assert [name for name, _ in concluded[2]["ends"]] == [0, 1]
    assert [name for name, _ in free[2]["ends"]] == [0, 1, 2]
    assert concluded[3]["spots"]["2"] == free[3]["spots"]["2"]
