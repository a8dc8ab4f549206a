"""The text of ``figure``: what is seen, and where it was written."""

from __future__ import annotations

from allworlds.evidence.figures.figure_table import Figure
from allworlds.reports import entry


def figure_line(report: Figure, _width: int) -> str:
    """The verdict and the files in one line."""
    return f"{_verdict(report)}: figure {report.figure} in {report.path}, its data in {report.data}"


def figure_text(report: Figure, width: int) -> str:
    """The verdict, the files and the caption."""
    lines = entry(_verdict(report), f"figure {report.figure}", width)
    lines += entry("picture", str(report.path), width)
    lines += entry("data", str(report.data), width)
    for i, sentences in enumerate(report.caption):
        lines += entry("" if i else "caption", sentences, width)
    return "\n".join(lines)


def _verdict(report: Figure) -> str:
    return report.verdict.name.replace("_", "-")
