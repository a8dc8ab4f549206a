"""The part of ``mutants.py`` in the copy: which mutant is active, and how its tests end.

Each process of Python in the copy imports this module, and pytest has it as a plugin, too.  Every
place of a mutant asks ``mutated`` for its number.  (PYTEST_DONT_REWRITE)
"""

from __future__ import annotations

import builtins
import functools
import json
import os
import signal
import time
from contextlib import suppress
from typing import Any

ACTIVE = int(os.environ.get("MUTANT", "0"))
"""The number of the active mutant; 0: none."""

LATE = "the deadline"
"""What has killed a mutant whose tests do not end."""

TRYING = "MUTANTS_TO_TRY" in os.environ
"""Whether mutants are tried; else the tests that meet them are noted."""

_seen = set[int]()
_caches = list[Any]()


def _noted_cache(maxsize: Any = 128, typed: bool = False) -> Any:
    """Make a cache as ``functools.lru_cache`` does, and note the functions that have one."""

    def cached(function: Any) -> Any:
        made = _lru_cache(maxsize, typed)(function)
        if (function.__module__ or "").startswith("allworlds"):
            _caches.append(made)
        return made

    if callable(maxsize):  # the decorator stands without parentheses
        function, maxsize = maxsize, 128
        return cached(function)
    return cached


_lru_cache = functools.lru_cache
if not TRYING:
    functools.lru_cache = _noted_cache  # type: ignore[assignment]
    functools.cache = _noted_cache(maxsize=None)  # type: ignore[assignment]


def mutated(number: int) -> bool:
    """Whether a mutant is active; note the test that meets its place first."""
    if number not in _seen and not TRYING:
        _seen.add(number)
        note("met", number, os.environ.get("PYTEST_CURRENT_TEST", "").rpartition(" (")[0])
    return number == ACTIVE


builtins._mutated = mutated  # type: ignore[attr-defined]  # noqa: SLF001


def note(*words: object) -> None:
    """Append a line to the notes, if there are any."""
    if "MUTANTS_NOTES" in os.environ:
        with open(os.environ["MUTANTS_NOTES"], "a") as notes:  # noqa: PTH123  # no import at start
            notes.write(json.dumps(words) + "\n")


def pytest_runtest_logstart(nodeid: str) -> None:
    """Forget which places the test before has met, and what the package keeps in caches.

    So a test meets the places that compute what an earlier test has left in a cache.
    """
    del nodeid
    _seen.clear()
    if not TRYING:
        for each in _caches:
            each.cache_clear()


def pytest_runtest_setup(item: Any) -> None:
    """Note the fixtures that the test shares with others."""
    for definitions in item._fixtureinfo.name2fixturedefs.values():  # noqa: SLF001
        if definitions[-1].scope != "function" and not TRYING:
            note("uses", item.nodeid, _owner(definitions[-1]))


def pytest_fixture_setup(fixturedef: Any) -> None:
    """Whatever is met from here on is met for the fixture, and for each test that uses it."""
    if fixturedef.scope != "function":
        _seen.clear()
        os.environ["PYTEST_CURRENT_TEST"] = f"{_owner(fixturedef)} (setup)"


def _owner(fixture: Any) -> str:
    return f"fixture {fixture.argname} of {fixture.baseid}"


def pytest_runtest_logreport(report: Any) -> None:
    """Note how long the test took, and whether it failed."""
    if "PYTEST_XDIST_WORKER" not in os.environ and not TRYING:
        note("took", report.nodeid, report.duration, report.failed)


def pytest_runtestloop(session: Any) -> bool | None:
    """Try mutants, where there are any to try: each in a fork, with its tests."""
    if not TRYING:
        return None
    with open(os.environ["MUTANTS_TO_TRY"]) as file:  # noqa: PTH123
        to_try = json.load(file)
    items = {item.nodeid: item for item in session.items}
    for number, tests, seconds in to_try:
        tried = [items[each] for each in tests if each in items]
        killer = _killed(session, number, tried, seconds)
        if killer == LATE and _killed(session, 0, tried, seconds):
            killer = ""  # without it they do not end well, either
        note("ended", number, killer)
    return True


def _try(session: Any, number: int, items: list[Any]) -> None:
    """Run tests with a mutant until one fails; the exit code says whether one has."""
    import resource
    from itertools import zip_longest

    global ACTIVE  # noqa: PLW0603  # the one thing that a mutant changes
    code = 2
    try:
        os.setsid()
        resource.setrlimit(resource.RLIMIT_DATA, (6 << 30, 6 << 30))
        ACTIVE = number
        os.environ["MUTANT"] = str(number)
        session.items = items
        for item, following in zip_longest(items, items[1:]):
            item.config.hook.pytest_runtest_protocol(item=item, nextitem=following)
            if session.shouldfail or session.shouldstop:
                note("killed", number, item.nodeid)
                break
        code = int(bool(session.shouldfail))
    finally:
        os._exit(code)


def _killed(session: Any, number: int, items: list[Any], seconds: float) -> str:
    """Run tests with a mutant in a fork; return what has killed it; empty: nothing."""
    pid = os.fork()
    if pid == 0:
        _try(session, number, items)
    end = time.monotonic() + seconds
    ended, status = 0, 0
    while not ended and time.monotonic() < end:
        time.sleep(0.02)
        ended, status = os.waitpid(pid, os.WNOHANG)
    with suppress(ProcessLookupError):
        os.killpg(pid, signal.SIGKILL)
    if not ended:
        os.waitpid(pid, 0)
        return LATE
    code = os.waitstatus_to_exitcode(status)
    return {0: "", 1: "a test"}.get(code, f"exit code {code}")
