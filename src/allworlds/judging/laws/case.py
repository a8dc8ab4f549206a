"""Cases that a law is asked about, and the answers that are quotients."""

from __future__ import annotations

from functools import cached_property
from typing import Literal, TypeAlias

from msgspec import Struct

from allworlds.maps.canonical import carries, numbering
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.maps.quotient import Quotient, is_ambiguous, project
from allworlds.protocol.actions import Move
from allworlds.protocol.answers import Ambiguous, Answer, Checkpoint, Estimate
from allworlds.protocol.transcript import Transcript


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


def ambiguity_law(case: Case) -> Violation | None:
    """Require that an answer without a map is the rooted quotient of a world that has lookalikes.

    The percepts are one mark at the start's vertex, and the degree; lookalikes are counted
    among all maps, whatever the class that is checked.
    Cost: O(m log m).
    """
    answer = case.estimate
    if not isinstance(answer, Ambiguous):
        return None
    map_, v0 = case.map, case.map.vertex_of[case.start]
    marks = [int(vertex == v0) for vertex in map_.vertex_of]
    quotient, classes = project((map_, marks, case.start))
    # The criterion wants the root at v0; the robot may be elsewhere.
    if not is_ambiguous(quotient):
        return Violation(
            "ambiguity",
            "the map: no other world looks like this one",
            f"Ambiguous, {_words(_canonical(answer))}",
        )
    truth = _of(quotient.rerooted(classes[case.trail[-1]]))
    if _canonical(answer) == truth:
        return None
    return Violation("ambiguity", _words(truth), _words(_canonical(answer)))


def _of(quotient: Quotient) -> Ambiguous:
    marks = tuple([label for label in quotient.labels if isinstance(label, int)])
    return Ambiguous(quotient.sigma, quotient.alpha, quotient.degree, marks, 0)


def _canonical(answer: Ambiguous) -> Ambiguous:
    """The quotient with its darts numbered from ``here``."""
    order = numbering(answer.sigma, answer.alpha, answer.here)
    number = {q: i for i, q in enumerate(order)}
    return Ambiguous(
        tuple(number[answer.sigma[q]] for q in order),
        tuple(number[answer.alpha[q]] for q in order),
        tuple(answer.degree[q] for q in order),
        tuple(answer.marks[q] for q in order),
        0,
    )


def _words(answer: Ambiguous) -> str:
    """The rooted quotient in a sentence."""
    parts = (
        f"{name} {list(values)}"
        for name, values in (
            ("sigma", answer.sigma),
            ("alpha", answer.alpha),
            ("degree", answer.degree),
            ("marks", answer.marks),
        )
    )
    return f"the quotient rooted at 0 with {', '.join(parts)}"
