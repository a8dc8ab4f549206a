"""Reports for the CI service in which the program runs, written without being asked for."""

from __future__ import annotations

import os
import sys
from pathlib import Path

from allworlds.cli.output import complain
from allworlds.outcome import Result
from allworlds.reports import file_of, formats_of
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
