"""Telling of ``bench``: rates and their ratios."""

from __future__ import annotations

from statistics import median

from allworlds.evidence.bench.rounds import BenchReport
from allworlds.reports import (
    Block,
    Cell,
    CsvRows,
    Headline,
    Section,
    Shown,
    ToldFacts,
    ToldResult,
    ToldTable,
    Value,
    so_far,
)
from allworlds.version import host
from allworlds.words import plural


def bench_telling(report: BenchReport) -> ToldResult:
    """A row for each contender: its rate, and the ratio to the reference's rate."""
    ratios = {row.to: row.ratio for row in report.ratios}
    reference = report.contenders[0].name
    rows: list[list[Cell]] = []
    for one in report.contenders:
        ratio, seconds = ratios.get(one.name), median(one.seconds)
        compared: list[Cell] = ["", ""]
        if ratio is not None:
            spread = f"{_times(ratio.lowest)}..{_times(ratio.highest)}"
            compared = [Shown(ratio.median, _times(ratio.median)), Shown(spread, spread)]
        row: list[Cell] = [one.name, one.edges, Shown(seconds, f"{seconds:.3f}")]
        rows.append([*row, round(one.worlds_per_second.median), *compared, one.does])
    header = ["name", "edges", "seconds", "worlds/s", f"{reference} is", "spread", "does"]
    made = host()
    machine = (
        f"{made.processor}, {made.cores} cores, load {made.load}; "
        f"Python {made.python}, numba {made.numba}"
    )
    facts = [
        ("rounds", f"{report.rounds}, in turns; medians"),
        ("machine", machine),
        ("commit", report.commit or "unknown"),
        ("memory", f"{report.peak_mb} MB at most"),
    ]
    blocks: list[Block] = [ToldTable(header, rows, "Side by side"), ToldFacts(facts)]
    head = so_far(report, Headline("MEASURED", plural(report.rounds, "round")))
    section = Section("seen", "", blocks)
    return ToldResult(
        "allworlds self bench", "", report, head, [section], rows=lambda: _rows(report)
    )


def _rows(report: BenchReport) -> CsvRows:
    """A row for each contender; ratios are those of the first one's rate to its own."""
    columns = {"name": str, "edges": int, "seconds": float, "worlds_per_second": float}
    ratios = {row.to: row.ratio for row in report.ratios}
    rows: list[list[Value]] = []
    for one in report.contenders:
        ratio = ratios.get(one.name)
        found = (ratio.median, ratio.lowest, ratio.highest) if ratio else (None, None, None)
        rows.append(
            [one.name, one.edges, median(one.seconds), one.worlds_per_second.median, *found]
        )
    spread = {"ratio": float, "ratio_lowest": float, "ratio_highest": float}
    return CsvRows({**columns, **spread}, rows)


def _times(ratio: float) -> str:
    return f"{ratio:,.0f} x" if ratio >= 100 else f"{ratio:.2f} x"
