"""From a finding to its explanation."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from allworlds.inputs import InputError, show
from allworlds.judging.explanations.by_law import teller_of
from allworlds.judging.explanations.spending import Spending
from allworlds.judging.explanations.story import Story
from allworlds.judging.findings.finding import Finding
from allworlds.maps import Dart
from allworlds.outcome import SCHEMA, Exit
from allworlds.protocol import Estimate
from allworlds.world import World

if TYPE_CHECKING:
    from allworlds import documents


@dataclass(frozen=True, slots=True)
class Explanation:
    """What a finding means.

    Vertices and darts are those of the world, in the numbering of the finding.

    Attributes:
        finding: what is explained.
        sentences: in plain words.
        step: the first step at which belief and truth part; 0 is the start, None where they
            part at none.
        robot: its dart at the end of the walk.
        answer: the wrong answer; None where the finding holds none.
        other: another world in which the robot would have sensed the same, where that is what
            is wrong; else None.
        slip: the name of the one thing that makes all the difference between the answer and the
            world; empty where there is none, or none that is known.
        spent: what the traversals were spent on, where they were too many; else None.
    """

    finding: Finding
    sentences: tuple[str, ...]
    step: int | None
    robot: Dart
    answer: Estimate | None
    other: World | None = None
    slip: str = ""
    spent: Spending | None = None

    @property
    def explorer(self) -> str:
        """Its name."""
        return self.finding.explorer

    @property
    def law(self) -> str:
        """The broken law."""
        return self.finding.law

    @property
    def world(self) -> World:
        """Where it happened."""
        return self.finding.world

    @property
    def exit_code(self) -> Exit:
        """The exit code of the command: a question was answered."""
        return Exit.ANSWERED

    def to_json(self) -> documents.ExplainDocument:
        """The document of ``explain --json``."""
        answer = self.answer
        return {
            "schema": SCHEMA,
            "explorer": self.explorer,
            "law": self.law,
            "step": self.step,
            "sentences": list(self.sentences),
            "world": self.world.to_json(),
            "robot": self.robot,
            "answer": answer.to_json() if answer else None,
            "other": self.other.to_json() if self.other else None,
            "slip": self.slip or None,
        }


def explain(finding: Finding) -> Explanation:
    """The finding in plain words.

    Raises:
        InputError: if its transcript is no walk in its world, or its answer is none.
    """
    if not isinstance(finding, Finding):
        raise InputError(f"finding = {show(finding)} is no Finding; Finding.from_json makes one")
    story = Story(finding)
    telling = teller_of(finding.law)(story)
    return Explanation(
        finding,
        tuple(telling.sentences),
        telling.step,
        story.walked[-1],
        telling.answer,
        telling.other,
        telling.slip,
        telling.spent,
    )
