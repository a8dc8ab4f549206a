"""Finished units are kept: a job that was ended goes on, and reports as if it had not been."""

from importlib import import_module

import pytest

from allworlds import ambiguity, check, worst
from allworlds.engines.judge import PythonJudge
from allworlds.studies.worst.compiled_engine import ScheduleSearch
from kept_jobs import EXPLORERS

pytestmark = pytest.mark.usefixtures("compiled")

CENSUS = "allworlds.studies.ambiguity.census_sweep"


def wrong(name):
    return f"{EXPLORERS / 'wrong.py'}:{name}"


VERBS = {
    "own": lambda **more: check(edges=3, engine="python", **more),
    "compiled": lambda **more: check(edges=5, engine="kernel", **more),
    "foreign": lambda **more: check(wrong("right"), edges=3, **more),
    "refuted": lambda **more: check(wrong("here_of_another"), edges=3, max_findings=3, **more),
    "worst": lambda **more: worst(edges=4, **more),
    "census": lambda **more: ambiguity.census(edges=4, **more),
}


@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize("name", ["own", "worst", "census"])
def test_what_is_finished_is_not_done_again(name, tmp_path, monkeypatch):
    job = VERBS[name]
    whole = job(run=tmp_path / "run").to_json()

    def nobody(*_):
        raise AssertionError("a unit was done again")

    monkeypatch.setattr(PythonJudge, "batches", nobody)
    for engine in (ScheduleSearch, import_module(CENSUS).PartBySensing):
        monkeypatch.setattr(engine, "parts", nobody)
    assert job(run=tmp_path / "run").to_json() == whole
    with pytest.raises(AssertionError):
        job(run=tmp_path / "another")


@pytest.mark.usefixtures("without_workers")
def test_a_finding_is_confirmed_once(tmp_path, monkeypatch):
    job = lambda: check(wrong("everywhere"), edges=2, run=tmp_path / "run")  # noqa: E731
    whole = job().to_json()
    assert whole["findings"][0]["confirmed"]
    monkeypatch.setattr("allworlds.engines.single.played_again", lambda *_: 1 / 0)
    assert job().to_json() == whole


@pytest.mark.usefixtures("without_workers")
def test_a_time_limit_is_no_part_of_the_job(tmp_path):
    job = lambda **more: check(edges=3, engine="python", **more)  # noqa: E731
    stopped = job(run=tmp_path / "run", time_limit=1e-9)
    assert stopped.exit_code == 3
    assert job(run=tmp_path / "run", workers=2).to_json() == job().to_json()
