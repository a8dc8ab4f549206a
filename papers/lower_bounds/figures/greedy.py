"""Draw ``greedy.svg``: greedy against Algorithm 1 on twelve families.

``python papers/lower_bounds/figures/greedy.py`` draws it from ``growth.csv`` alone; matplotlib is
in the extra ``figures``.
"""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path
from typing import Any

import matplotlib as mpl
from growth import Costs, by_family, costs, exact_sizes, read
from matplotlib.figure import Figure

from allworlds.claims import mean_interval

FILE = Path(__file__).with_suffix(".svg")
WHO = {"algorithm1": ("Algorithm 1", "#b3261e"), "greedy": ("greedy", "#1d5fa8")}
LEFT_OUT = "corridor"
ROWS, COLUMNS, TICKS = 3, 4, (12, 25, 50, 100, 200)


def band(found: Costs, exact: Collection[int]) -> list[tuple[int, float, float, float]]:
    """For each size the edges, the mean cost over the worlds, and the ends of its interval.

    Where a size has no interval, because it is exact or has too few worlds, both ends are the mean.
    """
    made = []
    for edges, some in found.items():
        mean = sum(some) / len(some)
        low, high = (None if edges in exact else mean_interval(some)) or (mean, mean)
        made.append((edges, mean, low, high))
    return made


def drawn() -> Figure:
    """A panel for each family but one, both axes logarithmic."""
    every = by_family(read())
    # In corridors they differ by a few percent only.
    families = [(name, rows) for name, rows in every.items() if name != LEFT_OUT]
    figure = Figure(figsize=(10, 7.2), layout="constrained")
    panels = figure.subplots(ROWS, COLUMNS).flat
    for (family, rows), panel in zip(families, panels, strict=True):
        for explorer, (name, colour) in WHO.items():
            points = band(costs(rows, explorer), exact_sizes(rows, explorer))
            _line(panel, points, name, colour)
        panel.set(title=family, xscale="log", yscale="log")
        panel.set_xticks(TICKS, labels=list(map(str, TICKS)))
        panel.set_xticks([], minor=True)
    figure.supxlabel("edges")
    figure.supylabel("mean traversals in a world")
    handles, labels = figure.axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=2)
    return figure


def _line(panel: Any, points: list[tuple[int, float, float, float]], name: str, of: str) -> None:
    edges, means, low, high = zip(*points, strict=True)
    panel.plot(edges, means, label=name, color=of, marker="o", markersize=3, linewidth=1)
    panel.fill_between(edges, low, high, color=of, alpha=0.3, linewidth=0)


if __name__ == "__main__":
    with mpl.rc_context({"svg.hashsalt": "allworlds", "svg.fonttype": "none"}):
        drawn().savefig(FILE, format="svg", metadata={"Date": None})
