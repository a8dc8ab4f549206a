"""Reports as files, and what a CI service is told."""

from __future__ import annotations

import os
import sys
import tempfile
from contextlib import suppress
from dataclasses import fields, make_dataclass
from functools import cache
from pathlib import Path
from typing import Annotated

from allworlds.cli.made_by import words_of_command
from allworlds.cli.output import complain
from allworlds.inputs.checks import InputError, a_path, show
from allworlds.inputs.requests import OUTPUT, Option
from allworlds.outcome import Result
from allworlds.reports.format_table import FORMATS, content_of, ensure_possible, file_of, formats_of
from allworlds.verbs import BY_NAME, FINDINGS


def tell_service(verb: str, report: Result) -> None:
    """Add a report with findings to the CI service's files, and print to stderr the lines it reads.

    A file that cannot be written is lost with a word on stderr; the verdict is not.
    """
    if FINDINGS not in BY_NAME[verb].has:
        return
    for form, format_ in formats_of(verb).items():
        if os.environ.get(format_.told_to) == "true":
            print(file_of(verb, form, report), end="", file=sys.stderr)
        if path := os.environ.get(format_.summary):
            try:
                with Path(path).open("a", encoding="utf-8") as file:
                    file.write(file_of(verb, form, report))
            except OSError as error:
                complain(f"the file of {format_.summary} cannot be written: {error.strerror}")


SOURCES = (".c", ".cc", ".cpp", ".dylib", ".h", ".js", ".mjs", ".py", ".rs", ".so")
"""The ends of names of files that no report replaces."""


class Files:
    """The files into which a verb's result is written.

    A verb that has one as a parameter gets an option for each format, of :func:`files_of`.

    Raises:
        InputError: naming a file that cannot be written, and the reason.
    """

    def __post_init__(self) -> None:
        forms: dict[str, str] = {}
        for form, path in self.named().items():
            ensure_possible(form, path)
            ensure_writable(path)
            other = forms.setdefault(os.path.realpath(path), form)
            if other != form:
                raise InputError(f"{other} and {form} are both to be written into {show(path)}")
        for form, path in self.named().items():
            _ensure_meant(form, path)

    def expect(self, request: object) -> None:
        """Refuse an option of a request that tells of a file which is not written.

        Raises:
            InputError: naming it.
        """
        by = getattr(request, "by", None)
        if by is not None and "csv" not in self.named():
            raise InputError(f"by {by} has no effect without --csv")

    def write(self, verb: str, result: Result) -> None:
        """Write the result into each file that was named, and where a CI service looks for it."""
        for form, path in self.named().items():
            write_file(path, content_of(verb, form, result, path))
        tell_service(verb, result)

    def named(self) -> dict[str, str]:
        """The files that were named, by their formats."""
        given = {each.name: getattr(self, each.name) for each in fields(self)}  # type: ignore[arg-type]  # each kind is one
        return {form: path for form, path in given.items() if path is not None}


@cache
def files_of(verb: str) -> type[Files]:
    """The kind of files that a verb can write, with an option for each format."""
    told = [(name, _option(name), None) for name in formats_of(verb)]
    return make_dataclass("Files", told, bases=(Files,), frozen=True)


def _option(form: str) -> object:
    return Annotated[str | None, Option(OUTPUT, "FILE", FORMATS[form].help)]


def _ensure_meant(form: str, path: str) -> None:
    """Refuse a path that is there since a FILE was forgotten, or whose content is needed."""
    if path.startswith("-"):
        raise InputError(f"{form} lacks its FILE: {show(path)} begins with a dash (a file: ./...)")
    if not Path(path).exists():
        return
    if path.endswith(SOURCES):
        raise InputError(f"{form} {show(path)} is a source or a library, and no report; it stays")
    if _times_named(path) > 1:
        raise InputError(f"{form} {show(path)} is a file that is read; name another one")


def _times_named(path: str) -> int:
    """How many words of the command name that file."""
    real = os.path.realpath(path)
    return sum(real in _files_in(word) for word in words_of_command())


def _files_in(word: str) -> set[str]:
    """The files that a word may name: as a whole, behind a sign, or before an attribute."""
    value = word.partition("=")[2] if word.startswith("--") else word
    found = set()
    for name in (value, value.removeprefix("@"), *value.partition(":")[::2]):
        with suppress(ValueError):  # there is no file of such a name
            found.add(os.path.realpath(name))
    return found


def write_text(path: str, text: str) -> None:
    """Write a text as :func:`write_file` does."""
    write_file(path, text.encode())


def write_file(path: str, content: bytes) -> None:
    """Write a file that was checked to be writable before the work began.

    If the file cannot be written any more, on a full disk for example, a line on stderr says so;
    the report and its verdict are not lost.
    """
    try:
        Path(path).write_bytes(content)
    except OSError as error:
        complain(f"{_refusal(path, error)}; the report is on stdout only")
        with suppress(OSError):  # half a report is none
            if Path(path).is_file():
                Path(path).unlink()


def ensure_writable(path: str) -> None:
    """Refuse a file that cannot be written. Its content stays, and no new file is made.

    Raises:
        InputError: naming the file and the reason.
    """
    try:
        file = a_path("file", path)
        existed = file.exists()
        file.open("a", encoding="utf-8").close()
        if not existed:
            file.unlink()
    except (OSError, ValueError) as error:
        raise _refusal(path, error) from None


def _refusal(path: str, error: Exception) -> InputError:
    reason = error.strerror if isinstance(error, OSError) else error
    return InputError(f"file {show(path)} cannot be written: {reason}")


def ensure_directory(name: str | Path | None) -> None:
    """Make the directory if it is missing. It is bad input if no file can be written there."""
    if name is None:
        return
    path = a_path("corpus", name)
    try:
        path.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=path):
            pass
    except OSError as error:
        reason = f"{show(name)} cannot be written: {error.strerror}"
        raise InputError(f"corpus {reason}") from None
