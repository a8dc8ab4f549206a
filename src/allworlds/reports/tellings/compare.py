"""The telling of a comparison."""

from __future__ import annotations

from collections.abc import Iterator

from allworlds.explorers.sources import short_names
from allworlds.reports.rows import CsvRows
from allworlds.reports.telling import (
    Block,
    Cell,
    Headline,
    Section,
    Shown,
    ToldFacts,
    ToldResult,
    ToldTable,
)
from allworlds.reports.tellings.finding import finding_section
from allworlds.reports.tellings.scope import SAID, explorers_told, maps_words, options_told
from allworlds.reports.tellings.single_run import run_section
from allworlds.reports.world_rows import rows_of_worlds
from allworlds.studies.compare.comparison import ComparedRow, Comparison
from allworlds.studies.compare.growth import CostRatio, GrowRow, Growth
from allworlds.studies.compare.intervals import LEVEL
from allworlds.words import number, plural, size


def growth_telling(report: Growth) -> ToldResult:
    """A row for each family, size and explorer."""
    findings = [finding_section(found, i) for i, found in enumerate(report.findings, 1)]
    blocks: list[Block] = [_growth_table(report)]
    if report.ratios:
        blocks.append(_ratios(report))
    blocks.append(ToldFacts(_growth_facts(report)))
    return ToldResult(
        "allworlds compare",
        ", ".join(report.names),
        report,
        Headline(report.verdict.value.upper(), _growth_verdict(report), report.verdict.value),
        [*findings, Section("seen", "What was compared", blocks)],
        rows=lambda: _growth_rows(report),
    )


COLUMNS = {
    "family": str,
    "edges": int,
    "vertices": int,
    "explorer": str,
    "seeds": int,
    "drawn_from": int,
    "worlds": int,
    "places": int,
    "runs": int,
    "exact": bool,
    "mean": float,
    "least": int,
    "worst": int,
    "bound": int,
}
ENDS = {"low": float, "high": float, "ratio": float, "ratio_low": float, "ratio_high": float}


def _growth_rows(report: Growth) -> CsvRows:
    """A row for each family, size and explorer, for each world, or for each run."""
    if report.by != "size":
        return rows_of_worlds(report.in_worlds(), report.names[0], report.by or "run")
    ratios = {(one.family, one.edges, one.explorer): one for one in report.ratios}
    rows = []
    for row in report.rows:
        ratio = ratios.get((row.family, row.edges, row.explorer))
        ends = row.interval or (None, None)
        beside = ratio.interval or (None, None) if ratio else (None, None)
        told = [getattr(row, name) for name in COLUMNS]
        rows.append([*told, *ends, ratio.ratio if ratio else None, *beside])
    return CsvRows(COLUMNS | ENDS, rows)


def _growth_table(report: Growth) -> ToldTable:
    header = ["family", "edges", "vertices", "explorer", "worlds", "runs", "mean", "interval"]
    rows = [
        [
            row.family,
            row.edges,
            row.vertices,
            row.explorer,
            Shown(row.worlds, number(row.worlds)),
            Shown(row.runs, f"{number(row.runs)} of {number(row.places)}"),
            Shown(row.mean, f"{row.mean:,.1f}"),
            _interval(row, ",.1f"),
            row.worst,
            row.bound,
        ]
        for row in report.rows
    ]
    return ToldTable([*header, "worst", "bound"], rows, "Costs, in traversals", keys=4)


def _ratios(report: Growth) -> ToldTable:
    (first, *_) = short_names(report.names)
    rows: list[list[Cell]] = [
        [
            *(one.family, one.edges, one.explorer, one.worlds),
            *(Shown(one.ratio, f"{one.ratio:.3f}"), _interval(one, ".3f")),
        ]
        for one in report.ratios
    ]
    header = ["family", "edges", "explorer", "worlds", f"cost / {first}", "interval"]
    return ToldTable(header, rows, "Ratios in the same worlds", keys=3)


def _interval(found: GrowRow | CostRatio, form: str) -> Cell:
    if found.exact:
        return "exact"
    if found.interval is None:
        return None
    low, high = (format(end, form) for end in found.interval)
    return Shown(f"{low}..{high}", f"{low}..{high}")


def _growth_verdict(report: Growth) -> str:
    runs = sum(row.runs for row in report.rows)
    said = f"no law is broken in {plural(runs, 'run')}"
    if report.findings:
        said = "a run has broken a law"
    elif not report.complete:
        said = f"{report.stopped or 'interrupted'}; {said} of finished sizes"
    return said


def _growth_facts(report: Growth) -> list[tuple[str, str]]:
    shard = "" if report.whole else f", shard {report.portion}"
    asked = report.request
    scope = (
        f"families {', '.join(report.families)} up to {plural(asked.to, 'edge')}, "
        f"{plural(asked.worlds, 'seed')} of each size from seed {asked.seed} on, at most "
        f"{plural(asked.places, 'place')} of the lighthouse in each world{shard}"
    )
    words = [*explorers_told(report), ("scope", scope), *options_told(report, GROWTH_SAID)]
    if report.rows:
        drawn = max(row.seeds for row in report.rows)
        words += [
            ("worlds", f"different rooted maps of {plural(drawn, 'seed')}; isomorphic ones once"),
            ("runs", "of all places of the lighthouse in them; worst: of these runs"),
            ("mean", "over the worlds, in each over its runs; ratios: geometric mean"),
            ("interval", f"{LEVEL:.0%}, by a bootstrap over the worlds; -: too few worlds"),
        ]
    if any(row.exact for row in report.rows):
        words.append(("exact", "every world that seeds draw was run, in every place"))
    if report.rows:
        member = report.rows[-1].members[-1].name
        words.append(("again", f"allworlds run {report.names[0]} --family {member}"))
    if report.begun:
        begun = len({one.name for row in report.begun for one in row.members})
        words.append(
            ("begun", f"{plural(begun, 'world')} of an unfinished size, in the rows alone")
        )
    if report.left_out:
        left = plural(report.left_out, "world")
        words.append(("left out", f"{left} without a place for the lighthouse"))
    return words


GROWTH_SAID = (*SAID, "to", "worlds", "places")
"""The fields of the request of which the facts tell."""


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
    scope = f"one world: {report.member.described}" if report.member else maps_words(report)
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
