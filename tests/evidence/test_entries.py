"""Found beside expected: whatever is changed of what is expected, the claim fails."""

from dataclasses import replace as replaced

import pytest

import allworlds
from allworlds.document import replace
from allworlds.evidence.claims import ledger
from allworlds.evidence.claims.claim_table import CHECKS
from allworlds.evidence.claims.claim_types import Found, Means, NotChecked
from allworlds.evidence.claims.ledger import ClaimsReport, entry_of, entry_with
from allworlds.evidence.claims.manifest import manifest
from allworlds.inputs import InputError
from allworlds.outcome import Exit

BY_NAME = {claim.id: claim for claim in manifest()}
CHEAP = ["fig1", "fig1-caption", "printed-3", "lower-bound-2m", "pass-kinds", "printed-limit-of-2"]


def as_expected(claim, budget="quick"):
    """What must be found, as if it had been."""
    scope = claim.scopes[budget]
    return Found(claim.expected, scope.witnesses, scope.figures)


def other(value):
    """Another value of the same kind."""
    match value:
        case [*first, last]:
            return [*first, other(last)]
        case str():
            return value + "?"
        case _:
            return value + 1


def changes(entry):
    """The entry with one expected thing changed, each in turn."""
    yield (
        "verdict",
        replace(entry, expected={"holds": "refuted", "refuted": "holds"}[entry.expected]),
    )
    for part in ("expected_witnesses", "expected_figures"):
        for name, value in getattr(entry, part).items():
            yield name, replace(entry, **{part: {**getattr(entry, part), name: other(value)}})


def ledger_of(*entries, required=(), complete=True):
    """The report of these entries."""
    return ClaimsReport(budget="quick", required=required, claims=entries, complete=complete)


def fails_when_changed(entry):
    """So many expected things, each of which makes the claim fail when it alone is changed."""
    assert entry.standing == "as-expected"
    changed = list(changes(entry))
    for what, one in changed:
        assert one.standing == "unexpected", (one.id, what)
        assert len(one.differences) == 1
        assert what in one.differences[0]
        assert ledger_of(one).exit_code == Exit.REFUTED
    return len(changed)


@pytest.mark.parametrize("budget", ["quick", "full"])
def test_each_expected_verdict_and_number_matters(budget):
    total = sum(
        fails_when_changed(entry_with(claim, budget, as_expected(claim, budget)))
        for claim in manifest()
    )
    assert total > 2 * len(manifest())


@pytest.mark.parametrize("name", CHEAP)
def test_each_expected_number_matters_beside_what_is_really_found(name):
    assert fails_when_changed(entry_of(BY_NAME[name], CHECKS[name], Means())) >= 2


@pytest.mark.slow
def test_the_quick_ledger_is_as_expected_and_no_number_of_it_is_idle():
    report = allworlds.claims(workers=2)
    assert [one.id for one in report.claims] == [*BY_NAME]
    unchecked = {one.id for one in report.claims if one.standing == "not-checked"}
    assert unchecked == {name for name in BY_NAME if name.startswith(("cert-", "coq-"))}
    assert [one.differences for one in report.claims if one.differences] == []
    assert report.exit_code == Exit.HOLDS
    for one in report.claims:
        if one.id not in unchecked:
            fails_when_changed(one)


def entry(found, name="fig1"):
    return entry_with(BY_NAME[name], "quick", found)


def test_a_witness_that_was_never_met_is_no_pass():
    full = as_expected(BY_NAME["fig1"])
    none = entry(replaced(full, witnesses={"starts": 4, "darts": 0}))
    assert none.verdict == none.standing == "vacuous"
    assert entry(replaced(full, witnesses={})).verdict == "vacuous"
    assert entry(replaced(full, witnesses={"starts": 4})).verdict == "vacuous"
    assert ledger_of(none).exit_code == Exit.VACUOUS


def test_what_nobody_expected_is_a_difference_too():
    full = as_expected(BY_NAME["fig1"])
    more = entry(replaced(full, figures={"surplus": 1}))
    assert more.standing == "unexpected"
    assert more.differences == ("surplus: None expected, 1 found",)


def test_what_was_not_checked_neither_passes_nor_fails_unless_it_is_required():
    one = entry(NotChecked("no Coq"))
    assert (one.verdict, one.standing, one.differences) == ("not-checked", "not-checked", ())
    assert ledger_of(one).exit_code == Exit.HOLDS
    assert ledger_of(one, required=("fig1",)).exit_code == Exit.INCONCLUSIVE
    assert ledger_of(one, required=("bound",)).exit_code == Exit.HOLDS


def test_a_difference_outweighs_what_is_missing_and_an_interrupt_both():
    wrong = entry(Found("refuted", {"starts": 4, "darts": 56}))
    missing = entry(NotChecked("no Coq"), "coq-2m")
    told = ledger_of(wrong, missing, required=("coq-2m",))
    assert told.exit_code == Exit.REFUTED
    assert replace(told, complete=False).exit_code == Exit.INTERRUPTED


def test_a_required_claim_is_checked_along_with_those_that_are_named():
    report = allworlds.claims(only=["fig1"], require=["fig1-different"])
    assert [one.id for one in report.claims] == ["fig1", "fig1-different"]
    assert report.exit_code == Exit.HOLDS


def test_an_interrupt_leaves_what_was_checked(monkeypatch):
    def interrupted(_means, **_bounds):
        raise KeyboardInterrupt

    from allworlds.evidence.claims import claim_table as table

    monkeypatch.setattr(table, "CHECKS", {**CHECKS, "fig1-different": interrupted})
    report = ledger.claims(only=["fig1", "fig1-different", "fig1-caption"])
    assert [one.id for one in report.claims] == ["fig1"]
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
