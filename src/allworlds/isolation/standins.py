"""What an explorer plays against in place of a plain world: a record, or a world that tells."""

from __future__ import annotations

from collections.abc import Sequence
from multiprocessing.connection import Connection
from typing import TypeVar

from allworlds.isolation.jobs import Traced
from allworlds.maps.combinatorial import Dart
from allworlds.protocol import Action, Choices, Kind, Percept, Transcript
from allworlds.world import IllegalAction, World

T = TypeVar("T")


class Recorded:
    """In place of a world: answers every action with the next recorded percept."""

    def __init__(self, transcript: Transcript, told: int | None) -> None:
        self.start: Dart = 0
        self.first = transcript.first
        self.told = told
        self.percepts = transcript.percepts

    def step(self, state: int, _action: Action) -> tuple[int, Percept]:
        """The next percept; the 'dart' of a step is its number.

        Raises:
            IllegalAction: past the end of the record.
        """
        if state + 1 == len(self.percepts):
            raise IllegalAction("nothing: the record ends here")
        return state + 1, self.percepts[state + 1]


class TellingWorld:
    """A world that tells each step before the explorer sees its outcome."""

    def __init__(self, world: World, connection: Connection) -> None:
        self._world, self._connection = world, connection
        self.start, self.first, self.told = world.start, world.first, world.told
        self.percepts = world.percepts

    def step(self, state: int, action: Action) -> tuple[int, Percept]:
        """The world's, told."""
        after, percept = self._world.step(state, action)
        self._connection.send(Traced((action, percept)))
        return after, percept


class TellingChoices(Choices):
    """Choices that tell each pick."""

    def __init__(self, choices: Choices, connection: Connection) -> None:
        super().__init__()
        self._choices, self._connection = choices, connection
        self.record = choices.record

    def pick(self, options: Sequence[T], of: Kind, cost: Sequence[int] | None = None) -> T:
        """One of the options, told."""
        picked = self._choices.pick(options, of, cost)
        self._connection.send(Traced(self.record[-1]))
        return picked
