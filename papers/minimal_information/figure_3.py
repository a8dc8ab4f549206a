"""Fig. 3: the cost in lattices and dense graphs of growing size, 10 % of the edges removed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from msgspec import Struct

from allworlds.engines import Limits, Silent, subject_of
from allworlds.studies.compare import (
    LEVEL,
    CompareRequest,
    Contestant,
    GrowingWorlds,
    GrowRow,
    Growth,
    Member,
    drawn_places,
)
from drawn import Table
from formulas import paper_bound, printed_bound

HOLES, PLACES = "10%", 4
"""Of the edges of a graph, and the directions of the marker in it that are run."""

LADDERS: Mapping[str, tuple[str, ...]] = {
    "lattice": tuple(f"lattice:{n}x{n}" for n in (4, 5, 6, 8, 10, 12)),
    "dense": tuple(f"dense:{n}" for n in (6, 9, 12, 16, 20, 24)),
}
"""The graphs of each family before edges are removed: squares, and complete graphs."""

OTHERS = Path(__file__).parents[1] / "lower_bounds" / "explorers.py"

WHO = (
    ("algorithm1", "fifo"),
    ("algorithm1", "lifo"),
    ("algorithm1", "nearest"),
    (f"{OTHERS}:remembering", "fifo"),
    (f"{OTHERS}:greedy", ""),
    (f"{OTHERS}:prudent", ""),
    ("dudek91", "fifo"),
)
"""Explorers, each with the policy that answers its choices, if it asks any."""

TITLES = {
    "lattice": "lattices, 10 % of the edges removed",
    "dense": "dense graphs, 10 % of the edges removed",
}


class Holes(Struct, frozen=True):
    """Costs of the runs.

    Attributes:
        growth: of every explorer in every graph.
        worlds: how many graphs of each size.
        seed: of the first of them.
    """

    growth: Growth
    worlds: int
    seed: int

    @property
    def right(self) -> bool:
        """Whether no run broke a law."""
        return not self.growth.facts.refuted

    def table(self) -> Table:
        """Rows, one for each run."""
        header = ["family", "vertices", "edges", "explorer", "world", "place", "traversals"]
        header += ["bound_1_plus_2", "bound_3_as_printed", "twice_the_edges"]
        return header, [
            [
                row.family,
                row.vertices,
                row.edges,
                row.explorer,
                one.name,
                place,
                cost,
                paper_bound(row.vertices, row.edges),
                round(printed_bound(row.vertices, row.edges)),
                2 * row.edges,
            ]
            for row in self.growth.rows
            for one in row.members
            for place, cost in zip(one.ran, one.costs, strict=True)
        ]

    def caption(self) -> Sequence[str]:
        """The lines that stand below the figure."""
        last = {row.family: row for row in self.growth.rows if row.explorer == _name(*WHO[0])}
        runs = sum(row.runs for row in self.growth.rows)
        sentences = [
            (
                f"Traversals by edges, means with their {LEVEL:.0%} intervals by a bootstrap over "
                f"{self.worlds} graphs a size, in each over at most {PLACES} directions of the "
                f"marker, which are drawn; seeds {self.seed} to {self.seed + self.worlds - 1}: "
                "squares of a lattice and complete graphs, "
                f"without {HOLES} of their edges, removed at random while the "
                f"rest stays connected. Every one of the {runs:,} runs was judged. Above linear "
                "axes, which the bounds leave at once; below the same with logarithmic ones."
            ),
        ]
        for family, row in last.items():
            bound = paper_bound(row.vertices, row.edges)
            sentences.append(
                f"{family}, m = {row.edges}: Algorithm 1 (fifo) walks {row.mean:,.0f}, {bound:,} "
                f"is its bound (1)+(2), {bound / row.mean:,.0f} times as much."
            )
        above = all(row.mean > 2 * row.edges for row in self.growth.rows)
        sentences.append(
            "As the paper says, the cost lies far below the bound. 2m, which it calls a lower "
            "bound, is none: a cycle is mapped by m traversals; here "
            + ("every mean lies above it." if above else "some means lie below it, too.")
        )
        sentences.append(
            "(3) as it is printed lacks 5mn and lies below (1)+(2); beside 2m^2 n that is little "
            "at these sizes."
        )
        sentences.append(
            "The paper does not say which edge is explored next: first in, first out (fifo), last "
            "in, first out (lifo) and the nearest are three answers. `dudek91` carries a marker "
            "that it may drop and pick up, and has another bound."
        )
        return sentences

    def draw(self, figure: Any) -> None:
        """Draw, for each family, linear axes above logarithmic ones."""
        families = [family for family in LADDERS if any(self._rows(family))]
        figure.set_size_inches(11, 9)
        panels = figure.subplots(2, max(1, len(families)), squeeze=False)
        for column, family in enumerate(families):
            for line, scale in enumerate(("linear", "log")):
                self._panel(panels[line][column], family, scale)
        handles, labels = panels[0][0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside lower center", ncols=5, fontsize="small")

    def _rows(self, family: str) -> Iterator[GrowRow]:
        return (row for row in self.growth.rows if row.family == family)

    def _panel(self, axes: Any, family: str, scale: str) -> None:
        highest = 0.0
        for explorer in self.growth.names:
            rows = [row for row in self._rows(family) if row.explorer == explorer]
            means = [row.mean for row in rows]
            highest = max([highest, *means])
            low, high = zip(*(row.interval or (row.mean, row.mean) for row in rows), strict=True)
            at = [row.edges for row in rows]
            (line,) = axes.plot(at, means, label=explorer, marker="o", markersize=3, linewidth=1.2)
            axes.fill_between(at, low, high, color=line.get_color(), alpha=0.25, linewidth=0)
        sizes = sorted({(row.edges, row.vertices) for row in self._rows(family)})
        edges = [m for m, _ in sizes]
        for label, style, values in (
            ("bound (1)+(2)", "-", [paper_bound(n, m) for m, n in sizes]),
            ("(3) as printed", ":", [printed_bound(n, m) for m, n in sizes]),
            ("2m", "--", [2 * m for m in edges]),
        ):
            axes.plot(edges, values, style, color="black", linewidth=1, label=label)
        axes.set(title=TITLES[family], xlabel="edges", ylabel="traversals")
        if scale == "log":
            axes.set(xscale="log", yscale="log")
            axes.set_xticks(edges, labels=list(map(str, edges)))
            axes.set_xticks([], minor=True)
        else:
            axes.set(ylim=(0, 1.08 * highest))


def figure_3(worlds: int = 30, seed: int = 1) -> Holes:
    """Run every explorer in every graph. Cost: some minutes."""
    limits = Limits()
    ladders = {
        family: [[Member(text, HOLES, seed + number) for number in range(worlds)] for text in texts]
        for family, texts in LADDERS.items()
    }
    contestants = [_contestant(name, policy, limits) for name, policy in WHO]
    effort = CompareRequest(listener=Silent())
    sweep = GrowingWorlds(contestants, ladders, effort, partial(drawn_places, most=PLACES))
    return Holes(sweep.answer(None), worlds, seed)


def _contestant(name: str, policy: str, limits: Limits) -> Contestant:
    subject = subject_of(name, limits)
    request = CompareRequest(policy=policy) if policy else CompareRequest()
    return Contestant(subject, request.rules(subject), _name(name, policy))


def _name(explorer: str, policy: str) -> str:
    own = explorer.rpartition(":")[2]
    return f"{own}, {policy}" if policy else own
