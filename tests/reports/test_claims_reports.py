"""The ledger as text, as JUnit XML and as a page."""

from xml.etree import ElementTree as ET

import pytest

import allworlds
from allworlds.document import replace
from allworlds.evidence.claims.claim_types import Found, NotChecked
from allworlds.evidence.claims.ledger import ClaimsReport, entry_with
from allworlds.evidence.claims.manifest import manifest
from allworlds.outcome import COMPLETED
from allworlds.reports import brief, file_of, text

BY_NAME = {claim.id: claim for claim in manifest()}


def entry(name, found):
    return entry_with(BY_NAME[name], "quick", found)


@pytest.fixture(scope="module")
def mixed():
    """One of each standing."""
    return ClaimsReport(
        ending=COMPLETED,
        budget="quick",
        required=("coq-2m",),
        claims=(
            *allworlds.claims(only=["fig1", "printed-3"]).claims,
            entry("bound", Found("refuted", {"worlds": 1, "sizes": 2, "sizes that attain it": 3})),
            entry("criterion", Found("holds", {"worlds": 0, "ambiguous": 0})),
            entry("coq-2m", NotChecked("Coq is not installed")),
        ),
    )


def test_each_standing_has_its_sign_and_what_differs_is_told(mixed):
    told = text("paper claims", mixed, 100)
    signs = [line[0] for line in told.splitlines() if line[:1] in "=≠?-" and line[1:2] == " "]
    assert signs[:5] == ["=", "=", "≠", "?", "-"]
    assert "DIFFERS    bound: verdict: holds expected, refuted found;" in told
    assert "REQUIRED   coq-2m was not checked" in told
    assert told.startswith("REFUTED    5 claims: 1 holds, ")
    assert brief("paper claims", mixed, 100) == (
        "REFUTED: 5 claims: 1 holds, 1 is refuted, as expected, 1 not as expected, 1 vacuous, "
        "1 not checked (Coq is not installed)"
    )


def test_one_claim_is_told_at_length_and_drawn():
    told = text("paper claims", allworlds.claims(only=["position-not-enough"]), 100)
    assert "Pair-two-loops, the one" in told
    assert "witnesses  pairs 4" in told
    figures = text("paper claims", allworlds.claims(only=["printed-3"]), 100)
    assert "figures    first edges and vertices [1, 1]" in figures
    reason = text("paper claims", allworlds.claims(only=["coq-2m"]), 100)
    assert "reason     it takes minutes: --budget full" in reason


def test_the_cases_of_junit_are_the_claims(mixed):
    suite = ET.fromstring(file_of("paper claims", "junit", mixed))
    totals = {"tests": "5", "failures": "3", "errors": "0"}
    assert suite.attrib == {"name": "allworlds claims", **totals}
    kinds = [case.find("failure").get("type") for case in suite.iter("testcase") if len(case)]
    assert kinds == ["unexpected", "vacuous", "required"]
    free = replace(mixed, required=())
    assert ET.fromstring(file_of("paper claims", "junit", free))[0].get("skipped") == "1"


def test_the_page_has_every_claim_and_draws_its_worlds(mixed):
    page = file_of("paper claims", "html", mixed)
    assert page.count("<figure") == 2
    for one in mixed.claims:
        assert f'id="{one.id}"' in page
    assert "Left graph" in page
    assert "verdict refuted" in page
