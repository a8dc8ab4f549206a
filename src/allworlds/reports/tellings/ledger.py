"""Telling of ``ledger``: each claim, expected beside found."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping

from allworlds.reports.drawing.scene import scene_of
from allworlds.reports.rows import CsvRows
from allworlds.reports.telling import (
    Block,
    Headline,
    Section,
    Suite,
    ToldCase,
    ToldFacts,
    ToldPicture,
    ToldResult,
    ToldTable,
    Words,
    so_far,
)
from allworlds.studies.ledger import CheckedClaim, LedgerReport
from allworlds.words import number, plural

LEGEND = "= as expected, ≠ not as expected, ? vacuous, - not checked"

SIGNS = {"as-expected": "=", "unexpected": "≠", "vacuous": "?", "not-checked": "-"}
"""Before each claim: whether it is what is expected."""

VERDICTS = {
    0: ("HOLDS", "holds"),
    1: ("REFUTED", "refuted"),
    3: ("INCONCLUSIVE", "inconclusive"),
    4: ("VACUOUS", "vacuous"),
    70: ("ERROR", "error"),
    130: ("INCONCLUSIVE", "inconclusive"),
}
"""The word, and the verdict whose colour it has, by the exit code."""


def ledger_telling(report: LedgerReport) -> ToldResult:
    """A row for each claim; for a single claim, and on a page for each, also the details."""
    facts = []
    for one in report.claims:
        if one.standing in ("unexpected", "vacuous"):
            facts.append(("DIFFERS", f"{one.id}: {'; '.join(one.differences)}"))
    facts += [("REQUIRED", f"{name} was not checked") for name in report.missed]
    ledger: list[Block] = [ToldFacts(facts)] if facts else []
    header = ["", "claim", "found", "sentence"]
    rows = [[SIGNS[one.standing], one.id, one.verdict, one.statement] for one in report.claims]
    ledger += [ToldTable(header, rows, "Every claim", keys=2), Words(LEGEND)]
    sections = [_section(one) for one in report.claims]
    alone = sections if len(sections) == 1 else []
    return ToldResult(
        "allworlds ledger",
        f"budget {report.budget}",
        report,
        _headline(report),
        [Section("ledger", "The ledger", ledger), *alone],
        more=lambda: [] if alone else sections,
        rows=lambda: _rows(report),
        suite=lambda: _suite(report),
    )


def _rows(report: LedgerReport) -> CsvRows:
    names = ("section", "claim", "sentence", "method", "expected", "found", "standing")
    rows = [
        [one.section, one.id, one.statement, one.method, one.expected, one.verdict, one.standing]
        for one in report.claims
    ]
    return CsvRows(dict.fromkeys(names, str), rows)


def _heading(section: str) -> str:
    """``Section IV``; a section that is no number is its own heading."""
    return f"Section {section}" if re.fullmatch(r"[IVXLC]+|[0-9.]+|[A-Z]", section) else section


def _headline(report: LedgerReport) -> Headline | None:
    """The verdict, and the number of claims with each outcome."""
    standings = Counter(one.standing for one in report.claims)
    checked = [one for one in report.claims if one.standing == "as-expected"]
    held = sum(one.verdict == "holds" for one in checked)
    refuted = len(checked) - held
    parts = []
    if held:
        parts.append(f"{number(held)} {'holds' if held == 1 else 'hold'}")
    if refuted:
        parts.append(f"{number(refuted)} {'is' if refuted == 1 else 'are'} refuted, as expected")
    errors = sum(one.verdict == "error" for one in report.claims)
    if unexpected := standings["unexpected"] - errors:
        parts.append(f"{number(unexpected)} not as expected")
    if errors:
        parts.append(f"{number(errors)} ended in an error of this program")
    if standings["vacuous"]:
        parts.append(f"{number(standings['vacuous'])} vacuous")
    if standings["not-checked"]:
        parts.append(f"{number(standings['not-checked'])} not checked ({_needed(report)})")
    word, verdict = VERDICTS[int(report.exit_code)]
    said = f"{plural(len(report.claims), 'claim')}: {', '.join(parts)}"
    told = Headline(word, said, verdict)
    return so_far(report, told if report.claims else None)


def _needed(report: LedgerReport) -> str:
    """The reasons why claims were not checked, each with the number of its claims."""
    reasons = Counter(one.told for one in report.claims if one.standing == "not-checked")
    if len(reasons) == 1:
        return next(iter(reasons))
    return "; ".join(f"{number(count)}: {reason}" for reason, count in reasons.items())


def _section(one: CheckedClaim) -> Section:
    """One claim, with the worlds that show it."""
    told = [("verdict", f"{one.verdict}, {one.standing.replace('-', ' ')}"), *_details(one)]
    if one.differences:
        told.append(("differs", "; ".join(one.differences)))
    pictures = [
        ToldPicture(caption.capitalize(), scene_of(world))
        for caption, world in zip(one.captions, one.worlds, strict=True)
    ]
    blocks: list[Block] = [Words(one.statement), *pictures, ToldFacts(told)]
    return Section(one.id, f"{_heading(one.section)}: {one.id}", blocks)


def _suite(report: LedgerReport) -> Suite:
    """A case for each claim: passed as expected, failed otherwise, skipped if not checked."""
    properties = {
        "budget": report.budget,
        "exit_code": int(report.exit_code),
        "complete": report.complete,
    }
    cases = [_case(one, required=one.id in report.missed) for one in report.claims]
    return Suite("ledger", "ledger", properties, cases)


def _case(one: CheckedClaim, *, required: bool) -> ToldCase:
    name = f"{_heading(one.section)}: {one.id}: {one.statement}"
    told = [Section(one.id, "", [ToldFacts(_details(one))])]
    if one.standing == "not-checked":
        if required:
            return ToldCase(name, "failure", "required", one.told, told)
        return ToldCase(name, "skipped", message=one.told)
    if one.standing == "as-expected":
        return ToldCase(name)
    return ToldCase(name, "failure", one.standing, "; ".join(one.differences), told)


def _details(one: CheckedClaim) -> list[tuple[str, str]]:
    """Further named facts about a claim."""
    told = [
        ("method", one.method),
        ("scope", one.scope),
        ("expected", one.expected),
        ("source", one.source),
    ]
    if one.standing == "not-checked":
        return [*told, ("reason", one.told)]
    if one.witnesses:
        told.append(("witnesses", _listed(one.witnesses)))
    if one.figures:
        told.append(("figures", _listed(one.figures)))
    if one.told:
        told.append(("seen", one.told))
    return told


def _listed(values: Mapping[str, object]) -> str:
    return ", ".join(f"{name} {_value(value)}" for name, value in values.items())


def _value(value: object) -> str:
    if isinstance(value, list):
        return "[" + ", ".join(map(str, value)) + "]"
    return number(value) if isinstance(value, int) else str(value)
