"""Costs beside the player's: those of runs, and never below what is possible."""

import json

import pytest

from allworlds import optimum, run
from allworlds.inputs import InputError
from allworlds.reports import game, text
from allworlds.reports.play.costs import costs_beside, in_words
from allworlds.studies.play import play
from allworlds.world import Directional, Position, World
from allworlds.world.enumeration import worlds
from small import PATH


def test_each_cost_is_that_of_its_run_and_no_less_than_each_edge_once():
    for start in list(worlds(edges=3))[-6:]:
        world = World(start.map, Directional(0), 0)
        one, best, least = costs_beside(world)
        assert one.cost == run("algorithm1", world).cost >= least.cost == 3
        # Who knows the number of edges may leave one out, but needs no more than in the worst case.
        assert best.cost <= optimum(edges=3).rows[-1].optimum
        assert best.who.startswith("the optimum")


def test_under_another_lighthouse_there_is_nothing_to_compare_with():
    assert costs_beside(World(PATH, Position(0), 0)) == []
    assert in_words([]) == ""


def test_a_world_of_a_size_is_drawn_by_its_seed():
    one, again, other = (play("random:8", seed=seed).world for seed in (3, 3, 4))
    assert one == again != other
    assert one.map.edge_count == 8
    assert len(costs_beside(one)) == 2


@pytest.mark.parametrize(
    "world", ["k4", '{"sigma": [0, 1], "alpha": [1, 0]}', World(PATH, Directional(0))]
)
def test_a_seed_without_a_family_is_refused(world):
    with pytest.raises(InputError, match=r"seed = 1 has no effect|seed 1 has no effect"):
        play(world, seed=1)


def test_the_page_has_the_costs_and_no_text_tells_them_before_the_walk():
    made = play("random:3", seed=3)
    said = in_words(costs_beside(made.world))
    assert json.dumps(said) in game(made)
    assert "Algorithm 1" not in text("play", made, 100)
