"""The text of ``bench``."""

from __future__ import annotations

from statistics import median

from allworlds.evidence.bench.rounds import BenchReport, commit
from allworlds.reports import entry, interruption, table
from allworlds.version import host
from allworlds.words import number


def bench_text(report: BenchReport, width: int) -> str:
    """A line for each contender: its rate, and how many times that the reference's is."""
    ratios = {row["to"]: row["ratio"] for row in report.ratios()}
    reference = report.measured[0].contender.name
    rows = []
    for measured in report.measured:
        contender = measured.contender
        ratio = ratios.get(contender.name)
        rows.append(
            [
                contender.name,
                str(contender.edges),
                f"{median(measured.seconds):.3f}",
                number(round(median(measured.rates))),
                "" if ratio is None else _figure(ratio["median"]),
                "" if ratio is None else f"{_figure(ratio['lowest'])}..{_figure(ratio['highest'])}",
                contender.does,
            ]
        )
    header = ["name", "edges", "seconds", "worlds/s", f"{reference} is", "spread", "does"]
    lines = table(header, rows, "lrrrrrl", width)
    facts = host()
    rounds = len(report.measured[0].seconds)
    lines += [""]
    lines += interruption(complete=report.complete, width=width)
    lines += entry("rounds", f"{rounds}, in turns; medians", width)
    lines += entry(
        "machine",
        f"{facts['processor']}, {facts['cores']} cores, load {facts['load']}; "
        f"Python {facts['python']}, numba {facts['numba']}",
        width,
    )
    lines += entry("commit", commit() or "unknown", width)
    lines += entry("memory", f"{report.peak_mb} MB at most", width)
    return "\n".join(lines)


def _figure(ratio: float) -> str:
    return f"{ratio:,.0f} x" if ratio >= 100 else f"{ratio:.2f} x"
