"""The text of a comparison in worlds that grow, and its rows as CSV."""

from __future__ import annotations

import csv
import io

from allworlds.reports.finding_words import headline
from allworlds.reports.text_layout import entry, table
from allworlds.studies.compare import Growth
from allworlds.words import number, plural


def growth_text(report: Growth, width: int) -> str:
    """A line for each family, size and explorer; then the exponents."""
    header = ["family", "edges", "vertices", "explorer", "mean", "least", "worst", "bound"]
    rows = [
        [
            row.family,
            number(row.edges),
            number(row.vertices),
            row.explorer,
            f"{row.mean:,.1f}",
            number(row.least),
            number(row.worst),
            "-" if row.bound is None else number(row.bound),
        ]
        for row in report.rows
    ]
    lines = [*table(header, rows, "lrrlrrrr", width, keys=4), ""]
    fitted = [
        [one.family, one.explorer, f"{one.slope:.2f}", f"{one.last_slope:.2f}"]
        for one in report.exponents
    ]
    if fitted:
        lines += [*table(["family", "explorer", "exponent", "last"], fitted, "llrr", width), ""]
    for name, text in _words(report):
        lines += entry(name, text, width)
    return "\n".join(lines)


def _words(report: Growth) -> list[tuple[str, str]]:
    runs = sum(len(row.costs) for row in report.rows)
    said = f"no law is broken in {plural(runs, 'run')}"
    if report.findings:
        said = "a run has broken a law"
    elif not report.complete:
        said = f"{report.stopped or 'interrupted'}; {said} of finished families"
    words = [(report.verdict.value.upper(), said)]
    if report.exponents:
        words += [
            ("exponent", "of the power of the edges that fits the means best, over all sizes"),
            ("last", "the same of the last two sizes"),
        ]
    if report.rows:
        member = report.rows[-1].members[-1]
        words.append(("again", f"allworlds run {report.explorers[0]} --family {member}"))
    if report.left_out:
        left = plural(report.left_out, "world")
        words.append(("left out", f"{left} without a place for the lighthouse"))
    words += [("finding", headline(finding)) for finding in report.findings]
    return words


def growth_csv(report: Growth) -> str:
    """One line for each run."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(["family", "edges", "vertices", "explorer", "member", "cost", "bound"])
    for row in report.rows:
        for member, cost in zip(row.members, row.costs, strict=True):
            bound = "" if row.bound is None else row.bound
            writer.writerow(
                [row.family, row.edges, row.vertices, row.explorer, member, cost, bound]
            )
    return out.getvalue()
