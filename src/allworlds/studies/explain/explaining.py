"""``explain``: a finding in plain words."""

from __future__ import annotations

from itertools import islice

from allworlds.engines import Limits, single_run, subject_of
from allworlds.inputs import InputError, answers, show
from allworlds.judging import (
    Answered,
    Chirality,
    Explanation,
    Fault,
    Finding,
    chiral_worlds,
    chirality_in,
    explain as explained,
    needs_a_chiral_world,
)
from allworlds.studies.explain.explain_request import ExplainRequest

TRIED = 8
"""The number of chiral worlds that are tried before the question stays open."""


@answers(ExplainRequest)
def explain(request: ExplainRequest) -> Explanation:
    """Explain the finding in plain words.

    Where the world is its own mirror image, and both a wrong ``here`` and wrong rotations would
    explain the answer, the recorded explorer is played in a world that tells them apart.

    Raises:
        InputError: if the transcript of the finding is no walk in its world, or its answer is
            none.
    """
    finding = request.finding
    if not isinstance(finding, Finding):
        raise InputError(f"finding = {show(finding)} is no Finding; Finding.from_json makes one")
    chirality = None
    if needs_a_chiral_world(finding):
        chirality = _played(finding, Limits(answer_timeout=request.answer_timeout))
    return explained(finding, chirality=chirality, number=request.number, findings=request.findings)


def _played(finding: Finding, limits: Limits) -> Chirality:
    """The result of the recorded explorer in a chiral world, under the rules of the finding."""
    try:
        subject = subject_of(finding.explorer, limits)
    except InputError as error:
        return Chirality("unknown", str(error))
    broken = ""
    for world in islice(chiral_worlds(finding), TRIED):
        ending = single_run(subject, world, finding.rules, (), limits).ending
        if isinstance(ending, Fault):
            broken = ending.law
            if broken == "timeout":  # the others would be waited for as long
                break
        if isinstance(ending, Answered) and (shown := chirality_in(world, ending.estimate.map)):
            return shown
    if broken:
        return Chirality("unknown", f"there it broke the law '{broken}'")
    return Chirality("unknown", "there its map was neither right nor a mirror image")
