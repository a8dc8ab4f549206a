"""The data of the tables and the figure of large worlds in the README.

    allworlds compare EXPLORER ... --family lattice,torus --to 200 --by world -o a.csv
    python papers/lower_bounds/figures/growth.py a.csv ... > papers/lower_bounds/figures/growth.csv

keeps the columns of numbers: family and seed name each world, so that its code is left out.
"""

from __future__ import annotations

import csv
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TypeAlias

FILE = Path(__file__).with_suffix(".csv")
COLUMNS = (
    *("family", "seed", "edges", "vertices", "drawn_from", "explorer"),
    *("runs", "places", "mean", "worst", "bound"),
)

Row: TypeAlias = dict[str, str]
Costs: TypeAlias = dict[int, list[float]]
"""The mean cost in each world, by the number of edges."""


def kept(rows: Iterable[Row]) -> Iterator[Row]:
    """The columns that are kept, of each row; an explorer has its name without its file."""
    some = ({name: row[name] for name in COLUMNS} for row in rows)
    return ({**row, "explorer": row["explorer"].rpartition(":")[2]} for row in some)


def read(file: Path = FILE) -> list[Row]:
    """The rows of a file."""
    with file.open(encoding="utf-8", newline="") as opened:
        return [*csv.DictReader(opened)]


def by_family(rows: Iterable[Row]) -> dict[str, list[Row]]:
    """The rows of each family, by its name without a size."""
    found: dict[str, list[Row]] = {}
    for row in rows:
        found.setdefault(row["family"].partition(":")[0], []).append(row)
    return found


def costs(rows: Iterable[Row], explorer: str) -> Costs:
    """The costs of one explorer in rows of one family."""
    found: Costs = {}
    for row in rows:
        if row["explorer"] == explorer:
            found.setdefault(int(row["edges"]), []).append(float(row["mean"]))
    return dict(sorted(found.items()))


def exact_sizes(rows: Iterable[Row], explorer: str) -> set[int]:
    """The numbers of edges of which every world that a seed can draw was run, in every place."""
    sizes: dict[int, list[Row]] = {}
    for row in rows:
        if row["explorer"] == explorer:
            sizes.setdefault(int(row["edges"]), []).append(row)
    return {
        edges
        for edges, some in sizes.items()
        if some[0]["drawn_from"] == str(len(some))
        and all(row["runs"] == row["places"] for row in some)
    }


if __name__ == "__main__":
    writer = csv.DictWriter(sys.stdout, COLUMNS, lineterminator="\n")
    writer.writeheader()
    for name in sys.argv[1:]:
        writer.writerows(kept(read(Path(name))))
