"""What bounds the effort, and not the meaning, of a job."""

from __future__ import annotations

import os
import re
import time
from math import inf
from pathlib import Path
from typing import Annotated

from allworlds.engines.progress import Listener, Silent
from allworlds.inputs import (
    EFFORT,
    InputError,
    Option,
    Request,
    Taken,
    an_integer,
    at_most,
    integer_of,
    seconds_of,
    show,
    values_of,
)
from allworlds.protocol import ANSWER_TIMEOUT

LEAST_TIMEOUT = 0.1
"""Seconds; explorers are not looked at more often."""

POLL = LEAST_TIMEOUT
"""Seconds between two looks at what goes on elsewhere."""

MOST = {"workers": 10_000, "answer-timeout": 10**6, "time-limit": 10**9, "memory": 10**9}
"""The largest legal value of each limit: an operating system does not count further."""


def worker_count(text: str) -> int:
    """A number of processes, or one a usable core for ``auto``."""
    if text == "auto":
        return len(os.sched_getaffinity(0))
    if re.fullmatch(r"[0-9]{1,9}", text) and int(text) > 0:
        return int(text)
    raise InputError(f"workers {show(text)} is neither auto nor a positive number")


class AskedPatience(Request):
    """How long explorers are waited for."""

    answer_timeout: Annotated[
        float,
        Option(EFFORT, "S", "Seconds of silence that break the law 'timeout'.", parse=seconds_of),
    ] = ANSWER_TIMEOUT


class AskedWorkers(Request):
    """How many there are."""

    workers: Annotated[
        int,
        Option(
            EFFORT,
            "N|auto",
            "Processes, or threads.",
            parse=worker_count,
            default="auto",
            apart=True,
        ),
    ] = 1


class Limits(AskedWorkers, AskedPatience):
    """What bounds the effort of many runs.

    Raises:
        InputError: for values that are not positive, for infinite ones, and for a timeout that
            is too short to be kept.
    """

    time_limit: Annotated[
        float | None,
        Option(EFFORT, "S", "Seconds for everything.", parse=seconds_of, apart=True),
    ] = None
    memory: Annotated[
        int | None,
        Option(
            EFFORT,
            "MB",
            "Address space of each worker process; the kernel engine has none.",
            parse=integer_of,
        ),
    ] = None

    def __post_init__(self) -> None:
        for name in ("workers", "answer_timeout", "time_limit", "memory"):
            value, legal = getattr(self, name), name.replace("_", "-")
            if value is None and name in ("time_limit", "memory"):
                continue
            if not isinstance(value, int | float) or isinstance(value, bool):
                raise InputError(f"{legal} = {show(value)} is not a number")
            if name in ("workers", "memory"):
                an_integer(legal, value)
            if not 0 < value < inf:
                raise InputError(f"{legal} {show(value)} is not positive and finite")
            at_most(legal, value, MOST[legal])
        if self.answer_timeout < LEAST_TIMEOUT:
            raise InputError(
                f"answer-timeout {self.answer_timeout} s is shorter than silence is noticed; the "
                f"least is {LEAST_TIMEOUT} s"
            )

    @property
    def limits(self) -> Limits:
        """These alone, of a request that says more."""
        return Limits(**values_of(Limits, self))

    def deadline(self) -> float | None:
        """When the time is up, on the monotonic clock, if the job begins now."""
        return None if self.time_limit is None else time.monotonic() + self.time_limit


class AskedListener(Request):
    """Who is told."""

    listener: Annotated[
        Taken[Listener | None, Listener], "is told of the progress; by default nobody"
    ] = Taken(lambda listener: listener or Silent(), None)


class AskedDirectory(Request):
    """Where finished units are kept."""

    run: Annotated[
        str | Path | None,
        Option(
            EFFORT,
            "DIR",
            "A directory that keeps what is finished: the same command goes on from there, and "
            "'merge' joins shards.",
            apart=True,
        ),
    ] = None


class AskedCluster(Request):
    """On which machines the work is done."""

    dask: Annotated[
        str | None,
        Option(
            EFFORT,
            "ADDRESS|local",
            "Do the work on the workers of this Dask scheduler (extra: distributed).",
            apart=True,
        ),
    ] = None


class TimeIsUp(Exception):
    """The time limit of the whole job has been reached."""


def check_deadline(deadline: float | None) -> None:
    """Nothing before the deadline.

    Raises:
        TimeIsUp: after it.
    """
    if deadline is not None and time.monotonic() > deadline:
        raise TimeIsUp
