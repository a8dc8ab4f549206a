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
    """The running descendants of a process, but for its guardians, which end with it."""
    below = _below()
    guardians = guardians_of(pid, below)
    return [one for one in _descendants(below, [pid]) if one not in guardians]


def guarded_by(pid):
    """The running descendants of the guardians of a process, but for nurseries."""
    below = _below()
    guardians = guardians_of(pid, below)
    return [one for one in _descendants(below, guardians) if one not in guardians]


def guardians_of(pid, below=None):
    """The guardians of a process, and their nurseries, which live as long as they."""
    below = below or _below()
    guardians = {child for child in below.get(pid, []) if is_guardian(child)}
    started = {child for one in guardians for child in below.get(one, [])}
    return guardians | {child for child in started if _is_named(child, b"\0nursery\0")}


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


def is_guardian(pid):
    """Whether a child is a guardian; what it has forked has the same command."""
    return _is_named(pid, b"allworlds.engines.player")


def _is_named(pid, word):
    try:
        return word in Path(f"/proc/{pid}/cmdline").read_bytes()
    except OSError:
        return False


def named(word):
    """The processes with that word in their command line."""
    found = []
    for pid, _ in running():
        try:
            words = Path(f"/proc/{pid}/cmdline").read_bytes()
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
