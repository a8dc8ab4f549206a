"""Telling of ``compare --to``: costs in worlds that grow."""

from __future__ import annotations

from allworlds.explorers import short_names
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
from allworlds.reports.tellings.scope import SAID, explorers_told, options_told
from allworlds.reports.world_rows import rows_of_worlds
from allworlds.studies.compare import (
    LEAST_SIZES,
    LEAST_WORLDS,
    LEVEL,
    CostRatio,
    Exponent,
    GrowRow,
    Growth,
    Shape,
)
from allworlds.words import number, plural


def growth_telling(report: Growth) -> ToldResult:
    """A row for each family, size and explorer; then the exponents."""
    findings = [finding_section(found, i) for i, found in enumerate(report.findings, 1)]
    blocks: list[Block] = [_table(report)]
    if report.ratios:
        blocks.append(_ratios(report))
    if report.exponents:
        blocks.append(_exponents(report))
    blocks.append(ToldFacts(_facts(report)))
    return ToldResult(
        "allworlds compare",
        ", ".join(report.names),
        report,
        Headline(report.verdict.value.upper(), _verdict(report), report.verdict.value),
        [*findings, Section("seen", "What was compared", blocks)],
        rows=lambda: _rows(report),
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


def _rows(report: Growth) -> CsvRows:
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


def _table(report: Growth) -> ToldTable:
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


def _exponents(report: Growth) -> ToldTable:
    rows: list[list[Cell]] = [
        [
            *(one.family, one.explorer),
            Shown(one.exponent, f"{one.exponent:.2f}"),
            _interval(one, ".2f") or f"too few {_lacking(one)}",
            *(Shown(one.residual, f"{one.residual:.2f}"), _shape(one)),
        ]
        for one in report.exponents
    ]
    header = ["family", "explorer", "exponent", "interval", "residual", "power law"]
    return ToldTable(header, rows, "Fitted exponents", keys=2)


def _lacking(one: Exponent) -> str:
    """The word for that of which an exponent without an interval has too few."""
    return "sizes" if len(one.fit.distances) < LEAST_SIZES else "worlds"


def _shape(one: Exponent) -> str:
    """The words for whether a power law fits."""
    if one.shape is Shape.POWER:
        return "fits"
    if one.shape is Shape.UNTESTED:
        return "two sizes"
    return f"no: {one.shape.value}, {one.distance:+.0%} at {plural(one.farthest, 'edge')}"


def _interval(found: GrowRow | CostRatio | Exponent, form: str) -> Cell:
    if found.exact:
        return "exact"
    if found.interval is None:
        return None
    low, high = (format(end, form) for end in found.interval)
    return Shown(f"{low}..{high}", f"{low}..{high}")


def _verdict(report: Growth) -> str:
    runs = sum(row.runs for row in report.rows)
    said = f"no law is broken in {plural(runs, 'run')}"
    if report.findings:
        said = "a run has broken a law"
    elif not report.complete:
        said = f"{report.stopped or 'interrupted'}; {said} of finished sizes"
    return said


def _facts(report: Growth) -> list[tuple[str, str]]:
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
    if report.exponents:
        best = "of the power of the edges that fits all worlds best, in logarithms"
        needs = f"{LEAST_SIZES} sizes, and {LEAST_WORLDS} worlds of each that is not exact"
        words += [
            ("exponent", f"{best}; its interval takes {needs}"),
            ("residual", "standard deviation of the logarithm of the cost about that power"),
        ]
    if report.rows:
        member = report.rows[-1].members[-1].name
        words.append(("again", f"allworlds run {report.names[0]} --family {member}"))
    if report.begun:
        begun = len({one.name for row in report.begun for one in row.members})
        words.append(("begun", f"{plural(begun, 'world')} of an unfinished size, in --csv alone"))
    if report.left_out:
        left = plural(report.left_out, "world")
        words.append(("left out", f"{left} without a place for the lighthouse"))
    return words


GROWTH_SAID = (*SAID, "to", "worlds", "places")
"""The fields of the request of which the facts tell."""
