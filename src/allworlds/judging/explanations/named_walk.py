"""The walk that a log describes."""

from __future__ import annotations

from allworlds.judging.findings.walks import recorded_trail
from allworlds.maps import Dart
from allworlds.protocol import Move, Transcript
from allworlds.world import World


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

    def vertex(self, dart: Dart) -> str:
        """The name of a dart's vertex: ``v1``."""
        return f"v{self.map.vertex_of[dart]}"

    def place(self, dart: Dart) -> str:
        """The name of a dart with its vertex: ``v1, dart 3``."""
        return f"{self.vertex(dart)}, dart {dart}"
