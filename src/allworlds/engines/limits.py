"""The limits of the time, the workers and the memory of a job; they do not change its meaning."""

import os
import re
import signal
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import fields
from math import inf
from typing import Annotated, Any

from allworlds import outcome
from allworlds.inputs.checks import (
    InputError,
    OutOfTime,
    an_integer,
    at_most,
    integer_of,
    seconds_of,
    show,
)
from allworlds.inputs.requests import EFFORT, RARE_EFFORT, Converted, Option, Request
from allworlds.protocol import importing
from allworlds.protocol.actions import ANSWER_TIMEOUT

POLL = 0.1
"""Seconds between two checks whether other threads or processes have sent a result.

This is also the shortest legal time-out of an answer.
"""

START_TIMEOUT = 60.0
"""The default number of seconds in which an explorer must be imported."""

MOST = {
    "workers": 10_000,
    "answer-timeout": 10**6,
    "start-timeout": 10**6,
    "time-limit": 10**9,
    "memory": 10**9,
    "max-findings": 10**9,
}
"""The largest legal value of each limit; operating systems refuse larger numbers."""


def worker_count(text: str) -> int:
    """The number of workers that a text names; for ``auto`` the number of usable cores.

    Raises:
        InputError: if the text is neither ``auto`` nor a positive number.
    """
    if text == "auto":
        return len(os.sched_getaffinity(0))
    if re.fullmatch(r"[0-9]{1,9}", text) and int(text) > 0:
        return int(text)
    raise InputError(f"workers {show(text)} is neither auto nor a positive number")


def positive(name: str) -> Callable[[Any], Any]:
    """Return a function that checks a value of the limit ``name``, and returns this value.

    The value must be positive, and at most the number in :data:`MOST`; for ``time-limit`` and
    ``memory`` it may be None.  For any other value the returned function raises InputError.
    """

    def limit(value: Any) -> Any:
        if value is None and name in ("time-limit", "memory"):
            return None
        if not isinstance(value, int | float) or isinstance(value, bool):
            raise InputError(f"{name} = {show(value)} is not a number")
        if name in ("workers", "memory", "max-findings"):
            an_integer(name, value)
        if not 0 < value < inf:
            raise InputError(f"{name} {show(value)} is not positive and finite")
        at_most(name, value, MOST[name])
        if name == "answer-timeout" and value < POLL:
            raise InputError(
                f"answer-timeout {value} s is shorter than silence is noticed; the least is "
                f"{POLL} s"
            )
        return value

    return limit


def _seconds(about: str, panel: str = RARE_EFFORT) -> Option:
    """An option for a number of seconds on which no result depends.

    ``about`` is the help text of the option, and ``panel`` names the section of the help in which
    the option is listed.  An interrupted job can go on with another value of the option.
    """
    return Option(panel, "S", about, parse=seconds_of, apart=True)


class TimeoutOptions(Request):
    """The part of a request with the time-outs of explorers."""

    answer_timeout: Annotated[
        Converted[float, float],
        Option(
            RARE_EFFORT, "S", "Seconds of silence that break the law 'timeout'.", parse=seconds_of
        ),
    ] = Converted(positive("answer-timeout"), ANSWER_TIMEOUT)
    start_timeout: Annotated[
        Converted[float, float],
        _seconds("Seconds in which an explorer must be imported, or a library loaded."),
    ] = Converted(positive("start-timeout"), START_TIMEOUT)

    @property
    def limits(self) -> "Limits":
        """The limits that this request has as fields; all other limits have their defaults."""
        shared = {each.name for each in fields(Limits)} & {each.name for each in fields(self)}
        return Limits(**{name: getattr(self, name) for name in shared})


class WorkerOptions(Request):
    """The part of a request that names the number of workers."""

    workers: Annotated[
        Converted[int, int],
        Option(
            RARE_EFFORT,
            "N|auto",
            "Processes, or threads.",
            parse=worker_count,
            default="auto",
            apart=True,
        ),
    ] = Converted(positive("workers"), 1)


class TimeLimitOptions(Request):
    """The part of a request that names the time limit."""

    time_limit: Annotated[
        Converted[float | None, float | None],
        _seconds("Stop after S seconds, and report what is finished.", EFFORT),
    ] = Converted(positive("time-limit"), None)


class Limits(TimeLimitOptions, WorkerOptions, TimeoutOptions):
    """The limits of time-outs, workers, time and memory for many runs.

    Raises:
        InputError: for a value that is not positive or not finite, or for too short a time-out.
    """

    memory: Annotated[
        Converted[int | None, int | None],
        Option(
            RARE_EFFORT,
            "MB",
            "Address space of each worker process; the kernel engine has none.",
            parse=integer_of,
        ),
    ] = Converted(positive("memory"), None)


LOCAL = "local"
"""The word that a user writes in place of the address of a Dask cluster.

It stands for a new cluster on this machine, which is made for one job.
"""


class TimeIsUp(OutOfTime):
    """Raised if the time limit of the whole job has been reached."""


class ClusterLost(outcome.NoResult):
    """Raised if too many workers of a Dask cluster are lost, or if its scheduler is lost."""


def deadline_after(time_limit: float | None) -> float | None:
    """The time on the monotonic clock at which this time limit ends; None without a limit.

    The limit, in seconds, begins now.
    """
    return None if time_limit is None else time.monotonic() + time_limit


def check_deadline(deadline: float | None) -> None:
    """Raise TimeIsUp once the deadline has passed.

    Raises:
        TimeIsUp: after the deadline.
    """
    if deadline is not None and time.monotonic() > deadline:
        raise TimeIsUp


@contextmanager
def models_bounded(deadline: float | None) -> Iterator[None]:
    """A context in which TimeIsUp is raised inside the user's models after the deadline.

    A model is a user's lighthouse, task or condition.  In any thread but the main thread, or if
    SIGALRM already has a handler, nothing interrupts models.
    """
    here = threading.current_thread() is threading.main_thread()
    if deadline is None or not here or signal.getsignal(signal.SIGALRM) != signal.SIG_DFL:
        yield
        return
    signal.signal(signal.SIGALRM, _end_models)
    try:
        left = min(deadline - time.monotonic(), MOST["time-limit"])
        signal.setitimer(signal.ITIMER_REAL, max(POLL, left), POLL)
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, signal.SIG_DFL)


def _end_models(*_: object) -> None:
    if importing.AT_WORK:
        raise TimeIsUp(f" in {importing.AT_WORK[-1]}")
