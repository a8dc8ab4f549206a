"""Found beside expected: whatever is changed of what is expected, the claim fails."""

import pytest
from allworlds.evidence.claims import claim_table, ledger
from allworlds.evidence.claims.claim_table import CHECKS
from allworlds.evidence.claims.claim_types import (
    FAULTS,
    Found,
    InternalError,
    Means,
    NotChecked,
)
from allworlds.evidence.claims.ledger import ClaimsReport, entry_of, entry_with
from allworlds.evidence.claims.manifest import manifest

import allworlds
from allworlds.document import replace, replace as replaced
from allworlds.engines.isolation.failures import HarnessError
from allworlds.inputs import InputError
from allworlds.outcome import COMPLETED, Exit, Interrupted
from allworlds.reports import brief

BY_NAME = {claim.id: claim for claim in manifest()}
CHEAP = ["fig1", "fig1-caption", "printed-3", "lower-bound-2m", "pass-kinds", "printed-limit-of-2"]


def as_expected(claim, budget="quick"):
    """The result that a claim expects, as if it had been found."""
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


def ledger_of(*entries, required=(), ending=COMPLETED):
    """The report of these entries."""
    return ClaimsReport(budget="quick", required=required, claims=entries, ending=ending)


def fails_when_changed(entry):
    """Require that each change of one expected thing makes the claim fail; return their number."""
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
def test_the_quick_ledger_is_as_expected_and_no_number_of_it_is_idle(monkeypatch):
    monkeypatch.setattr(ledger, "proofs_of_clone", lambda: None)
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
    none = entry(replaced(full, witnesses={"starts": 4, "pairs of darts": 0}))
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
    right = entry(as_expected(BY_NAME["fig1"]))
    assert ledger_of(one, right).exit_code == Exit.HOLDS
    assert ledger_of(one, right, required=("fig1",)).exit_code == Exit.INCONCLUSIVE
    assert ledger_of(one, right, required=("bound",)).exit_code == Exit.HOLDS


def test_a_ledger_of_which_nothing_was_checked_is_vacuous_and_does_not_hold():
    one = entry(NotChecked("no Coq"))
    assert ledger_of(one).exit_code == Exit.VACUOUS
    assert ledger_of(one, required=("fig1",)).exit_code == Exit.INCONCLUSIVE
    assert brief("paper claims", ledger_of(one), 80).startswith(
        "VACUOUS: 1 claim: 1 not checked (no Coq)"
    )


def test_the_line_tells_what_those_need_that_were_not_checked():
    some = [entry(NotChecked("no Coq")), entry(NotChecked("no Coq")), entry(NotChecked("no time"))]
    assert "3 not checked (2: no Coq; 1: no time)" in brief("paper claims", ledger_of(*some), 80)


def test_a_clone_has_its_proofs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(ledger, "__file__", str(tmp_path / "a/b/c/d/e/ledger.py"))
    assert ledger.proofs_of_clone() is None
    sources = tmp_path / "src/allworlds/evidence/claims"
    for folder, file in ((tmp_path / "proofs", "check.py"), (sources, "ledger.py")):
        assert ledger.proofs_of_clone() is None
        folder.mkdir(parents=True)
        (folder / file).touch()
    assert ledger.proofs_of_clone() == tmp_path / "proofs"
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path / "elsewhere")
    assert ledger.proofs_of_clone() is None
    monkeypatch.setattr(ledger, "__file__", str(sources / "ledger.py"))
    assert ledger.proofs_of_clone() == tmp_path / "proofs"


@pytest.mark.parametrize("fault", FAULTS)
@pytest.mark.parametrize("name", ["fig1", "lower-bound-2m"])
def test_a_disagreement_within_the_program_refutes_whatever_is_expected(monkeypatch, name, fault):
    def disagreeing(_means, **_bounds):
        raise fault("one says 3, the other 4")

    monkeypatch.setattr(claim_table, "CHECKS", {**CHECKS, name: disagreeing})
    report = allworlds.claims(only=[name])
    (one,) = report.claims
    assert (one.verdict, one.standing, report.exit_code) == ("refuted", "unexpected", Exit.REFUTED)
    assert one.told == "one says 3, the other 4"
    assert one.differences == ("a disagreement within this program: one says 3, the other 4",)


@pytest.mark.parametrize("error", [AssertionError, RuntimeError, HarnessError, KeyError])
def test_an_error_in_one_claim_leaves_the_others_and_keeps_its_traceback(monkeypatch, error):
    def failing(_means, **_bounds):
        raise error("so it is")

    monkeypatch.setattr(claim_table, "CHECKS", {**CHECKS, "fig1": failing})
    report = allworlds.claims(only=["fig1", "fig1-caption"])
    one, other_one = report.claims
    assert (one.verdict, one.standing, report.exit_code) == ("error", "unexpected", Exit.INTERNAL)
    assert other_one.standing == "as-expected"
    assert error.__name__ in one.differences[0]
    assert one.told.startswith("Traceback")
    assert "in failing" in one.told
    assert "1 holds, 1 ended in an error of this program" in brief("paper claims", report, 100)
    (alone,) = allworlds.claims(only=["fig1"]).claims
    assert alone.truth is None


def test_an_error_outweighs_an_interrupt_and_a_refutation():
    wrong = entry(Found("refuted", as_expected(BY_NAME["fig1"]).witnesses))
    failed = entry(InternalError("KeyError: 3", "Traceback ..."), "coq-2m")
    assert ledger_of(wrong, failed, ending=Interrupted()).exit_code == Exit.INTERNAL


def test_a_difference_outweighs_what_is_missing_and_an_interrupt_both():
    wrong = entry(Found("refuted", as_expected(BY_NAME["fig1"]).witnesses))
    missing = entry(NotChecked("no Coq"), "coq-2m")
    told = ledger_of(wrong, missing, required=("coq-2m",))
    assert told.exit_code == Exit.REFUTED
    assert replace(told, ending=Interrupted()).exit_code == Exit.INTERRUPTED


def test_a_required_claim_is_checked_along_with_those_that_are_named():
    report = allworlds.claims(only=["fig1"], require=["fig1-different"])
    assert [one.id for one in report.claims] == ["fig1", "fig1-different"]
    assert report.exit_code == Exit.HOLDS


def test_an_interrupt_leaves_what_was_checked(monkeypatch):
    def interrupted(_means, **_bounds):
        raise KeyboardInterrupt

    monkeypatch.setattr(claim_table, "CHECKS", {**CHECKS, "fig1-different": interrupted})
    report = ledger.claims(only=["fig1", "fig1-different", "fig1-caption"])
    assert [one.id for one in report.claims] == ["fig1"]
    assert report.exit_code == Exit.INTERRUPTED


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ({"only": ["fig-1"]}, "only 'fig-1' is no claim; near it are fig1"),
        ({"require": ["@"]}, "require '@' is no claim"),
        ({"only": ["fig1,cycles"]}, "claims are named one by one: --only fig1 --only cycles"),
        ({"only": ["fig1,fig2"]}, "only 'fig1,fig2' is no claim; near it are fig1"),
        ({"budget": "large"}, "budget 'large' is not one of quick, full"),
        ({"workers": 0}, "workers 0 is not positive"),
        ({"proofs": "nowhere"}, "proofs 'nowhere' is no folder"),
    ],
)
def test_bad_input_is_refused(options, told):
    with pytest.raises(InputError, match=told):
        allworlds.claims(**options)
