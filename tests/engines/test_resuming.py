"""Finished units are kept: a job that was ended goes on, and reports as if it had not been."""

import json
import sqlite3
from contextlib import closing
from importlib import import_module

import pytest

from allworlds import ambiguity, check, worst
from allworlds.engines.judge import PythonJudge
from allworlds.engines.progress import Silent
from allworlds.studies.worst.compiled_engine import ScheduleSearch
from kept_jobs import EXPLORERS

pytestmark = pytest.mark.usefixtures("compiled")

CENSUS = "allworlds.studies.ambiguity.marked_worlds"


class Ended(BaseException):
    """The process is ended here, and has no time to do anything about it."""


class Ends(Silent):
    """Ends the process when so many worlds are done."""

    def __init__(self, worlds):
        self.left = worlds

    def progress(self, worlds):
        self.left -= worlds
        if self.left < 0:
            raise Ended


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


def units_in(directory):
    # To look must make no file: a command that is killed before it has made its own would find it.
    address = f"{(directory / 'units.sqlite').absolute().as_uri()}?mode=ro"
    with closing(sqlite3.connect(address, uri=True)) as connection:
        return {key for (key,) in connection.execute("SELECT key FROM units")}


@pytest.mark.no_cover
@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize("name", ["compiled", "refuted", "worst", "census"])
def test_a_job_that_was_ended_goes_on_and_says_the_same(name, tmp_path):
    job = VERBS[name]
    whole = json.dumps(job().to_json())
    before = set()
    for worlds in (0, 10, 30):
        with pytest.raises(Ended):
            job(run=tmp_path / "run", listener=Ends(worlds))
        assert before <= units_in(tmp_path / "run")
        before = units_in(tmp_path / "run")
    assert before
    # Byte for byte, and so in the same order.
    assert json.dumps(job(run=tmp_path / "run").to_json()) == whole
    assert before < units_in(tmp_path / "run")


class NoticeOnce(Silent):
    """Does something when the first worlds are done, and hears notices."""

    def __init__(self, something):
        self.left, self.notices = [something], []

    def progress(self, worlds):
        if self.left:
            self.left.pop()()

    def notice(self, text):
        self.notices += [text] if "run directory" in text else []


@pytest.mark.no_cover
@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize("name", ["refuted", "worst"])
def test_a_lock_that_is_removed_by_hand_harms_nobody(name, tmp_path):
    job, run = VERBS[name], tmp_path / "run"
    whole = job().to_json()

    def remove():
        (run / "lock").unlink()
        # Now another command takes the directory for its own, and keeps the same units.
        assert job(run=run).to_json() == whole

    listener = NoticeOnce(remove)
    assert job(run=run, listener=listener).to_json() == whole
    assert listener.notices == []
    assert job(run=run).to_json() == whole


@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize("what", ["the directory", "its database", "another in its place"])
def test_a_command_says_that_its_directory_was_removed(what, tmp_path):
    job, run = VERBS["own"], tmp_path / "run"
    whole = job().to_json()

    def remove():
        if what == "its database":
            (run / "units.sqlite").unlink()
            return
        run.rename(tmp_path / "removed")
        if what == "another in its place":
            assert job(run=run).to_json() == whole

    listener = NoticeOnce(remove)
    assert job(run=run, listener=listener).to_json() == whole
    (notice,) = listener.notices
    assert "was removed; the job goes on without it, and keeps nothing" in notice


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


@pytest.mark.no_cover
@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize("name", ["here_of_another", "sys_exit"])
def test_a_finding_that_was_kept_is_the_same_finding(name, tmp_path):
    job = lambda **more: check(wrong(name), edges=3, max_findings=4, **more)  # noqa: E731
    whole = job()
    assert whole.findings
    first = job(run=tmp_path / "run")
    again = job(run=tmp_path / "run")
    assert first.to_json() == again.to_json() == whole.to_json()
    assert [(f.place, f.machine, f.key) for f in again.findings] == [
        (f.place, f.machine, f.key) for f in whole.findings
    ]
    assert [f.rules for f in again.findings] == [f.rules for f in whole.findings]


@pytest.mark.usefixtures("without_workers")
def test_a_finding_is_confirmed_once(tmp_path, monkeypatch):
    job = lambda: check(wrong("everywhere"), edges=2, run=tmp_path / "run")  # noqa: E731
    whole = job().to_json()
    assert whole["findings"][0]["confirmed"]
    monkeypatch.setattr("allworlds.studies.check.tally_sweep.played_again", lambda *_: 1 / 0)
    assert job().to_json() == whole


@pytest.mark.no_cover
@pytest.mark.usefixtures("without_workers")
def test_a_time_limit_is_no_part_of_the_job(tmp_path):
    job = lambda **more: check(edges=3, engine="python", **more)  # noqa: E731
    stopped = job(run=tmp_path / "run", time_limit=1e-9)
    assert stopped.exit_code == 3
    assert job(run=tmp_path / "run", workers=2).to_json() == job().to_json()
