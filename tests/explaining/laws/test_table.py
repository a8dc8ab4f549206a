"""The table of what each law has to tell."""

from dataclasses import replace

from allworlds.explaining import explain
from allworlds.explaining.laws import TELLERS
from allworlds.judge import PRECEDENCE


def test_every_law_of_the_judge_has_its_entry_in_the_judges_order():
    assert tuple(TELLERS) == PRECEDENCE


def test_a_law_that_only_later_versions_know_is_told_by_its_sentences(finding_of):
    finding = replace(finding_of("no-answer"), law="ambiguity")
    assert "The law 'ambiguity' is broken." in explain(finding).sentences
