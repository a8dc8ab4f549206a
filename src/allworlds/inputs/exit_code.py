"""The exit code of a process, which is no matter of a model's: it would pass for a verdict."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from typing import NoReturn

_exit = os._exit


class _Kept:
    """The process in which ``os._exit`` is refused; 0 if it is refused nowhere."""

    process = 0


def keep_exit_code() -> None:
    """Refuse ``os._exit`` in this process, and not in those that are forked."""
    _Kept.process, os._exit = os.getpid(), _refuse


@contextmanager
def exit_code_kept() -> Iterator[None]:
    """A context in which ``os._exit`` is refused in this process."""
    before = _Kept.process, os._exit
    keep_exit_code()
    try:
        yield
    finally:
        _Kept.process, os._exit = before


def _refuse(status: int) -> NoReturn:
    if _Kept.process == os.getpid():
        raise SystemExit(f"os._exit({status}) would end the process")
    _exit(status)
