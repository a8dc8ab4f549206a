"""A finding with the walk that its log describes, and the names of the places on it."""

from __future__ import annotations

from allworlds.findings import Finding, recorded_trail
from allworlds.inputs import InputError
from allworlds.maps.combinatorial import Dart


class Story:
    """A finding with its walk.

    Attributes:
        finding: what is to be told.
        world: its world.
        map: the map of that.
        transcript: its log.
        sensed: the percepts at the start and after each step.
        walked: the robot's darts in the world, likewise.
        checkpoint: the step before the checkpoint that breaks the law; None where none does.

    Raises:
        InputError: if the transcript is no walk in the world, or has no such step.
    """

    def __init__(self, finding: Finding) -> None:
        self.finding = finding
        self.world = finding.world
        self.map = finding.world.map
        self.transcript = finding.transcript
        self.sensed = self.transcript.percepts
        self.walked = recorded_trail(self.world, self.transcript)
        self.checkpoint = finding.step
        if finding.step is not None and finding.step >= len(self.walked):
            raise InputError(
                f"step = {finding.step} is behind the walk, which has {len(self.walked) - 1} steps"
            )

    def vertex(self, dart: Dart) -> str:
        """The vertex of a dart: ``v1``."""
        return f"v{self.map.vertex_of[dart]}"

    def place(self, dart: Dart) -> str:
        """A dart with its vertex: ``v1, dart 3``."""
        return f"{self.vertex(dart)}, dart {dart}"

    def last_left(self, dart: Dart, step: int) -> str:
        """When the robot had been at the dart's vertex before that step."""
        vertex = self.vertex(dart)
        last = max(i for i in range(step) if self.vertex(self.walked[i]) == vertex)
        just = last == step - 1
        return "which it had just left" if just else f"which it had left at step {last + 1}"

    def expected_and_seen(self) -> list[str]:
        """What the law expected and what was seen, as the finding has it."""
        return [f"Expected was: {self.finding.expected}.", f"Seen was: {self.finding.seen}."]
