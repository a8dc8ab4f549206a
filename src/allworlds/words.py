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
    return f"dart{'s' if len(names) > 1 else ''} {listed(names)}"


def listed(names: Sequence[str]) -> str:
    """``1``, ``1 and 3``, ``1, 3 and 5``."""
    *others, last = names
    return f"{', '.join(others)} and {last}" if others else last


def duration(seconds: float) -> str:
    """``12 s``, ``5 min``, ``3 h 20 min``, ``4 days 3 h``: two units at most, rounded down."""
    whole = int(seconds)
    minutes, hours, days = whole // 60, whole // 3600, whole // 86400
    if minutes == 0:
        return f"{whole} s"
    if hours == 0:
        return f"{minutes} min"
    if days == 0:
        return f"{hours} h {minutes % 60} min"
    return f"{plural(days, 'day')} {hours % 24} h"
