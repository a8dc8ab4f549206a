"""Print the means of figure 3's data, a line for each family, size and explorer.

    python papers/minimal_information/figures.py 3 --graphs 9 --places 4 --out figure-3.svg
    python papers/minimal_information/figures/means.py figure-3.csv > figure-3-means.csv

The data themselves have a line for each run. A world counts with its mean over the directions of
the marker; low and high are the ends of the 95% interval.
"""

from __future__ import annotations

import csv
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from statistics import mean

from allworlds.claims import mean_interval


def means(rows: Iterable[dict[str, str]]) -> Iterator[list[object]]:
    """The header, and the lines in the order in which they first occur."""
    kinds: dict[tuple[str, ...], dict[str, list[int]]] = {}
    for row in rows:
        key = (*(row[name] for name in KEYS), *(row[name] for name in SAME))
        kinds.setdefault(key, {}).setdefault(row["world"], []).append(int(row["traversals"]))
    yield [*KEYS, "graphs", "runs", "mean", "low", "high", *SAME]
    for key, worlds in kinds.items():
        costs = [mean(some) for some in worlds.values()]
        ends = [f"{end:.2f}" for end in mean_interval(costs) or ()] or ["", ""]
        runs = sum(map(len, worlds.values()))
        found = [len(costs), runs, f"{mean(costs):.2f}", *ends]
        yield [*key[: len(KEYS)], *found, *key[len(KEYS) :]]


KEYS = ("family", "vertices", "edges", "explorer")
SAME = ("bound_1_plus_2", "twice_the_edges")


if __name__ == "__main__":
    with Path(sys.argv[1]).open(encoding="utf-8", newline="") as file:
        csv.writer(sys.stdout, lineterminator="\n").writerows(means(csv.DictReader(file)))
