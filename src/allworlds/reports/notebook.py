"""Results as notebooks show them, and as ``print`` does."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import Any
from xml.etree import ElementTree as ET

from allworlds.document.report import Report
from allworlds.judging.findings.finding import Finding
from allworlds.protocol.transcript import Transcript
from allworlds.reports.formats.csv import rows_of
from allworlds.reports.formats.html import html
from allworlds.reports.rendering import finding_in_words, tag, text, told, verb_of
from allworlds.reports.tellings.finding import finding_section, headline_of
from allworlds.reports.text_layout import table
from allworlds.reports.web.frame import Page, framed
from allworlds.reports.web.sections import element

WIDTH = 100
"""Columns of a printed report."""

HEIGHT = 480
"""Pixels of a page in a notebook; it scrolls."""


def text_of(value: Report | Finding | Transcript) -> str:
    """The text of the command line; of a transcript a line for each step."""
    match value:
        case Transcript():
            return "\n".join(table(*_steps(value), "r"))
        case Finding():
            return finding_in_words(value, WIDTH)
        case _:
            return text(verb_of(type(value)), value, WIDTH).rstrip("\n")


def records(report: Report) -> list[dict[str, Any]]:
    """The rows of ``-o FILE.csv``, by the names of their columns."""
    return rows_of(told(verb_of(type(report)), report)).records


def shown(value: Report | Finding | Transcript) -> str:
    """An element of a page: a table of steps, or a whole page in a frame of its own.

    The style and the keys of a page in a frame touch nothing outside.
    """
    match value:
        case Transcript():
            return _element(*_steps(value))
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


def _steps(transcript: Transcript) -> tuple[list[str], list[list[str]]]:
    """The names of the columns, and a row for the start and for each step."""
    rows = [("start", transcript.first), *transcript.steps]
    told = [[str(i), str(action), str(percept)] for i, (action, percept) in enumerate(rows)]
    return ["step", "action", "sensed"], told


def _element(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table as an element of a page."""
    head = tag("tr", *(tag("th", name) for name in header))
    body = [tag("tr", *(tag("td", cell) for cell in row)) for row in rows]
    return ET.tostring(tag("table", tag("thead", head), tag("tbody", *body)), "unicode")
