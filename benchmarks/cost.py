"""Print the table of docs/how-to/bound.md: what every bound costs, from one measured rate.

python benchmarks/cost.py benchmarks/results/kernel.json
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from allworlds.maps.counting.any_genus import rooted_maps

TO_EDGES = 12


def rows(rate: float) -> Iterator[tuple[int, int, int, float]]:
    """``(m, worlds with m edges, worlds with at most m edges, core seconds)`` for every bound."""
    total = 0
    for edges in range(1, TO_EDGES + 1):
        worlds = sum(rooted_maps(edges).values())
        total += worlds
        yield edges, worlds, total, total / rate


def _spoken(seconds: float) -> str:
    """Core seconds in a unit that fits."""
    for unit, size in (("years", 365.25 * 86400), ("days", 86400), ("hours", 3600), ("min", 60)):
        if seconds >= 2 * size:
            return f"{seconds / size:,.1f} {unit}"
    return f"{seconds:.1f} s" if seconds >= 0.1 else "< 0.1 s"


def table(document: dict[str, Any]) -> Iterator[str]:
    """The lines of the table."""
    kernel = next(row for row in document["contenders"] if row["name"] == "kernel")
    rate = kernel["worlds_per_second"]["median"]
    yield "| m | worlds with m edges | with at most m | core hours | on one core |"
    yield "|---:|---:|---:|---:|---:|"
    for edges, worlds, total, seconds in rows(rate):
        hours = f"{seconds / 3600:,.4f}" if seconds < 36_000 else f"{seconds / 3600:,.0f}"
        yield f"| {edges} | {worlds:,} | {total:,} | {hours} | {_spoken(seconds)} |"


if __name__ == "__main__":
    print("\n".join(table(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")))))
