"""Telling of ``ambiguity census``: marked maps, and the ambiguous ones."""

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
from allworlds.studies.ambiguity import AmbiguityCensus
from allworlds.words import counted, number, plural


def census_telling(census: AmbiguityCensus) -> ToldResult:
    """A row for each number of edges, and the source with which the counts were compared."""
    header = ["edges", "marked worlds", "ambiguous", "classes", "largest class"]
    rows = [
        [
            row.edges,
            row.marked_worlds,
            row.ambiguous_worlds,
            row.classes,
            row.largest_class or None,
        ]
        for row in census.rows
    ]
    scope = (
        f"maps with {_marked(census)}, up to isomorphism; ambiguous are those from which no "
        f"motion tells another world of the class {census.map_class}"
    )
    facts = [*interruption(complete=census.complete, stopped=census.stopped), ("scope", scope)]
    if not census.whole:
        text = (
            f"of the shard {census.shard} alone, which may hold some members of a class and not "
            "others: classes and counts are told by the merge of all shards"
        )
        facts.append(("shard", text))
    elif census.gate is None:
        facts.append(("gate", f"absent: no source counts the maps that are {census.where}"))
    elif census.gate.agrees:
        facts.append(("gate", f"no rooted map was forgotten: {counted(census.source)}"))
    table = ToldTable(header, rows, "Marked worlds")
    return ToldResult(
        "allworlds ambiguity census",
        f"class {census.map_class}",
        census,
        _headline(census),
        [Section("seen", "", [table, ToldFacts(facts)])],
        rows=lambda: _rows(census),
    )


def _rows(census: AmbiguityCensus) -> Rows:
    """A row for each number of edges."""
    counts = {"ambiguous_worlds": int, "classes": int, "largest_class": int}
    return Rows.of(census.rows, edges=int, marked_worlds=int, **counts)


def _marked(census: AmbiguityCensus) -> str:
    if census.lighthouse == "position":
        return "one marked vertex"
    return f"a lighthouse {census.lighthouse} in them"


def _headline(census: AmbiguityCensus) -> Headline:
    wrong = [row for row in census.rows if row.rooted != row.counted]
    if census.whole and census.gate is not None and wrong:
        told = [
            f"with {plural(row.edges, 'edge')} {plural(row.rooted, 'rooted map')} "
            f"{'was' if row.rooted == 1 else 'were'} met, but {census.source} counts {row.counted}"
            for row in wrong
        ]
        return Headline("MISMATCH", "; ".join(told), "error")
    all_ = plural(sum(row.marked_worlds for row in census.rows), "marked world")
    if not census.whole:
        return Headline("SHARD", f"{all_} of the shard {census.shard}")
    ambiguous = sum(row.ambiguous_worlds or 0 for row in census.rows)
    return Headline("AMBIGUOUS", f"{number(ambiguous)} of {all_}")
