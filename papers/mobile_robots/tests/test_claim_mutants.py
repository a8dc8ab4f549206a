"""Every claim can fail: under its mutation it is not as it must be."""

import pytest
from claim_mutants import MUTANTS

from paper_claims import BY_NAME, assert_fails, params


def test_every_claim_has_a_mutation_and_every_mutation_a_claim():
    assert {mutant.claim for mutant in MUTANTS} == {*BY_NAME}


@pytest.mark.parametrize("mutant", [*params(MUTANTS)])
def test_a_claim_fails_under_its_mutation(monkeypatch, tmp_path, mutant):
    assert_fails(mutant, monkeypatch, tmp_path)
