"""Telling of ``figure``: verdict, files and caption."""

from __future__ import annotations

from allworlds.evidence.figures.figure_table import Figure
from allworlds.reports import Headline, Section, ToldFacts, ToldResult


def figure_telling(report: Figure) -> ToldResult:
    """The verdict, the files and the caption."""
    word = report.verdict.name.replace("_", "-")
    files = f"figure {report.figure} in {report.path}, its data in {report.data}"
    captions = [("" if i else "caption", said) for i, said in enumerate(report.caption)]
    return ToldResult(
        "allworlds paper figure",
        report.figure,
        report,
        Headline(word, files, report.verdict.value),
        [Section("caption", "", [ToldFacts(captions)])],
    )
