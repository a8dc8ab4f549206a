"""Files for CI services: Markdown, JUnit XML, commands of GitHub's runner, and SARIF."""

from __future__ import annotations

import json
import os
import re
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any
from urllib.parse import quote
from xml.etree import ElementTree as ET

from allworlds.explorers.sources import SourceLine, place_of_explorer
from allworlds.judging.findings.finding import Finding
from allworlds.judging.laws.law_table import ASKED
from allworlds.outcome import Verdict
from allworlds.reports.parts import (
    FactList,
    MapPictures,
    ReportContent,
    Section,
    ShownWalk,
    Table,
)
from allworlds.reports.plain_text import finding_in_words, text_of
from allworlds.version import __version__
from allworlds.words import escaped, harmless_json

WIDTH = 100


def markdown(content: ReportContent) -> str:
    """The headline, every section with a picture, and the others folded."""
    head = [f"## {_plain(content.done)}: {_plain(content.subject)}"]
    if said := content.headline:
        named = content.done.partition(" ")[0]
        head = [f"## {named}: {said.word} {_plain(content.subject)}", _plain(said.text)]
    blocks = [block for section in content.sections for block in _section(section)]
    return "\n\n".join([*head, *blocks]) + "\n"


def _section(section: Section) -> Iterator[str]:
    if any(isinstance(block, ShownWalk | MapPictures) for block in section.blocks):
        yield from [f"### {_plain(section.title)}"] if section.title else []
        yield fenced(text_of([section], WIDTH))
        return
    for table in section.blocks:
        if isinstance(table, Table) and table.rows:
            yield from [f"**{_plain(table.caption)}**"] if table.caption else []
            yield _table(table.header, table.texts, table.right)
    others = [block for block in section.blocks if not isinstance(block, Table)]
    if others:
        yield f"<details><summary>{_plain(section.title or 'More')}</summary>"
        for block in others:
            if isinstance(block, FactList):
                yield _table(["", ""], block.entries, "ll")
            else:
                yield fenced(text_of([Section("", "", [block])], WIDTH))
        yield "</details>"


def _table(header: Sequence[str], rows: Sequence[Sequence[str]], right: str) -> str:
    rule = "| " + " | ".join("--:" if side == "r" else "---" for side in right) + " |"
    first, *lines = (f"| {' | '.join(_plain(cell) for cell in line)} |" for line in (header, *rows))
    return "\n".join([first, rule, *lines])


def fenced(text: str) -> str:
    """The text as a block of Markdown, in a fence that is longer than any in the text."""
    longest = max((len(run) for run in re.findall("`+", text)), default=0)
    fence = "`" * max(3, longest + 1)
    return f"{fence}text\n{text}\n{fence}"


def _plain(text: str) -> str:
    """The text in one line, with markup escaped."""
    one = escaped(re.sub(r"[\t\n\r]+", " ", text))
    one = one.replace("&", "&amp;").replace("<", "&lt;")
    return re.sub(r"([\\`*_|\[\]#~])", r"\\\1", one)


_FORBIDDEN = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def junit(content: ReportContent) -> str:
    """A document with one suite."""
    assert content.cases is not None
    cases, verb = content.cases(), content.done.removeprefix("allworlds ")
    results = Counter(case.result for case in cases)
    totals = {
        "tests": str(len(cases)),
        "failures": str(results["failure"]),
        "errors": str(results["error"]),
    }
    root = ET.Element("testsuites", {"name": content.done, **totals})
    # The schemas of services have this number at a suite, and not at the root.
    skipped = {"skipped": str(results["skipped"])}
    made = ET.SubElement(root, "testsuite", {"name": _legal(content.subject), **totals, **skipped})
    for case in cases:
        named = {"classname": f"allworlds.{verb}", "name": _legal(case.name)}
        element = ET.SubElement(made, "testcase", named)
        if case.result != "passed":
            kind = {} if case.result == "skipped" else {"type": case.kind}
            why = ET.SubElement(element, case.result, {"message": _legal(case.message), **kind})
            why.text = _legal(text_of(case.sections, WIDTH)) or None
    ET.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ET.tostring(root, "unicode") + "\n"


def _legal(text: str) -> str:
    """The text with control characters as numbers, and without others that XML does not allow."""
    return _FORBIDDEN.sub("\N{REPLACEMENT CHARACTER}", escaped(text))


LEVELS = {
    Verdict.ERROR: "error",
    Verdict.VACUOUS: "error",
    Verdict.INCONCLUSIVE: "warning",
}
"""How loud a verdict is that is no finding; the others say nothing that needs a notification."""


def runner_commands(content: ReportContent) -> str:
    """Commands, one for each finding at the explorer's file and line; else for the verdict."""
    from allworlds.reports.content.single_run import headline_of

    report: Any = content.result  # of a check
    head = content.headline
    assert head is not None
    place = place_of_explorer(report.explorer)
    at = {"file": place.named_from(project_folder()), "line": str(place.line)} if place else {}
    shown = [
        (headline_of(found), finding_in_words(found, WIDTH, i))
        for i, found in enumerate(report.findings, 1)
    ]
    kind, commands = "error" if shown else LEVELS.get(report.verdict, "notice"), []
    for title, said in shown or [(f"allworlds: {head.word}", f"{report.explorer}: {head.text}")]:
        named = (
            f"{name}={_escaped(value, ':,')}" for name, value in {**at, "title": title}.items()
        )
        commands.append(f"::{kind} {','.join(named)}::{_escaped(said)}\n")
    return "".join(commands)


def _escaped(text: str, more: str = "") -> str:
    """The text with per cent signs, line ends and further characters written as their numbers."""
    return "".join(f"%{ord(sign):02X}" if sign in "%\r\n" + more else sign for sign in text)


SCHEMA = (
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"
)

NO_FILE = "no file associated with this alert"
"""The location of a result without a file, as other tools have it: GitHub refuses one without."""


def sarif(content: ReportContent) -> str:
    """The report as a SARIF log with one run.

    Every law is a rule.  Every finding is a result at the file and line of the explorer, or at
    ``NO_FILE`` if no file is known (built-in explorers, programs on the PATH): its message has the
    picture and the walk.  A verdict without a finding that is no good news is a notification.
    """
    report: Any = content.result  # of a check
    head = content.headline
    assert head is not None
    place = place_of_explorer(report.explorer)
    rules = [
        {
            "id": law,
            "shortDescription": {"text": asked},
            "defaultConfiguration": {"level": "error"},
        }
        for law, asked in ASKED.items()
    ]
    driver = {"name": "allworlds", "semanticVersion": __version__, "rules": rules}
    level = LEVELS.get(report.verdict)
    said = [(level, head.line)] if level else []
    said += [("note", remark) for remark in report.remarks]
    invocation = {
        "executionSuccessful": report.verdict is not Verdict.ERROR and not report.interrupted,
        "exitCode": int(report.exit_code),
        "toolExecutionNotifications": [
            {"level": level, "message": {"text": text}} for level, text in said
        ],
    }
    run = {
        "tool": {"driver": driver},
        "invocations": [invocation],
        "originalUriBaseIds": {"SRCROOT": {"uri": project_folder().as_uri() + "/"}},
        "results": [_result(*found, place) for found in enumerate(report.findings, 1)],
    }
    log = {"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}
    return harmless_json(json.dumps(log, indent=2)) + "\n"


def _result(number: int, finding: Finding, place: SourceLine | None) -> dict[str, Any]:
    from allworlds.reports.content.single_run import headline_of

    text = finding_in_words(finding, WIDTH, number)
    head = f"{headline_of(finding)}."
    where = _artifact(place) if place else {"uri": quote(NO_FILE)}
    if not place:
        head += " No file with the explorer's code is known, so this stands at none."
    region = {"startLine": place.line if place else 1}
    return {
        "ruleId": finding.law,
        "level": "error",
        "message": {"text": f"{head}\n\n{text}", "markdown": f"{head}\n\n{fenced(text)}"},
        "locations": [{"physicalLocation": {"artifactLocation": where, "region": region}}],
        # The name of the finding's file holds a digest of all of it.
        "partialFingerprints": {"finding/v1": finding.file_name},
    }


def _artifact(place: SourceLine) -> dict[str, Any]:
    """The location of a file, relative to the project's folder where possible."""
    name = place.named_from(project_folder())
    if Path(name).is_absolute():
        return {"uri": place.file.as_uri()}
    return {"uri": quote(os.fsencode(name)), "uriBaseId": "SRCROOT"}


def project_folder() -> Path:
    """The project's folder in a CI service; elsewhere the current folder."""
    return Path(os.environ.get("GITHUB_WORKSPACE") or Path.cwd()).resolve()
