"""``explain``: a finding in plain words."""

from __future__ import annotations

from allworlds.document import replace
from allworlds.engines import Limits, shown_chirality, single_run, subject_of
from allworlds.inputs import InputError, answers, show
from allworlds.judging import (
    Chirality,
    Explanation,
    Finding,
    explain as explained,
    needs_a_chiral_world,
)
from allworlds.studies.explain.explain_request import ExplainRequest


@answers(ExplainRequest)
def explain(request: ExplainRequest) -> Explanation:
    """Explain the finding in plain words.

    Where the world is its own mirror image, and both a wrong ``here`` and wrong rotations would
    explain the answer, the recorded explorer is played in a world that tells them apart, unless
    it does something else now.

    Raises:
        InputError: if the transcript of the finding is no walk in its world, or its answer is
            none.
    """
    finding = request.finding
    if not isinstance(finding, Finding):
        raise InputError(f"finding = {show(finding)} is no Finding; Finding.from_json makes one")
    if needs_a_chiral_world(finding):
        limits = Limits(answer_timeout=request.answer_timeout)
        finding = replace(finding, chirality=_played(finding, limits))
    return explained(finding, number=request.number, findings=request.findings)


def _played(finding: Finding, limits: Limits) -> Chirality | None:
    """The sense of rotation that the recorded explorer shows, if it is still the same."""
    try:
        subject = subject_of(finding.explorer, limits)
    except InputError as error:
        return Chirality("unknown", f"the explorer cannot be run ({error})")
    run = single_run(
        subject, finding.world, finding.rules, finding.choices, limits, finding.hash_seed
    )
    now = run.finding
    if now is None or not _alike(now, finding):
        return Chirality("unknown", "the explorer has changed since, and was not played again")
    return shown_chirality(finding, subject, limits)


def _alike(one: Finding, other: Finding) -> bool:
    """Whether two findings of one world hold the same run."""
    return (one.law, one.transcript, one.seen) == (other.law, other.transcript, other.seen)
