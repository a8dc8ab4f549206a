"""Content of reports of ``ledger``: each claim, with the expected and the found result."""

import re
from collections import Counter
from collections.abc import Mapping
from shlex import join

from allworlds import outcome, words
from allworlds.documents.document import replace
from allworlds.reports import parts
from allworlds.studies.ledger import CheckedClaim, LedgerReport

LEGEND = "Signs: = as expected, ≠ not as expected, ? vacuous, - not checked."

SIGNS = {"as-expected": "=", "unexpected": "≠", "vacuous": "?", "not-checked": "-"}
"""The sign before each claim, by the claim's standing."""

VERDICTS = {
    outcome.Exit.HOLDS: "holds",
    outcome.Exit.REFUTED: "refuted",
    outcome.Exit.VACUOUS: "vacuous",
    outcome.Exit.INTERNAL: "error",
}
"""The verdict of an exit code; every other exit code means inconclusive."""


def ledger_content(report: LedgerReport) -> parts.ReportContent:
    """The content for a ledger: a row for each claim.

    If there is a single claim, its details follow; the details of several claims are on pages only.
    """
    facts = [
        ("DIFFERS", f"{one.id}: {'; '.join(one.differences)}")
        for one in report.claims
        if one.standing in ("unexpected", "vacuous")
    ]
    missed = "must be checked, as --require says, but was not"
    facts += [("REQUIRED", f"{name} {missed}") for name in report.missed]
    ledger: list[parts.Block] = [parts.FactList(facts)] if facts else []
    header = ["", "claim", "found", "sentence"]
    rows = [[SIGNS[one.standing], one.id, one.verdict, one.statement] for one in report.claims]
    ledger += [parts.Table(header, rows, "Every claim", keys=2), parts.Paragraph(LEGEND)]
    sections = [_section(one) for one in report.claims]
    alone = sections if len(sections) == 1 else []
    return parts.ReportContent(
        "allworlds ledger",
        f"budget {report.budget}",
        report,
        _headline(report),
        [parts.Section("ledger", "The ledger", ledger), *alone],
        more=lambda: [] if alone else sections,
        rows=lambda: _rows(report),
        cases=lambda: [
            replace(_case(one, required=one.id in report.missed), seconds=one.seconds)
            for one in report.claims
        ],
        command=join([report.directory, "--budget", report.budget]),
    )


def _rows(report: LedgerReport) -> parts.CsvRows:
    names = ("section", "claim", "sentence", "method", "expected", "found", "standing")
    rows = [
        [one.section, one.id, one.statement, one.method, one.expected, one.verdict, one.standing]
        for one in report.claims
    ]
    return parts.CsvRows(dict.fromkeys(names, str), rows)


def _heading(section: str) -> str:
    """The heading of a section: ``Section IV`` for ``IV``; a text with words stays as it is.

    ``Section`` is put before a Roman number, a number such as ``4`` or ``4.2``, and a capital
    letter.
    """
    return f"Section {section}" if re.fullmatch(r"[IVXLC]+|[0-9.]+|[A-Z]", section) else section


def _headline(report: LedgerReport) -> parts.Headline | None:
    """The verdict, and the number of claims with each outcome.

    None if there are no claims and the job is complete.  For a job that ended early the headline is
    that of :func:`parts.so_far`.
    """
    if not report.claims:
        return parts.so_far(report, None)
    standings = Counter(one.standing for one in report.claims)
    held = sum((one.standing, one.verdict) == ("as-expected", "holds") for one in report.claims)
    refuted = standings["as-expected"] - held
    errors = sum(one.verdict == "error" for one in report.claims)
    # The reasons why claims were not checked, each with the number of its claims.
    reasons = Counter(one.told for one in report.claims if one.standing == "not-checked")
    outcomes = (
        (held, "holds" if held == 1 else "hold"),
        (refuted, f"{'is' if refuted == 1 else 'are'} refuted, as expected"),
        (standings["unexpected"] - errors, "not as expected"),
        (errors, "ended in an error of this program"),
        (standings["vacuous"], "vacuous"),
        *((count, f"not checked ({reason})") for reason, count in reasons.items()),
    )
    counts = ", ".join(f"{words.number(count)} {outcome}" for count, outcome in outcomes if count)
    verdict = VERDICTS.get(report.exit_code, "inconclusive")
    said = f"{words.plural(len(report.claims), 'claim')}: {counts}"
    return parts.so_far(report, parts.Headline(verdict.upper(), said, verdict))


def _section(one: CheckedClaim) -> parts.Section:
    """A section for a claim, with the worlds that show it."""
    verdict = ", ".join(dict.fromkeys([one.verdict, one.standing])).replace("-", " ")
    differs = "; ".join(one.differences)
    facts = [("verdict", verdict), *_details(one), ("differs", differs)]
    captioned = zip(one.captions, one.worlds, strict=True)
    pictures = [(caption.capitalize(), parts.scene_of(world)) for caption, world in captioned]
    drawn = [parts.MapPictures(pictures)] if pictures else []
    blocks: list[parts.Block] = [parts.Paragraph(one.statement), *drawn, parts.FactList(facts)]
    return parts.Section(one.id, f"{_heading(one.section)}: {one.id}", blocks)


def _case(one: CheckedClaim, *, required: bool) -> parts.SuiteCase:
    """The test case for a claim: passed if the result is the expected one, else failed.

    A claim that was not checked is skipped; if the claim is ``required``, its case has failed.
    """
    name = f"{_heading(one.section)}: {one.id}: {one.statement}"
    details = [parts.Section(one.id, "", [parts.FactList(_details(one))])]
    if one.standing == "as-expected":
        return parts.SuiteCase(name)
    if one.standing != "not-checked":
        return parts.SuiteCase(name, "failure", one.standing, "; ".join(one.differences), details)
    if required:
        return parts.SuiteCase(name, "failure", "required", one.told, details)
    return parts.SuiteCase(name, "skipped", message=one.told)


def _details(one: CheckedClaim) -> list[tuple[str, str]]:
    """Further named facts about a claim: its method, scope and source, and what was seen."""
    facts = [(name, getattr(one, name)) for name in ("method", "scope", "expected", "source")]
    if one.standing == "not-checked":
        return [*facts, ("reason", one.told)]
    seen = [("witnesses", _listed(one.witnesses)), ("figures", _listed(one.figures))]
    return [*facts, *seen, ("seen", one.told)]


def _listed(values: Mapping[str, object]) -> str:
    def text(value: object) -> str:
        if isinstance(value, list):
            return "[" + ", ".join(map(str, value)) + "]"
        return words.number(value) if isinstance(value, int) else str(value)

    return ", ".join(f"{name} {text(value)}" for name, value in values.items())
