"""Found beside expected: whatever is changed of what is expected, the claim fails."""

from dataclasses import replace

import pytest

import allworlds
from allworlds.evidence.claims import ledger as entries
from allworlds.evidence.claims.claim_table import CHECKS
from allworlds.evidence.claims.claim_types import Found, Means, NotChecked
from allworlds.evidence.claims.ledger import CheckedClaim, ClaimsReport, entry_of
from allworlds.evidence.claims.manifest import manifest
from allworlds.inputs import InputError
from allworlds.outcome import Exit

BY_NAME = {claim.name: claim for claim in manifest()}
CHEAP = ["fig1", "fig1-caption", "printed-3", "lower-bound-2m", "pass-kinds", "printed-limit-of-2"]


def as_expected(claim, budget="quick"):
    """What must be found, as if it had been."""
    scope = claim.scopes[budget]
    return Found(claim.expected, dict(scope.witnesses), dict(scope.figures))


def other(value):
    """Another value of the same kind."""
    match value:
        case [*first, last]:
            return [*first, other(last)]
        case str():
            return value + "?"
        case _:
            return value + 1


def changes(claim, scope):
    """The claim and its scope with one expected thing changed, each in turn."""
    verdict = {"holds": "refuted", "refuted": "holds"}[claim.expected]
    yield "verdict", replace(claim, expected=verdict), scope
    for part in ("witnesses", "figures"):
        for name, value in getattr(scope, part).items():
            changed = {**getattr(scope, part), name: other(value)}
            yield name, claim, replace(scope, **{part: changed})


def fails_when_changed(claim, scope, found):
    """So many expected things, each of which makes the claim fail when it alone is changed."""
    assert CheckedClaim(claim, scope, found, 0.0).standing == "as-expected"
    changed = list(changes(claim, scope))
    for what, other_claim, other_scope in changed:
        entry = CheckedClaim(other_claim, other_scope, found, 0.0)
        assert entry.standing == "unexpected", (claim.name, what)
        assert len(entry.differences) == 1
        assert what in entry.differences[0]
        assert ClaimsReport("quick", (entry,)).exit_code == Exit.REFUTED
    return len(changed)


@pytest.mark.parametrize("budget", ["quick", "full"])
def test_each_expected_verdict_and_number_matters(budget):
    total = sum(
        fails_when_changed(claim, claim.scopes[budget], as_expected(claim, budget))
        for claim in manifest()
    )
    assert total > 2 * len(manifest())


@pytest.mark.parametrize("name", CHEAP)
def test_each_expected_number_matters_beside_what_is_really_found(name):
    entry = entry_of(BY_NAME[name], CHECKS[name], Means())
    assert fails_when_changed(entry.claim, entry.scope, entry.found) >= 2


@pytest.mark.slow
def test_the_quick_ledger_is_as_expected_and_no_number_of_it_is_idle():
    report = allworlds.claims(workers=2)
    assert [entry.claim.name for entry in report.entries] == [*BY_NAME]
    unchecked = {e.claim.name for e in report.entries if e.standing == "not-checked"}
    assert unchecked == {name for name in BY_NAME if name.startswith(("cert-", "coq-"))}
    assert [e.differences for e in report.entries if e.differences] == []
    assert report.exit_code == Exit.HOLDS
    for entry in report.entries:
        if entry.claim.name not in unchecked:
            fails_when_changed(entry.claim, entry.scope, entry.found)


def entry_with(found, name="fig1"):
    claim = BY_NAME[name]
    return CheckedClaim(claim, claim.scopes["quick"], found, 0.0)


def test_a_witness_that_was_never_met_is_no_pass():
    full = as_expected(BY_NAME["fig1"])
    none = entry_with(replace(full, witnesses={"starts": 4, "darts": 0}))
    assert none.verdict == none.standing == "vacuous"
    assert entry_with(replace(full, witnesses={})).verdict == "vacuous"
    assert entry_with(replace(full, witnesses={"starts": 4})).verdict == "vacuous"
    assert ClaimsReport("quick", (none,)).exit_code == Exit.VACUOUS


def test_what_nobody_expected_is_a_difference_too():
    full = as_expected(BY_NAME["fig1"])
    more = entry_with(replace(full, figures={"surplus": 1}))
    assert more.standing == "unexpected"
    assert more.differences == ["surplus: None expected, 1 found"]


def test_what_was_not_checked_neither_passes_nor_fails_unless_it_is_required():
    entry = entry_with(NotChecked("no Coq"))
    assert (entry.verdict, entry.standing, entry.differences) == ("not-checked", "not-checked", [])
    assert ClaimsReport("quick", (entry,)).exit_code == Exit.HOLDS
    assert ClaimsReport("quick", (entry,), ("fig1",)).exit_code == Exit.INCONCLUSIVE
    assert ClaimsReport("quick", (entry,), ("bound",)).exit_code == Exit.HOLDS


def test_a_difference_outweighs_what_is_missing_and_an_interrupt_both():
    wrong = entry_with(Found("refuted", {"starts": 4, "darts": 56}))
    missing = entry_with(NotChecked("no Coq"), "coq-2m")
    entries = (wrong, missing)
    assert ClaimsReport("quick", entries, ("coq-2m",)).exit_code == Exit.REFUTED
    assert ClaimsReport("quick", entries, ("coq-2m",), complete=False).exit_code == Exit.INTERRUPTED


def test_a_required_claim_is_checked_along_with_those_that_are_named():
    report = allworlds.claims(only=["fig1"], require=["fig1-different"])
    assert [entry.claim.name for entry in report.entries] == ["fig1", "fig1-different"]
    assert report.exit_code == Exit.HOLDS


def test_an_interrupt_leaves_what_was_checked(monkeypatch):
    def interrupted(_means, **_bounds):
        raise KeyboardInterrupt

    from allworlds.evidence.claims import claim_table as table

    monkeypatch.setattr(table, "CHECKS", {**CHECKS, "fig1-different": interrupted})
    report = entries.claims(only=["fig1", "fig1-different", "fig1-caption"])
    assert [entry.claim.name for entry in report.entries] == ["fig1"]
    assert report.exit_code == Exit.INTERRUPTED


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ({"only": ["fig-1"]}, "only 'fig-1' is no claim; near it are fig1"),
        ({"require": ["@"]}, "require '@' is no claim"),
        ({"budget": "large"}, "budget 'large' is not one of quick, full"),
        ({"workers": 0}, "workers = 0"),
        ({"proofs": "nowhere"}, "proofs 'nowhere' is no folder"),
    ],
)
def test_bad_input_is_refused(options, told):
    with pytest.raises(InputError, match=told):
        allworlds.claims(**options)
