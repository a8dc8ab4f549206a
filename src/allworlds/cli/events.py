"""A file of events: the progress of a long job, one JSON document per line."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager, suppress
from time import monotonic
from typing import Any, TextIO, TypeVar

from typing_extensions import override

from allworlds.cli.options import LongOutputGroup, OutputGroup
from allworlds.cli.output import Progress, complain
from allworlds.document import replace
from allworlds.engines import Listener
from allworlds.inputs import InputError, a_path, answer, show
from allworlds.outcome import Result
from allworlds.reports import (
    Event,
    FindingEvent,
    LevelEvent,
    NoticeEvent,
    ProgressEvent,
    StageEvent,
    UnitEvent,
    VerdictEvent,
)
from allworlds.words import harmless_json

Answer = TypeVar("Answer", bound=Result)

EVERY = 1.0
"""Seconds between two lines that say how much is done."""


class Events(Listener):
    """A listener that writes each event into a file and passes it on.

    On a full disk the remaining events are lost, and nothing else.
    """

    def __init__(self, progress: Progress, file: TextIO | None) -> None:
        self._progress, self._file = progress, file
        self._done, self._told = 0, monotonic()

    @override
    def level(self, edges: int, worlds: int) -> None:
        self._progress.level(edges, worlds)
        self._done = 0
        self._write(LevelEvent(edges=edges, worlds=worlds))

    def stage(self, name: str, total: int, of: str) -> None:
        """Begin a stage, and write its name and total."""
        self._progress.stage(name, total, of)
        self._done = 0
        self._write(StageEvent(name=name, all=total, of=of))

    def progress(self, count: int) -> None:
        """Write now and then how many are done."""
        self._progress.progress(count)
        self._done += count
        if monotonic() >= self._told + EVERY:
            self._told = monotonic()
            self._write(ProgressEvent(done=self._done))

    @override
    def unit(self, key: str, worlds: int) -> None:
        self._write(UnitEvent(unit=key, worlds=worlds))

    @override
    def finding(self, document: Mapping[str, Any]) -> None:
        self._write(FindingEvent(finding=document))

    def notice(self, text: str) -> None:
        """Write a message for the user."""
        self._progress.notice(text)
        self._write(NoticeEvent(text=text))

    def verdict(self, report: Result) -> None:
        """Write the last event, which holds the whole report."""
        self._write(VerdictEvent(report=report))

    def _write(self, event: Event) -> None:
        if self._file is None:
            return
        try:
            print(harmless_json(json.dumps(event.to_json())), file=self._file, flush=True)
        except OSError as error:
            self._file = None
            complain(f"events are no longer written: {error.strerror}")


@contextmanager
def listening(output: LongOutputGroup) -> Iterator[Events]:
    """The listener of a long job: progress on a terminal, and a file of events if one is named.

    Raises:
        InputError: if it cannot be written.
    """
    with ExitStack() as stack:
        file = _opened(output.events) if output.events is not None else None
        if file is not None:
            stack.callback(_let_go, file)
        yield Events(stack.enter_context(Progress(quiet=output.quiet)), file)


def answered(function: Callable[..., Answer], request: Any, output: OutputGroup) -> Answer:
    """Answer a request by a function of the package, reporting progress and the result.

    There is progress where the request names a listener.
    """
    if not isinstance(output, LongOutputGroup):
        return answer(function, request)
    with listening(output) as listener:
        report = answer(function, replace(request, listener=listener))
        listener.verdict(report)
    return report


def _opened(path: str) -> TextIO:
    try:
        return a_path("events", path).open("w", encoding="utf-8")
    except OSError as error:
        raise InputError(f"file {show(path)} cannot be written: {error.strerror}") from None


def _let_go(file: TextIO) -> None:
    """Close the file. An error has been reported already, and is not reported twice."""
    with suppress(OSError):
        file.close()
