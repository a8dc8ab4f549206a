"""Reports as commands for GitHub's runner, which shows them at a line of the code."""

from __future__ import annotations

from allworlds.explorers.sources import place_of_explorer
from allworlds.outcome import Verdict
from allworlds.reports.file_format import Format
from allworlds.reports.project import project_folder
from allworlds.reports.rendering import finding_in_words
from allworlds.reports.telling import ToldResult
from allworlds.verbs import FINDINGS

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


def runner_commands(telling: ToldResult) -> str:
    """Commands, one for each finding at the explorer's file and line; else for the verdict."""
    from allworlds.reports.tellings.finding import headline_of
    from allworlds.studies.check.report import CheckReport

    report, head = telling.result, telling.headline
    assert isinstance(report, CheckReport)
    assert head is not None
    place = place_of_explorer(report.explorer)
    at = {}
    if place:
        at = {"file": place.named_from(project_folder()), "line": str(place.line)}
    told = [
        (headline_of(found), finding_in_words(found, WIDTH, i))
        for i, found in enumerate(report.findings, 1)
    ]
    told = told or [(f"allworlds: {head.word}", f"{report.explorer}: {head.text}")]
    kind = KINDS[report.verdict]
    return "".join(_command(kind, {**at, "title": title}, said) for title, said in told)


def _command(kind: str, properties: dict[str, str], message: str) -> str:
    """A command of the runner."""
    written = ",".join(f"{name}={_escaped(value, ':,')}" for name, value in properties.items())
    return f"::{kind} {written}::{_escaped(message)}\n"


def _escaped(text: str, more: str = "") -> str:
    """The text with per cent signs, line ends and further characters written as their numbers."""
    return "".join(f"%{ord(sign):02X}" if sign in "%\r\n" + more else sign for sign in text)


FORMAT = Format(runner_commands, "", (FINDINGS,), told_to="GITHUB_ACTIONS")
