"""The findings of wrong explorers in words, whatever the law."""

import pytest

from allworlds.studies.explain import explain
from judging.test_explanation import MUTANTS

pytestmark = pytest.mark.slowest


@pytest.mark.parametrize("name", MUTANTS)
def test_every_mutants_finding_is_explained_under_its_law(name, finding_of):
    finding = finding_of(name)
    explanation = explain(finding)
    assert explanation.law == finding.law
    assert len(explanation.sentences) >= 2
    assert all(s and s[0].isupper() for s in explanation.sentences)
    assert (explanation.answer is not None) == (finding.law in ("map", "pose"))
    assert explanation.exit_code == 0
