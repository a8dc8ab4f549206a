"""More plays of a refuted explorer: an option is told only if the check with it holds."""

import re

import pytest

from allworlds import Estimate, Move, check
from allworlds.engines import engine_table
from allworlds.engines.units import Scope
from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.explorers.loading import Subject
from allworlds.judging.rules import Rules
from allworlds.maps.classes import Extent, MapClass, condition_named
from allworlds.studies.check import hints
from allworlds.studies.explain import explain


def hand(side, first):
    yield Move(0)
    while True:
        yield Move(side)


def left(first):
    yield from hand(1, first)


def right(first):
    yield from hand(-1, first)


def crashing(first):
    yield Move(0)
    while True:
        percept = yield Move(1)
        if percept.degree > 2:
            raise ValueError("a crossing")


def to_and_fro(first, times):
    estimate = yield from algorithm1(first)
    for _ in range(times):
        yield Move(0)
        yield Move(0)
    return estimate


def dear(first):
    return (yield from to_and_fro(first, 8))


def wordy(first):
    return (yield from to_and_fro(first, 60))


def dear_and_mirrored(first):
    estimate = yield from dear(first)
    return Estimate(estimate.map.mirrored(), estimate.here)


@pytest.fixture(autouse=True)
def any_time(monkeypatch):
    """Trials end by the number of their runs alone."""
    monkeypatch.setattr(hints, "SECONDS", 1e6)


def told(explorer, **options):
    (finding,) = check(explorer, **{"edges": 2, **options}).findings
    return finding, " ".join(explain(finding).sentences)


SCOPES = [
    {"task": "cover", "map_class": "planar-simple", "edges": 4},
    {"task": "cover:edges"},
    {"map_class": "simple"},
    {"where": "eulerian"},
    {"where": "girth:4"},
]


@pytest.mark.parametrize("options", SCOPES, ids=lambda one: "-".join(map(str, one.values())))
@pytest.mark.parametrize("hand", [left, right, crashing])
def test_a_wall_follower_gets_no_advice_that_does_not_help(hand, options, monkeypatch):
    monkeypatch.setattr(hints, "LARGER", 2)
    finding, text = told(hand, **options)
    assert finding.law in ("budget", "crash")
    assert finding.tried == ""
    assert not re.search("clockwise|counts|--|would be right|put right|pip install", text)


def test_a_bound_is_told_to_be_the_only_fault_where_that_was_tried():
    finding, text = told(dear)
    assert finding.tried == "--edges 2 --bound none"
    assert "With --edges 2 --bound none no law is broken" in text
    assert check(dear, edges=2, bound="none").exit_code == 0


def test_a_larger_budget_is_told_with_what_else_it_needs():
    finding, _ = told(wordy, edges=1)
    assert finding.law == "budget"
    assert finding.tried == "--edges 1 --step-budget 432 --bound none"
    assert check(wordy, edges=1, step_budget=432, bound="none").exit_code == 0


def test_an_option_with_which_a_larger_world_refutes_is_not_told():
    assert told(dear_and_mirrored, edges=1)[0].tried == "--edges 1 --bound none"
    assert told(dear_and_mirrored)[0].tried == ""


def test_only_levels_that_fit_are_tried_and_told(monkeypatch):
    monkeypatch.setattr(hints, "MOST", 10)
    assert told(dear)[0].tried == "--edges 1 --bound none"
    monkeypatch.setattr(hints, "MOST", 2)
    assert told(dear)[0].tried == ""


def test_nothing_is_told_that_was_not_decided_in_time(monkeypatch):
    monkeypatch.setattr(hints, "SECONDS", -1)
    assert told(dear, edges=2)[0].tried == ""


@pytest.mark.parametrize(("where", "says"), [(None, "needs numba"), ("cubic", "")])
def test_an_extra_is_not_proposed_where_it_would_not_help(where, says, monkeypatch):
    monkeypatch.setattr(engine_table, "lack_of", lambda package, _extra: f"needs {package}")
    extent = Extent(MapClass.MAPS, 9, where=condition_named(where) if where else None)
    why = engine_table.why_not_compiled(Scope(extent, Rules()), Subject("a.py:f", frozenset()))
    assert says in why
    assert bool(why) == bool(says)
