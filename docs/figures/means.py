"""Print the means of figure 3's data, a line for each family, size and explorer.

    allworlds paper figure 3 --out figure-3.svg
    python docs/figures/means.py figure-3.csv > docs/figures/figure-3-means.csv

The data themselves have a line for each of 2,520 runs.
"""

from __future__ import annotations

import csv
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from statistics import mean, stdev


def means(rows: Iterable[dict[str, str]]) -> Iterator[list[object]]:
    """The header, and the lines in the order in which they first occur."""
    kinds: dict[tuple[str, ...], list[int]] = {}
    for row in rows:
        key = (*(row[name] for name in KEYS), *(row[name] for name in SAME))
        kinds.setdefault(key, []).append(int(row["traversals"]))
    yield [*KEYS, "graphs", "mean", "standard_error", *SAME]
    for key, costs in kinds.items():
        error = stdev(costs) / len(costs) ** 0.5 if len(costs) > 1 else 0.0
        spread = [len(costs), f"{mean(costs):.2f}", f"{error:.2f}"]
        yield [*key[: len(KEYS)], *spread, *key[len(KEYS) :]]


KEYS = ("family", "vertices", "edges", "explorer")
SAME = ("bound_1_plus_2", "twice_the_edges")


if __name__ == "__main__":
    with Path(sys.argv[1]).open(encoding="utf-8", newline="") as file:
        csv.writer(sys.stdout, lineterminator="\n").writerows(means(csv.DictReader(file)))
