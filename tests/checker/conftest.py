import os
import sys
import time
from pathlib import Path

import pytest

EXPLORERS = Path(__file__).parents[1] / "explorers_for_tests"


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


def alive(pid):
    try:
        state = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
    except OSError:
        return False
    return state != "Z"


def descendants():
    """The processes that come from this one and still run, but for the guardians, which stay."""
    below = {}
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                after = (entry / "stat").read_text().rpartition(")")[2].split()
            except OSError:
                continue
            if after[0] != "Z":
                below.setdefault(int(after[1]), []).append(int(entry.name))
    found = []
    for pid in (waiting := [os.getpid()]):
        waiting += below.get(pid, [])
        found += below.get(pid, [])
    return {pid for pid in found if not is_guardian(pid)}


def is_guardian(pid):
    """A guardian, and not what it has forked, which has the same command."""
    try:
        command = Path(f"/proc/{pid}/cmdline").read_bytes()
        parent = int(Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[1])
    except OSError:
        return True
    return b"isolation.roles" in command and parent == os.getpid()


@pytest.fixture
def no_orphans():
    """Nothing that a check has started outlives it."""
    before = descendants()
    yield
    deadline = time.monotonic() + 30
    while descendants() - before and time.monotonic() < deadline:
        time.sleep(0.05)
    assert not descendants() - before


@pytest.fixture
def gone():
    """Whether every process of a file of pids has ended."""

    def all_gone(file):
        pids = file.read_text().split()
        assert pids
        deadline = time.monotonic() + 5
        while any(map(alive, pids)) and time.monotonic() < deadline:
            time.sleep(0.05)
        return not any(map(alive, pids))

    return all_gone
