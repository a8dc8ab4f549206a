"""The refusal of nested checks: a check must not begin in a player, or while a file is loaded.

Without the refusal, a user's file that begins a check when it is imported would begin another check
in each player that imports the file.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path
from traceback import walk_stack
from types import FrameType

from allworlds.inputs.checks import NestedCheck, show

PLAYER = "ALLWORLDS_PLAYER"
"""The environment variable that marks players, and all processes that users' code in a player
starts."""

SAID = "begins a check where none may begin"
"""The words that each refusal contains, also when a program prints the refusal."""

PACKAGE = str(Path(__file__).parents[1])

_LOADING: ContextVar[bool] = ContextVar("loading", default=False)


@contextmanager
def loading() -> Iterator[None]:
    """A context for the loading of a user's file; no check may begin in it."""
    token = _LOADING.set(True)
    try:
        yield
    finally:
        _LOADING.reset(token)


def ensure_outermost() -> None:
    """Refuse to begin a job, such as a check or a run, in a player, or while a file is loaded.

    Raises:
        NestedCheck: naming the file, the line and the remedy.
    """
    if PLAYER in os.environ or _LOADING.get():
        raise NestedCheck(_refusal())


def refusal_in(words: str) -> NestedCheck | None:
    """The error about a nested check, if the last line of ``words`` is its message; else None.

    ``words`` are the lines that a program has printed, perhaps after a check in it was refused.
    """
    last = words.rstrip().rpartition("\n")[2]
    return NestedCheck(last.partition(": ")[2]) if SAID in last else None


def _refusal() -> str:
    stack = [*walk_stack(None)]
    users = [each for each in stack if not each[0].f_code.co_filename.startswith((PACKAGE, "<fro"))]
    imported = [each for each in users if _is_imported(each[0])]
    in_program = [each for each in stack if "__file__" in _of_program(each[0])]
    frame, line = (imported or in_program or users)[0]
    remedy = "inside another one: what is checked begins none"
    if imported:
        remedy = 'as it is imported: put it under if __name__ == "__main__":'
    return f"{show(frame.f_code.co_filename)}, line {line}, {SAID}, {remedy}"


def _is_imported(frame: FrameType) -> bool:
    return frame.f_code.co_name == "<module>" and not _of_program(frame)


def _of_program(frame: FrameType) -> Mapping[str, object]:
    """The global variables of a frame of a Python stack; empty if it is not of the main program."""
    return frame.f_globals if frame.f_globals.get("__name__") == "__main__" else {}
