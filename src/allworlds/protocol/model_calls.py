"""Calls of a model, which is code of the user's in the place of ours: its errors are bad input."""

from __future__ import annotations

import signal
import sys
import threading

# The function behind signal.signal, which converts constants, and so takes ten times as long.
from _signal import SIG_DFL, signal as set_handler  # type: ignore[import-not-found]
from collections.abc import Callable
from types import FrameType
from typing import TypeVar

from allworlds.inputs import InputError, let_users_interrupt
from allworlds.protocol.importing import said

T = TypeVar("T")

LONGEST_CALL = 10.0
"""The seconds after which a call of a model is given up."""


class _TooLate(BaseException):
    """No answer in time.  It is no Exception: a model that catches those does not go on."""


class _Limit:
    """The limit of calls in this process.

    Attributes:
        seconds: of one call.
        running: whether a call goes on; one inside it has no limit of its own.
    """

    seconds = LONGEST_CALL
    running = False


def limit_calls(seconds: float) -> None:
    """Let calls of models in this process take that long at most."""
    _Limit.seconds = min(seconds, LONGEST_CALL)


def tried(what: str, act: Callable[[], T], kind: type[InputError] = InputError) -> T:
    """The result of a model's function; its prints go to stderr.

    Args:
        what: the function, for the message.
        act: calls it.
        kind: of the error.

    Raises:
        InputError: naming it, if it raises, or gives no answer in time.
    """
    if _Limit.running:
        return act()
    # Other threads than the main one have no signals, and so no limit.
    timed = threading.current_thread() is threading.main_thread()
    _Limit.running, printed = True, sys.stdout
    others, handler = 0.0, None
    try:
        # What a model prints must not get into a document on stdout.
        sys.stdout = sys.stderr
        if timed:
            handler = set_handler(signal.SIGALRM, _give_up)
            others, _ = signal.setitimer(signal.ITIMER_REAL, _Limit.seconds)
        return act()
    except _TooLate:
        raise kind(f"{what} gives no answer for {_Limit.seconds:g} s") from None
    except BaseException as error:  # noqa: BLE001  # a model may raise anything
        let_users_interrupt(error)
        raise kind(f"{what} raises {said(error)}") from None
    finally:
        if timed:
            # Somebody else's timer stands still during the call.
            signal.setitimer(signal.ITIMER_REAL, others)
            set_handler(signal.SIGALRM, handler or SIG_DFL)
        _Limit.running, sys.stdout = False, printed


def _give_up(_number: int, _frame: FrameType | None) -> None:
    raise _TooLate
