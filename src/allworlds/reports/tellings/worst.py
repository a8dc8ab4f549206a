"""Telling of ``worst``: costs over all schedules."""

from __future__ import annotations

from allworlds.reports.rows import CsvRows, Value
from allworlds.reports.telling import (
    Cell,
    Headline,
    Section,
    Shown,
    SizeCost,
    ToldFacts,
    ToldResult,
    ToldTable,
    so_far,
)
from allworlds.reports.tellings.check import most_expensive_sections
from allworlds.reports.tellings.scope import (
    gate_told,
    maps_words,
)
from allworlds.studies.worst.all_worlds import WorstReport
from allworlds.words import number, plural, size
from allworlds.world.named import code_of


def worst_telling(report: WorstReport) -> ToldResult:
    """The worst and the best cost of each size.

    On a page also cost against bound, and the walk that attains each row's worst cost.
    """
    seen = Section("seen", "What was searched", [_table(report), ToldFacts(_facts(report))])
    cells = [SizeCost(row.edges, row.vertices, row.worst, row.bound) for row in report.rows]
    return ToldResult(
        "allworlds worst",
        report.explorer,
        report,
        _headline(report),
        [seen],
        more=lambda: most_expensive_sections(cells, report.walks()),
        rows=lambda: _rows(report),
    )


SIZES = {"edges": int, "vertices": int, "worlds": int, "best": int, "worst": int, "bound": int}


def _rows(report: WorstReport) -> CsvRows:
    """A row for each size, with the world and the choices that attain its worst cost."""
    rows: list[list[Value]] = []
    for row in report.rows:
        map_, lighthouse = row.world.map, row.world.lighthouse
        place = lighthouse.number(map_, row.world.start)
        choices = ",".join(map(str, row.choices))
        numbers = [row.edges, row.vertices, row.worlds, row.best, row.worst, row.bound]
        rows.append([*numbers, code_of(map_, row.world.start), place, choices])
    return CsvRows({**SIZES, "code": str, "place": int, "choices": str}, rows)


def _headline(report: WorstReport) -> Headline | None:
    if not report.agrees:
        return Headline("MISMATCH", _mismatch(report), "error")
    if report.complete and not report.rows:
        return Headline("VACUOUS", "there is no run", "vacuous")
    done = None
    if report.rows:
        most = max(report.rows, key=lambda row: row.worst)
        said = f"{plural(most.worst, 'traversal')}, with {size(most.edges, most.vertices)}"
        done = Headline("WORST", said)
    return so_far(report, done)


def _table(report: WorstReport) -> ToldTable:
    """A row for each size."""
    header = ["edges", "vertices", "worlds", "best", "worst", "bound", "worst/bound"]
    rows: list[list[Cell]] = []
    for row in report.rows:
        ratio = row.worst / (row.bound or 1)
        cells = [row.edges, row.vertices, row.worlds, row.best, row.worst, row.bound]
        rows.append([*cells, Shown(round(ratio, 6), f"{ratio:.3f}")])
    return ToldTable(header, rows, "Worst and best cost of each size", keys=2)


def _facts(report: WorstReport) -> list[tuple[str, str]]:
    """The scope of the numbers, and the sources they were compared with, as named texts."""
    words = _search(report)
    if not report.agrees:
        return words
    words += gate_told(report, "world", report.source, rows=bool(report.rows))
    said = "every worst cost was attained by the python engine"
    return [*words, ("replay", said)] if report.rows else words


def _search(report: WorstReport) -> list[tuple[str, str]]:
    """The compiled search, in words."""
    tests = sum(row.tests for row in report.rows)
    wrong = sum(row.wrong_tests for row in report.rows)
    scope = (
        f"every schedule of algorithm1 in {maps_words(report)}, from every vertex; transit on "
        f"{_WAYS[report.request.transit]}"
    )
    costs = (
        "worst: the most expensive schedule of the most expensive world; best: the cheapest "
        "schedule of each world, of these the largest cost"
    )
    return [
        ("scope", scope),
        ("costs", costs),
        ("tests", _tests(tests, wrong)),
    ]


def _tests(tests: int, wrong: int) -> str:
    if not tests:
        return "no hypothesis was false, so no test of one was walked"
    verdict = "all rejected" if not wrong else f"{number(wrong)} CONFIRMED"
    return f"{plural(tests, 'test')} of false hypotheses on every path: {verdict}"


_WAYS = {"shortest": "a shortest path", "simple": "any simple path"}


def _mismatch(report: WorstReport) -> str:
    if report.disagreement:
        return report.disagreement
    row = next(row for row in report.rows if not row.agrees)
    if row.counted not in (None, row.worlds):
        return (
            f"of maps with {size(row.edges, row.vertices)} {row.worlds} were enumerated, but "
            f"{report.source} counts {row.counted}"
        )
    return (
        f"with {size(row.edges, row.vertices)} the worst cost is {row.worst}, but "
        f"the python engine walks {row.replayed}"
    )
