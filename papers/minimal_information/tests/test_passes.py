"""Passes, each with its own cost: what a whole run would hide is found."""

import pytest
from claim_mutants import WatchedWasteful

import passes
from allworlds import Checkpoint, Move, World
from allworlds.claims import Unfinished
from allworlds.maps import from_rotation
from formulas import paper_bound
from paper_laws import verdict

TRIANGLE_BEHIND_AN_EDGE = World(from_rotation([[1], [0, 2, 3], [1, 3], [1, 2]]), "directional")


def test_a_pass_that_costs_too_much_is_found_out_though_the_run_keeps_its_bound(monkeypatch):
    monkeypatch.setattr(passes, "Watched", WatchedWasteful)
    world = TRIANGLE_BEHIND_AN_EDGE
    met = passes.passes_of(world)
    total = paper_bound(world.map.vertex_count, world.map.edge_count)
    assert sum(one.cost for one in met) <= total
    assert met[0].cost > passes.pass_bound(world.map.edge_count, 1, 0)
    assert verdict("pass-cost", edges=3, policies=["fifo"]) == "refuted"
    assert verdict("pass-walk", edges=3, policies=["fifo"]) == "refuted"


def test_a_pass_that_is_not_shown_is_no_pass_to_be_believed(monkeypatch):
    def silent(self):
        exploring, seen = super(passes.Watched, self).explore(), None
        while True:
            try:
                said = exploring.send(seen)
            except StopIteration as end:
                return end.value
            seen = None if type(said) is Checkpoint else (yield said)

    monkeypatch.setattr(passes.Watched, "explore", silent)
    with pytest.raises(Unfinished, match="after each pass"):
        passes.passes_of(TRIANGLE_BEHIND_AN_EDGE)


def test_a_run_that_does_not_end_has_no_passes(monkeypatch):
    def endless(_self):
        while True:
            yield Move(0)

    monkeypatch.setattr(passes.Watched, "explore", endless)
    with pytest.raises(Unfinished, match=r"no answer after \d+ traversals"):
        passes.passes_of(TRIANGLE_BEHIND_AN_EDGE)
