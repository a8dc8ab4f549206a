"""The text of ``native``."""

from __future__ import annotations

from allworlds.libraries import Header


def native_text(header: Header, _width: int) -> str:
    """The file, line by line."""
    return header.text.rstrip("\n")
