"""The text of ``optimum``."""

from __future__ import annotations

from allworlds.reports.text_layout import entry, interruption, table
from allworlds.studies.optimum import OptimumReport, OptimumRow
from allworlds.words import number


def optimum_text(report: OptimumReport, width: int) -> str:
    """A line for each number of edges: the optimum, and the worst cost of each explorer."""
    names = [*report.rows[0].explorers] if report.rows else []
    header = ["edges", "runs", "optimum", *names]
    rows = [_row(row) for row in report.rows]
    lines = [*table(header, rows, "r" * len(header), width), ""]
    lines += interruption(complete=report.complete, width=width)
    lines += entry(
        "optimum",
        "the fewest traversals with which an explorer that knows the number of edges can map "
        "every world; the others do not know it, and go first in, first out",
        width,
    )
    if all(row.agrees for row in report.rows):
        text = "each strategy was followed in every world, and costs what was found"
        lines += entry("replay", text, width)
    else:
        wrong = next(row for row in report.rows if not row.agrees)
        lines += entry("MISMATCH", _mismatch(wrong), width)
    return "\n".join(lines)


def _row(row: OptimumRow) -> list[str]:
    found = number(row.optimum) if row.optimum is not None else f"{row.at_least} or more"
    return [number(row.edges), number(row.runs), found, *map(number, row.explorers.values())]


def _mismatch(row: OptimumRow) -> str:
    costs = "is wrong in some world" if row.replayed is None else f"costs {row.replayed}"
    return f"for {row.edges} edges the optimum is {row.optimum}, but its strategy {costs}"
