"""Telling of ``count``: maps by size, beside their source."""

from __future__ import annotations

from allworlds.reports.rows import Rows
from allworlds.reports.telling import (
    Headline,
    Section,
    ToldFacts,
    ToldResult,
    ToldTable,
    interruption,
)
from allworlds.studies.count import Census
from allworlds.words import counted, plural


def count_telling(census: Census) -> ToldResult:
    """A row for each number of edges, and the source with which the counts were compared."""
    rows = [
        [
            row.edges,
            row.rooted,
            row.unrooted,
            " ".join(f"{n}:{count}" for n, count in row.by_vertices.items()),
        ]
        for row in census.rows
    ]
    table = ToldTable(["edges", "rooted", "unrooted", "rooted by vertices"], rows, "Maps")
    facts = interruption(complete=census.complete, stopped=census.stopped)
    total = sum(row.rooted for row in census.rows)
    found = f"{plural(total, 'rooted map')} of the class {census.map_class}"
    headline = Headline("COUNTED", found)
    if census.gate is None:
        facts.append(("gate", f"absent: no source counts the maps that are {census.where}"))
    elif census.gate.agrees:
        facts.append(("gate", f"no map was forgotten: {counted(census.gate.source)}"))
    else:
        wrong = [_mismatch(census, i) for i, row in enumerate(census.rows) if not row.agrees]
        headline = Headline("MISMATCH", "; ".join(wrong), "error")
    sections = [Section("seen", "", [table, ToldFacts(facts)])]
    return ToldResult(
        "allworlds count",
        f"class {census.map_class}",
        census,
        headline,
        sections,
        rows=lambda: _rows(census),
    )


def _rows(census: Census) -> Rows:
    """A row for each number of edges, of vertices, and genus."""
    columns = {"edges": int, "vertices": int, "genus": int, "rooted": int, "unrooted": int}
    rows = [[row.edges, *cell] for row in census.rows for cell in row.cells]
    return Rows(columns, rows)


def _mismatch(census: Census, i: int) -> str:
    row = census.rows[i]
    assert census.gate is not None
    return (
        f"with {plural(row.edges, 'edge')} {row.by_vertices} were enumerated, but "
        f"{census.gate.source} counts {row.counted}"
    )
