"""The log of a run in its world, with the robot's way: what the judges of tasks get."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Self

from msgspec import Struct, field

from allworlds.maps.combinatorial import Dart
from allworlds.protocol.actions import Action, Move, Percept
from allworlds.protocol.transcript import Transcript
from allworlds.world.world import World


class WalkLog(Struct):
    """A log that knows its world; while the run goes on, it grows.

    Its elements are the steps, pairs of an action and the percept that answered it.

    Attributes:
        world: in which the run takes place.
        steps: the elements.
        darts: the dart that the robot faced at the start, and the one by which it had arrived
            after each step.
        visited: the vertices where it was.
        walked: the edges along which it went, each by the smaller of its darts.
        cost: the number of traversals.
    """

    world: World
    steps: list[tuple[Action, Percept]] = field(default_factory=list)
    darts: list[Dart] = field(default_factory=list)
    visited: set[int] = field(default_factory=set)
    walked: set[Dart] = field(default_factory=set)
    cost: int = 0

    def __post_init__(self) -> None:
        self._stand(self.world.start)

    @classmethod
    def of(cls, world: World, transcript: Transcript) -> Self:
        """The walk of a finished run."""
        walk = cls(world)
        for action, percept in transcript.steps:
            walk.add(action, percept)
        return walk

    @property
    def first(self) -> Percept:
        """The percept before any motion."""
        return self.world.first

    @property
    def percepts(self) -> list[Percept]:
        """The percepts at the start and after each step."""
        return [self.first, *(percept for _, percept in self.steps)]

    @property
    def actions(self) -> list[Action]:
        """The actions, step by step."""
        return [action for action, _ in self.steps]

    @property
    def here(self) -> Dart:
        """The last of its darts."""
        return self.darts[-1]

    def __iter__(self) -> Iterator[tuple[Action, Percept]]:
        return iter(self.steps)

    def __len__(self) -> int:
        return len(self.steps)

    def add(self, action: Action, percept: Percept) -> None:
        """Go one step further."""
        self.steps.append((action, percept))
        map_, dart = self.world.map, self.here
        if type(action) is Move:
            dart = map_.alpha[map_.turn(dart, action.k)]
            self.walked.add(min(dart, map_.alpha[dart]))
            self.cost += 1
        self._stand(dart)

    def _stand(self, dart: Dart) -> None:
        self.darts.append(dart)
        self.visited.add(self.world.map.vertex_of[dart])
