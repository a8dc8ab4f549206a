"""How long searches for twins take on this machine, formulas, proofs and checks included.

    python benchmarks/search.py [--further] [--solver PATH]

One line a question: the answer, the seconds, and of those the ones for writing formulas and
solving them; the rest is for proofs.  Nothing is asserted.  ``--further``: directional, m = 6.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from typing import Any

import allworlds

FIG_1 = {
    "degree_marked": 4,
    "degree_others": 3,
    "motions": (1, 1, 2, 2, 1),
    "percepts": ("3A", "3A", "3A", "3A", "4P"),
}
QUESTIONS: dict[str, dict[str, Any]] = {
    "position, any map, m <= 2": {"lighthouse": "position", "edges": 2},
    "position, simple, m <= 5": {"lighthouse": "position", "map_class": "simple", "edges": 5},
    "position, simple, m <= 6": {"lighthouse": "position", "map_class": "simple", "edges": 6},
    "position, planar simple, m <= 8": {
        "lighthouse": "position",
        "map_class": "planar-simple",
        "edges": 8,
    },
    "Fig. 1: planar simple, n <= 9, m <= 14": {
        "lighthouse": "position",
        "map_class": "planar-simple",
        "edges": 14,
        **FIG_1,
    },
    "directional, any map, m <= 5": {"lighthouse": "directional", "edges": 5},
}
FURTHER = {"directional, any map, m <= 6": {"lighthouse": "directional", "edges": 6}}


def measured(question: dict[str, Any], solver: str | None) -> str:
    """Answer and seconds."""
    with tempfile.TemporaryDirectory() as out:
        start = time.perf_counter()
        result = allworlds.search(vertices=9, out=out, solver=solver, **question)
        seconds = time.perf_counter() - start
    solving = sum(searched.seconds for searched in result.levels)
    proofs = sum(searched.proof is not None for searched in result.levels)
    return f"{result.status:<7} {seconds:8.1f} {solving:8.1f} {proofs:7}"


def main() -> None:
    """The table."""
    parser = argparse.ArgumentParser(description="Time the searches for twins.")
    parser.add_argument("--further", action="store_true")
    parser.add_argument("--solver", help="a CaDiCaL 2 or later, in place of z3")
    options = parser.parse_args()
    print(f"{'question':<40} {'answer':<7} {'seconds':>8} {'solving':>8} {'proofs':>7}")
    for name, question in (QUESTIONS | (FURTHER if options.further else {})).items():
        print(f"{name:<40} {measured(question, options.solver)}", flush=True)


if __name__ == "__main__":
    main()
