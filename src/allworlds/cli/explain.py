"""The verb ``explain`` on the command line."""

from __future__ import annotations

import allworlds
from allworlds.cli.output import OutputGroup, emit
from allworlds.inputs.requests import answer, values_of
from allworlds.judging.findings.asked_finding import FindingWords
from allworlds.studies.explain import AskedExplanation, ExplainRequest


def explain(words: FindingWords, *, asked: AskedExplanation, output: OutputGroup) -> int:
    """Example: allworlds explain finding.json

    Tell in words what the robot believed, what was true, and where belief and truth diverge.
    The recorded explorer is played once more where only another world can tell two slips apart.
    """
    request = ExplainRequest(*words.chosen(), **values_of(AskedExplanation, asked))
    return emit(answer(allworlds.explain, request), output)
