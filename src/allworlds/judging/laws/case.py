"""A finished run beside the truth: the value of its answer, and the other inputs of laws."""

from __future__ import annotations

from functools import cached_property
from typing import Literal, TypeAlias

from msgspec import Struct

from allworlds.maps import CombinatorialMap, Dart, carries, numbering
from allworlds.protocol import Answer, Checkpoint, Estimate, Move, Transcript


class Case(Struct, frozen=True, dict=True):
    """A finished run with the truth beside it.

    Attributes:
        map, start: the true map and the dart that the robot faced at the start.
        transcript: the log.
        checkpoints: the published S and U, each with the number of steps before it.
        estimate: the answer: its map is valid, or its permutations are, and ``here`` is one
            of its darts; None where a task asks for something else.
        bound: the largest legal number of traversals, or None.
    """

    map: CombinatorialMap
    start: Dart
    transcript: Transcript
    checkpoints: tuple[tuple[int, Checkpoint], ...]
    estimate: Answer | None
    bound: int | None = None

    @cached_property
    def trail(self) -> tuple[Dart, ...]:
        """The robot's true dart at the start and after each step, walked anew from the log."""
        turn, alpha = self.map.turn, self.map.alpha
        dart = self.start
        trail = [dart]
        for action, _ in self.transcript.steps:
            if type(action) is Move:
                dart = alpha[turn(dart, action.k)]
            trail.append(dart)
        return tuple(trail)

    @cached_property
    def walked(self) -> dict[Dart, int]:
        """For each dart of an edge that was crossed, the number of steps before the first time."""
        walked: dict[Dart, int] = {}
        for step, (action, _) in enumerate(self.transcript.steps):
            if type(action) is Move:
                entered = self.trail[step + 1]
                walked.setdefault(entered, step)
                walked.setdefault(self.map.alpha[entered], step)
        return walked

    @cached_property
    def answer(self) -> Literal["right", "pose", "map", "open"]:
        """The value of the estimate: right, or the one of its two parts that is wrong.

        ``pose``: the map is the same, but no isomorphism takes ``here`` to the robot's dart.
        ``open``: the answer names no map.
        """
        if not isinstance(self.estimate, Estimate):
            return "open"
        estimate, truth = self.estimate.map, self.map
        if len(estimate.sigma) != len(truth.sigma):
            return "map"
        order = numbering(estimate.sigma, estimate.alpha, self.estimate.here)

        def fits(dart: Dart) -> bool:
            return carries(estimate.sigma, estimate.alpha, order, truth.sigma, truth.alpha, dart)

        if fits(self.trail[-1]):
            return "right"
        return "pose" if any(fits(dart) for dart in truth.darts) else "map"


Value: TypeAlias = Estimate | int | str
"""An expectation, or an observation: estimates for map and pose, integers for bound, or texts."""


class Violation(Struct, frozen=True):
    """A broken law.

    Attributes:
        law: its name.
        expected, seen: estimates for map and pose, integers for bound, else a sentence.
        step: the number of steps before the checkpoint that breaks it; None if none does.
    """

    law: str
    expected: Value
    seen: Value
    step: int | None = None
