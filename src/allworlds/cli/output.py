"""Where results and progress go: results to stdout, all else to stderr."""

from __future__ import annotations

import json
import os
import shutil
import sys
from collections.abc import Callable
from typing import Any, Protocol, Self

NARROWEST = 40


class Document(Protocol):
    """A result that has both forms."""

    def to_json(self) -> dict[str, Any]:
        """The JSON document."""


def width() -> int:
    """The width for texts: the terminal's, 100 where there is none."""
    return max(NARROWEST, shutil.get_terminal_size((100, 24)).columns)


def emit(result: Document, text: Callable[[int], str], *, as_json: bool) -> None:
    """Print a result in the form that was asked for."""
    try:
        print(json.dumps(result.to_json(), indent=2) if as_json else text(width()))
        sys.stdout.flush()
    except BrokenPipeError:
        # The reader has gone (a pipe to head); the exit code is still to be told.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


class Progress:
    """A bar on stderr with the exact total and the time that is left; only on a terminal."""

    def __init__(self, *, quiet: bool) -> None:
        self._quiet = quiet
        self._bar: Any = None
        if not quiet and sys.stderr.isatty():
            self._bar = _bar()

    def __enter__(self) -> Self:
        if self._bar:
            self._bar.start()
        return self

    def __exit__(self, *_: object) -> None:
        if self._bar:
            self._bar.stop()

    def level(self, edges: int, worlds: int) -> None:
        """A level begins."""
        if self._bar:
            self._task = self._bar.add_task(f"m = {edges}", total=worlds)

    def progress(self, worlds: int) -> None:
        """So many more worlds are done."""
        if self._bar:
            self._bar.advance(self._task, worlds)

    def notice(self, text: str) -> None:
        """One line on stderr."""
        if not self._quiet:
            print(f"allworlds: {text}", file=sys.stderr)


def _bar() -> Any:
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeRemainingColumn
    from rich.progress import Progress as RichProgress

    return RichProgress(
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("worlds"),
        TimeRemainingColumn(),
        console=Console(stderr=True),
    )
