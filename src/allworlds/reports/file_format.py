"""A file format of reports: what it shows, and the function that makes its content."""

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
        of_telling: the content of the file, made of the telling of a result.
        suffix: the end of a file's name that means it; empty where only its own name does.
        shows: what a verb must have one of to be written so; empty where every verb is.
        library: without which the content cannot be made, as it is imported; the extra of this
            package that brings it; and what needs it, for a refusal.
        summary: the variable in which a CI service names a file to which the report is added
            without being asked for; empty where there is none.
        told_to: the variable that says that a CI service reads stderr for it, likewise.
    """

    of_telling: Callable[[ToldResult], str | bytes]
    suffix: str
    shows: tuple[str, ...] = (ROWS,)
    library: tuple[str, str, str] | None = None
    summary: str = ""
    told_to: str = ""
