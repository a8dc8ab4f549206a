"""Telling of ``optimum``: the fewest traversals, beside built-in explorers."""

from __future__ import annotations

from collections.abc import Iterable

from allworlds.reports.telling import (
    Cell,
    Headline,
    Section,
    Shown,
    ToldFacts,
    ToldResult,
    ToldTable,
    so_far,
)
from allworlds.studies.optimum import OptimumReport, OptimumRow
from allworlds.words import plural

MEANING = (
    "the fewest traversals with which an explorer that knows the number of edges can map every "
    "world; the others do not know it, and go first in, first out"
)


def optimum_telling(report: OptimumReport) -> ToldResult:
    """A row for each number of edges: the optimum, and the worst cost of each explorer."""
    names = [*report.rows[0].explorers] if report.rows else []
    rows = [_row(row, names) for row in report.rows]
    table = ToldTable(["edges", "runs", "optimum", *names], rows, "Traversals in the worst world")
    facts = [("optimum", MEANING)]
    if all(row.agrees for row in report.rows):
        text = "each strategy was followed in every world, and costs what was found"
        facts.append(("replay", text))
    sections = [Section("seen", "", [table, ToldFacts(facts)])]
    return ToldResult("allworlds optimum", "every explorer", report, _headline(report), sections)


def _headline(report: OptimumReport) -> Headline | None:
    wrong = next((row for row in report.rows if not row.agrees), None)
    if wrong is not None:
        return Headline("MISMATCH", _mismatch(wrong), "error")
    done = None
    if report.rows:
        last = report.rows[-1]
        found = plural(last.optimum if last.optimum is not None else last.at_least, "traversal")
        more = "" if last.optimum is not None else " or more"
        done = Headline("OPTIMUM", f"{found}{more}, with {plural(last.edges, 'edge')}")
    return so_far(report, done)


def _row(row: OptimumRow, names: Iterable[str]) -> list[Cell]:
    found: Cell = row.optimum
    if row.optimum is None:
        found = Shown(f"{row.at_least} or more", f"{row.at_least} or more")
    return [row.edges, row.runs, found, *map(row.explorers.get, names)]


def _mismatch(row: OptimumRow) -> str:
    costs = "is wrong in some world" if row.replayed is None else f"costs {row.replayed}"
    return f"for {row.edges} edges the optimum is {row.optimum}, but its strategy {costs}"
