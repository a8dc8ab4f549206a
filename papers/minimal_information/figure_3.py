"""Fig. 3: the cost in lattices and dense graphs of growing size, 10 % of the edges removed."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from itertools import groupby, islice
from pathlib import Path
from random import Random
from signal import SIG_IGN, SIGINT, signal
from typing import Any

from msgspec import Struct

from allworlds import CombinatorialMap, Percept, run
from allworlds.claims import mean_interval
from allworlds.maps import family, rooted_code
from drawn import Table
from formulas import paper_bound, printed_bound

HOLES = "10%"
"""Of the edges of a graph."""

LADDERS: Mapping[str, tuple[str, ...]] = {
    "lattice": tuple(f"lattice:{n}x{n}" for n in (4, 5, 6, 8, 10, 12)),
    "dense": tuple(f"dense:{n}" for n in (6, 9, 12, 16, 20, 24)),
}
"""The graphs of each family before edges are removed: squares, and complete graphs."""

WHO = (
    ("algorithm1", "fifo"),
    ("algorithm1", "lifo"),
    ("algorithm1", "nearest"),
    ("remembering", "fifo"),
    ("greedy", ""),
    ("prudent", ""),
    ("dudek91", "fifo"),
)
"""Explorers, each with the policy that answers its choices, if it asks any."""

OTHERS = Path(__file__).parents[1] / "lower_bounds"
"""The folder of the explorers that the package does not have."""

TITLES = {
    "lattice": "lattices, 10 % of the edges removed",
    "dense": "dense graphs, 10 % of the edges removed",
}


class Graph(Struct, frozen=True):
    """A graph of a family, with the words that name it on the command line."""

    text: str
    seed: int

    @property
    def name(self) -> str:
        """Words that name it: ``lattice:4x4 --holes 10% --seed 1``."""
        return f"{self.text} --holes {HOLES} --seed {self.seed}"

    def map(self) -> CombinatorialMap:
        """The map; a robot starts at dart 0."""
        return family(self.text, holes=0.1, seed=self.seed)


class Costs(Struct, frozen=True):
    """What one explorer walked in one graph.

    Attributes:
        family: of the graph.
        vertices, edges: of the graph.
        explorer: its name, and its policy.
        world: the words that name the graph.
        by_place: traversals, by the direction of the marker.
        right: whether no run broke a law.
    """

    family: str
    vertices: int
    edges: int
    explorer: str
    world: str
    by_place: Mapping[int, int]
    right: bool

    @property
    def mean(self) -> float:
        """Over the directions."""
        return sum(self.by_place.values()) / len(self.by_place)


class Size(Struct, frozen=True):
    """The costs of one explorer in the graphs of one size."""

    family: str
    vertices: int
    edges: int
    explorer: str
    costs: Sequence[Costs]

    @property
    def mean(self) -> float:
        """Over the graphs."""
        return sum(one.mean for one in self.costs) / len(self.costs)

    @property
    def interval(self) -> tuple[float, float]:
        """Of the mean, to six digits; both ends are the mean where there is none."""
        low, high = mean_interval([one.mean for one in self.costs]) or (self.mean, self.mean)
        return round(low, 6), round(high, 6)


class Holes(Struct, frozen=True):
    """Costs of the runs.

    Attributes:
        costs: of every explorer in every graph; those of a size and an explorer side by side.
        worlds: how many graphs of each size were drawn; isomorphic ones count once.
        seed: of the first of them.
        places: at most so many directions of the marker are run in a graph.
        complete: whether all was run; else the last sizes are not there.
    """

    costs: Sequence[Costs]
    worlds: int
    seed: int
    places: int
    complete: bool = True

    @property
    def right(self) -> bool:
        """Whether all was run, and no run broke a law."""
        return self.complete and all(one.right for one in self.costs)

    @property
    def sizes(self) -> list[Size]:
        """The costs by family, size and explorer."""
        kinds = groupby(self.costs, lambda c: (c.family, c.vertices, c.edges, c.explorer))
        return [Size(*kind, list(some)) for kind, some in kinds]

    def table(self) -> Table:
        """Rows, one for each run."""
        header = ["family", "vertices", "edges", "explorer", "world", "place", "traversals"]
        header += ["bound_1_plus_2", "bound_3_as_printed", "twice_the_edges"]
        return header, [
            [
                one.family,
                one.vertices,
                one.edges,
                one.explorer,
                one.world,
                place,
                cost,
                paper_bound(one.vertices, one.edges),
                round(printed_bound(one.vertices, one.edges)),
                2 * one.edges,
            ]
            for one in self.costs
            for place, cost in one.by_place.items()
        ]

    def caption(self) -> Sequence[str]:
        """The lines that stand below the figure."""
        sizes = self.sizes
        last = {size.family: size for size in sizes if size.explorer == _name(*WHO[0])}
        runs = sum(len(one.by_place) for one in self.costs)
        shown = "" if mean_interval(range(1, self.worlds + 1)) is None else " with 95% intervals"
        sentences = [] if self.complete else ["Interrupted: the finished sizes alone."]
        sentences += [
            (
                f"Traversals by edges, means{shown} over {self.worlds} graphs a size, in each "
                f"over at most {self.places} directions of the marker, which are drawn; seeds "
                f"{self.seed} to {self.seed + self.worlds - 1}: squares of a lattice and complete "
                f"graphs, without {HOLES} of their edges, removed at random while the "
                f"rest stays connected. Every one of the {runs:,} runs was judged. Above linear "
                "axes, which the bounds leave at once; below the same with logarithmic ones."
            ),
        ]
        for name, row in last.items():
            bound = paper_bound(row.vertices, row.edges)
            sentences.append(
                f"{name}, m = {row.edges}: Algorithm 1 (fifo) walks {row.mean:,.0f}, {bound:,} "
                f"is its bound (1)+(2), {bound / row.mean:,.0f} times as much."
            )
        above = all(size.mean > 2 * size.edges for size in sizes)
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
        figure.set_size_inches(11, 9)
        panels = figure.subplots(2, len(LADDERS), squeeze=False)
        for column, name in enumerate(LADDERS):
            for line, scale in enumerate(("linear", "log")):
                self._panel(panels[line][column], name, scale)
        handles, labels = panels[0][0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside lower center", ncols=5, fontsize="small")

    def _panel(self, axes: Any, name: str, scale: str) -> None:
        shown = [size for size in self.sizes if size.family == name]
        for explorer in (_name(*who) for who in WHO):
            sizes = [size for size in shown if size.explorer == explorer]
            low, high = ([size.interval[end] for size in sizes] for end in (0, 1))
            at, means = [size.edges for size in sizes], [size.mean for size in sizes]
            (line,) = axes.plot(at, means, label=explorer, marker="o", markersize=3, linewidth=1.2)
            axes.fill_between(at, low, high, color=line.get_color(), alpha=0.25, linewidth=0)
        both = sorted({(size.edges, size.vertices) for size in shown})
        edges = [m for m, _ in both]
        for label, style, values in (
            ("bound (1)+(2)", "-", [paper_bound(n, m) for m, n in both]),
            ("(3) as printed", ":", [printed_bound(n, m) for m, n in both]),
            ("2m", "--", [2 * m for m in edges]),
        ):
            axes.plot(edges, values, style, color="black", linewidth=1, label=label)
        axes.set(title=TITLES[name], xlabel="edges", ylabel="traversals")
        if scale == "log" and edges:
            axes.set(xscale="log", yscale="log")
            axes.set_xticks(edges, labels=list(map(str, edges)))
            axes.set_xticks([], minor=True)
        else:
            axes.set(ylim=(0, 1.08 * max((size.mean for size in shown), default=1)))


def figure_3(worlds: int = 3, seed: int = 1, places: int = 2) -> Holes:
    """Run every explorer in every graph, from the smallest size of any family on.

    So what is finished when Ctrl-C is pressed is a part of each family.
    """
    sizes = [
        (number, name, distinct([Graph(text, seed + drawn) for drawn in range(worlds)]))
        for name, texts in LADDERS.items()
        for number, text in enumerate(texts)
    ]
    sizes.sort(key=lambda size: size[0])
    groups = [(name, graphs, who) for _, name, graphs in sizes for who in WHO]
    tasks = [(name, graph, *who) for name, graphs, who in groups for graph in graphs]
    costs: list[Costs] = []
    with ProcessPoolExecutor(initializer=partial(signal, SIGINT, SIG_IGN)) as processes:
        found = processes.map(partial(_costs, places), *zip(*tasks, strict=True))
        try:
            for _, graphs, _ in groups:
                costs += list(islice(found, len(graphs)))
            complete = True
        except KeyboardInterrupt:
            processes.shutdown(cancel_futures=True)
            complete = False
    costs.sort(key=lambda one: list(LADDERS).index(one.family))
    return Holes(costs, worlds, seed, places, complete)


def distinct(graphs: Sequence[Graph]) -> list[Graph]:
    """The graphs; of those that are isomorphic as rooted maps the first."""
    seen: dict[object, Graph] = {}
    for graph in graphs:
        map_ = graph.map()
        seen.setdefault(rooted_code(map_.sigma, map_.alpha, 0), graph)
    return list(seen.values())


def _costs(most: int, name: str, graph: Graph, explorer: str, policy: str) -> Costs:
    """What one explorer walks; the marker of ``dudek91`` lies in its hand, not in a direction."""
    map_ = graph.map()
    places = places_of(graph, 1 if explorer == "dudek91" else map_.degree_at[0], most)
    asked = {"family": graph.text, "holes": HOLES, "seed": graph.seed, "policy": policy or "fifo"}
    explore = _explore(explorer)
    told = {place: run(explore, place=place, **asked) for place in places}
    return Costs(
        family=name,
        vertices=map_.vertex_count,
        edges=map_.edge_count,
        explorer=_name(explorer, policy),
        world=graph.name,
        by_place={place: one.outcome.cost for place, one in told.items()},
        right=all(one.finding is None for one in told.values()),
    )


def places_of(graph: Graph, places: int, most: int) -> Sequence[int]:
    """The numbers of all places, or of some of them, drawn by the name of the graph."""
    if places <= most:
        return range(places)
    return sorted(Random(f"places/{graph.name}").sample(range(places), most))  # noqa: S311  # reproducible, not secret


def _explore(name: str) -> str | Callable[[Percept], Any]:
    """The explorer; one that the package does not have is played in this process."""
    if name not in ("remembering", "greedy", "prudent"):
        return name
    sys.path.append(str(OTHERS))
    import explorers

    explore = getattr(explorers, name)

    def played_here(first: Percept) -> Any:
        return (yield from explore(first))

    return played_here


def _name(explorer: str, policy: str) -> str:
    return f"{explorer}, {policy}" if policy else explorer
