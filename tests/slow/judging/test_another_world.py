"""Another world that agrees with the log: it is another one, and it does agree."""

import pytest

from allworlds.corpus.explorers import WRONG_EXPLORERS
from allworlds.studies.check.exhaustive import check
from allworlds.studies.explain import explain
from judging import test_another_world as quick
from small import slowest

pytestmark = pytest.mark.slowest


@pytest.mark.parametrize("map_class", [slowest("maps")])
def test_in_every_small_world_and_for_every_short_walk_it_is_another_and_senses_the_same(map_class):
    quick.test_in_every_small_world_and_for_every_short_walk_it_is_another_and_senses_the_same(
        map_class
    )


@pytest.mark.parametrize("mutant", WRONG_EXPLORERS, ids=lambda mutant: mutant.name)
def test_findings_of_folding_name_it_and_no_others_do(mutant):
    for finding in check(mutant.explorer(), edges=3, max_findings=3).findings:
        told = explain(finding)
        assert (told.other is not None) == (finding.law == "folding")
        assert (told.to_json()["other"] is not None) == (finding.law == "folding")
