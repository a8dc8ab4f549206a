"""Results in the form in which notebooks and ``print`` show them."""

from html import escape
from typing import Any
from xml.etree import ElementTree as ET

from allworlds.documents.report import Report
from allworlds.documents.shown import Writers
from allworlds.judging.findings.finding import Finding
from allworlds.protocol.actions import Transcript
from allworlds.reports import formats, plain_text
from allworlds.reports.content.single_run import finding_section, headline_of
from allworlds.reports.drawing.svg import draw
from allworlds.reports.parts import Cell, Table, rows_of
from allworlds.reports.web.sections import element, framed, table_element
from allworlds.words import harmless

WIDTH = 100
"""The number of columns of a printed report."""

MOST = 20
"""The largest number of lines of a result in a Python shell."""

HEIGHT = 480
"""The height in pixels of a page in a notebook; the page scrolls."""


def text_of(value: Report | Finding | Transcript) -> str:
    """The text of a value, as on the command line; for a transcript, a line for each step."""
    match value:
        case Transcript():
            steps = _steps(value)
            return "\n".join(plain_text.table(steps.header, steps.texts, "r"))
        case Finding():
            return plain_text.finding_in_words(value, WIDTH)
        case _:
            return formats.text(value, WIDTH).rstrip("\n")


def short_text_of(value: Report | Finding) -> str:
    """The text of a value for a Python shell: first lines and last line, at most :data:`MOST`."""
    text = text_of(value)
    if isinstance(value, Report):
        content = formats.content_of(value)
        text = harmless(plain_text.on_terminal(content, WIDTH, whole=False))
    lines = text.splitlines()
    if (more := len(lines) - MOST) > 0:
        lines[MOST - 2 : -1] = [f"... ({more + 1} lines more: print it)"]
    return "\n".join(lines)


def records(report: Report) -> list[dict[str, Any]]:
    """The rows that ``-o FILE.csv`` writes, as dictionaries, by the names of the columns."""
    return rows_of(formats.content_of(report)).records


def shown(value: Report | Finding | Transcript) -> str:
    """The HTML of a value: a table for a transcript, else a whole page in a frame of its own.

    In a frame, neither the style of the page nor its keyboard shortcuts affect the notebook.
    """
    match value:
        case Transcript():
            return ET.tostring(table_element(_steps(value)), "unicode")
        case Finding():
            verdict = ("REFUTED", headline_of(value), "refuted")
            section = element(finding_section(value))
            page = framed(("finding", value.explorer), verdict, [section], value.to_json())
        case _:
            page = formats.html(formats.content_of(value))
    return (
        f'<iframe srcdoc="{escape(page)}" width="100%" height="{HEIGHT}" '
        'style="border: 1px solid #d5d9dd" title="allworlds"></iframe>'
    )


def _steps(transcript: Transcript) -> Table:
    """The table of a transcript: a row for the start and for each step."""
    rows = [("start", transcript.first), *transcript.steps]
    steps: list[list[Cell]] = [[i, str(action), str(it)] for i, (action, it) in enumerate(rows)]
    return Table(["step", "action", "sensed"], steps)


WRITERS = Writers(text_of, short_text_of, shown, lambda value: draw(value).svg, records)
"""The functions that write values as text, page, picture and rows; ``allworlds`` registers them."""
