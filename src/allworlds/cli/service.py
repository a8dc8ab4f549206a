"""What a CI service gets of a report without being asked for, where the program runs in one."""

from __future__ import annotations

import os
import sys
from pathlib import Path

from allworlds.cli.output import complain, printable
from allworlds.outcome import Result
from allworlds.reports import FORMATS, written


def tell_service(report: Result) -> None:
    """Add the report to the files that the service names, and tell stderr what it reads there.

    A file that cannot be written is lost with a word on stderr; the verdict is not.
    """
    for form, format_ in FORMATS.items():
        if os.environ.get(format_.told_to) == "true":
            print(printable(written(form, report)), end="", file=sys.stderr)
        if path := os.environ.get(format_.summary):
            try:
                with Path(path).open("a", encoding="utf-8") as file:
                    file.write(written(form, report))
            except OSError as error:
                complain(f"the file of {format_.summary} cannot be written: {error.strerror}")
