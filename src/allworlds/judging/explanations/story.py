"""What a law is told of a finding, and what it tells: the walk, and the belief about it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

from allworlds.inputs import InputError, show
from allworlds.judging.explanations.named_walk import Walked
from allworlds.judging.explanations.spending import Spending
from allworlds.judging.findings.belief import believed_walk
from allworlds.judging.findings.divergence import Parting
from allworlds.judging.findings.finding import Finding
from allworlds.maps import Dart
from allworlds.protocol import Estimate, Percept
from allworlds.world import World


class Story(Walked):
    """A finding with the walk that its log describes.

    Attributes:
        finding: what is to be told.
        checkpoint: the step before the checkpoint that breaks the law; None where none does.

    Raises:
        InputError: if the transcript is no walk in the world, or has no such step.
    """

    def __init__(self, finding: Finding) -> None:
        super().__init__(finding.world, finding.transcript)
        self.finding = finding
        self.checkpoint = finding.step
        if finding.step is not None and finding.step >= len(self.walked):
            raise InputError(
                f"step = {show(finding.step)} is behind the walk, which has "
                f"{len(self.walked) - 1} steps"
            )

    def last_left(self, dart: Dart, step: int) -> str:
        """When the robot had been at the dart's vertex before that step."""
        vertex = self.vertex(dart)
        last = max(i for i in range(step) if self.vertex(self.walked[i]) == vertex)
        just = last == step - 1
        return "which it had just left" if just else f"which it had left at step {last + 1}"

    def expected_and_seen(self) -> str:
        """What the law expected and what was seen, as the finding has it."""
        return f"Expected was: {self.finding.expected}; seen was: {self.finding.seen}."


class Belief:
    """What the answer makes of the walk, under the laws that are about the answer.

    Attributes:
        story: the finding with its walk in the world.
        answer: the wrong answer.
        believed: the robot's darts in the answer at the start and after each step.

    Raises:
        InputError: if what was seen is no answer.
    """

    def __init__(self, story: Story) -> None:
        self.story = story
        self.answer = _answer(story.finding.seen)
        self._walk = believed_walk(story.world, self.answer, story.transcript)
        self.believed = self._walk.trail

    @cached_property
    def expected(self) -> Sequence[Percept]:
        """What the answer makes expect at each step, as far as that can be said."""
        return self._walk.expected(self.answer.map)

    @cached_property
    def misfits(self) -> list[int]:
        """The steps at which something else was sensed than the answer makes expect."""
        pairs = zip(self.expected, self.story.sensed, strict=True)
        return [step for step, (expected, sensed) in enumerate(pairs) if expected != sensed]

    @property
    def parting(self) -> Parting | None:
        """Where the walk and the same walk in the answer part; None if they never do."""
        return self._walk.parting

    @property
    def agreement(self) -> int:
        """The number of steps, the start included, in which both go along with each other."""
        return self._walk.agreement

    @property
    def step(self) -> int | None:
        """The first step at which belief and truth part."""
        return self.parting.step if self.parting else None


def _answer(seen: object) -> Estimate:
    if not isinstance(seen, Estimate):
        raise InputError(f"seen = {show(seen)} is no rooted map, but the law is about the answer")
    return seen


@dataclass(frozen=True, slots=True)
class Telling:
    """What there is to say of a run that breaks a law.

    Attributes:
        sentences: in plain words.
        step: the first step at which belief and truth part; None where they part at none.
        answer: the wrong answer; None where the law is not about the answer.
        other: another world that agrees with the log; None where the law is not about that.
        slip: the name of what makes all the difference between answer and world; empty where
            nothing that is known does.
        spent: what the traversals were spent on; None where the law is not about the cost.
    """

    sentences: list[str]
    step: int | None = None
    answer: Estimate | None = None
    other: World | None = None
    slip: str = ""
    spent: Spending | None = None


Teller: TypeAlias = Callable[[Story], Telling]
"""What a law has to tell of a story; it may raise InputError."""
