"""The example of an explorer that walks words for many hypotheses at once."""

from math import inf
from pathlib import Path

import pytest

import sweep
from adversary import Deciding
from allworlds import check, run
from corridors import usual_shape
from playing import named, played
from small import slowest

HERE = Path(sweep.__file__)


def test_it_is_right_in_every_small_world():
    assert check(f"{HERE}:sweep", edges=3, bound="none").verdict.value == "holds"


@pytest.mark.parametrize("edges", [3, slowest(4)])
def test_it_is_right_if_it_sweeps_wherever_it_can(monkeypatch, edges):
    class Eager(sweep.Sweep):
        credit = inf

    def eager(first):
        return (yield from Eager(first, lambda _: None).explore())

    for name, value in {"WORTH": 0, "STILL_WORTH": 0, "FEWEST": 1}.items():
        monkeypatch.setattr(sweep, name, value)
    report = check(eager, edges=edges, bound="none")
    assert report.verdict.value == "holds"
    assert report.traversals > check(named("prudent"), edges=edges).traversals  # it did sweep


@pytest.mark.parametrize(("far", "cost"), [(1, 832), slowest(2, 7_799)])
def test_what_it_walks_against_the_adversary(far, cost):
    deciding = Deciding(usual_shape(far), 1)
    walk = played(sweep.sweep, deciding, deciding.heed)
    assert len(walk.actions) == cost
    told = run(lambda first: (yield from sweep.sweep(first)), deciding.world(), bound="none")
    assert told.finding is None
    assert told.transcript.actions == walk.actions
