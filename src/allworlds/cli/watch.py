"""Repeat a check whenever a file of the user's is saved."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from time import sleep

from allworlds.cli.output import complain
from allworlds.explorers import files_of_explorer
from allworlds.inputs import InputError, show
from allworlds.outcome import Exit

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
