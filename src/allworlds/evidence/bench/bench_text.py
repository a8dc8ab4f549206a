"""The text of ``bench``."""

from __future__ import annotations

from statistics import median

from allworlds.evidence.bench.rounds import BenchReport
from allworlds.reports import entry, interruption, table
from allworlds.version import host
from allworlds.words import number


def bench_text(report: BenchReport, width: int) -> str:
    """A line for each contender: its rate, and how many times that the reference's is."""
    ratios = {row.to: row.ratio for row in report.ratios}
    reference = report.contenders[0].name
    rows = []
    for one in report.contenders:
        ratio = ratios.get(one.name)
        rows.append(
            [
                one.name,
                str(one.edges),
                f"{median(one.seconds):.3f}",
                number(round(one.worlds_per_second.median)),
                "" if ratio is None else _figure(ratio.median),
                "" if ratio is None else f"{_figure(ratio.lowest)}..{_figure(ratio.highest)}",
                one.does,
            ]
        )
    header = ["name", "edges", "seconds", "worlds/s", f"{reference} is", "spread", "does"]
    lines = table(header, rows, "lrrrrrl", width)
    facts = host()
    lines += [""]
    lines += interruption(complete=report.complete, width=width)
    lines += entry("rounds", f"{report.rounds}, in turns; medians", width)
    lines += entry(
        "machine",
        f"{facts.processor}, {facts.cores} cores, load {facts.load}; "
        f"Python {facts.python}, numba {facts.numba}",
        width,
    )
    lines += entry("commit", report.commit or "unknown", width)
    lines += entry("memory", f"{report.peak_mb} MB at most", width)
    return "\n".join(lines)


def _figure(ratio: float) -> str:
    return f"{ratio:,.0f} x" if ratio >= 100 else f"{ratio:.2f} x"
