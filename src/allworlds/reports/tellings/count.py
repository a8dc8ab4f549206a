"""Telling of ``count``: maps by size, beside their source."""

from __future__ import annotations

from allworlds.reports.rows import CsvRows
from allworlds.reports.telling import (
    Headline,
    Section,
    ToldFacts,
    ToldResult,
    ToldTable,
    so_far,
)
from allworlds.reports.tellings.scope import finished, gate_told, maps_words
from allworlds.studies.count import Census
from allworlds.words import plural


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
    table = ToldTable(["edges", "rooted", "unrooted", "rooted by vertices"], rows, "Maps by size")
    facts = [("scope", maps_words(census))]
    if census.agrees:
        facts += gate_told(census, "map", census.source, rows=bool(rows))
    sections = [Section("seen", "", [table, ToldFacts(facts)])]
    return ToldResult(
        "allworlds count",
        f"class {census.extent.map_class}",
        census,
        _headline(census),
        sections,
        rows=lambda: _rows(census),
    )


def _rows(census: Census) -> CsvRows:
    """A row for each number of edges, of vertices, and genus."""
    columns = {"edges": int, "vertices": int, "genus": int, "rooted": int, "unrooted": int}
    rows = [[row.edges, *cell] for row in census.rows for cell in row.cells]
    return CsvRows(columns, rows)


def _headline(census: Census) -> Headline | None:
    if not census.agrees:
        wrong = [_mismatch(census, i) for i, row in enumerate(census.rows) if not row.agrees]
        return Headline("MISMATCH", "; ".join(wrong), "error")
    if census.complete and census.whole and census.empty:
        return Headline("VACUOUS", "there is no such map", "vacuous")
    done = None
    if census.rows:
        total = plural(sum(row.rooted for row in census.rows), "rooted map")
        done = Headline("COUNTED", f"{total} {finished(census, census.rows[-1].edges)}")
    return so_far(census, done)


def _mismatch(census: Census, i: int) -> str:
    row = census.rows[i]
    return (
        f"with {plural(row.edges, 'edge')} {row.by_vertices} were enumerated, but "
        f"{census.source} counts {row.counted}"
    )
