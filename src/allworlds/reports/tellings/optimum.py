"""Telling of ``optimum``: the fewest traversals, beside built-in explorers."""

from __future__ import annotations

from collections.abc import Iterable

from allworlds.reports.rows import CsvRows
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

OF_ALL = (
    "the fewest traversals with which an explorer that knows the number of edges can map every "
    "world; the others do not know it, and go first in, first out"
)
OF_BOUQUETS = (
    "the fewest traversals with which an explorer can map every bouquet, if it knows the number of "
    "loops, and that v0 has degree 1 and is joined to the vertex with the loops"
)
OTHER_BOUNDS = (
    "information: with less no explorer can tell so many worlds apart, as counting alone says; "
    "cautious: the worst cost of explorers that test one hypothesis after the other"
)
STATES = "the number of states of knowledge that the search has looked into"


def optimum_telling(report: OptimumReport) -> ToldResult:
    """A row for each number of edges or loops: the optimum, and the worst cost of others."""
    if report.rows and report.rows[0].loops:
        header = ["loops", "worlds", "optimum", "information", "cautious", "states"]
        rows = [_row_of_bouquets(row) for row in report.rows]
        facts = [("optimum", OF_BOUQUETS), ("bounds", OTHER_BOUNDS), ("states", STATES)]
    else:
        names = [*report.rows[0].explorers] if report.rows else []
        header = ["edges", "runs", "optimum", *names]
        rows = [_row(row, names) for row in report.rows]
        facts = [("optimum", OF_ALL)]
    table = ToldTable(header, rows, "Traversals in the worst world")
    if all(row.agrees for row in report.rows):
        text = "each strategy was followed in every world, and costs what was found"
        facts.append(("replay", text))
    sections = [Section("seen", "", [table, ToldFacts(facts)])]
    return ToldResult(
        "allworlds optimum",
        "every explorer",
        report,
        _headline(report),
        sections,
        rows=lambda: _rows(report),
    )


def _rows(report: OptimumReport) -> CsvRows:
    """A row for each number of edges and explorer, with the explorer's worst cost."""
    columns = {"edges": int, "runs": int, "at_least": int, "optimum": int}
    rows = [
        [row.edges, row.runs, row.at_least, row.optimum, name, cost]
        for row in report.rows
        for name, cost in row.explorers.items() or [(None, None)]
    ]
    return CsvRows({**columns, "explorer": str, "worst": int}, rows)


def _headline(report: OptimumReport) -> Headline | None:
    wrong = next((row for row in report.rows if not row.agrees), None)
    if wrong is not None:
        return Headline("MISMATCH", _mismatch(wrong), "error")
    done = None
    if report.rows:
        last = report.rows[-1]
        traversals = "traversal" if last.optimum == 1 else "traversals"
        done = Headline("OPTIMUM", f"{_bounds(last)} {traversals}, with {_size(last)}")
    return so_far(report, done)


def _size(row: OptimumRow) -> str:
    return plural(row.loops, "loop") if row.loops else plural(row.edges, "edge")


def _bounds(row: OptimumRow) -> str:
    """The optimum, or the bounds on both sides."""
    most = row.cautious if row.at_most is None else row.at_most
    if most is None:
        return f"{row.at_least} or more"
    return str(row.optimum) if row.optimum is not None else f"{row.at_least} to {most}"


def _optimum(row: OptimumRow) -> Cell:
    return Shown(_bounds(row), _bounds(row)) if row.optimum is None else row.optimum


def _row(row: OptimumRow, names: Iterable[str]) -> list[Cell]:
    return [row.edges, row.runs, _optimum(row), *map(row.explorers.get, names)]


def _row_of_bouquets(row: OptimumRow) -> list[Cell]:
    return [row.loops, row.runs, _optimum(row), row.information, row.cautious, row.states]


def _mismatch(row: OptimumRow) -> str:
    costs = "is wrong in some world" if row.replayed is None else f"costs {row.replayed}"
    return f"with {_size(row)} a strategy is said to cost {row.at_most}, but it {costs}"
