"""The text of ``native``."""

from __future__ import annotations

from allworlds.libraries import Header


def native_text(header: Header, width: int) -> str:  # noqa: ARG001  # a file has its own
    """The file, line by line."""
    return header.text.rstrip("\n")
