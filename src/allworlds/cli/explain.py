"""The verb ``explain`` on the command line."""

import allworlds
from allworlds.cli.output import OutputGroup, emit
from allworlds.inputs.requests import answer
from allworlds.studies.explain import ExplainRequest
from allworlds.studies.findings import FindingWords


def explain(words: FindingWords, *, output: OutputGroup) -> int:
    """Example: allworlds explain finding.json

    Tell in words what the robot believed, what was true, and where belief and truth diverge.
    """
    request = ExplainRequest(*words.chosen())
    return emit(answer(allworlds.explain, request), output)
