"""Plot how the work grows with the number of edges: worlds, and seconds of the compiled engine.

pip install '.[figures]'
python benchmarks/growth.py growth.svg --edges 8
"""

from __future__ import annotations

import argparse
import time
from pathlib import Path

from allworlds import check
from allworlds.engines.listeners import Listener

FROM_EDGES = 4
"""Smaller levels take less time than starting does."""


class Clock(Listener):
    """A listener that notes when each level begins, and how many worlds it holds."""

    def __init__(self) -> None:
        self.worlds: dict[int, int] = {}
        self.starts: dict[int, float] = {}

    def level(self, edges: int, worlds: int) -> None:
        """Note both."""
        self.worlds[edges], self.starts[edges] = worlds, time.perf_counter()


def measure(edges: int, workers: int) -> dict[int, tuple[int, float]]:
    """``{m: (worlds, seconds)}`` of one check, from FROM_EDGES on; compiled before."""
    check(edges=6, engine="kernel").uninterrupted()
    clock = Clock()
    check(edges=edges, engine="kernel", workers=workers, listener=clock).uninterrupted()
    ends = [*list(clock.starts.values())[1:], time.perf_counter()]
    return {
        m: (clock.worlds[m], end - start)
        for (m, start), end in zip(clock.starts.items(), ends, strict=True)
        if m >= FROM_EDGES
    }


def plot(measured: dict[int, tuple[int, float]], file: Path) -> None:
    """Both curves over m, on a logarithmic scale."""
    import matplotlib as mpl

    mpl.use("Agg")
    from matplotlib import pyplot as plt

    figure, left = plt.subplots(figsize=(6, 4), layout="constrained")
    right = left.twinx()
    edges = list(measured)
    left.semilogy(edges, [worlds for worlds, _ in measured.values()], "o-", color="C0")
    right.semilogy(edges, [seconds for _, seconds in measured.values()], "s--", color="C1")
    left.set_xlabel("edges m")
    left.set_ylabel("rooted maps with m edges", color="C0")
    right.set_ylabel("seconds for the level", color="C1")
    left.set_xticks(edges)
    figure.savefig(file)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description="Plot how the work grows with the edges.")
    parser.add_argument("file", type=Path, help="SVG or PNG")
    parser.add_argument("--edges", type=int, default=8)
    parser.add_argument("--workers", type=int, default=1)
    options = parser.parse_args()
    measured = measure(options.edges, options.workers)
    for m, (worlds, seconds) in measured.items():
        print(f"m = {m}: {worlds:,} worlds in {seconds:.3f} s")
    plot(measured, options.file)
