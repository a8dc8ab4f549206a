"""Telling of ``ambiguity census``: marked maps, and the ambiguous ones."""

from __future__ import annotations

from allworlds.reports.rows import CsvRows
from allworlds.reports.telling import (
    Cell,
    Headline,
    Section,
    ToldFacts,
    ToldResult,
    ToldTable,
    so_far,
)
from allworlds.reports.tellings.lookalikes import alike
from allworlds.reports.tellings.scope import finished, gate_told, maps_words, places_told
from allworlds.studies.ambiguity.marked_worlds import AmbiguityCensus, CensusCell, CensusRow
from allworlds.words import number, plural
from allworlds.world.lighthouses.marked import Position


def census_telling(census: AmbiguityCensus) -> ToldResult:
    """A row for each number of edges, and the source with which the counts were compared."""
    header = ["marked worlds", "ambiguous", "classes", "largest class"]
    rows = [[row.edges, *_counts(row)] for row in census.rows]
    cells = [[cell.edges, cell.vertices, *_counts(cell)] for cell in census.by_vertices]
    scope = (
        f"{maps_words(census)}, {_marked(census)}, up to isomorphism; ambiguous are those "
        "from which no motion tells another world of the scope"
    )
    facts = [("scope", scope), *places_told(census.places)]
    if not census.whole:
        text = (
            f"{census.portion}: it may hold some members of a class and not others; classes and "
            "counts are told by the merge of all shards"
        )
        facts.append(("shard", text))
    if census.agrees:
        facts += gate_told(census, "rooted map", census.source, rows=bool(rows))
    tables = [
        ToldTable(["edges", *header], rows, "Marked worlds by edges"),
        ToldTable(["edges", "vertices", *header], cells, "By edges and vertices", keys=2),
    ]
    return ToldResult(
        "allworlds ambiguity census",
        f"class {census.extent.map_class}",
        census,
        _headline(census),
        [Section("seen", "", [*tables, ToldFacts(facts)]), *_pair(census)],
        rows=lambda: _rows(census),
    )


def _rows(census: AmbiguityCensus) -> CsvRows:
    """A row for each number of edges and vertices."""
    counts = {"ambiguous_worlds": int, "classes": int, "largest_class": int}
    return CsvRows.of(census.by_vertices, edges=int, vertices=int, marked_worlds=int, **counts)


def _counts(row: CensusRow | CensusCell) -> list[Cell]:
    return [row.marked_worlds, row.ambiguous_worlds, row.classes, row.largest_class or None]


def _pair(census: AmbiguityCensus) -> list[Section]:
    """The smallest pair, with its proof; an empty list if there is none."""
    if not census.pair:
        return []
    title = "The smallest worlds that no motion tells apart"
    return [Section("pair", title, [alike("AB", census.pair, census.bisimulation)])]


def _marked(census: AmbiguityCensus) -> str:
    kind = census.request.lighthouse
    return (
        "with one marked vertex" if str(kind) == Position.kind else f"under the lighthouse {kind}"
    )


def _headline(census: AmbiguityCensus) -> Headline | None:
    if not census.agrees:
        told = [
            f"with {plural(row.edges, 'edge')} {plural(row.rooted, 'rooted map')} "
            f"{'was' if row.rooted == 1 else 'were'} met, but {census.source} counts {row.counted}"
            for row in census.rows
            if not row.agrees(whole=census.whole)
        ]
        return Headline("MISMATCH", "; ".join(told), "error")
    done = _found(census) if census.rows else None
    return so_far(census, done)


def _found(census: AmbiguityCensus) -> Headline:
    """The headline of the finished levels."""
    all_ = plural(sum(row.marked_worlds for row in census.rows), "marked world")
    scope = finished(census, census.rows[-1].edges)
    if census.places:
        scope += f" ({census.places})"
    if not census.whole:
        return Headline("SHARD", f"{all_} {scope}, of the shard {census.portion}")
    if census.empty:
        return Headline("VACUOUS", f"there is no world {scope}", "vacuous")
    ambiguous = sum(row.ambiguous_worlds or 0 for row in census.rows)
    if not ambiguous:
        return Headline("TOLD APART", f"{all_} {scope}: motions tell each from every other")
    return Headline("AMBIGUOUS", f"{number(ambiguous)} of {all_} {scope}")
