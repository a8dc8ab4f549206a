"""A finding in words."""

from __future__ import annotations

from typing import Annotated

from allworlds.document.struct import replace
from allworlds.engines.effort import AskedPatience, Limits
from allworlds.engines.other_worlds import played_elsewhere
from allworlds.engines.single import single_run, subject_of
from allworlds.inputs.checks import InputError, show
from allworlds.inputs.requests import answers
from allworlds.judging.explanations.explanation import (
    Explanation,
    explain as explained,
    may_be_misread,
    needs_a_chiral_world,
)
from allworlds.judging.findings.finding import Chirality, Finding


class AskedExplanation(AskedPatience):
    """Options for the explanation of a finding."""


class ExplainRequest(AskedExplanation, kw_only=False):
    """Request of ``explain``: the finding, and how it is explained."""

    finding: Annotated[Finding, "the finding"]
    number: Annotated[int, "the number of the finding in its report, from 1 on"] = 1
    findings: Annotated[int, "how many findings the report holds"] = 1


@answers(ExplainRequest)
def explain(request: ExplainRequest) -> Explanation:
    """Explain the finding in plain words.

    Where a wrong convention may be the cause, the recorded explorer is played behind translators;
    where both a wrong ``here`` and wrong rotations would explain the answer, since the world is
    its own mirror image, in a world that tells them apart; unless it does something else now.

    Raises:
        InputError: if the transcript of the finding is no walk in its world, or its answer is
            none.
    """
    finding = request.finding
    if not isinstance(finding, Finding):
        raise InputError(f"finding = {show(finding)} is no Finding; Finding.from_json makes one")
    if needs_a_chiral_world(finding) or may_be_misread(finding):
        limits = Limits(answer_timeout=request.answer_timeout)
        finding = _played(finding, limits)
    return explained(finding, number=request.number, findings=request.findings)


def _played(finding: Finding, limits: Limits) -> Finding:
    """The finding with what the recorded explorer shows elsewhere, if it is still the same."""
    try:
        subject = subject_of(finding.explorer, limits)
    except InputError as error:
        return _undecided(finding, f"the explorer cannot be run ({error})")
    run = single_run(
        subject, finding.world, finding.rules, finding.choices, limits, finding.hash_seed
    )
    now = run.finding
    if now is None or not _alike(now, finding):
        return _undecided(finding, "the explorer has changed since, and was not played again")
    return played_elsewhere(finding, subject, limits)


def _undecided(finding: Finding, why: str) -> Finding:
    needs = needs_a_chiral_world(finding)
    return replace(finding, chirality=Chirality("unknown", why) if needs else None)


def _alike(one: Finding, other: Finding) -> bool:
    """Whether two findings of one world hold the same run."""
    return (one.law, one.transcript, one.seen) == (other.law, other.transcript, other.seen)
