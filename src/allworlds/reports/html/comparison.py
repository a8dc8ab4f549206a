"""A comparison on a page: the rows, and the walks in the world that differs most."""

from __future__ import annotations

from collections.abc import Iterator
from xml.etree import ElementTree as ET

from allworlds.reports.compare_text import compare_table, compare_words
from allworlds.reports.html.findings import finding_section
from allworlds.reports.html.frame import Page, counts
from allworlds.reports.html.runs import run_section
from allworlds.reports.markup import tag
from allworlds.studies.compare import Comparison
from allworlds.words import plural


def comparison_page(report: Comparison) -> Page:
    """The rows of a comparison, its findings, and a walk of each explorer."""
    (word, text), *words = compare_words(report)
    summary = {key: told for key, told in report.to_json().items() if key != "findings"}
    entries = [
        part for name, said in words for part in (tag("dt", name), tag("dd", tag("bdi", said)))
    ]
    seen = tag(
        "section",
        tag("h2", "What was compared", id="seen"),
        tag("dl", *entries),
        *counts(*compare_table(report), "Compared worlds"),
        aria_labelledby="seen",
        class_="scope",
    )
    findings = [finding_section(found, i) for i, found in enumerate(report.findings, 1)]
    return Page(
        "allworlds compare",
        ", ".join(report.names),
        (word, text, report.verdict.value),
        [seen, *findings, *_walks(report)],
        summary,
    )


def _walks(report: Comparison) -> Iterator[ET.Element]:
    for number, told in enumerate(report.walks(), 1):
        cost = plural(told.outcome.cost, "traversal")
        title = f"In the world that differs most: {told.explorer}, {cost}"
        yield run_section(told, f"walk-{number}", title)
