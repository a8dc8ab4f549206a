"""Explorers that go by hashes: told from others, and judged so that a report is always the same."""

import json

import pytest

from allworlds.engines.batch import SECOND
from allworlds.engines.hash_seeds import GOES_BY_HASHES
from allworlds.engines.listeners import Listener
from allworlds.studies.check.exhaustive import check
from allworlds.studies.fuzz.sample_sweep import fuzz
from allworlds.studies.run import replay

pytestmark = pytest.mark.processes


WALKS_BY_HASHES = """
from allworlds import Move
from allworlds.explorers.builtin.algorithm1 import algorithm1

def explore(first):
    for digit in f"{hash('a word') % 64:b}":
        for step in (int(digit), 0, -int(digit), 0):
            yield Move(step)
    return (yield from algorithm1(first))
"""


WRONG_WITH_ONE = """
from allworlds.explorers.builtin.algorithm1 import algorithm1

def explore(first):
    estimate = yield from algorithm1(first)
    wrong = next(iter({"ab", "cd", "ef"})) != "ab" and len(estimate.map.sigma) > 4
    return 7 if wrong else estimate
"""
"""Right with seed 0, and wrong with seed 1."""


CHECKS = {
    "walks": (WALKS_BY_HASHES, {"laws": ("map", "pose"), "edges": 3}),
    "wrong": (WRONG_WITH_ONE, {"edges": 4}),
}


class Ends(Listener):
    """Interrupts the job when it has done so many worlds."""

    def __init__(self, worlds):
        self.left = worlds

    def progress(self, worlds):
        self.left -= worlds
        if self.left < 0:
            raise KeyboardInterrupt


@pytest.mark.slowest
@pytest.mark.parametrize("name", CHECKS)
def test_a_check_of_an_explorer_that_goes_by_hashes_is_the_same_whenever_that_is_noticed(
    name, tmp_path, monkeypatch
):
    text, options = CHECKS[name]
    tmp_path.joinpath("by_hashes.py").write_text(text)
    monkeypatch.chdir(tmp_path)
    reports = [check("by_hashes.py:explore", workers=workers, **options) for workers in (1, 2, 1)]
    whole = json.dumps(reports[0].to_json())
    assert [json.dumps(report.to_json()) for report in reports[1:]] == [whole] * 2
    assert reports[0].remarks == (GOES_BY_HASHES,)
    if name == "wrong":
        (found,) = reports[0].findings
        assert (found.law, found.minimal, found.confirmed) == ("no-estimate", True, True)
        assert found.world.map.edge_count == 3
        assert replay(found).outcome == "reproduced"
    else:
        assert reports[0].exit_code == 0
    for worlds in (0, 40):
        ended = check(
            "by_hashes.py:explore", workers=1, run="run", listener=Ends(worlds), **options
        )
        assert ended.exit_code in (130, reports[0].exit_code)
    again = check("by_hashes.py:explore", workers=2, run="run", **options)
    assert json.dumps(again.to_json()) == whole


@pytest.mark.slowest
def test_a_sample_of_an_explorer_that_goes_by_hashes_is_shrunk_with_either_seed(tmp_path):
    module = tmp_path / "by_hashes.py"
    module.write_text(WRONG_WITH_ONE)
    options = {"edges": 5, "runs": 20, "seed": 1, "workers": 1}
    first, second = (fuzz(f"{module}:explore", **options) for _ in range(2))
    assert first.to_json() == second.to_json()
    (found,) = first.findings
    assert found.world.map.edge_count == 3
    assert found.hash_seed == SECOND


EVERY_OTHER_TIME = """
from pathlib import Path
from allworlds.explorers.builtin.algorithm1 import algorithm1

def explore(first):
    estimate = yield from algorithm1(first)
    with Path(__file__).with_suffix(".calls").open("a") as calls:
        calls.write(".")
        return 7 if calls.tell() % 2 else estimate
"""


@pytest.mark.slowest
def test_the_finding_of_a_play_that_another_does_not_repeat_has_both(tmp_path):
    module = tmp_path / "chance.py"
    module.write_text(EVERY_OTHER_TIME)
    laws = set()
    for _ in range(3):
        report = check(f"{module}:explore", edges=1)
        (found,) = report.findings
        laws.add(found.law)
        assert (found.confirmed, found.hash_seed) == (True, None)
        assert report.remarks == ()
        assert "first play, from step" in found.detail
        assert "second play, from step" in found.detail
    assert laws == {"nondeterministic"}
