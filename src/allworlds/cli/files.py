"""The options that write a report into a file, one for each of the reports' formats."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from allworlds.cli import options as opt
from allworlds.inputs import InputError, a_path, show
from allworlds.outcome import Result
from allworlds.reports import FORMATS, written

Junit = Annotated[
    str | None,
    typer.Option(
        "--junit",
        metavar="FILE",
        help=FORMATS["junit"].help,
        rich_help_panel=opt.OUTPUT,
        show_default=False,
    ),
]

Html = Annotated[
    str | None,
    typer.Option(
        "--html",
        metavar="FILE",
        help=FORMATS["html"].help,
        rich_help_panel=opt.OUTPUT,
        show_default=False,
    ),
]


def ensure_writable(path: str | None) -> None:
    """Nothing, if the file can be written; it is left as it is, and not made.

    Raises:
        InputError: naming the file and the reason.
    """
    if path is None:
        return
    try:
        file = a_path("file", path)
        existed = file.exists()
        file.open("a", encoding="utf-8").close()
        if not existed:
            file.unlink()
    except (OSError, ValueError) as error:
        raise _refusal(path, error) from None


def write_reports(report: Result, files: dict[str, str | None]) -> None:
    """The report in each file that was named, by its format.

    Raises:
        InputError: naming the file and the reason why it cannot be written.
    """
    for form, path in files.items():
        if path is not None:
            _write(path, written(form, report))


def _write(path: str, text: str) -> None:
    try:
        Path(path).write_text(text, encoding="utf-8")
    except OSError as error:
        raise _refusal(path, error) from None


def _refusal(path: str, error: Exception) -> InputError:
    reason = error.strerror if isinstance(error, OSError) else error
    return InputError(f"file {show(path)} cannot be written: {reason}")
