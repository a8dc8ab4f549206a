"""The explanation of a finding in plain words."""

from typing import Annotated

from allworlds.documents.document import (
    Natural,
    NotInDocument,
    Positive,
    Some,
    Text,
    about,
    computed,
)
from allworlds.documents.report import Report
from allworlds.inputs.checks import InputError, show
from allworlds.inputs.requests import Request, answers
from allworlds.judging.explanations.by_law import teller_of
from allworlds.judging.explanations.story import Story
from allworlds.judging.findings.finding import Finding
from allworlds.judging.laws.law_table import LawName
from allworlds.maps.combinatorial import Dart
from allworlds.protocol.actions import Estimate
from allworlds.robots.team_finding import TeamFinding
from allworlds.studies.team.finding_reports import TeamExplanation
from allworlds.world.world import World


class Explanation(Report):
    """Report of 'explain'.

    The explanation of a finding.  Vertices and darts are named by their numbers in the finding's
    world.

    ``step`` is the step at which the mistake first shows; 0 is the start.  For a wrong answer, it
    is the first step at which the walks in the world and in the answer diverge.  Otherwise it is
    the last step before a wrong checkpoint.  It is null if there is no such step.
    """

    step: Annotated[
        Natural | None,
        about(
            "the first at which the walks in the world and in the answer part (0: the start), or "
            "the one before a wrong checkpoint; null: none"
        ),
    ]
    sentences: Annotated[Some[Text], about("in plain words")]
    robot: Annotated[Dart, about("where the robot is at the end")]
    answer: Annotated[Estimate | None, about("the wrong answer; null where the finding holds none")]
    other: Annotated[
        World | None,
        about("under the law `folding` another world that agrees with the log; else null"),
    ]
    slip: Annotated[
        Text | None,
        about(
            "the one difference between answer and world, such as "
            "`mirror image`; null: none that is known"
        ),
    ]
    number: Annotated[Positive, about("the number of the finding in its report; 1: the first")]
    findings: Annotated[Positive, about("how many findings the report holds")]
    finding: NotInDocument[Finding]

    @computed
    def explorer(self) -> str:
        """The name of the explorer."""
        return self.finding.explorer

    @computed
    def law(self) -> LawName:
        """The law that the run of the finding breaks."""
        return self.finding.law

    @computed
    def world(self) -> World:
        """The world of the finding."""
        return self.finding.world


class ExplainRequest(Request, kw_only=False):
    """Request of ``explain``: the finding, and its number in its report."""

    finding: Annotated[Finding | TeamFinding, "the finding"]
    number: Annotated[int, "the number of the finding in its report, from 1 on"] = 1
    findings: Annotated[int, "how many findings the report holds"] = 1


@answers(ExplainRequest)
def explain(request: ExplainRequest) -> Explanation | TeamExplanation:
    """Explain a finding in plain words.

    Raises:
        InputError: if the finding's transcript is no walk in its world, or its answer is illegal.
    """
    finding = request.finding
    if isinstance(finding, TeamFinding):
        return TeamExplanation(finding=finding, number=request.number, findings=request.findings)
    if not isinstance(finding, Finding):
        raise InputError(f"finding = {show(finding)} is no Finding; Finding.from_json makes one")
    return explained(finding, request.number, request.findings)


def explained(finding: Finding, number: int = 1, findings: int = 1) -> Explanation:
    """The explanation of a finding of one robot.

    ``number`` is the number of the finding in its report; ``findings`` is how many findings the
    report has.

    Raises:
        InputError: if the finding's transcript is no walk in its world, or its answer is illegal.
    """
    story = Story(finding)
    telling = teller_of(finding.law)(story)
    return Explanation(
        step=telling.step,
        sentences=(*telling.sentences,),
        robot=story.walk.here,
        answer=telling.answer,
        other=telling.other,
        slip=telling.slip or None,
        number=number,
        findings=findings,
        finding=finding,
    )
