"""The options that write a report into a file, and what is written where."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, make_dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from allworlds.cli.output import complain
from allworlds.cli.service import tell_service
from allworlds.inputs import OUTPUT, InputError, Option, a_path, show
from allworlds.outcome import Result
from allworlds.reports import FORMATS, PAGE, file_of, page_of, written


class _Files:
    """One option for each of the reports' formats, each with the name of its file."""

    def ensure_writable(self) -> None:
        """Nothing, if each file can be written; it is left as it is, and not made.

        Raises:
            InputError: naming the file and the reason.
        """
        for path in self.named().values():
            _ensure_writable(path)

    def write(self, report: Result) -> None:
        """The report in each file that was named, and where a CI service looks for it."""
        for form, path in self.named().items():
            _write_text(path, written(form, report))
        tell_service(report)

    def named(self) -> dict[str, str]:
        """The files that were named, by their formats."""
        given = {form: getattr(self, form) for form in FORMATS}
        return {form: path for form, path in given.items() if path is not None}


def _option(form: str) -> object:
    help_ = FORMATS[form].help
    return Annotated[str | None, Option(OUTPUT, "FILE", help_)]


if TYPE_CHECKING:
    Files = _Files
else:
    Files = make_dataclass(
        "Files", [(form, _option(form), None) for form in FORMATS], bases=(_Files,), frozen=True
    )


@dataclass(frozen=True, slots=True)
class PageFile:
    """The option that writes a verb's result as a web page."""

    html: Annotated[str | None, Option(OUTPUT, "FILE", PAGE)] = None

    def ensure_writable(self) -> None:
        """Nothing, if the file can be written; it is left as it is, and not made.

        Raises:
            InputError: naming the file and the reason.
        """
        ensure_all_writable({"html": self.html})

    def write(self, verb: str, result: Result) -> None:
        """A verb's result in the file, if one was named."""
        if self.html is not None:
            _write_text(self.html, page_of(verb, result))


def ensure_all_writable(files: Mapping[str, str | None]) -> None:
    """Nothing, if each file can be written; by the options that name them, where they do.

    Raises:
        InputError: naming the file and the reason.
    """
    for path in files.values():
        if path is not None:
            _ensure_writable(path)


def write_files(verb: str, result: Result, files: Mapping[str, str | None]) -> None:
    """A verb's result in each file that was named."""
    for name, path in files.items():
        if path is not None:
            _write_text(path, file_of(verb, name, result))


def _write_text(path: str, text: str) -> None:
    """Write a file that could be written before the work began.

    One that cannot be written any more, on a full disk, say, is lost with a word on stderr; the
    report and its verdict are not.
    """
    try:
        Path(path).write_text(text, encoding="utf-8")
    except OSError as error:
        complain(f"{_refusal(path, error)}; the report stands on stdout alone")
        with suppress(OSError):  # half a report is none
            if Path(path).is_file():
                Path(path).unlink()


def _ensure_writable(path: str) -> None:
    """Nothing, if the file can be written; it is left as it is, and not made.

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
    """Make the directory if it is missing; bad input if no file can be written there."""
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
