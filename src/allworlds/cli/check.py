"""The command check, and its --watch."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from time import sleep
from typing import Annotated, Any

import allworlds
from allworlds.cli.files import Files, ensure_directory
from allworlds.cli.output import OutputGroup, answered, complain, emit
from allworlds.document.struct import replace
from allworlds.explorers.sources import files_of_explorer
from allworlds.inputs.checks import InputError, show
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
        bool,
        Option(
            EFFORT,
            "",
            "Only estimate the duration, from a sample of some seconds.",
            "estimate",
        ),
    ] = False,
    files: Files,
    output: OutputGroup,
) -> int:
    """Example: allworlds check my_explorer.py:explore --edges 4

    Run an explorer (default: Algorithm 1 of the paper) on every start and every marker
    orientation of every map of a class.  Exit code 0: holds, 1: refuted, 3: inconclusive,
    4: vacuous.
    """
    if estimate:
        kept = {"corpus": request.corpus, "run": request.run, "watch": watch}
        _refuse_beside_estimate({**files.named(), **kept})
        return _estimate(request, output)
    ensure_directory(request.corpus)

    def once(request: CheckRequest) -> int:
        report = answered(allworlds.check, request, output)
        files.write("check", report)
        return emit(report, "check", output, request.workers)

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


def _estimate(request: CheckRequest, output: OutputGroup) -> int:
    from allworlds.studies.check.exhaustive import estimate

    guess = answered(estimate, request, output)
    return emit(guess, "check", output, request.workers)


def _refuse_beside_estimate(given: Mapping[str, object]) -> None:
    """Raise InputError if an option is given that has no effect on an estimate.

    Raises:
        InputError: naming the first.
    """
    for name, value in given.items():
        if value is not None and value is not False:
            raise InputError(
                f"{name} {'' if value is True else show(value) + ' '}has no effect beside "
                "--estimate, which checks nothing; leave one of them out"
            )
