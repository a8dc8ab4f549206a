"""The costs in worlds that grow as a picture, logarithmic in both directions, a panel a family.

A band is the interval of the mean; where a size has none, it is as narrow as the line.  A square is
the mean of a size that is exact.
"""

from __future__ import annotations

import io
from math import ceil
from typing import TYPE_CHECKING, Any

from allworlds.reports.file_format import Format
from allworlds.reports.telling import ToldResult
from allworlds.verbs import GROWTH

if TYPE_CHECKING:
    from allworlds.studies.compare.growth import Growth

COLUMNS, SIDE = 3, 3.4
"""Panels side by side, and the side of one in inches."""


def growth_plot(telling: ToldResult) -> str:
    """An SVG document, equal for equal reports."""
    import matplotlib as mpl
    from matplotlib.figure import Figure

    from allworlds.studies.compare.growth import Growth

    report = telling.result
    assert isinstance(report, Growth)
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
    for name in report.names:
        rows = [row for row in report.rows if (row.family, row.explorer) == (family, name)]
        if rows:
            edges = [row.edges for row in rows]
            (line,) = panel.plot(
                edges, [row.mean for row in rows], label=name, marker="o", markersize=3, linewidth=1
            )
            bands = [row.interval or (row.mean, row.mean) for row in rows]
            low, high = zip(*bands, strict=True)
            panel.fill_between(edges, low, high, color=line.get_color(), alpha=0.25, linewidth=0)
            exact = [(row.edges, row.mean) for row in rows if row.exact]
            if exact:
                square = {"color": line.get_color(), "marker": "s", "linestyle": "none"}
                panel.plot(*zip(*exact, strict=True), label=f"{name}, exact", **square)
    panel.set(title=family, xlabel="edges", ylabel="traversals", xscale="log", yscale="log")
    panel.legend(fontsize="x-small")


FORMAT = Format(growth_plot, ".svg", (GROWTH,), ("matplotlib", "figures", "a file .svg"))
