"""Results as notebooks show them, and as ``print`` does."""

from __future__ import annotations

from html import escape
from typing import Any
from xml.etree import ElementTree as ET

from allworlds.document import Report
from allworlds.judging import Finding
from allworlds.protocol import Transcript
from allworlds.reports import csv_rows
from allworlds.reports.html.frame import Page, framed
from allworlds.reports.html.html_page import html
from allworlds.reports.html.sections import element
from allworlds.reports.markup import tag
from allworlds.reports.rendering import finding_in_words, text, told, verb_of
from allworlds.reports.tellings.finding import finding_section, headline_of

WIDTH = 100
"""Columns of a printed report."""

HEIGHT = 480
"""Pixels of a page in a notebook; it scrolls."""


def text_of(report: Report | Finding) -> str:
    """The text of the command line."""
    if isinstance(report, Finding):
        return finding_in_words(report, WIDTH)
    return text(verb_of(type(report)), report, WIDTH).rstrip("\n")


def records(report: Report) -> list[dict[str, Any]]:
    """The rows of ``--csv``, by the names of their columns."""
    return csv_rows.records(told(verb_of(type(report)), report))


def shown(value: Report | Finding | Transcript) -> str:
    """An element of a page: a table of steps, or a whole page in a frame of its own.

    The style and the keys of a page in a frame touch nothing outside.
    """
    match value:
        case Transcript():
            return _steps(value)
        case Finding():
            verdict = ("REFUTED", headline_of(value), "refuted")
            section = element(finding_section(value, 1))
            page = framed(Page("finding", value.explorer, verdict, [section], value.to_json()))
        case _:
            page = html(told(verb_of(type(value)), value))
    return (
        f'<iframe srcdoc="{escape(page)}" width="100%" height="{HEIGHT}" '
        'style="border: 1px solid #d5d9dd" title="allworlds"></iframe>'
    )


def _steps(transcript: Transcript) -> str:
    rows = [("start", transcript.first), *transcript.steps]
    body = [
        tag("tr", *(tag("td", str(cell)) for cell in (i, action, percept)))
        for i, (action, percept) in enumerate(rows)
    ]
    head = tag("tr", *(tag("th", name) for name in ("step", "action", "sensed")))
    return ET.tostring(tag("table", tag("thead", head), tag("tbody", *body)), "unicode")
