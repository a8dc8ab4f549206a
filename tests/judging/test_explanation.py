"""The findings of wrong explorers in words, whatever the law."""

import json

import pytest

import allworlds
from allworlds.corpus.explorers import WRONG_EXPLORERS
from allworlds.documents.document import replace
from allworlds.inputs.checks import InputError
from allworlds.judging.findings.finding import Finding
from allworlds.judging.laws.law_table import PRECEDENCE
from allworlds.protocol.actions import Percept, Transcript
from allworlds.studies.explain import explain

# One mutant is first wrong in a world with four edges.
MUTANTS = [m.name for m in WRONG_EXPLORERS if m.name != "confirmed-too-early"]


def test_the_mutants_break_every_law_of_a_directional_world_but_timeout(finding_of):
    broken = {finding_of(name).law for name in MUTANTS}
    assert broken == {*PRECEDENCE} - {"timeout", "ambiguity", "task"}


@pytest.mark.parametrize("name", MUTANTS)
def test_a_finding_read_from_its_file_is_explained_alike(name, finding_of):
    finding = finding_of(name)
    again = Finding.from_json(json.dumps(finding.to_json()))
    assert explain(again).to_json() == explain(finding).to_json()


def test_relabelling_the_world_does_not_move_the_parting(finding_of):
    finding = finding_of("wrong-entry-label")
    names = list(reversed(finding.world.map.darts))
    turned = replace(finding, world=finding.world.relabelled(names))
    assert explain(turned).step == explain(finding).step


def test_the_package_offers_it(finding_of):
    finding = finding_of("crashes-at-leaves")
    assert allworlds.explain(finding).to_json() == explain(finding).to_json()


def test_a_transcript_that_is_no_walk_in_the_world_is_refused(finding_of):
    finding = finding_of("pose-lost")
    with pytest.raises(InputError, match="at step 0 it has degree 9"):
        explain(replace(finding, transcript=Transcript(Percept(9))))
