"""Finished units are kept: a job that was ended goes on, and reports as if it had not been."""

import json
import os
import random
import signal
import sqlite3
import subprocess
import sys
from contextlib import closing, suppress

import pytest

import processes
from allworlds import check
from allworlds.engines.listeners import Listener
from engines.test_resuming import VERBS, wrong
from kept_jobs import EXPLORERS, stable
from small import slowest

pytestmark = pytest.mark.usefixtures("compiled")


def started(command, directory):
    return subprocess.Popen(
        [sys.executable, "-m", "allworlds", *command.split(), "--run", str(directory), "--json"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )


def count(directory):
    try:
        return len(units_in(directory))
    except sqlite3.Error:
        return 0


def wait_for_units(process, directory, goal):
    assert processes.end(lambda: process.poll() is None and count(directory) < goal)


def killed_often(command, directory, times, seed):
    """How often the command could be killed, each time after some more units."""
    draw, kills = random.Random(seed), 0
    for _ in range(times):
        process = started(command, directory)
        wait_for_units(process, directory, count(directory) + draw.randrange(3))
        with suppress(subprocess.TimeoutExpired):
            process.wait(draw.random() / 10)
        if process.poll() is None:
            os.kill(process.pid, signal.SIGKILL)
            kills += 1
        process.communicate()
    return kills


LONGER = {
    "foreign": f"check {EXPLORERS}/wrong.py:right --edges 6 --class simple --workers 2",
    "compiled": "check --edges 7 --engine kernel",
    "worst": "worst --edges 5",
    "census": "ambiguity census --edges 4",
}


@pytest.mark.slowest
@pytest.mark.parametrize("name", [name if name == "census" else slowest(name) for name in LONGER])
def test_a_job_that_is_killed_at_random_moments_says_the_same(name, tmp_path):
    command, times = LONGER[name], 20 if name == "foreign" else 4
    whole = subprocess.run(
        [sys.executable, "-m", "allworlds", *command.split(), "--json"],
        check=True,
        capture_output=True,
    )
    kills = killed_often(command, tmp_path / "run", times, seed=13)
    assert kills >= times // 4  # those before the first unit at least
    last = started(command, tmp_path / "run")
    out, err = last.communicate()
    assert last.returncode == 0, err
    assert stable(out) == stable(whole.stdout)
    # Byte for byte: but for the one key the texts are the same, too.
    cut = [json.dumps(stable(text), indent=2) for text in (out, whole.stdout)]
    assert cut[0] == cut[1]


class Ended(BaseException):
    """The process is ended here, and has no time to do anything about it."""


class Ends(Listener):
    """Ends the process when so many worlds are done."""

    def __init__(self, worlds):
        self.left = worlds

    def progress(self, worlds):
        self.left -= worlds
        if self.left < 0:
            raise Ended


def units_in(directory):
    # To look must make no file: a command that is killed before it has made its own would find it.
    address = f"{(directory / 'units.sqlite').absolute().as_uri()}?mode=ro"
    with closing(sqlite3.connect(address, uri=True)) as connection:
        return {key for (key,) in connection.execute("SELECT key FROM units")}


@pytest.mark.slowest
@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize("name", ["compiled", "refuted", "worst", "census", "own", "foreign"])
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


class NoticeOnce(Listener):
    """Does something when the first worlds are done, and hears notices."""

    def __init__(self, something):
        self.left, self.notices = [something], []

    def progress(self, worlds):
        if self.left:
            self.left.pop()()

    def notice(self, text):
        self.notices += [text] if "run directory" in text else []


@pytest.mark.slowest
@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize("name", ["refuted", "worst", *("own", "compiled", "foreign", "census")])
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


@pytest.mark.slowest
@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize("name", ["here_of_another", "sys_exit", "raises", "everywhere"])
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
