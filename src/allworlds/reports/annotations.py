"""Reports as the commands by which a program tells GitHub's runner what to write at which line."""

from __future__ import annotations

from allworlds.explorers import place_of_explorer
from allworlds.outcome import Verdict
from allworlds.reports.check_words import verdict_words
from allworlds.reports.finding_words import headline
from allworlds.reports.project import project_folder
from allworlds.reports.run_text import finding_text
from allworlds.studies.check import CheckReport

WIDTH = 80

KINDS = {
    Verdict.HOLDS: "notice",
    Verdict.NOT_REFUTED: "notice",
    Verdict.INCONCLUSIVE: "warning",
    Verdict.VACUOUS: "error",
    Verdict.ERROR: "error",
    Verdict.REFUTED: "error",
}
"""How loud a verdict is."""


def runner_commands(report: CheckReport) -> str:
    """One line a finding, at the file and line of the explorer; without one, the verdict's."""
    place = place_of_explorer(report.explorer)
    at = {}
    if place:
        at = {"file": place.named_from(project_folder()), "line": str(place.line)}
    word, text = verdict_words(report)
    told = [(headline(found), finding_text(found, WIDTH)) for found in report.findings]
    told = told or [(f"allworlds: {word}", f"{report.explorer}: {text}")]
    kind = KINDS[report.verdict]
    return "".join(_command(kind, {**at, "title": title}, said) for title, said in told)


def _command(kind: str, properties: dict[str, str], message: str) -> str:
    """Source: the runner's rules for what stands in properties and messages."""
    written = ",".join(f"{name}={_escaped(value, ':,')}" for name, value in properties.items())
    return f"::{kind} {written}::{_escaped(message)}\n"


def _escaped(text: str, more: str = "") -> str:
    """Per cent signs and ends of lines by their numbers, and what else is named."""
    return "".join(f"%{ord(sign):02X}" if sign in "%\r\n" + more else sign for sign in text)
