"""Telling of ``compare``: costs in the same worlds."""

from __future__ import annotations

from collections.abc import Iterator

from allworlds.explorers import short_names
from allworlds.reports.rows import CsvRows
from allworlds.reports.telling import (
    Cell,
    Headline,
    Section,
    Shown,
    ToldFacts,
    ToldResult,
    ToldTable,
)
from allworlds.reports.tellings.finding import finding_section
from allworlds.reports.tellings.growth import growth_telling
from allworlds.reports.tellings.scope import SAID, explorers_told, maps_words, options_told
from allworlds.reports.tellings.single_run import run_section
from allworlds.reports.world_rows import rows_of_worlds
from allworlds.studies.compare import ComparedRow, Comparison, Growth
from allworlds.words import number, plural, size


def compare_telling(report: Comparison | Growth) -> ToldResult:
    """The verdict, the findings, the rows, and the world of the largest difference.

    On a page also a walk of each explorer in the world that differs most.
    """
    if isinstance(report, Growth):
        return growth_telling(report)
    findings = [finding_section(found, i) for i, found in enumerate(report.findings, 1)]
    seen = Section("seen", "What was compared", [_table(report), ToldFacts(_facts(report))])
    return ToldResult(
        "allworlds compare",
        ", ".join(report.names),
        report,
        Headline(report.verdict.value.upper(), _verdict(report), report.verdict.value),
        [*findings, seen],
        more=lambda: _walks(report),
        rows=lambda: _rows(report),
        apart=frozenset({"findings"}),
    )


def _walks(report: Comparison) -> Iterator[Section]:
    for i, told in enumerate(report.walks(), 1):
        cost = plural(told.outcome.cost, "traversal")
        title = f"In the world that differs most: {told.explorer}, {cost}"
        yield run_section(told, f"walk-{i}", title)


def _table(report: Comparison) -> ToldTable:
    """Costs as a table. The first explorer is compared with each other one."""
    names = short_names(report.names)
    header = ["edges", "vertices", "worlds"]
    header += [f"{name} mean" for name in names] + [f"{name} worst" for name in names]
    header += [f"{name} / {names[0]}" for name in names[1:]]
    header += [f"{names[0]} < = > {name}" for name in names[1:]]
    rows = [_cells(report, row) for row in report.rows]
    return ToldTable(header, rows, "Compared worlds", keys=2)


def _cells(report: Comparison, row: ComparedRow) -> list[Cell]:
    cells: list[Cell] = [row.edges, row.vertices, row.worlds]
    cells += [_mean(row.mean[name]) for name in report.names]
    cells += [row.worst[name] for name in report.names]
    ratios = [row.ratio[name] for name in report.names[1:]]
    cells += [None if ratio is None else _mean(ratio) for ratio in ratios]
    for name in report.names[1:]:
        told = " ".join(number(times[name]) for times in (row.less, row.equal, row.more))
        cells.append(Shown(told, told))
    return cells


SIZES = {"edges": int, "vertices": int, "worlds": int, "explorer": str}
COSTS = {"mean": float, "worst": int, "ratio": float}
TIMES = {"less": int, "equal": int, "more": int}


def _rows(report: Comparison) -> CsvRows:
    """A row for each size and explorer, or as is asked for.

    The first explorer is compared with each other one.
    """
    if report.by in ("world", "run"):
        return rows_of_worlds(report.worlds_kept, report.names[0], report.by)
    rows = []
    for row in report.rows:
        for name in report.names:
            times = [which.get(name) for which in (row.less, row.equal, row.more)]
            costs = [row.mean[name], row.worst[name], row.ratio[name]]
            rows.append([row.edges, row.vertices, row.worlds, name, *costs, *times])
    return CsvRows({**SIZES, **COSTS, **TIMES}, rows)


def _facts(report: Comparison) -> list[tuple[str, str]]:
    """Named facts beside the table."""
    scope = f"one world: {report.member.told}" if report.member else maps_words(report)
    words = [*explorers_told(report), ("scope", scope), *options_told(report, SAID)]
    meant = "traversals; mean: over rooted maps, in each over the places; worst: of a run"
    words.append(("costs", meant))
    first = short_names(report.names)[0]
    exact = "; exact" if report.whole else ""
    ratio = f"of the means in each map, to that of {first}: the geometric mean over the maps{exact}"
    words.append(("ratio", ratio))
    if report.rows:
        words += [("in all", _in_all(report, name)) for name in report.names[1:]]
    most = report.differ_most
    if most is not None:
        costs = ", ".join(f"{name} {cost:,.2f}" for name, cost in most.costs.items())
        map_ = most.world.map
        where = size(map_.edge_count, map_.vertex_count)
        world = f"sigma={[*map_.sigma]} alpha={[*map_.alpha]}"
        if map_.edge_count > _SHOWN:
            world = "in the document"
        words.append(("difference", f"most in a world with {where}: {costs}; {world}"))
    return words


_SHOWN = 12
"""The edges of the largest world that a text spells out."""


def _verdict(report: Comparison) -> str:
    runs = sum(row.runs for row in report.rows)
    if report.findings:
        return "a run has broken a law"
    if not report.all_counted:
        return "the enumeration and its count disagree"
    if not report.complete:
        why = report.stopped or "interrupted"
        return f"{why}; no law is broken in {plural(runs, 'run')} of finished levels"
    if not report.rows:
        return "there is no world in which every explorer has a place"
    return f"no law is broken in {plural(runs, 'run')}"


def _in_all(report: Comparison, name: str) -> str:
    first = report.names[0]
    less, equal, more = (
        sum(getattr(row, which)[name] for row in report.rows) for which in ("less", "equal", "more")
    )
    return (
        f"{first} walks less than {name} in {plural(less, 'world')}, as much in {number(equal)}, "
        f"more in {number(more)}"
    )


def _mean(value: float) -> Shown:
    return Shown(round(value, 6), f"{value:,.2f}")
