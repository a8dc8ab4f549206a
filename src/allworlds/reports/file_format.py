"""A file format of reports: what it shows, and the function that makes its text."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from msgspec import Struct

from allworlds.verbs import ROWS

if TYPE_CHECKING:
    from allworlds.reports.telling import ToldResult


class Format(Struct, frozen=True):
    """A file format of reports.

    Attributes:
        of_telling: the text of the file, made of the telling of a result.
        help: the help of the option.
        shows: what it shows; it is an option of every verb that has such.
        summary: the variable of a CI service that names a file to which the report is added
            without being asked for; empty where there is none.
        told_to: the variable by which a CI service says that it reads stderr for it, likewise.
    """

    of_telling: Callable[[ToldResult], str]
    help: str
    shows: str = ROWS
    summary: str = ""
    told_to: str = ""
