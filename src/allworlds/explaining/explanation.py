"""From a finding to its explanation."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from allworlds.explaining.laws import teller_of
from allworlds.explaining.story import Story
from allworlds.findings import Finding
from allworlds.inputs import InputError, show
from allworlds.maps.combinatorial import Dart
from allworlds.outcome import SCHEMA, Exit
from allworlds.protocol import Estimate
from allworlds.world import World


@dataclass(frozen=True, slots=True)
class Explanation:
    """What a finding means.

    Vertices and darts are those of the world, in the numbering of the finding.

    Attributes:
        law: the broken law.
        sentences: in plain words.
        step: the first step at which belief and truth part; 0 is the start, None where they
            part at none.
        explorer: its name.
        world: where it happened.
        robot: its dart at the end of the walk.
        answer: the wrong answer; None where the finding holds none.
    """

    law: str
    sentences: tuple[str, ...]
    step: int | None
    explorer: str
    world: World
    robot: Dart
    answer: Estimate | None

    @property
    def exit_code(self) -> Exit:
        """The exit code of the command: a question was answered."""
        return Exit.ANSWERED

    def to_json(self) -> dict[str, Any]:
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
        finding.law,
        tuple(telling.sentences),
        telling.step,
        finding.explorer,
        finding.world,
        story.walked[-1],
        telling.answer,
    )
