"""The ledger as JUnit XML: a test case a claim."""

from __future__ import annotations

from allworlds.evidence.claims.claims_text import details, heading
from allworlds.evidence.claims.ledger import CheckedClaim, ClaimsReport
from allworlds.reports import JUnitCase, junit_text


def claims_junit(report: ClaimsReport) -> str:
    """Passed: as expected.  Failed: not so, or vacuous.  Skipped: not checked, with the reason."""
    properties = {
        "budget": report.budget,
        "exit_code": int(report.exit_code),
        "complete": report.complete,
    }
    cases = [_case(one, required=one.id in report.missed) for one in report.claims]
    return junit_text("claims", "claims", properties, cases)


def _case(one: CheckedClaim, *, required: bool) -> JUnitCase:
    name = f"{heading(one.section)}: {one.id}: {one.statement}"
    told = "\n".join(f"{key}: {text}" for key, text in details(one))
    if one.standing == "not-checked":
        if required:
            return JUnitCase(name, "failure", "required", one.told, told)
        return JUnitCase(name, "skipped", message=one.told)
    if one.standing == "as-expected":
        return JUnitCase(name)
    return JUnitCase(name, "failure", one.standing, "; ".join(one.differences), told)
