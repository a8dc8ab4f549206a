"""Reports as SARIF 2.1.0, which code scanning services and editors show beside the code."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any
from urllib.parse import quote

from allworlds.explorers.sources import SourceLine, place_of_explorer
from allworlds.judging.findings.finding import Finding
from allworlds.judging.findings.walks import true_trail
from allworlds.judging.laws.law_table import ASKED
from allworlds.outcome import Verdict
from allworlds.protocol.actions import Move
from allworlds.reports.file_format import Format
from allworlds.reports.project import project_folder
from allworlds.reports.rendering import finding_in_words
from allworlds.reports.telling import ToldResult
from allworlds.reports.text_layout import fenced
from allworlds.verbs import FINDINGS
from allworlds.version import __version__
from allworlds.words import harmless_json

if TYPE_CHECKING:
    from allworlds.studies.check.report import CheckReport

SCHEMA = (
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"
)
WIDTH = 100

LEVELS = {
    Verdict.ERROR: "error",
    Verdict.VACUOUS: "error",
    Verdict.INCONCLUSIVE: "warning",
}
"""How loud a verdict is that is no finding; the others say nothing that needs a notification."""

NO_FILE = "no file associated with this alert"
"""The location of a result without a file, as other tools have it: GitHub refuses one without."""


def sarif(telling: ToldResult) -> str:
    """The report as a SARIF log with one run.

    Every law is a rule.  Every finding is a result at the file and line of the explorer, or at
    ``NO_FILE`` if no file is known (built-in explorers, programs on the PATH): its message has the
    picture and the walk, its ``graphs`` the world with a directed edge for each dart, and its
    ``graphTraversals`` the robot's walk along them.  A verdict without a finding that is no good
    news is a notification.  ``properties`` hold the report without its findings, those of a result
    the document of its finding.
    """
    from allworlds.studies.check.report import CheckReport

    report, head = telling.result, telling.headline
    assert isinstance(report, CheckReport)
    assert head is not None
    place = place_of_explorer(report.explorer)
    document: dict[str, Any] = dict(report.to_json())
    del document["findings"]
    run = {
        "tool": {"driver": _driver()},
        "invocations": [_invocation(report, head.line)],
        "columnKind": "unicodeCodePoints",
        "originalUriBaseIds": {"SRCROOT": {"uri": project_folder().as_uri() + "/"}},
        "artifacts": [{"location": _artifact(place)}] if place else [],
        "results": [_result(*told, place) for told in enumerate(report.findings, 1)],
        "properties": {"report": document},
    }
    log = {"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}
    return harmless_json(json.dumps(log, indent=2)) + "\n"


def _driver() -> dict[str, Any]:
    rules = [
        {
            "id": law,
            "shortDescription": {"text": asked},
            "defaultConfiguration": {"level": "error"},
        }
        for law, asked in ASKED.items()
    ]
    return {"name": "allworlds", "semanticVersion": __version__, "rules": rules}


def _invocation(report: CheckReport, verdict: str) -> dict[str, Any]:
    """Completion of the check itself, and its further remarks."""
    level = LEVELS.get(report.verdict)
    said = [(level, verdict)] if level else []
    said += [("note", remark) for remark in report.remarks]
    return {
        "executionSuccessful": report.verdict is not Verdict.ERROR and not report.interrupted,
        "exitCode": int(report.exit_code),
        "toolExecutionNotifications": [
            {"level": level, "message": {"text": text}} for level, text in said
        ],
    }


def _result(number: int, finding: Finding, place: SourceLine | None) -> dict[str, Any]:
    from allworlds.reports.tellings.finding import headline_of

    text = finding_in_words(finding, WIDTH, number)
    head = f"{headline_of(finding)}."
    if not place:
        head += " No file with the explorer's code is known, so this stands at none."
    graph, traversal = _walk(finding)
    return {
        "ruleId": finding.law,
        "ruleIndex": [*ASKED].index(finding.law),
        "level": "error",
        "message": {
            "text": f"{head}\n\n{text}",
            "markdown": f"{head}\n\n{fenced(text)}",
        },
        "locations": [_location(place)],
        # The name of the finding's file holds a digest of all of it.
        "partialFingerprints": {"finding/v1": finding.file_name},
        "graphs": [graph],
        "graphTraversals": [traversal],
        "properties": {"finding": finding.to_json()},
    }


def _walk(finding: Finding) -> tuple[dict[str, Any], dict[str, Any]]:
    """The world as a graph with a directed edge for each dart, and the walk along its edges."""
    map_ = finding.world.map
    graph = {
        "description": {"text": "the world; a directed edge leaves along each dart"},
        "nodes": [{"id": f"v{vertex}"} for vertex in range(map_.vertex_count)],
        "edges": [
            {
                "id": f"d{dart}",
                "sourceNodeId": f"v{map_.vertex_of[dart]}",
                "targetNodeId": f"v{map_.vertex_of[other]}",
            }
            for dart, other in enumerate(map_.alpha)
        ],
    }
    trail = true_trail(finding.world, finding.transcript)
    log = zip(trail[1:], finding.transcript.actions, finding.transcript.percepts[1:], strict=True)
    # The robot stands on the dart by which it came: it left by the other half of that edge.
    steps = [
        {"edgeId": f"d{map_.alpha[dart]}", "message": {"text": f"{action}: sensed {percept}"}}
        for dart, action, percept in log
        if type(action) is Move
    ]
    walked = {"description": {"text": "the walk"}, "resultGraphIndex": 0, "edgeTraversals": steps}
    return graph, walked


def _location(place: SourceLine | None) -> dict[str, Any]:
    where: dict[str, Any] = {"uri": quote(NO_FILE)}
    if place:
        where = {**_artifact(place), "index": 0}
    region = {"startLine": place.line if place else 1}
    return {"physicalLocation": {"artifactLocation": where, "region": region}}


def _artifact(place: SourceLine) -> dict[str, Any]:
    """The location of a file, relative to the project's folder where possible."""
    name = place.named_from(project_folder())
    if Path(name).is_absolute():
        return {"uri": place.file.as_uri()}
    return {"uri": quote(os.fsencode(name)), "uriBaseId": "SRCROOT"}


FORMAT = Format(sarif, ".sarif", (FINDINGS,))
