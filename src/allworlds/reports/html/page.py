"""The page: the verdict with its scope, what was counted, and every finding."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterator
from hashlib import sha256
from importlib.resources import files
from xml.etree import ElementTree as ET

from allworlds.checker import Report
from allworlds.markup import document, raw, record, tag
from allworlds.reports.check_words import origin_words, scope_words, size_table, verdict_words
from allworlds.reports.html.findings import finding_section
from allworlds.runs import Sample


def page(report: Report) -> str:
    """The report as an HTML document that refers to nothing outside of it.

    Its own style and script are allowed by their hashes, and nothing else is.  Every finding
    is in it as JSON too, and the report without the findings.
    """
    style, script = _own("style.css"), _own("script.js")
    word, text = verdict_words(report)
    verb = "fuzz" if isinstance(report.scope.coverage, Sample) else "check"
    title = f"allworlds {verb}"
    policy = f"default-src 'none'; style-src {_hash(style)}; script-src {_hash(script)}"
    head = tag(
        "head",
        tag("meta", charset="utf-8"),
        tag("meta", http_equiv="Content-Security-Policy", content=f"{policy}; {_REFUSED}"),
        tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
        tag("meta", name="color-scheme", content="light dark"),
        tag("meta", name="referrer", content="no-referrer"),
        tag("title", f"{title}: {word}, {report.explorer}"),
        raw("style", style),
    )
    summary = {key: told for key, told in report.to_json().items() if key != "findings"}
    body = tag(
        "body",
        tag(
            "header",
            tag("h1", title, ": ", tag("bdi", report.explorer)),
            tag(
                "p",
                tag("b", word),
                " ",
                tag("span", text),
                class_=f"verdict {report.verdict.value}",
            ),
        ),
        tag(
            "main",
            *(
                finding_section(finding, number, origin_words(report, finding))
                for number, finding in enumerate(report.findings, 1)
            ),
            tag("section", *_seen(report), aria_labelledby="seen", class_="scope"),
        ),
        tag("footer", tag("p", "This page needs no network, and holds its findings as JSON.")),
        record(summary, class_="report", id="report-json"),
        raw("script", script),
    )
    return document(tag("html", head, body, lang="en"))


_REFUSED = "base-uri 'none'; form-action 'none'"


def _own(name: str) -> str:
    return (files("allworlds.reports.html") / name).read_text(encoding="utf-8")


def _hash(text: str) -> str:
    return f"'sha256-{b64encode(sha256(text.encode()).digest()).decode()}'"


def _seen(report: Report) -> Iterator[ET.Element]:
    """What the verdict is about, and what was counted."""
    yield tag("h2", "What was checked", id="seen")
    entries = []
    for name, text in scope_words(report):
        if name:
            entries.append(tag("dt", name))
        entries.append(tag("dd", tag("bdi", text)))
    yield tag("dl", *entries)
    header, rows = size_table(report)
    if rows:
        yield tag(
            "div",
            _table(header, rows),
            class_="frame",
            tabindex="0",
            role="group",
            aria_label="Counts",
        )


def _table(header: list[str], rows: list[list[str]]) -> ET.Element:
    return tag(
        "table",
        tag("caption", "Finished levels"),
        tag("thead", tag("tr", *(tag("th", name, scope="col") for name in header))),
        tag("tbody", *(tag("tr", *(tag("td", cell) for cell in row)) for row in rows)),
    )
