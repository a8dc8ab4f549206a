"""The cost of Algorithm 1 beside the player's."""

import json
import sys
from io import StringIO

import pytest

from allworlds import run
from allworlds.cli.app import call
from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.inputs.checks import InputError
from allworlds.reports.formats import text
from allworlds.reports.web.play import game
from allworlds.studies.run import play
from allworlds.world import LIGHTHOUSES, Directional, World
from allworlds.world.selection import worlds
from small import LOLLIPOP, PATH


def test_the_cost_of_algorithm1_is_that_of_its_run():
    for start in [*worlds(edges=3)][-20:]:
        world = World(start.map, Directional(0), 0)
        assert play(world).algorithm1 == run("algorithm1", world).cost >= 3


@pytest.mark.parametrize("kind", LIGHTHOUSES)
def test_algorithm1_is_run_under_each_lighthouse_that_it_is_written_for(kind):
    made = play(json.dumps(LOLLIPOP.to_json()), lighthouse=kind)
    variants = {BUILT_IN[n].lighthouse for n in BUILT_IN if n.startswith("algorithm1")}
    assert (made.algorithm1 is not None) == (kind in variants)


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


def test_the_page_has_the_cost_and_no_text_tells_it_before_the_walk():
    made = play("random:3", seed=3)
    assert "Algorithm 1" in game(made)
    assert "Algorithm 1" not in text(made, 100)


def test_the_own_cost_stands_beside_that_of_algorithm1(monkeypatch, capsys):
    monkeypatch.setattr(sys, "stdin", StringIO("0\n0\n\n"))
    assert call(["play", "star:3"]) == 0
    said = capsys.readouterr().out
    rows = [line.rsplit(maxsplit=1) for line in said.partition("walked by")[2].splitlines()[1:3]]
    assert rows == [["you", "2"], ["Algorithm 1", "5"]]


def test_the_document_has_the_cost(monkeypatch, capsys):
    monkeypatch.setattr(sys, "stdin", StringIO("0\n"))
    assert call(["play", "star:3", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["algorithm1"] == 5
