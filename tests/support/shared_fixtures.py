import os
import sys
import time
from collections import Counter
from pathlib import Path

import pytest

import processes
from allworlds.engines.players import GRACE
from kept_jobs import reporting
from processes import PATIENCE

EXPLORERS = Path(__file__).parent / "explorers_for_tests"


@pytest.fixture
def wrong():
    """The name of an explorer of wrong.py."""
    return lambda name: f"{EXPLORERS / 'wrong.py'}:{name}"


@pytest.fixture
def folding():
    return f"{EXPLORERS / 'folding.py'}:explore"


@pytest.fixture
def program():
    """The name of the program of that kind."""
    return lambda kind, *more: " ".join(
        ["exec:" + sys.executable, str(EXPLORERS / "program.py"), kind, *map(str, more)]
    )


@pytest.fixture
def explorers(monkeypatch):
    """Explorers of wrong.py as functions that no other process can find."""
    monkeypatch.syspath_prepend(str(EXPLORERS))
    import wrong

    def closure(name):
        explore = getattr(wrong, name)

        def inner(first):
            return (yield from explore(first))

        return inner

    return closure


@pytest.fixture
def no_orphans():
    """Require that the processes that a check has started end with it."""
    before = {*processes.workers_of(os.getpid())}
    yield

    def left():  # a browser that another test has left open starts processes at any time
        others = {child for pid in before for child in processes.workers_of(pid)}
        return {*processes.workers_of(os.getpid())} - before - others

    assert processes.end(left), processes.commands(left())


@pytest.fixture
def gone():
    """Whether every process with that word in its command line has ended, or soon will have."""
    return lambda word: processes.end(lambda: processes.named(word))


class Clock:
    """A slow clock that leaps where a process has said that it hangs.

    So an explorer is given longer than any machine takes, and one that hangs is noticed at once.
    A leap is a little more than it is given, and less than what is allowed where something is
    still to be heard.  It comes when the clock has been read some times since the process has
    said so, because then its heart has been seen to beat for the last time; and once more for a
    process that goes on and on telling of itself.
    """

    LEAP = PATIENCE + GRACE / 2
    SLOW = 10

    def __init__(self, hung):
        self.hung, self.read = hung, Counter()

    def monotonic(self):
        hung = self.hung.read_text().splitlines() if self.hung.exists() else []
        self.read.update(pid for pid in hung if Path("/proc", pid).exists())
        leaps = sum((times > 3) + (times > 500) for times in self.read.values())
        return time.monotonic() / self.SLOW + leaps * self.LEAP

    def sleep(self, seconds):
        time.sleep(seconds)


@pytest.fixture
def clock(monkeypatch, tmp_path):
    """The clock that limits are told by; explorers of wrong.py say when they hang."""
    hung = tmp_path / "hung"
    monkeypatch.setenv("HUNG", str(hung))
    clock = Clock(hung)
    for module in (
        "engines.players",
        "engines.limits",
        "studies.check.tally_sweep",
    ):
        monkeypatch.setattr(f"allworlds.{module}.time", clock)
    return clock


@pytest.fixture
def report(cli):
    return reporting(cli)
