"""Units on a Dask cluster: the report is the same, whatever becomes of its workers."""

import json
import os
import signal
import time

import pytest

import processes
from allworlds import check, count, worst
from allworlds.engines.listeners import Listener
from clusters import cluster_apart
from engines import test_dask as quick
from engines.test_dask import WRONG, distributed
from small import slowest

here = quick.here

pytestmark = [
    pytest.mark.processes,
    pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning"),
]


class Interrupts(Listener):
    def progress(self, worlds):
        raise KeyboardInterrupt


@pytest.mark.slowest
def test_an_interrupt_cancels_what_is_done_elsewhere(here, tmp_path):
    report = check(edges=5, engine="kernel", dask=here, listener=Interrupts(), run=tmp_path)
    assert report.exit_code == 130
    with distributed.Client(here) as client:
        assert processes.end(lambda: [v for v in client.processing().values() if v])
    assert check(edges=5, run=tmp_path).to_json() == check(edges=5).to_json()


class After(Listener):
    """A listener that does something when so many worlds are done, once."""

    def __init__(self, worlds, then):
        self.left, self.then, self.notices = worlds, [then], []

    def progress(self, worlds):
        self.left -= worlds
        if self.left < 0 and self.then:
            self.then.pop()()

    def notice(self, text):
        self.notices.append(text)


@pytest.fixture
def apart(tmp_path):
    """A cluster of processes; it is gone, whatever was done to it."""
    with cluster_apart(distributed, tmp_path) as cluster:
        yield cluster


@pytest.mark.slowest
@pytest.mark.parametrize("name", ["python", slowest("kernel"), slowest("foreign")])
def test_a_worker_that_is_killed_changes_nothing(name, apart, tmp_path):
    job, after = {
        "python": (lambda **more: check(edges=4, engine="python", **more), 300),
        "kernel": (lambda **more: check(edges=7, engine="kernel", **more), 50_000),
        "foreign": (lambda **more: check(f"{WRONG}:right", edges=3, **more), 40),
    }[name]
    whole = job().to_json()
    killer = After(after, apart.workers[0].kill)
    report = job(dask=apart.address, listener=killer, run=tmp_path / "run")
    assert not killer.then, "nobody was killed"
    assert apart.workers[1].poll() is None
    assert report.to_json() == whole


SILENCE = 10.0
"""Seconds that no heartbeat takes, under any load."""


@pytest.mark.slowest
@pytest.mark.parametrize("verb", ["check", slowest("worst"), slowest("count")])
def test_a_worker_that_is_stopped_is_given_up(verb, apart, monkeypatch):
    monkeypatch.setattr("allworlds.engines.dask.SILENCE", SILENCE)
    job, after = {
        "check": (lambda **more: check(edges=4, engine="python", **more), 300),
        "worst": (lambda **more: worst(edges=4, **more), 30),
        "count": (lambda **more: count(edges=5, **more), 300),
    }[verb]
    stopper = After(after, lambda: apart.workers[0].send_signal(signal.SIGSTOP))
    report = job(dask=apart.address, listener=stopper)
    assert not stopper.then, "nobody was stopped"
    assert report.to_json() == job().to_json()


GOES_AWAY = {
    "scheduler killed": (lambda apart: [apart.scheduler], signal.SIGKILL, "is gone"),
    "scheduler stopped": (lambda apart: [apart.scheduler], signal.SIGSTOP, "no sign of life for"),
    "workers stopped": (lambda apart: apart.workers, signal.SIGSTOP, "no worker of the Dask"),
    "all killed": (lambda apart: apart.all, signal.SIGKILL, "is gone"),
}


@pytest.mark.slowest
@pytest.mark.parametrize(
    "what", [name if name == "scheduler killed" else slowest(name) for name in GOES_AWAY]
)
def test_a_cluster_that_goes_away_leaves_what_was_finished(
    what, apart, tmp_path, capfd, monkeypatch
):
    monkeypatch.setattr("allworlds.engines.dask.SILENCE", SILENCE)
    which, number, told = GOES_AWAY[what]
    asked = {"edges": 4, "engine": "python", "run": tmp_path / "run"}

    def go():
        for process in which(apart):
            process.send_signal(number)

    listener = After(300, go)
    report = check(**asked, dask=apart.address, listener=listener)
    assert (report.exit_code, report.levels[:3]) == (3, (1, 2, 3))
    (notice,) = listener.notices
    assert told in notice
    assert notice.partition(";")[0] in json.dumps(report.to_json())
    assert capfd.readouterr() == ("", "")
    assert check(**asked).to_json() == check(edges=4, engine="python").to_json()


@pytest.mark.slowest
def test_an_interrupt_waits_for_no_cluster(apart):
    def interrupt():
        for process in apart.all:
            process.send_signal(signal.SIGSTOP)
        began.append(time.monotonic())
        raise KeyboardInterrupt

    began = []
    report = check(edges=4, engine="python", dask=apart.address, listener=After(300, interrupt))
    assert report.exit_code == 130
    assert time.monotonic() - began[0] < 5


@pytest.mark.slowest
@pytest.mark.parametrize("stopped", [False, True], ids=["lively", "stopped"])
def test_a_cluster_of_this_machine_leaves_nothing_behind(stopped, tmp_path, monkeypatch):
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    monkeypatch.chdir(tmp_path)

    def mine():
        return [*processes.named(tmp_path, "environ")]

    def interrupt():
        assert mine()
        for pid in mine() if stopped else ():
            os.kill(pid, signal.SIGSTOP)
        raise KeyboardInterrupt

    report = check(edges=4, engine="python", dask="local", listener=After(300, interrupt))
    assert report.exit_code == 130
    assert processes.end(mine)
    assert [*tmp_path.iterdir()] == []


@pytest.mark.slowest
def test_a_cluster_of_this_machine_that_is_killed_is_told_of_in_one_line(capfd):
    def kill():
        (cluster_,) = {*processes.named("engines.dask")} & {*processes.children_of(os.getpid())}
        os.kill(cluster_, signal.SIGKILL)

    killer = After(300, kill)
    report = check(edges=4, engine="python", dask="local", listener=killer)
    assert not killer.then, "nobody was killed"
    assert report.exit_code == 3
    (notice,) = killer.notices
    assert "is gone" in notice
    assert processes.end(lambda: processes.named("engines.dask"))
    assert capfd.readouterr() == ("", "")
