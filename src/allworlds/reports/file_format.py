"""A file format of reports: what it shows, and the function that makes its text."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, NamedTuple

from msgspec import Struct

from allworlds.verbs import ROWS

if TYPE_CHECKING:
    from allworlds.reports.telling import ToldResult


class NeededLibrary(NamedTuple):
    """A library without which a file cannot be made.

    Attributes:
        name: as it is imported.
        extra: the extra of this package that brings it.
        needed_by: what needs it, for a refusal.
    """

    name: str
    extra: str
    needed_by: str


class Binary(NamedTuple):
    """A file that is no text: its content, made of the telling of a result, and what it needs."""

    of_telling: Callable[[ToldResult], bytes]
    library: NeededLibrary


class Format(Struct, frozen=True):
    """A file format of reports.

    Attributes:
        of_telling: the text of the file, made of the telling of a result.
        help: the help of the option.
        shows: what a verb must have to get the option.
        binary: what is made in place of the text, by the end of the file's name.
        summary: the variable in which a CI service names a file to which the report is added
            without being asked for; empty where there is none.
        told_to: the variable that says that a CI service reads stderr for it, likewise.
    """

    of_telling: Callable[[ToldResult], str]
    help: str
    shows: str = ROWS
    binary: Mapping[str, Binary] = {}
    summary: str = ""
    told_to: str = ""

    def binary_for(self, name: str) -> Binary | None:
        """Return how a file of that name is made in place of a text; None if it is a text."""
        return next((made for end, made in self.binary.items() if name.endswith(end)), None)
