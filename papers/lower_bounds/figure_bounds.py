"""The bound examined: exact worst cases over all schedules, beside known lower bounds."""

from __future__ import annotations

import argparse
import sys
from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from msgspec import Struct

from adversary import against
from allworlds import worlds, worst
from corridors import usual_shape
from drawn import Table, write
from optima import fewest_traversals
from testers import paper_bound

MOST_OPTIMAL = 3
"""The largest number of edges for which the optimum is searched for: some seconds."""

MOST_FAR = 3
"""The largest number of far hubs of the corridors in which an adversary plays: some seconds."""


class BoundsCell(Struct, frozen=True):
    """The worlds of one size.

    Attributes:
        edges, vertices: the size.
        worst: the largest cost of Algorithm 1, over all worlds and all schedules.
        best: the largest, over the worlds, of the cost of the best schedule.
        optimum: the best worst case of an explorer that knows both numbers; None where it was
            not searched for.
    """

    edges: int
    vertices: int
    worst: int
    best: int
    optimum: int | None

    @property
    def bound(self) -> int:
        """The bound (1) + (2)."""
        return paper_bound(self.vertices, self.edges)


class CorridorCell(Struct, frozen=True):
    """Corridors with one number of far hubs.

    Attributes:
        far: that number.
        edges, vertices: the size.
        cost: that of Algorithm 1 against the adversary.
        least: the least cost of a tester against it, by the theorem.
    """

    far: int
    edges: int
    vertices: int
    cost: int
    least: int

    @property
    def bound(self) -> int:
        """The bound (1) + (2)."""
        return paper_bound(self.vertices, self.edges)


class BoundsFigure(Struct, frozen=True):
    """Worst cases and optima by size, and costs against the adversary of corridors.

    Attributes:
        report: the worst cases, counted and replayed.
        cells: ascending by edges and vertices.
        corridors: ascending by far hubs.
    """

    report: Any
    cells: tuple[BoundsCell, ...]
    corridors: tuple[CorridorCell, ...]

    @property
    def right(self) -> bool:
        """Whether no schedule exceeds the bound, and no cost is below a known lower bound."""
        kept = all(cell.edges <= cell.best <= cell.worst <= cell.bound for cell in self.cells)
        possible = all(cell.optimum is None or cell.optimum <= cell.worst for cell in self.cells)
        between = all(cell.least <= cell.cost <= cell.bound for cell in self.corridors)
        return bool(self.report.agrees and kept and possible and between)

    def table(self) -> Table:
        """Rows, one for each size."""
        header = ["edges", "vertices", "bound_1_plus_2", "worst", "best_schedule"]
        header += ["optimum", "every_edge_once", "far_hubs", "adversary", "testers_at_least"]
        rows = [
            [c.edges, c.vertices, c.bound, c.worst, c.best, c.optimum, c.edges, None, None, None]
            for c in self.cells
        ]
        return header, rows + [
            [c.edges, c.vertices, c.bound, None, None, None, c.edges, c.far, c.cost, c.least]
            for c in self.corridors
        ]

    def caption(self) -> Sequence[str]:
        """The lines that stand below the figure."""
        if not self.cells:
            return ("Interrupted before anything was known.",)
        tight = [cell for cell in self.cells if cell.worst == cell.bound and cell.vertices > 1]
        sizes = ", ".join(f"m = {cell.edges}, n = {cell.vertices}" for cell in tight)
        loosest = max(self.cells, key=lambda cell: cell.bound / cell.worst)
        times = f"{loosest.bound / loosest.worst:.1f}"
        shown = (
            "A panel for each number of vertices n: the bound (1)+(2) of Algorithm 1; its exact "
            "worst cost over all worlds with m edges and every schedule (each choice of edge, "
            "order of hypotheses and path); the cost in the world that is worst under the schedule "
            "that is best for it; the optimum; and m, for who does not know m must walk every edge."
        )
        optimum = (
            "The optimum is the best worst case of any explorer, here of one that knows m and n "
            f"(exact minimax, m <= {MOST_OPTIMAL}). Knowing m it need not walk the last edge, so "
            "it can lie below m; it can lie above the best schedule, which is chosen by one who "
            "knows the world."
        )
        attained = (
            f"With n = 1 the bound is the worst case; else it is attained with {sizes}. It is "
            f"loosest with m = {loosest.edges}, n = {loosest.vertices}, where it is {times} times "
            f"the worst case: {loosest.bound} and {loosest.worst}."
        )
        corridors = (
            "The last panel: corridors, a family in which every tester of hypotheses needs the "
            "order of (1)+(2). There Algorithm 1 plays against an adversary that decides the "
            "world as late as it can; below it the cost that is proved for every tester."
        )
        return shown, optimum, attained, corridors

    def draw(self, figure: Any) -> None:
        """Draw a panel for each number of vertices."""
        by_vertices = defaultdict(list)
        for cell in self.cells:
            by_vertices[cell.vertices].append(cell)
        columns = 3
        lines = -(-(len(by_vertices) + 1) // columns)
        figure.set_size_inches(10, 3 * lines + 0.6)
        panels = figure.subplots(lines, columns, squeeze=False).flat
        for (vertices, cells), panel in zip(sorted(by_vertices.items()), panels, strict=False):
            _panel(panel, vertices, cells)
        _corridors(figure.axes[len(by_vertices)], self.corridors)
        for panel in figure.axes[len(by_vertices) + 1 :]:
            panel.set_visible(False)
        first = figure.axes[0].get_legend_handles_labels()
        figure.legend(*first, loc="outside lower center", ncols=5, fontsize="small")


def _panel(axes: Any, vertices: int, cells: Sequence[BoundsCell]) -> None:
    edges = [cell.edges for cell in cells]
    axes.plot(edges, [c.bound for c in cells], "k_-", linewidth=1, label="bound (1)+(2)")
    axes.plot(edges, [c.worst for c in cells], "o-", markersize=4, label="worst, all schedules")
    axes.plot(edges, [c.best for c in cells], "s-", markersize=3, label="worst, best schedule")
    known = [(c.edges, c.optimum) for c in cells if c.optimum is not None]
    axes.plot(*zip(*known, strict=True) if known else ([], []), "D", label="optimum")
    axes.plot(edges, edges, "k:", linewidth=1, label="m")
    axes.set(title=f"n = {vertices}", xlabel="edges", ylabel="traversals", ylim=(0, None))
    axes.set_xticks(edges)


def _corridors(axes: Any, cells: Sequence[CorridorCell]) -> None:
    edges = [cell.edges for cell in cells]
    axes.plot(edges, [c.bound for c in cells], "k_-", linewidth=1)
    axes.plot(edges, [c.cost for c in cells], "o-", markersize=4, label="against the adversary")
    axes.plot(edges, [c.least for c in cells], "v-", markersize=4, label="every tester, proved")
    axes.plot(edges, edges, "k:", linewidth=1)
    axes.set(title="corridors", xlabel="edges", ylabel="traversals", yscale="log")
    axes.set_xticks(edges)
    axes.legend(fontsize="x-small")


def figure_bounds(edges: int) -> BoundsFigure:
    """Compute worst cases for all sizes up to the limit, optima and costs in corridors.

    Optima and corridors go as far as some seconds allow.
    """
    report = worst(edges=edges)
    optima = _optima(min(edges, MOST_OPTIMAL))
    cells = [
        BoundsCell(r.edges, r.vertices, r.worst, r.best, optima.get((r.edges, r.vertices)))
        for r in report.rows
    ]
    return BoundsFigure(report, tuple(cells), tuple(map(_in_corridors, range(1, MOST_FAR + 1))))


def _in_corridors(far: int) -> CorridorCell:
    shape = usual_shape(far)
    cost = against("algorithm1", shape, 1).cost
    return CorridorCell(far, shape.edges, shape.hubs + 1, cost, shape.bound_of_testers)


def _optima(edges: int) -> dict[tuple[int, int], int]:
    """The optimum of each size, for explorers that know it."""
    given = defaultdict(list)
    for world in worlds(edges=edges, places="all"):
        given[world.map.edge_count, world.map.vertex_count].append(world)
    return {size: fewest_traversals(some) for size, some in given.items()}


def main() -> int:
    """Draw the figure: ``python papers/lower_bounds/figure_bounds.py [--edges M] [--out FILE]``."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--edges", type=int, default=6, help="at most M edges (default: 6)")
    parser.add_argument("--out", type=Path, default=Path("figure-bounds.svg"))
    asked = parser.parse_args()
    return 0 if write(figure_bounds(asked.edges), asked.out) else 1


if __name__ == "__main__":
    sys.exit(main())
