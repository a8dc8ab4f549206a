"""Lanes in processes: every part once, whoever brings it, and nothing is left behind."""

import os
import signal
import subprocess
import sys
from collections import Counter

import pytest

from allworlds import check
from allworlds.engines import lane, lanes, tally, units
from allworlds.engines.limits import Limits, TimeIsUp
from allworlds.engines.listeners import Listener
from allworlds.engines.single import subject_of
from allworlds.engines.sweep import gather
from allworlds.judging.rules import Rules
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from processes import commands, end, workers_of

pytestmark = pytest.mark.processes

SCOPE = units.Scope(Extent(MapClass.MAPS, 3), Rules())


class Heard(Listener):
    worlds = 0

    def progress(self, count):
        self.worlds += count


def lanes_at_work():
    """The processes that were forked from this one; what else it has started has other words."""
    told = commands([os.getpid(), *workers_of(os.getpid())])
    own = told.pop(os.getpid())
    return {pid for pid, words in told.items() if words == own}


@pytest.mark.parametrize("workers", [2, 3])
def test_each_unit_is_done_once_and_the_processes_end(workers, monkeypatch):
    monkeypatch.setattr(lanes, "ALONE", 0.0)
    before = {*workers_of(os.getpid())}
    pieces = [*units.units_of_level(SCOPE.extent, 3, units.WHOLE)]
    total, whole, limits = tally.Tally(1), Counter(), Limits(workers=workers)
    with lanes.workers_for(subject_of("algorithm1", limits), limits) as transport:
        for part in transport.map(tally.RunCounter(SCOPE, 1), pieces):
            total.add(part.result)
            whole[part.unit.key] += part.last
            at_work = lanes_at_work() - before
    assert len(at_work) == workers
    assert whole == Counter(piece.key for piece in pieces)
    # 74 rooted maps with three edges (A000698).
    assert total.worlds == 74
    assert end(lambda: {*workers_of(os.getpid())} - before)
    for pid in at_work:
        with pytest.raises(ChildProcessError):
            os.waitpid(pid, os.WNOHANG)


def test_the_units_of_a_process_that_is_lost_are_done_again(monkeypatch):
    monkeypatch.setattr(lanes, "ALONE", 0.0)
    before = {*workers_of(os.getpid())}
    pieces = [*units.units_of_level(SCOPE.extent, 3, units.WHOLE)]
    lost, whole, limits = set(), Counter(), Limits(workers=2)
    with lanes.workers_for(subject_of("algorithm1", limits), limits) as transport:
        for part in transport.map(tally.RunCounter(SCOPE, 1), pieces):
            whole[part.unit.key] += part.last
            if not lost:
                lost = {*workers_of(os.getpid())} - before
                os.kill(max(lost), signal.SIGKILL)
    assert whole == Counter(piece.key for piece in pieces)


class LosesOne:
    """A transport of lanes that loses one, as soon as that has handed over a part of a unit."""

    def __init__(self, transport):
        self.transport, self.lost = transport, None

    def map(self, engine, pieces):
        for part in self.transport.map(engine, pieces):
            if not (self.lost or part.last) and part.result.worlds:
                self.lost = part.unit
                for process in self.transport._processes:
                    if part.unit in process.units:
                        os.kill(process.pid, signal.SIGKILL)
            yield part


def test_what_a_lost_process_has_handed_over_counts_once(monkeypatch):
    monkeypatch.setattr(lanes, "ALONE", 0.0)
    monkeypatch.setattr(tally, "REPORT_EVERY", -1.0)
    monkeypatch.setattr(lane, "LEAST", 1)
    monkeypatch.setattr(lane, "MOST", 1)
    pieces = [*units.units_of_level(SCOPE.extent, 3, units.WHOLE)]
    total, heard, limits = tally.Tally(1), Heard(), Limits(workers=2)
    with lanes.workers_for(subject_of("algorithm1", limits), limits) as transport:
        loses = LosesOne(transport)
        gather(loses, tally.RunCounter(SCOPE, 1), pieces, total, heard)
    assert loses.lost
    assert total.worlds == heard.worlds == 74


def test_a_process_that_ends_by_itself_has_the_time_to(monkeypatch):
    """The clock stands still: it is waited for until it has ended."""
    monkeypatch.setattr(lanes.time, "monotonic", lambda: 0.0)
    program = "import sys, time; sys.stdin.read(); time.sleep(0.1); sys.exit(7)"
    with subprocess.Popen([sys.executable, "-c", program], stdin=subprocess.PIPE) as child:
        process = object.__new__(lanes._Process)
        process.link, process.pid = child.stdin, child.pid
        assert "7" in process.end()


ENDLESS = """
from allworlds import Move

def walks(first):
    while True:
        yield Move(1)
"""


class HearsAWalk(Listener):
    def walk(self, turns, budget):
        self.heard = turns, budget
        raise TimeIsUp


@pytest.mark.parametrize("workers", [1, 2])
def test_a_run_that_goes_on_is_told_of_while_it_does(workers, tmp_path, monkeypatch):
    monkeypatch.setattr(lanes, "ALONE", 0.0)
    path, listener = tmp_path / "endless.py", HearsAWalk()
    path.write_text(ENDLESS)
    asked = {"step_budget": 10**9, "workers": workers, "time_limit": 600, "listener": listener}
    report = check(f"{path}:walks", edges=1, **asked)
    assert report.exit_code == 3
    turns, budget = listener.heard
    assert budget == 10**9
    assert 0 <= turns < budget


def test_a_job_that_is_soon_done_needs_no_process_besides(monkeypatch):
    monkeypatch.setattr(lanes, "ALONE", 1e9)
    before, limits = {*workers_of(os.getpid())}, Limits(workers=2)
    pieces = [*units.units_of_level(SCOPE.extent, 3, units.WHOLE)]
    with lanes.workers_for(subject_of("algorithm1", limits), limits) as transport:
        for _ in transport.map(tally.RunCounter(SCOPE, 1), pieces):
            assert len(lanes_at_work() - before) <= 1
