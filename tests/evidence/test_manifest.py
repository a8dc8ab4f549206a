"""The list of claims, and its agreement with the pages."""

import re
from pathlib import Path

import pytest
from allworlds.evidence import claims as ledger
from allworlds.evidence.claims.claim_table import CHECKS
from allworlds.evidence.claims.manifest import SECTIONS, BadManifest, manifest, read

ENTRY = """
[two]
section = "VI"
statement = "two"
method = "algebra"
scope = "up to {edges}"
expected = "holds"
source = "Section VI"
quick = { bounds = { edges = 2 }, witnesses = { pairs = 1 } }
"""


def test_every_claim_has_its_function_and_every_function_its_claim():
    assert {claim.id for claim in manifest()} == {*CHECKS}


def test_there_are_as_many_claims_as_were_asked_for_and_from_every_section():
    assert len(manifest()) >= 45
    assert [section for section in SECTIONS if any(c.section == section for c in manifest())] == [
        *SECTIONS
    ]


@pytest.mark.parametrize(
    "name", ["printed-3", "printed-limit-of-2", "lower-bound-2m", "natural-multigraphs"]
)
def test_an_erratum_is_expected_to_be_refuted(name):
    (claim,) = [claim for claim in manifest() if claim.id == name]
    assert claim.expected == "refuted"


def test_no_function_reads_what_is_expected():
    paths = sorted(Path(ledger.__file__).parent.glob("*.py"))
    finding = [path for path in paths if path.stem not in ("manifest", "ledger", "__init__")]
    assert len(finding) >= 12
    for path in finding:
        code = re.sub(r'""".*?"""', "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
        assert "manifest" not in code
        assert "claims.toml" not in code


def test_a_claim_is_read_with_its_scope_in_words():
    (claim,) = read(ENTRY)
    assert claim.scope_under("quick") == "up to 2"
    assert claim.scopes["full"] is claim.scopes["quick"]


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ('section = "VI"', 'section = "IX"', "two: section = 'IX' is not one of II, III, IV"),
        ('method = "algebra"', 'method = "guess"', "method = 'guess' is not one of"),
        (
            'expected = "holds"',
            'expected = "perhaps"',
            "expected = 'perhaps' is not one of holds, refuted",
        ),
        ('source = "Section VI"', "", "missing required field source"),
        ('source = "Section VI"', 'source = "-"\nfrom = "-"', "unknown field from"),
        ("{ pairs = 1 }", "{ pairs = 0 }", r"witnesses\[...\] = {'pairs': 0}: expected int >= 1"),
        ("{ pairs = 1 }", "{}", "witnesses = {}: expected object of length >= 1"),
    ],
)
def test_a_claim_that_cannot_be_meant_is_refused(old, new, told):
    assert old in ENTRY
    with pytest.raises(BadManifest, match=told):
        read(ENTRY.replace(old, new))
