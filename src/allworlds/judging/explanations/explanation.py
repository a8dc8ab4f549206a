"""A finding in words."""

from __future__ import annotations

from typing import Annotated

from allworlds.document.report import Report
from allworlds.document.struct import Aside, Natural, Positive, Some, Text, about, computed
from allworlds.inputs.checks import InputError, show
from allworlds.judging.explanations.by_law import teller_of
from allworlds.judging.explanations.story import Spending, Story
from allworlds.judging.findings.finding import Finding
from allworlds.judging.laws.law_table import LawName
from allworlds.maps.combinatorial import Dart
from allworlds.protocol.answers import Estimate
from allworlds.world.world import World


class Explanation(Report):
    """Report of 'explain'.

    Vertices and darts are those of the world, in the numbering of the finding.

    ``spent`` tells what the traversals were spent on, where they were too many.
    """

    explorer: Annotated[str, about("its name")] = computed(lambda told: told.finding.explorer)
    law: Annotated[LawName, about("the broken one")] = computed(lambda told: told.finding.law)
    step: Annotated[
        Natural | None,
        about(
            "the first at which the walk in the world and the same walk in the answer part; 0 is "
            "the start, null: at none"
        ),
    ]
    sentences: Annotated[Some[Text], about("in plain words")]
    world: Annotated[World, about("that of the finding")] = computed(
        lambda told: told.finding.world
    )
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
    finding: Aside[Finding]
    spent: Aside[Spending | None] = None


def explain(
    finding: Finding,
    *,
    number: int = 1,
    findings: int = 1,
) -> Explanation:
    """The finding in plain words.

    Args:
        finding: the one that is explained.
        number: of the finding in its report, from 1 on.
        findings: the number of findings in the report.

    Raises:
        InputError: if its transcript is no walk in its world, or its answer is none.
    """
    if not isinstance(finding, Finding):
        raise InputError(f"finding = {show(finding)} is no Finding; Finding.from_json makes one")
    story = Story(finding)
    telling = teller_of(finding.law)(story)
    return Explanation(
        step=telling.step,
        sentences=(*telling.sentences,),
        robot=story.walked[-1],
        answer=telling.answer,
        other=telling.other,
        slip=telling.slip or None,
        number=number,
        findings=findings,
        finding=finding,
        spent=telling.spent,
    )
