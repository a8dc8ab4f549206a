"""Every claim can fail: under its mutation it is not as it must be."""

import pytest
from allworlds.evidence.claims import ledger, machine
from allworlds.evidence.claims.claim_table import CHECKS
from allworlds.evidence.claims.claim_types import ProgramFault, found_by
from allworlds.evidence.claims.manifest import manifest

from evidence.claim_mutants import MUTANTS, as_claimed, means_of

BY_NAME = {claim.id: claim for claim in manifest()}


def test_every_claim_has_a_mutation_and_every_mutation_a_claim():
    assert {mutant.claim for mutant in MUTANTS} == {*BY_NAME}


def params():
    for mutant in MUTANTS:
        marks = [pytest.mark.slow] if mutant.slow else []
        yield pytest.param(mutant, id=f"{mutant.claim}: {mutant.what}", marks=marks)


@pytest.mark.parametrize("mutant", [*params()])
def test_a_claim_fails_under_its_mutation(monkeypatch, tmp_path, mutant):
    claim = BY_NAME[mutant.claim]
    means = means_of(mutant, tmp_path)
    bounds = claim.quick.bounds if mutant.bounds is None else mutant.bounds
    if mutant.claim.startswith("coq-"):
        monkeypatch.setattr(machine, "_assumptions", as_claimed)
        monkeypatch.setattr(machine.shutil, "which", lambda name: name)
    found = found_by(CHECKS[mutant.claim], means, bounds)
    assert found.verdict == claim.expected, found
    for where, name, other in mutant.patches:
        monkeypatch.setattr(where, name, other)
    if mutant.folder:
        mutant.folder(tmp_path)
    found = found_by(CHECKS[mutant.claim], means, {**bounds, **mutant.changed})
    entry = ledger.entry_with(claim, "quick", found)
    assert entry.truth == {"holds": "refuted", "refuted": "holds"}[claim.expected]
    assert entry.standing in ("unexpected", "vacuous")
    assert isinstance(found, ProgramFault) <= (entry.verdict == "refuted")
