"""Beyond the paper: the best worst case of any explorer, and explorers that never forget."""

from __future__ import annotations

from allworlds.evidence.claims.claim_types import (
    Checks,
    Found,
    Means,
    Picture,
    Unfinished,
    of_check,
    truth,
)
from allworlds.outcome import Exit, Verdict
from allworlds.studies.check import check
from allworlds.studies.optimum import optimum
from allworlds.studies.run import run
from allworlds.world import worlds


def best_of_all(_: Means, *, edges: int) -> Found:
    """Find the optimum by minimax over all worlds with m known.

    Each strategy is followed in each world.
    """
    report = optimum(edges=edges).uninterrupted()
    if report.exit_code != Exit.ANSWERED:
        raise Unfinished(f"the optimum ended with exit code {report.exit_code}")
    best = [row.optimum or 0 for row in report.rows]
    squares = all(
        value == (row.edges - 1) ** 2 for value, row in zip(best, report.rows, strict=True)
    )
    runs = sum(row.runs for row in report.rows)
    return Found(truth(squares), {"runs": runs}, {"optimum": best})


def run_by_run(_: Means, *, edges: int, one: str, other: str) -> Found:
    """Compare two explorers, first in, first out, in every run: the one never walks more."""
    runs = less = more = 0
    most_expensive = None
    for world in worlds(edges=edges, places="all"):
        costs = []
        for name in (one, other):
            told = run(name, world)
            if told.verdict is not Verdict.HOLDS:
                raise Unfinished(f"{name} breaks a law in {world}")
            costs.append(told.outcome.cost)
        runs += 1
        less += costs[0] < costs[1]
        more += costs[0] > costs[1]
        if costs[0] > costs[1] and most_expensive is None:
            most_expensive = world
    figures = (
        {}
        if most_expensive is None
        else {
            "runs with more": more,
            "edges": most_expensive.map.edge_count,
            "vertices": most_expensive.map.vertex_count,
        }
    )
    pictures = () if most_expensive is None else (Picture(f"{one} walks more", most_expensive),)
    return Found(truth(more == 0), {"runs": runs, "less": less}, figures, pictures)


def within_the_bound(means: Means, *, edges: int, explorers: list[str]) -> Found:
    """Check explorers that never forget under all laws, including the bound (1)+(2)."""
    seen: dict[str, int] = {}
    holds = True
    for name in explorers:
        found = of_check(
            check(name, edges=edges, bound="paper", workers=means.workers), "case-1", "case-2"
        )
        holds = holds and found.verdict == "holds"
        for witness, times in found.witnesses.items():
            seen[witness] = seen.get(witness, 0) + times
    return Found(truth(holds), seen)


CHECKS: Checks = {
    "optimum": best_of_all,
    "remembering-never-more": run_by_run,
    "greedy-never-more": run_by_run,
    "never-forgetting-in-bound": within_the_bound,
}
