"""The header of native explorers, from the package."""

from __future__ import annotations

from pathlib import Path


def header_text() -> str:
    """The text of ``allworlds.h``."""
    return Path(__file__).with_name("allworlds.h").read_text(encoding="utf-8")
