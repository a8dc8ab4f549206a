"""Results of ``check`` and ``fuzz`` as test runners count them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from allworlds.engines import Given, Sample
from allworlds.judging import Finding
from allworlds.outcome import Disagreed, Verdict
from allworlds.reports.telling import Section, Suite, ToldCase, Words
from allworlds.reports.tellings.finding import finding_section, nothing_checked
from allworlds.studies.check import CheckReport
from allworlds.version import __version__
from allworlds.words import plural, size


def check_suite(report: CheckReport, verb: str) -> Suite:
    """The cases of a check, or of a sample."""
    return Suite(verb, report.explorer, _properties(report), [*_cases(report)])


def numbered_finding(report: CheckReport, number: int) -> Section:
    """One of the findings, with its origin."""
    finding = report.findings[number]
    past = report.past and report.past.holds(finding)
    return finding_section(finding, number + 1, "from the corpus" if past else "")


def reason_if_vacuous(report: CheckReport) -> str:
    """The reason why a complete check says nothing."""
    if not report.runs:
        return "the scope holds no run"
    if not report.checked_laws:
        return nothing_checked(report.asked.rules)
    return "a witness is missing"


def _properties(report: CheckReport) -> dict[str, object]:
    """Verdict and scope, which belong to every result."""
    document: Mapping[str, Any] = report.to_json()
    named = ("verdict", "exit_code", "engine", "worlds", "runs", "traversals")
    told = {"version": __version__, **{name: document[name] for name in named}}
    return told | {f"scope.{name}": value for name, value in document["scope"].items()}


def _cases(report: CheckReport) -> Iterator[ToldCase]:
    """A case for each number of edges, of past findings before and of witnesses after; or one.

    A level is passed; failed, with its findings; an error where the count gate or two engines
    disagree; skipped, with the reason, where it was not finished.  A sample is one case.
    """
    if isinstance(report.asked.coverage, Sample):
        yield _sample(report, report.asked.coverage)
        return
    yield from _past(report)
    yield from _levels(report)
    yield from _whole(report)


def _past(report: CheckReport) -> Iterator[ToldCase]:
    """One case for a user's corpus, if there is one."""
    if report.past:
        standing = [finding for finding in report.findings if report.past.holds(finding)]
        yield _failure(report, "past findings", standing) if standing else ToldCase("past findings")


def _levels(report: CheckReport) -> Iterator[ToldCase]:
    """One case for each level."""
    past = report.past
    new = [finding for finding in report.findings if not (past and past.holds(finding))]
    every = "every given world" if isinstance(report.asked.coverage, Given) else "every world"
    for edges in report.asked.sizes:
        name = f"{every} with {plural(edges, 'edge')}"
        found = [finding for finding in new if finding.key[0] == edges]
        wrong = [cell for cell in report.cells if cell.edges == edges and not cell.agrees]
        if wrong:
            text = "\n".join(
                f"of maps with {size(cell.edges, cell.vertices)} {cell.enumerated} were "
                f"enumerated, but {cell.source} counts {cell.counted}"
                for cell in wrong
            )
            told = [Section("gate", "", [Words(text)]), *_sections(report, found)]
            yield ToldCase(name, "error", "count-gate", text.splitlines()[0], told)
        elif found:
            yield _failure(report, name, found)
        elif edges in report.levels:
            yield ToldCase(name)
        else:
            yield ToldCase(
                name, "skipped", message=report.ending.reason or "the level was not finished"
            )


def _whole(report: CheckReport) -> Iterator[ToldCase]:
    """Judgements about the scope as a whole."""
    gate = all(cell.agrees for cell in report.cells)
    if isinstance(report.ending, Disagreed) and gate:
        told = [Section("engines", "", [Words(report.ending.reason)])]
        yield ToldCase("engines", "error", "engines-disagree", "two engines disagree", told)
    if not report.complete or not report.asked.whole:
        return
    if not report.checked_laws:
        yield ToldCase("witnesses", "failure", "vacuous", reason_if_vacuous(report))
    elif report.missing_witnesses:
        missing = f"never seen: {', '.join(report.missing_witnesses)}"
        yield ToldCase("witnesses", "failure", "vacuous", missing)
    else:
        yield ToldCase("witnesses")


def _sample(report: CheckReport, sample: Sample) -> ToldCase:
    edges = plural(report.asked.extent.levels[-1], "edge")
    least = "up to" if sample.min_edges == 1 else f"{sample.min_edges} to"
    name = f"{plural(sample.runs, 'random world')} with {least} {edges}"
    if report.findings:
        return _failure(report, name, report.findings)
    if report.verdict is Verdict.NOT_REFUTED:
        return ToldCase(name)
    return ToldCase(name, "skipped", message=report.ending.reason or "no world was tried")


def _failure(report: CheckReport, name: str, findings: Sequence[Finding]) -> ToldCase:
    law = findings[0].law
    return ToldCase(name, "failure", law, f"law '{law}' is broken", _sections(report, findings))


def _sections(report: CheckReport, findings: Sequence[Finding]) -> list[Section]:
    """Sections for these findings, as the check shows them."""
    return [numbered_finding(report, report.findings.index(finding)) for finding in findings]
