"""Telling of ``worst``: costs over all schedules."""

from __future__ import annotations

from allworlds.engines import WHOLE
from allworlds.reports.rows import Rows, Value
from allworlds.reports.telling import (
    Cell,
    Headline,
    Section,
    Shown,
    SizeCost,
    ToldFacts,
    ToldResult,
    ToldTable,
    interruption,
)
from allworlds.reports.tellings.finding import finding_section, headline_of
from allworlds.reports.tellings.most_expensive import most_expensive_sections
from allworlds.studies.worst import WorstReport
from allworlds.words import counted, number, plural, size
from allworlds.world import code_of


def worst_telling(report: WorstReport) -> ToldResult:
    """The findings, and the worst and the best cost of each size.

    On a page also cost against bound, and the walk that attains each row's worst cost.
    """
    findings = [finding_section(found, i) for i, found in enumerate(report.findings, 1)]
    left = interruption(complete=report.complete, stopped=report.stopped)
    facts = ToldFacts([*left, *_facts(report)])
    seen = Section("seen", "What was searched", [_table(report), facts])
    cells = [SizeCost(row.edges, row.vertices, row.worst, row.bound) for row in report.rows]
    return ToldResult(
        "allworlds worst",
        report.explorer,
        report,
        _headline(report),
        [*findings, seen],
        more=lambda: most_expensive_sections(cells, report.walks()),
        rows=lambda: _rows(report),
    )


SIZES = {"edges": int, "vertices": int, "worlds": int, "best": int, "worst": int, "bound": int}


def _rows(report: WorstReport) -> Rows:
    """A row for each size, with the world and the choices that attain its worst cost."""
    rows: list[list[Value]] = []
    for row in report.rows:
        map_, lighthouse = row.world.map, row.world.lighthouse
        place = lighthouse.number(map_, row.world.start)
        choices = ",".join(map(str, row.choices))
        numbers = [row.edges, row.vertices, row.worlds, row.best, row.worst, row.bound]
        rows.append([*numbers, code_of(map_, row.world.start), place, choices])
    return Rows({**SIZES, "code": str, "place": int, "choices": str}, rows)


def _headline(report: WorstReport) -> Headline:
    if report.findings:
        return Headline("REFUTED", headline_of(report.findings[0]), "refuted")
    if not report.agrees:
        return Headline("MISMATCH", _mismatch(report), "error")
    if not report.rows:
        return Headline("NOTHING", "there is no run", "vacuous")
    most = max(report.rows, key=lambda row: row.worst)
    said = f"{plural(most.worst, 'traversal')}, with {size(most.edges, most.vertices)}"
    return Headline("WORST" if report.complete else "SO FAR", said)


def _table(report: WorstReport) -> ToldTable:
    """A row for each size."""
    header = ["edges", "vertices", "worlds", "best", "worst", "bound"]
    rows: list[list[Cell]] = [
        [row.edges, row.vertices, row.worlds, row.best, row.worst, row.bound] for row in report.rows
    ]
    if report.transit:
        header.append("worst/bound")
        for row, cells in zip(report.rows, rows, strict=True):
            ratio = row.worst / (row.bound or 1)
            cells.append(Shown(round(ratio, 6), f"{ratio:.3f}"))
    return ToldTable(header, rows, "Worst and best cost of each size", keys=2)


def _facts(report: WorstReport) -> list[tuple[str, str]]:
    """The scope of the numbers, and the sources they were compared with, as named texts."""
    words = _paper(report, _WAYS[report.transit]) if report.transit else _of_runs(report)
    if not report.agrees or report.findings:
        return words
    if report.gate is None:
        text = f"absent: no source counts the maps that are {report.where}"
    else:
        text = f"no world was forgotten: {counted(report.gate.source)}"
    if report.gate is not None and report.shard != str(WHOLE):
        text = f"of the shard {report.shard} alone; the merge of all shards compares counts"
    again = "by the python engine" if report.transit else "again"
    return [*words, ("gate", text), ("replay", f"every worst cost was attained {again}")]


def _of_runs(report: WorstReport) -> list[tuple[str, str]]:
    """Method for an explorer whose runs were played."""
    schedules = "every schedule" if report.schedules == "all" else "the one schedule"
    scope = (
        f"{schedules} of {report.explorer} in {_maps(report)}, "
        f"at every place of the lighthouse {report.lighthouse}"
    )
    costs = "worst: of all episodes; best: the largest cost of the cheapest schedule of a run"
    return [("scope", scope), ("costs", costs)]


def _paper(report: WorstReport, way: str) -> list[tuple[str, str]]:
    """Method for Algorithm 1: the compiled search."""
    tests = sum(row.tests or 0 for row in report.rows)
    wrong = sum(row.wrong_tests or 0 for row in report.rows)
    verdict = "all rejected" if not wrong else f"{number(wrong)} CONFIRMED"
    scope = f"every schedule of algorithm1 in {_maps(report)}, from every vertex; transit on {way}"
    costs = (
        "worst: the most expensive schedule of the most expensive world; best: the largest cost "
        "of the cheapest schedule of a world"
    )
    return [
        ("scope", scope),
        ("costs", costs),
        ("tests", f"{plural(tests, 'test')} of false hypotheses on every path: {verdict}"),
    ]


_WAYS = {"shortest": "a shortest path", "simple": "any simple path"}


def _maps(report: WorstReport) -> str:
    where = f", {report.where}," if report.where else ""
    most = plural(report.edges, "edge")
    return f"every map of the class {report.map_class}{where} with at most {most}"


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
