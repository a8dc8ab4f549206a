"""Numbers and lists in words: a thing in one place, for every sentence that a person reads."""

from __future__ import annotations

from collections.abc import Sequence


def number(value: int) -> str:
    """With thousands separated."""
    return f"{value:,}"


def plural(count: int, one: str, many: str = "") -> str:
    """``1 world``, ``2 worlds``."""
    return f"{number(count)} {one if count == 1 else many or one + 's'}"


def size(edges: int, vertices: int) -> str:
    """``1 edge and 2 vertices``."""
    return f"{plural(edges, 'edge')} and {plural(vertices, 'vertex', 'vertices')}"


def darts(names: Sequence[str]) -> str:
    """``dart 1``, ``darts 1 and 3``, ``darts 1, 3 and 5``."""
    *others, last = names
    return f"darts {', '.join(others)} and {last}" if others else f"dart {last}"
