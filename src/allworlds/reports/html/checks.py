"""The page of a check: the verdict with its scope, what was counted, and every finding."""

from __future__ import annotations

from collections.abc import Iterator
from xml.etree import ElementTree as ET

from allworlds.engines import Sample
from allworlds.reports.check_words import origin_words, scope_words, size_table, verdict_words
from allworlds.reports.html.findings import finding_section
from allworlds.reports.html.frame import Page, counts
from allworlds.reports.html.most_expensive import cells_of, most_expensive_sections
from allworlds.reports.markup import tag
from allworlds.studies.check import CheckReport, most_expensive_runs


def check_page(report: CheckReport) -> Page:
    """The verdict, the findings, and of a check that holds the most expensive runs.

    Every finding is in it as JSON too, and the report without the findings.
    """
    word, text = verdict_words(report)
    verb = "fuzz" if isinstance(report.asked.coverage, Sample) else "check"
    findings = [
        finding_section(finding, number, origin_words(report, finding))
        for number, finding in enumerate(report.findings, 1)
    ]
    seen = tag("section", *_seen(report), aria_labelledby="seen", class_="scope")
    most_expensive = most_expensive_sections(cells_of(report), most_expensive_runs(report))
    return Page(
        f"allworlds {verb}",
        report.explorer,
        (word, text, report.verdict.value),
        [*findings, seen, *(() if findings else most_expensive)],
        {key: told for key, told in report.to_json().items() if key != "findings"},
    )


def _seen(report: CheckReport) -> Iterator[ET.Element]:
    """What the verdict is about, and what was counted."""
    yield tag("h2", "What was checked", id="seen")
    entries = []
    for name, text in scope_words(report):
        if name:
            entries.append(tag("dt", name))
        entries.append(tag("dd", tag("bdi", text)))
    yield tag("dl", *entries)
    yield from counts(*size_table(report), "Finished levels")
