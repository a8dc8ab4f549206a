"""The ledger as JUnit XML: a test case a claim."""

from __future__ import annotations

from allworlds.ledger import ClaimsReport, Entry, NotChecked
from allworlds.reports.claims_text import details, heading
from allworlds.reports.junit import Case, junit_text


def claims_junit(report: ClaimsReport) -> str:
    """Passed: as expected.  Failed: not so, or vacuous.  Skipped: not checked, with the reason."""
    properties = {
        "budget": report.budget,
        "exit_code": int(report.exit_code),
        "complete": report.complete,
    }
    cases = [_case(one, required=one.claim.name in report.missed) for one in report.entries]
    return junit_text("claims", "claims", properties, cases)


def _case(one: Entry, *, required: bool) -> Case:
    name = f"{heading(one.claim.section)}: {one.claim.name}: {one.claim.says}"
    told = "\n".join(f"{key}: {text}" for key, text in details(one))
    if isinstance(one.found, NotChecked):
        if required:
            return Case(name, "failure", "required", one.found.reason, told)
        return Case(name, "skipped", message=one.found.reason)
    if one.standing == "as-expected":
        return Case(name)
    return Case(name, "failure", one.standing, "; ".join(one.differences), told)
