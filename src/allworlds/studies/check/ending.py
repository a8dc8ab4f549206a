"""How a job comes to its end: by itself, by a limit, by an explorer or by the user."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeAlias

from allworlds.engines import Limits, TimeIsUp, Unsettled


@dataclass(frozen=True, slots=True)
class Completed:
    """Everything was done that was to be done.

    Attributes:
        missing: witnesses that a complete check must have seen and has not.
    """

    missing: tuple[str, ...] = ()
    reason = ""


@dataclass(frozen=True, slots=True)
class Stopped:
    """Something is left undone.

    Attributes:
        reason: why.
        enough: nothing more is to be done all the same.
    """

    reason: str
    enough: bool = False


@dataclass(frozen=True, slots=True)
class Interrupted:
    """By the user."""

    reason = "interrupted"


@dataclass(frozen=True, slots=True)
class Disagreed:
    """Two roads to one number lead to different ones, so nothing is to be believed."""

    reason: str


Ending: TypeAlias = Completed | Stopped | Interrupted | Disagreed
"""How a check came to its end, each with the reason why it is not complete, if it is not."""


def ending_of(job: Callable[[], None], limits: Limits) -> Completed | Stopped | Interrupted:
    """The end of a job that is done here and now; what it had made by then is kept by the job."""
    try:
        job()
    except TimeIsUp:
        return Stopped(f"the time limit of {limits.time_limit:g} s was reached")
    except Unsettled as error:
        return Stopped(str(error))
    except KeyboardInterrupt:
        return Interrupted()
    return Completed()
