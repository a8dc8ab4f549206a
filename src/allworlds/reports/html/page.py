"""The page of a check: the verdict with its scope, what was counted, and every finding."""

from __future__ import annotations

from collections.abc import Iterator
from xml.etree import ElementTree as ET

from allworlds.checker import Report
from allworlds.markup import tag
from allworlds.reports.check_words import origin_words, scope_words, size_table, verdict_words
from allworlds.reports.html.findings import finding_section
from allworlds.reports.html.frame import counts, framed
from allworlds.runs import Sample


def page(report: Report) -> str:
    """The report as an HTML document that refers to nothing outside of it.

    Every finding is in it as JSON too, and the report without the findings.
    """
    word, text = verdict_words(report)
    verb = "fuzz" if isinstance(report.scope.coverage, Sample) else "check"
    findings = [
        finding_section(finding, number, origin_words(report, finding))
        for number, finding in enumerate(report.findings, 1)
    ]
    seen = tag("section", *_seen(report), aria_labelledby="seen", class_="scope")
    return framed(
        f"allworlds {verb}",
        report.explorer,
        (word, text, report.verdict.value),
        [*findings, seen],
        {key: told for key, told in report.to_json().items() if key != "findings"},
    )


def _seen(report: Report) -> Iterator[ET.Element]:
    """What the verdict is about, and what was counted."""
    yield tag("h2", "What was checked", id="seen")
    entries = []
    for name, text in scope_words(report):
        if name:
            entries.append(tag("dt", name))
        entries.append(tag("dd", tag("bdi", text)))
    yield tag("dl", *entries)
    yield from counts(*size_table(report), "Finished levels")
