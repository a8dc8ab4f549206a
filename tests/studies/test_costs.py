"""Costs beside the player's: those of runs, of the best strategy, and of the shortest walk."""

import json
import sys
from io import StringIO

import pytest

from allworlds import run
from allworlds.cli.app import call
from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.inputs.checks import InputError
from allworlds.maps import named_map
from allworlds.reports.formats import text
from allworlds.reports.web.play import LEAST, NAMES, game
from allworlds.studies.run import Walker, play
from allworlds.world import LIGHTHOUSES, Directional, World
from allworlds.world.selection import worlds
from small import LOLLIPOP, PATH


def costs(world):
    """The costs by their names."""
    return {one.who.value: one.cost for one in play(world).costs}


def test_each_cost_is_that_of_its_run_and_none_is_below_every_edge():
    for start in [*worlds(edges=3)][-20:]:
        world = World(start.map, Directional(0), 0)
        found = costs(world)
        assert found["algorithm1"] == run("algorithm1", world).cost >= found["every-edge"] >= 3


def test_from_the_middle_of_a_star_each_edge_once_is_not_enough():
    assert costs(World(named_map("star-3")))["every-edge"] == 5


@pytest.mark.parametrize("kind", LIGHTHOUSES)
def test_under_each_lighthouse_those_are_compared_that_can_be_run(kind):
    made = play(json.dumps(LOLLIPOP.to_json()), lighthouse=kind)
    variants = {BUILT_IN[n].lighthouse for n in BUILT_IN if n.startswith("algorithm1")}
    found = costs(made.world)
    assert ("algorithm1" in found) == (kind in variants)
    assert found["every-edge"] == 2


def test_a_world_of_a_size_is_drawn_by_its_seed():
    one, again, other = (play("random:8", seed=seed).world for seed in (3, 3, 4))
    assert one == again != other
    assert one.map.edge_count == 8


@pytest.mark.parametrize(
    "world", ["k4", '{"sigma": [0, 1], "alpha": [1, 0]}', World(PATH, Directional(0))]
)
def test_a_seed_without_a_family_is_refused(world):
    with pytest.raises(InputError, match=r"seed = 1 has no effect|seed 1 has no effect"):
        play(world, seed=1)


def test_the_page_has_the_costs_and_no_text_tells_them_before_the_walk():
    made = play("random:3", seed=3)
    assert all(json.dumps(NAMES[one.who]) in game(made) for one in made.costs)
    assert "Algorithm 1" not in text(made, 100)


def test_the_own_cost_stands_beside_the_others(monkeypatch, capsys):
    monkeypatch.setattr(sys, "stdin", StringIO("0\n0\n\n"))
    assert call(["play", "star:3"]) == 0
    said = capsys.readouterr().out
    rows = [line.rsplit(maxsplit=1) for line in said.partition("walked by")[2].splitlines()[1:4]]
    assert rows[0] == ["you", "2"]
    assert {name: int(cost) for name, cost in rows[1:]} == {
        NAMES[who]: cost for who, cost in zip(Walker, (5, 5), strict=True)
    }
    assert " ".join(LEAST.split()) in " ".join(said.split())


def test_the_document_has_the_costs(monkeypatch, capsys):
    monkeypatch.setattr(sys, "stdin", StringIO("0\n"))
    assert call(["play", "star:3", "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["costs"] == [
        {"who": "algorithm1", "cost": 5},
        {"who": "every-edge", "cost": 5},
    ]
