"""Another world that agrees with the log: it is another one, and it does agree."""

from itertools import product

import pytest

import allworlds
from allworlds import Move
from allworlds.judging.explanations.by_law import another_world
from allworlds.judging.laws.folding import fold
from allworlds.protocol.actions import Transcript
from second_opinion import same_pose

WORDS = [word for length in range(4) for word in product(range(2), repeat=length)]


def log_of(world, word):
    state, steps = world.initial, []
    for k in word:
        degree = (steps[-1][1] if steps else world.first).degree
        action = Move(k % degree)
        state, percept = world.step(state, action)
        steps.append((action, percept))
    return Transcript(world.first, tuple(steps))


@pytest.mark.parametrize("map_class", ["simple"])
def test_in_every_small_world_and_for_every_short_walk_it_is_another_and_senses_the_same(map_class):
    others = 0
    for world in allworlds.worlds(edges=3, map_class=map_class, places="all"):
        for word in WORDS:
            log = log_of(world, word)
            other = another_world(world, log)
            assert (other is None) == (fold(log).open_darts == 0)
            if other is not None:
                others += 1
                assert log_of(other, word) == log
                assert not same_pose(other.map, other.start, world.map, world.start)
                assert other.map.is_simple or not world.map.is_simple
    assert others > 100
