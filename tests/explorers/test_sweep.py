"""The example of an explorer that walks words for many hypotheses at once."""

import importlib.util
from math import inf
from pathlib import Path

import pytest

import allworlds
from allworlds.maps import CorridorShape, usual_degree
from allworlds.outcome import Verdict
from allworlds.world import Adversary
from small import long

pytestmark = pytest.mark.usefixtures("without_workers")

ROOT = Path(__file__).parents[2]
EXAMPLE = ROOT / "examples" / "python" / "sweep.py"


@pytest.fixture
def example():
    spec = importlib.util.spec_from_file_location("sweep_example", EXAMPLE)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_it_is_right_in_every_small_world():
    assert allworlds.check(f"{EXAMPLE}:sweep", edges=3, bound="none").verdict is Verdict.HOLDS


@pytest.mark.parametrize("edges", [3, long(4)])
def test_it_is_right_if_it_sweeps_wherever_it_can(example, monkeypatch, edges):
    class Eager(example.Sweep):
        credit = inf

    def eager(first):
        return (yield from Eager(first, lambda _: None).explore())

    for name, value in {"WORTH": 0, "STILL_WORTH": 0, "FEWEST": 1}.items():
        monkeypatch.setattr(example, name, value)
    report = allworlds.check(eager, edges=edges, bound="none")
    assert report.verdict is Verdict.HOLDS
    assert report.traversals > allworlds.check("prudent", edges=edges).traversals  # it did sweep


@pytest.mark.parametrize(("far", "cost"), [(1, 832), long(2, 7_799)])
def test_it_walks_against_the_adversary_what_the_page_says(far, cost):
    adversary = Adversary(CorridorShape(far, usual_degree(far)), 1)
    report = allworlds.run(f"{EXAMPLE}:sweep", adversary, bound="none")
    assert report.verdict is Verdict.HOLDS
    assert report.adversary.cost == cost
    page = (ROOT / "docs" / "explorers.md").read_text(encoding="utf-8")
    assert f"| {cost:,} |" in page.partition("## Words for many hypotheses")[2]
