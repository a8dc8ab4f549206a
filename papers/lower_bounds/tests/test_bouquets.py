"""Bouquets at a distance, and the bounds that need no search."""

from itertools import product
from math import prod

import pytest

from allworlds import Move, Percept
from allworlds.maps import rooted_code
from bouquets import (
    bound_of_information,
    bouquets,
    cautious_cost,
    number_of_bouquets,
    told_apart,
)
from playing import run_here
from small import slowest


@pytest.mark.parametrize("loops", [1, 2, 3, 4])
def test_every_bouquet_is_there_once(loops):
    every = [*bouquets(loops)]
    codes = {rooted_code(world.map.sigma, world.map.alpha, 0) for world in every}
    assert len(every) == len(codes) == number_of_bouquets(loops) == prod(range(1, 2 * loops, 2))
    for world in every:
        assert world.first == Percept(1, 1, 0)
        assert world.map.edge_count == loops + 1
        assert world.map.vertex_count == 2


def test_the_bound_of_information_is_the_one_that_coq_computes():
    # Coq: least_motions_of_bouquets.
    bounds = [bound_of_information(number_of_bouquets(loops)) for loops in range(2, 7)]
    assert bounds == [4, 9, 14, 20, 26]


def logs(worlds, walk):
    """The worlds by what is sensed on a walk."""
    parts = {}
    for world in worlds:
        state, sensed = world.initial, []
        for k in walk:
            state, percept = world.step(state, Move(k))
            sensed.append(percept)
        parts.setdefault(tuple(sensed), []).append(world)
    return parts


@pytest.mark.parametrize("length", [0, 1, 2, 3, 4, slowest(5)])
def test_no_walk_of_fixed_motions_tells_more_apart_than_the_bound(length):
    every = [*bouquets(3)]
    most = max(len(logs(every, walk)) for walk in product(range(7), repeat=length))
    assert most <= told_apart(Percept(1, 1, 0), length)


def test_cautious_explorers_need_what_is_said_in_their_worst_bouquet():
    for loops in (1, 2, 3):
        costs = [run_here("remembering", world).cost for world in bouquets(loops)]
        assert max(costs) == cautious_cost(loops)
