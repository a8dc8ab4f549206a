"""The options that write a report into a file: ``--junit`` and ``--html``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from allworlds.cli import options as opt
from allworlds.errors import InputError, a_path, show

if TYPE_CHECKING:
    from allworlds.checker import Report

Junit = Annotated[
    str | None,
    typer.Option(
        "--junit",
        metavar="FILE",
        help="Write the report as JUnit XML too.",
        rich_help_panel=opt.OUTPUT,
        show_default=False,
    ),
]

Html = Annotated[
    str | None,
    typer.Option(
        "--html",
        metavar="FILE",
        help="Write the report as a web page too: one file, which needs no network.",
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


def write_reports(report: Report, *, junit: str | None, html: str | None) -> None:
    """The report in each file that was named.

    Raises:
        InputError: naming the file and the reason why it cannot be written.
    """
    if junit is not None:
        from allworlds.reports.junit import junit as as_junit

        _write(junit, as_junit(report))
    if html is not None:
        from allworlds.reports.html import page

        _write(html, page(report))


def _write(path: str, text: str) -> None:
    try:
        Path(path).write_text(text, encoding="utf-8")
    except OSError as error:
        raise _refusal(path, error) from None


def _refusal(path: str, error: Exception) -> InputError:
    reason = error.strerror if isinstance(error, OSError) else error
    return InputError(f"file {show(path)} cannot be written: {reason}")
