"""The text of ``count``."""

from __future__ import annotations

from allworlds.reports.check_words import counted
from allworlds.reports.text_layout import entry, interruption, table
from allworlds.studies.count import Census
from allworlds.words import number, plural


def count_text(census: Census, width: int) -> str:
    """A line for each number of edges, and what the counts were compared with."""
    rows = [
        [
            str(row.edges),
            number(row.rooted),
            "-" if row.unrooted is None else number(row.unrooted),
            " ".join(f"{n}:{count}" for n, count in row.by_vertices.items()),
        ]
        for row in census.rows
    ]
    lines = table(["edges", "rooted", "unrooted", "rooted by vertices"], rows, "rrrl", width)
    total = sum(row.rooted for row in census.rows)
    lines += ["", f"{plural(total, 'rooted map')} of the class {census.map_class}", ""]
    lines += interruption(complete=census.complete, width=width)
    if census.gate.agrees:
        lines += entry("gate", f"no map was forgotten: {counted(census.gate.source)}", width)
    else:
        for row in census.rows:
            if not row.agrees:
                text = (
                    f"with {plural(row.edges, 'edge')} {row.by_vertices} "
                    f"were enumerated, but {census.gate.source} counts {row.counted}"
                )
                lines += entry("MISMATCH", text, width)
    return "\n".join(lines)
