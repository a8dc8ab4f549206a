"""Reports as JUnit XML, which most CI services show."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal
from xml.etree import ElementTree as ET

from allworlds.engines import Sample
from allworlds.judging import Finding
from allworlds.outcome import Verdict
from allworlds.reports.run_text import finding_text
from allworlds.studies.check import CheckReport, Disagreed
from allworlds.version import __version__
from allworlds.words import plural, size

WIDTH = 100
_FORBIDDEN = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


@dataclass(frozen=True, slots=True)
class JUnitCase:
    """One test case; ``kind`` tells which list of the sum it is in."""

    name: str
    result: Literal["passed", "failure", "error", "skipped"] = "passed"
    kind: str = ""
    message: str = ""
    text: str = ""


def junit(report: CheckReport) -> str:
    """The report as a JUnit XML document with one suite.

    An exhaustive check has one case for each number of edges of its scope: passed; failed,
    with its findings; an error where the count gate or two engines disagree; skipped, with
    the reason, where the level was not finished.  Where they are judged, a case ``past
    findings`` comes before them and a case ``witnesses`` after.  A sample is one case.
    """
    coverage = report.asked.coverage
    sampled = isinstance(coverage, Sample)
    cases = (
        [_sample(report, coverage)]
        if isinstance(coverage, Sample)
        else [*_past(report), *_levels(report), *_whole(report)]
    )
    verb = "fuzz" if sampled else "check"
    return junit_text(verb, report.explorer, _told(report), cases)


def junit_text(
    verb: str, suite: str, properties: Mapping[str, object], cases: Sequence[JUnitCase]
) -> str:
    """A document with one suite."""
    totals = {"tests": str(len(cases))}
    for result, name in (("failure", "failures"), ("error", "errors"), ("skipped", "skipped")):
        totals[name] = str(sum(case.result == result for case in cases))
    root = ET.Element("testsuites", {"name": f"allworlds {verb}", **totals})
    made = ET.SubElement(root, "testsuite", {"name": _legal(suite), **totals})
    _add_properties(made, properties)
    for case in cases:
        element = ET.SubElement(
            made, "testcase", {"classname": f"allworlds.{verb}", "name": _legal(case.name)}
        )
        if case.result == "passed":
            continue
        message = {"message": _legal(case.message)}
        kind = {} if case.result == "skipped" else {"type": case.kind}
        ET.SubElement(element, case.result, {**message, **kind}).text = _legal(case.text) or None
    ET.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ET.tostring(root, "unicode") + "\n"


def _told(report: CheckReport) -> Mapping[str, object]:
    """Verdict and scope, which no result is worth anything without."""
    document: Mapping[str, Any] = report.to_json()
    named = ("verdict", "exit_code", "engine", "worlds", "runs", "traversals")
    told = {"version": __version__, **{name: document[name] for name in named}}
    return told | {f"scope.{name}": value for name, value in document["scope"].items()}


def _add_properties(suite: ET.Element, told: Mapping[str, object]) -> None:
    properties = ET.SubElement(suite, "properties")
    for name, value in told.items():
        text = value if isinstance(value, str) else json.dumps(value)
        ET.SubElement(properties, "property", {"name": name, "value": _legal(text)})


def _past(report: CheckReport) -> Iterator[JUnitCase]:
    """One case for a user's corpus, if there is one."""
    if report.past:
        standing = [finding for finding in report.findings if report.past.holds(finding)]
        yield _failure("past findings", standing) if standing else JUnitCase("past findings")


def _levels(report: CheckReport) -> Iterator[JUnitCase]:
    """One case a level."""
    past = report.past
    new = [finding for finding in report.findings if not (past and past.holds(finding))]
    for edges in report.asked.extent.levels:
        name = f"every world with {plural(edges, 'edge')}"
        found = [finding for finding in new if finding.key[0] == edges]
        wrong = [cell for cell in report.cells if cell.edges == edges and not cell.agrees]
        if wrong:
            text = "\n".join(
                f"of maps with {size(cell.edges, cell.vertices)} {cell.enumerated} were "
                f"enumerated, but {cell.source} counts {cell.counted}"
                for cell in wrong
            )
            told = "\n\n".join([text, *(finding_text(finding, WIDTH) for finding in found)])
            yield JUnitCase(name, "error", "count-gate", text.splitlines()[0], told)
        elif found:
            yield _failure(name, found)
        elif edges in report.levels:
            yield JUnitCase(name)
        else:
            yield JUnitCase(
                name, "skipped", message=report.ending.reason or "the level was not finished"
            )


def _whole(report: CheckReport) -> Iterator[JUnitCase]:
    """What is judged about the scope as a whole."""
    gate = all(cell.agrees for cell in report.cells)
    if isinstance(report.ending, Disagreed) and gate:
        yield JUnitCase(
            "engines", "error", "engines-disagree", "two engines disagree", report.ending.reason
        )
    if not report.complete or not report.asked.whole:
        return
    if not report.runs:
        yield JUnitCase("witnesses", "failure", "vacuous", "nothing was checked: there is no run")
    elif report.missing_witnesses:
        missing = f"never seen: {', '.join(report.missing_witnesses)}"
        yield JUnitCase("witnesses", "failure", "vacuous", missing)
    else:
        yield JUnitCase("witnesses")


def _sample(report: CheckReport, sample: Sample) -> JUnitCase:
    edges = plural(report.asked.extent.levels[-1], "edge")
    least = "up to" if sample.min_edges == 1 else f"{sample.min_edges} to"
    name = f"{plural(sample.runs, 'random world')} with {least} {edges}"
    if report.findings:
        return _failure(name, report.findings)
    if report.verdict is Verdict.NOT_REFUTED:
        return JUnitCase(name)
    return JUnitCase(name, "skipped", message=report.ending.reason or "no world was tried")


def _failure(name: str, findings: Sequence[Finding]) -> JUnitCase:
    first = findings[0]
    text = "\n\n".join(finding_text(finding, WIDTH) for finding in findings)
    return JUnitCase(name, "failure", first.law, f"law '{first.law}' is broken", text)


def _legal(text: str) -> str:
    """The text with a sign in place of each character that XML does not allow."""
    return _FORBIDDEN.sub("\N{REPLACEMENT CHARACTER}", text)
