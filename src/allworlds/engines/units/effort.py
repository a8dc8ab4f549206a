"""What bounds the effort, and not the meaning, of a job."""

from __future__ import annotations

import time
from dataclasses import dataclass, fields
from math import inf
from typing import Any, TypedDict, cast

from allworlds.inputs import InputError, an_integer, at_most, show
from allworlds.protocol import ANSWER_TIMEOUT

LEAST_TIMEOUT = 0.1
"""Seconds; explorers are not looked at more often."""

POLL = LEAST_TIMEOUT
"""Seconds between two looks at what goes on elsewhere."""

MOST = {"workers": 10_000, "answer-timeout": 10**6, "time-limit": 10**9, "memory": 10**9}
"""The largest legal value of each limit: an operating system does not count further."""


class EffortOptions(TypedDict, total=False):
    """Options of every verb that has explorers run in many worlds.

    Attributes:
        workers: processes, or threads (default 1).
        answer_timeout: seconds of silence after which an explorer is killed (default 10).
        time_limit: seconds for everything; None (default) for no limit.
        memory: MB of address space of a worker process; None (default) for no limit.
    """

    workers: int
    answer_timeout: float
    time_limit: float | None
    memory: int | None


@dataclass(frozen=True, slots=True)
class Limits:
    """The values of :class:`EffortOptions`.

    Raises:
        InputError: for values that are not positive, for infinite ones, and for a timeout that
            is too short to be kept.
    """

    workers: int = 1
    answer_timeout: float = ANSWER_TIMEOUT
    time_limit: float | None = None
    memory: int | None = None

    @classmethod
    def of(cls, options: EffortOptions) -> Limits:
        """The limits of a verb's options."""
        given = cast("dict[str, Any]", options)
        return cls(**{f.name: given[f.name] for f in fields(cls) if f.name in given})

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

    def deadline(self) -> float | None:
        """When the time is up, on the monotonic clock, if the job begins now."""
        return None if self.time_limit is None else time.monotonic() + self.time_limit


class TimeIsUp(Exception):
    """The time limit of the whole job has been reached."""


def check_deadline(deadline: float | None) -> None:
    """Nothing before the deadline.

    Raises:
        TimeIsUp: after it.
    """
    if deadline is not None and time.monotonic() > deadline:
        raise TimeIsUp
