"""Numbers and enumerations in words."""

from __future__ import annotations

from collections.abc import Sequence

from allworlds.maps.combinatorial import CombinatorialMap


def size(map_: CombinatorialMap) -> str:
    """``2 vertices and 1 edge``."""
    vertices = count(map_.vertex_count, "vertex", "vertices")
    return f"{vertices} and {count(map_.edge_count, 'edge')}"


def count(number: int, one: str, many: str = "") -> str:
    """``1 edge``, ``2 edges``."""
    return f"{number} {one if number == 1 else many or one + 's'}"


def darts(names: Sequence[str]) -> str:
    """``dart 1``, ``darts 1 and 3``, ``darts 1, 3 and 5``."""
    *others, last = names
    return f"darts {', '.join(others)} and {last}" if others else f"dart {last}"
