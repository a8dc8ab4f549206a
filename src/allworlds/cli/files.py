"""The option ``--junit``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from allworlds.cli import options as opt
from allworlds.errors import InputError, show

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


def ensure_writable(path: str | None) -> None:
    """Nothing, if the file can be written; it is left as it is, and not made.

    Raises:
        InputError: naming the file and the reason.
    """
    if path is None:
        return
    file = Path(path)
    try:
        existed = file.exists()
        file.open("a", encoding="utf-8").close()
        if not existed:
            file.unlink()
    except (OSError, ValueError) as error:
        raise _refusal(path, error) from None


def write_junit(path: str | None, report: Report) -> None:
    """The report as JUnit XML in that file; nothing where no file was named.

    Raises:
        InputError: naming the file and the reason why it cannot be written.
    """
    if path is None:
        return
    from allworlds.reports.junit import junit

    try:
        Path(path).write_text(junit(report), encoding="utf-8")
    except OSError as error:
        raise _refusal(path, error) from None


def _refusal(path: str, error: Exception) -> InputError:
    reason = error.strerror if isinstance(error, OSError) else error
    return InputError(f"file {show(path)} cannot be written: {reason}")
