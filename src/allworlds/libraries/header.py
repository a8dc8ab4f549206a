"""The header of native explorers, as the package has it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from allworlds.inputs import InputError
from allworlds.libraries.library import VERSION
from allworlds.outcome import SCHEMA, Exit

if TYPE_CHECKING:
    from allworlds import documents


@dataclass(frozen=True, slots=True)
class Header:
    """The C header.

    Attributes:
        text: of the file.
    """

    text: str

    @property
    def exit_code(self) -> Exit:
        """The exit code of the command: a question was answered."""
        return Exit.ANSWERED

    def to_json(self) -> documents.NativeReport:
        """The document of ``native --header --json``."""
        return {"schema": SCHEMA, "version": VERSION, "header": self.text}


def header_text() -> str:
    """The text of ``allworlds.h``."""
    return Path(__file__).with_name("allworlds.h").read_text(encoding="utf-8")


def native(*, header: bool = False) -> Header:
    """What writers of native explorers need: the C header.

    Raises:
        InputError: if it is not asked for; there is nothing else.
    """
    if not header:
        raise InputError("native tells the C header alone: give --header")
    return Header(header_text())
