"""The processes of this machine, as a test has to look at them."""

import time
from contextlib import suppress
from pathlib import Path

PATIENCE = 300.0
"""Seconds that only a hang takes, on any machine and under any load."""

SOON = 4.0
"""Seconds after which whoever is silent for ever is given up; if a slow machine makes others silent
for as long, the smallest finding is the same."""


def running():
    """(pid, parent) of each process that has not ended."""
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                state, parent, *_ = (entry / "stat").read_text().rpartition(")")[2].split()
            except OSError:
                continue
            if state != "Z":
                yield int(entry.name), int(parent)


def children_of(pid):
    """The processes that a process has started and that still run."""
    return [child for child, parent in running() if parent == pid]


def workers_of(pid):
    """The running descendants of a process."""
    return _descendants(_below(), [pid])


def _below():
    below = {}
    for child, parent in running():
        below.setdefault(parent, []).append(child)
    return below


def _descendants(below, ancestors):
    found = [child for one in ancestors for child in below.get(one, [])]
    for one in found:
        found += below.get(one, [])
    return found


def commands(pids):
    """The command line of each of these processes that still runs."""
    told = {}
    for pid in pids:
        with suppress(OSError):
            told[pid] = Path(f"/proc/{pid}/cmdline").read_bytes().replace(b"\0", b" ").decode()
    return told


def named(word, part="cmdline"):
    """The processes with that word in their command line, or in another part of what is told."""
    found = []
    for pid, _ in running():
        try:
            words = Path(f"/proc/{pid}/{part}").read_bytes()
        except OSError:
            continue
        if str(word).encode() in words:
            found.append(pid)
    return found


def wait(until):
    """Wait until ``until()`` is true, or patience ends; return its last answer."""
    deadline = time.monotonic() + PATIENCE
    while not (told := until()) and time.monotonic() < deadline:
        time.sleep(0.02)
    return told


def end(which):
    """Whether there comes a time when ``which()`` names no process any more."""
    return wait(lambda: not which())
