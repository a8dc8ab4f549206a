"""The costs in worlds that grow as a picture, logarithmic in both directions, a panel a family."""

from __future__ import annotations

import io
from math import ceil
from typing import Any

from allworlds.studies.compare import Growth

COLUMNS, SIDE = 3, 3.4
"""Panels side by side, and the side of one in inches."""


def growth_plot(report: Growth) -> str:
    """An SVG document; the same for the same report."""
    import matplotlib as mpl
    from matplotlib.figure import Figure

    columns = max(1, min(COLUMNS, len(report.families)))
    lines = max(1, ceil(len(report.families) / columns))
    # Without a salt the names in an SVG are drawn anew each time.
    with mpl.rc_context({"svg.hashsalt": "allworlds", "svg.fonttype": "none"}):
        figure = Figure(figsize=(columns * SIDE, lines * SIDE), layout="constrained")
        panels = figure.subplots(lines, columns, squeeze=False).flat
        for family, panel in zip(report.families, panels, strict=False):
            _draw(report, family, panel)
        for panel in list(panels):
            panel.set_visible(False)
        out = io.StringIO()
        figure.savefig(out, format="svg", metadata={"Date": None})
    return out.getvalue()


def _draw(report: Growth, family: str, panel: Any) -> None:
    for name in report.explorers:
        rows = [row for row in report.rows if (row.family, row.explorer) == (family, name)]
        if rows:
            low = [row.mean - row.least for row in rows]
            high = [row.worst - row.mean for row in rows]
            panel.errorbar(
                [row.edges for row in rows],
                [row.mean for row in rows],
                yerr=[low, high],
                label=name,
                marker="o",
                markersize=3,
                linewidth=1,
                capsize=2,
            )
    panel.set(title=family, xlabel="edges", ylabel="traversals", xscale="log", yscale="log")
    panel.legend(fontsize="x-small")
