"""Calls of a model, which is code of the user's in the place of ours: its errors are bad input."""

from __future__ import annotations

import signal
import sys
import threading

# The function behind signal.signal, which converts constants, and so takes ten times as long.
from _signal import SIG_DFL, signal as set_handler  # type: ignore[import-not-found]
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from types import FrameType
from typing import TypeVar

from allworlds.inputs import (
    InputError,
    keep_exit_code,
    let_users_interrupt,
    release_exit_code,
)
from allworlds.protocol.importing import TooLate, said

T = TypeVar("T")

LONGEST_CALL = 10.0
"""The seconds after which a call of a model is given up."""


START_TIMEOUT = 60.0
"""Seconds in which code of the user's must be imported, unless others are named."""

AGAIN = 1.0
"""Seconds after which a model that has caught its end is ended once more."""

_loading: ContextVar[float] = ContextVar("loading", default=START_TIMEOUT)


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
    printed = sys.stdout
    try:
        # What a model prints must not get into a document on stdout.
        sys.stdout = sys.stderr
        return _in_time(_Limit.seconds, act)
    except TooLate:
        raise kind(f"{what} gives no answer for {_Limit.seconds:g} s") from None
    except BaseException as error:  # noqa: BLE001  # a model may raise anything
        let_users_interrupt(error)
        raise kind(f"{what} raises {said(error)}") from None
    finally:
        sys.stdout = printed


@contextmanager
def limited_loading(seconds: float) -> Iterator[None]:
    """A context in which a model must be imported in so many seconds."""
    token = _loading.set(seconds)
    try:
        yield
    finally:
        _loading.reset(token)


def loaded(name: str, load: Callable[[], T]) -> T:
    """The object that the import of a model yields.

    Args:
        name: of the model, for the message.
        load: imports it.

    Raises:
        InputError: naming it, if that does not end in time.
    """
    if _Limit.running:
        return load()
    seconds = _loading.get()
    try:
        return _in_time(seconds, load)
    except TooLate:
        raise InputError(f"{name} does not import: it was at it for {seconds:g} s") from None


def _in_time(seconds: float, act: Callable[[], T]) -> T:
    """The result of user's code; other threads than the main one have no signals, and no limit.

    Raises:
        TooLate: if there is none in time.
    """
    timed = threading.current_thread() is threading.main_thread()
    others, handler = 0.0, None
    _Limit.running = True
    keep_exit_code()
    try:
        if timed:
            handler = set_handler(signal.SIGALRM, _give_up)
            others, _ = signal.setitimer(signal.ITIMER_REAL, seconds, AGAIN)
        return act()
    finally:
        if timed:
            # Somebody else's timer stands still during the call.
            signal.setitimer(signal.ITIMER_REAL, others)
            set_handler(signal.SIGALRM, handler or SIG_DFL)
        release_exit_code()
        _Limit.running = False


def _give_up(_number: int, _frame: FrameType | None) -> None:
    raise TooLate
