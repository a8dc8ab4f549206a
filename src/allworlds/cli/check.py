"""The command check, and its --watch."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory, TemporaryFile
from time import sleep
from typing import Annotated, Any

import allworlds
from allworlds.cli.output import OutputGroup, answered, complain, emit
from allworlds.document.struct import replace
from allworlds.explorers.source_line import files_of_explorer
from allworlds.inputs.checks import InputError, a_path, show
from allworlds.inputs.requests import EFFORT, Option, fields_of
from allworlds.outcome import Exit
from allworlds.studies.check.requests import CheckRequest

PAUSE = 0.2
"""Seconds between two looks at the files."""


def watched(explorer: str, once: Callable[[], int], models: Iterable[Path] = ()) -> int:
    """The exit code of the last call of ``once``, made now and after every change of the files.

    It ends with an interrupt.  An explorer that is no explorer any more is told in a line, and
    waited for; so is a model, whose file is watched, too.

    Raises:
        InputError: if no file belongs to the explorer, or it is none at the beginning.
    """
    files = files_of_explorer(explorer)
    if not files:
        raise InputError(
            f"explorer {show(explorer)} cannot be watched; what can is path/to/file.py:attribute, "
            "and a program or a library that lies in a file"
        )
    files += [file for file in dict.fromkeys(models) if file not in files]
    seen = _state(files)
    code = once()
    while code != Exit.INTERRUPTED:
        complain(f"watching {', '.join(map(str, files))}: it is checked again whenever it is saved")
        try:
            seen = _changed(files, seen)
        except KeyboardInterrupt:
            break
        try:
            code = once()
        except InputError as error:
            complain(str(error))
            code = Exit.USAGE
    return code


@contextmanager
def kept_in(corpus: str | Path | None) -> Iterator[str | Path]:
    """The directory for past findings.

    Without a name a temporary one is made, and removed at the end.
    """
    if corpus is not None:
        yield corpus
        return
    with TemporaryDirectory(prefix="allworlds-") as directory:
        yield directory


def _changed(files: list[Path], seen: object) -> object:
    """Wait until the files have changed and then stayed as they are; return their new state."""
    before = seen
    while True:
        sleep(PAUSE)
        now = _state(files)
        if now not in (seen, None) and now == before:
            return now
        before = now


def _state(files: list[Path]) -> object:
    """Times, sizes and inodes of the files; None while one is missing, as between two saves."""
    try:
        found = [file.stat() for file in files]
    except OSError:
        return None
    return [(state.st_mtime_ns, state.st_size, state.st_ino) for state in found]


def ensure_directory(name: str | Path | None) -> None:
    """Make the directory if it is missing. It is bad input if no file can be written there."""
    if name is None:
        return
    path = a_path("corpus", name)
    try:
        path.mkdir(parents=True, exist_ok=True)
        with TemporaryFile(dir=path):
            pass
    except OSError as error:
        raise InputError(f"corpus {show(name)} cannot be written: {error.strerror}") from None


def check(
    request: CheckRequest,
    *,
    watch: Annotated[
        bool,
        Option(
            EFFORT,
            "",
            "Check again whenever the explorer, or a model of yours, is saved, earlier findings "
            "first.",
        ),
    ] = False,
    estimate: Annotated[
        bool, Option(EFFORT, "", "Only estimate the duration, from a sample of some seconds.")
    ] = False,
    output: OutputGroup,
) -> int:
    """Example: allworlds check my_explorer.py:explore --edges 4

    Run an explorer (default: Algorithm 1 of the paper) on every start and every marker
    orientation of every map of a class.  Exit code 0: holds, 1: refuted, 3: inconclusive,
    4: vacuous.
    """
    if estimate:
        written = next(iter(output.files or ()), None)
        kept = {"-o": written, "corpus": request.corpus, "run": request.run, "watch": watch}
        for name, value in kept.items():
            if value not in (None, False):
                given = name if value is True else f"{name} {show(value)}"
                raise InputError(f"{given} has no effect beside --estimate; leave one of them out")
        from allworlds.studies.check.exhaustive import estimate as estimated

        return emit(answered(estimated, request, output), output, request.workers)
    ensure_directory(request.corpus)

    def once(request: CheckRequest) -> int:
        return emit(answered(allworlds.check, request, output), output, request.workers)

    if not watch:
        return once(request)
    if request.run is not None:
        raise InputError(
            f"watch cannot be given with run {show(request.run)}, which is about one text of the "
            "explorer"
        )
    with kept_in(request.corpus) as past:
        assert isinstance(request.explore, str)
        models = {name: code for name, code in _models(request) if code}
        again = {name: getattr(request, name).name for name in models}
        return watched(
            request.explore,
            # A name stands for the text that its file has now.
            lambda: once(replace(request, corpus=past, **again)),
            [code.file for codes in models.values() for code in codes if code.source],
        )


def _models(request: CheckRequest) -> Iterator[tuple[str, Sequence[Any]]]:
    """The fields of a request, with the user's code that their values stand for."""
    for each in fields_of(type(request)):
        yield each.name, getattr(getattr(request, each.name), "codes", ())
