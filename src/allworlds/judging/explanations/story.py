"""The story of a run: its walk in names, and that walk in a wrong answer."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

from msgspec import Struct

from allworlds.inputs.checks import InputError, show
from allworlds.judging.findings.finding import Finding
from allworlds.judging.findings.walks import believed_walk, recorded_trail
from allworlds.maps.combinatorial import Dart
from allworlds.protocol.actions import Move
from allworlds.protocol.answers import Estimate
from allworlds.protocol.transcript import Transcript
from allworlds.world.world import World


class Walked:
    """The walk that a log describes, and the names of the places on it.

    Attributes:
        world: in which it was.
        map: of the world.
        transcript: the log.
        sensed: the percepts at the start and after each step.
        walked: the robot's darts in the world at the start and after each step.

    Raises:
        InputError: if the transcript is no walk in the world.
    """

    def __init__(self, world: World, transcript: Transcript) -> None:
        self.world = world
        self.map = world.map
        self.transcript = transcript
        self.sensed = transcript.percepts
        self.walked = recorded_trail(world, transcript)

    @property
    def discoveries(self) -> tuple[int, ...]:
        """The steps that first went along an edge, one for each walked edge, numbered from 1."""
        first: dict[Dart, int] = {}
        for step, (action, arrived) in enumerate(
            zip(self.transcript.actions, self.walked[1:], strict=False), 1
        ):
            if type(action) is Move:
                first.setdefault(min(arrived, self.map.alpha[arrived]), step)
        return (*first.values(),)

    @property
    def steps_back(self) -> int:
        """The number of traversals that take back the last one not yet taken back."""
        back, path = 0, list[Dart]()
        for action, before, arrived in zip(
            self.transcript.actions, self.walked, self.walked[1:], strict=False
        ):
            if type(action) is not Move:
                continue
            if path and self.map.turn(before, action.k) == path[-1]:
                path.pop()
                back += 1
            else:
                path.append(arrived)
        return back

    def vertex(self, dart: Dart) -> str:
        """The name of a dart's vertex: ``hall``, or ``v1`` where it has none."""
        return self.world.labels.vertex(self.map.vertex_of[dart])

    def place(self, dart: Dart) -> str:
        """The name of a dart with its vertex: ``v1, dart 3``."""
        return f"{self.vertex(dart)}, dart {dart}"

    def arrival(self, step: int) -> str:
        """The place after a step; where vertices have names and it moved: ``hall -> F, dart 3``."""
        place = self.place(self.walked[step])
        moved = step and type(self.transcript.actions[step - 1]) is Move
        if moved and self.world.labels.vertices:
            return f"{self.vertex(self.walked[step - 1])} -> {place}"
        return place


class Story(Walked):
    """A finding with the walk that its log describes.

    Attributes:
        finding: the one that is explained.
        checkpoint: the step before the checkpoint that breaks the law; None if none does.

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
        """A clause about the last time before ``step`` that the robot was at the dart's vertex."""
        vertex = self.vertex(dart)
        last = max(i for i in range(step) if self.vertex(self.walked[i]) == vertex)
        just = last == step - 1
        return "which it had just left" if just else f"which it had left at step {last + 1}"


class Belief:
    """The walk as the answer has it, under the laws that are about the answer.

    Attributes:
        story: the finding with its walk in the world.
        answer: the wrong answer.
        walk: the walk in it.

    Raises:
        InputError: if the observation is no answer.
    """

    def __init__(self, story: Story) -> None:
        seen = story.finding.seen
        if not isinstance(seen, Estimate):
            raise InputError(
                f"seen = {show(seen)} is no rooted map, but the law is about the answer"
            )
        self.story, self.answer = story, seen
        self.walk = believed_walk(story.world, self.answer, story.transcript)

    @property
    def step(self) -> int | None:
        """The first step at which belief and truth diverge."""
        parting = self.walk.parting
        return parting.step if parting else None


class Telling(Struct, frozen=True):
    """The explanation of a run that breaks a law.

    Attributes:
        sentences: in plain words.
        step: the first step at which belief and truth diverge; None if they never do.
        answer: the wrong answer; None if the law is not about the answer.
        other: another world that agrees with the log; None if the law is not about that.
        slip: the name of the one difference between answer and world; empty if it is no known
            slip.
    """

    sentences: list[str]
    step: int | None = None
    answer: Estimate | None = None
    other: World | None = None
    slip: str = ""


Teller: TypeAlias = Callable[[Story], Telling]
"""The explanation of a story by a law; may raise InputError."""
