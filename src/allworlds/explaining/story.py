"""A finding with the walk that its log describes, and the names of the places on it."""

from __future__ import annotations

from allworlds.checker.belief import recorded_trail
from allworlds.checker.finding import Finding
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

    Raises:
        InputError: if the transcript is no walk in the world.
    """

    def __init__(self, finding: Finding) -> None:
        self.finding = finding
        self.world = finding.world
        self.map = finding.world.map
        self.transcript = finding.transcript
        self.sensed = [self.transcript.first, *(percept for _, percept in self.transcript.steps)]
        self.walked = recorded_trail(self.world, self.transcript)

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
