"""Wrong explorers: Algorithm 1 with one thing done wrong each, and two learners of quotients.

The findings of the corpus name them: ``allworlds.corpus.explorers:pose_lost``.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from itertools import count, pairwise
from typing import Any

from msgspec import Struct

from allworlds.documents.document import replace
from allworlds.explorers.builtin.algorithm1 import Algorithm1, Stage
from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.explorers.builtin.folding import OPEN, FoldedLog, explore_folding, way
from allworlds.maps.combinatorial import CombinatorialMap, cycles
from allworlds.protocol.actions import Ambiguous, Answer, Checkpoint, Drop, Estimate, Move, Percept
from allworlds.protocol.choices import Choices


class BearingIgnored(Algorithm1):
    """Takes any dart of v0 for the one it came by: the marker's direction is not compared."""

    def __init__(self, first: Percept, choices: Choices) -> None:
        super().__init__(first, choices)
        for dart, percept in enumerate(self.s.expected):
            self.s.expected[dart] = without_bearing(percept)

    def hypotheses(self, goal: int, percept: Percept) -> list[int]:
        return super().hypotheses(goal, without_bearing(percept))

    def try_path(self, partner: int, path: list[int]) -> Stage[tuple[list[int], bool]]:
        tried: Stage[tuple[list[int], bool]] = sensing(
            super().try_path(partner, path), without_bearing
        )
        return (yield from tried)


def without_bearing(percept: Percept) -> Percept:
    """The percept without its bearing, as a robot that senses no direction has it."""
    return replace(percept, bearing=None)


def sensing(walk: Stage[Any], change: Callable[[Percept], Percept]) -> Stage[Any]:
    """The walk of a robot whose percepts are altered."""
    reply: Any = None
    while True:
        try:
            message = walk.send(reply)
        except StopIteration as stop:
            return stop.value
        seen = yield message
        reply = None if seen is None else change(seen)


class MarkerIgnored(Algorithm1):
    """Compares degrees only: neither the marker nor its direction is seen."""

    def __init__(self, first: Percept, choices: Choices) -> None:
        super().__init__(Percept(first.degree), choices)

    def explore(self) -> Stage[Estimate]:
        walk: Stage[Estimate] = sensing(super().explore(), lambda seen: Percept(seen.degree))
        return (yield from walk)


class NoRetracing(Algorithm1):
    """Line 15 left out: after a rejected hypothesis the robot stays where it is."""

    def retrace(self, motions: list[int]) -> Stage[None]:
        del motions
        self.turned = 0
        yield from ()


class OrientationNotRestored(Algorithm1):
    """Line 15 by half: the robot comes back to v_u, but forgets how it is turned there."""

    def retrace(self, motions: list[int]) -> Stage[None]:
        yield from super().retrace(motions)
        self.turned = 0


class PartnerLeftInU(Algorithm1):
    """Line 19 by half: the confirmed e' stays in U and is explored again."""

    def augment_by_loop(self, goal: int, partner: int) -> None:
        super().augment_by_loop(goal, partner)
        self.s.unexplored.append(partner)


class PartnerShownInU(Algorithm1):
    """Publishes a U that still holds the partner of the edge explored last; walks rightly."""

    def explore(self) -> Stage[Estimate]:
        return (yield from published(super().explore(), partner_open))


def partner_open(checkpoint: Checkpoint) -> Checkpoint:
    """The checkpoint with the later end of its last explored edge marked as open."""
    alpha = list(checkpoint.alpha)
    explored = [d for d, e in enumerate(alpha) if d != e]
    alpha[explored[-1]] = explored[-1]
    return replace(checkpoint, alpha=alpha)


def published(walk: Stage[Estimate], change: Callable[[Checkpoint], Checkpoint]) -> Stage[Estimate]:
    """The walk of an explorer with altered checkpoints."""
    reply: Any = None
    while True:
        try:
            message = walk.send(reply)
        except StopIteration as stop:
            return stop.value  # type: ignore[no-any-return]
        reply = yield change(message) if isinstance(message, Checkpoint) else message


class PlaceShownWrong(Algorithm1):
    """Publishes an S in which the robot stands at the next dart; walks rightly."""

    def explore(self) -> Stage[Estimate]:
        def turned(checkpoint: Checkpoint) -> Checkpoint:
            return replace(checkpoint, here=checkpoint.sigma[checkpoint.here])

        return (yield from published(super().explore(), turned))


class PassWithoutProgress(Algorithm1):
    """Publishes every S twice, so that t does not fall; walks rightly."""

    def explore(self) -> Stage[Estimate]:
        walk = super().explore()
        reply: Any = None
        while True:
            try:
                message = walk.send(reply)
            except StopIteration as stop:
                return stop.value  # type: ignore[no-any-return]
            if isinstance(message, Checkpoint):
                yield message
            reply = yield message


class OneHypothesisOnly(Algorithm1):
    """Lines 7-17 without the loop: only the first hypothesis is tested."""

    def test_all(self, hypotheses: list[int]) -> Stage[int | None]:
        return (yield from super().test_all(hypotheses[:1]))


class SecondEntryForgotten(Algorithm1):
    """Line 6: an unexplored loop's other end is not taken for a hypothesis."""

    def hypotheses(self, goal: int, percept: Percept) -> list[int]:
        vertex = self.s.vertex
        return [d for d in super().hypotheses(goal, percept) if vertex[d] != vertex[goal]]


class ConfirmedTooEarly(Algorithm1):
    """Lines 10-13: a hypothesis is confirmed when the first step of its path matches."""

    def try_path(self, partner: int, path: list[int]) -> Stage[tuple[list[int], bool]]:
        motions, matched = yield from super().try_path(partner, path[:1])
        if matched and len(path) > 1:
            rest = yield from self.finish(path)
            motions += rest
        return motions, matched

    def finish(self, path: list[int]) -> Stage[list[int]]:
        """Stage the rest of the path with closed eyes."""
        motions = []
        for before, dart in pairwise(path):
            motions.append(self.s.offset(self.s.alpha[before], dart))
            yield Move(motions[-1])
        return motions


class WrongEntryLabel(Algorithm1):
    """Line 20: the edge is added at the dart behind the one by which the robot has entered."""

    def augment_by_vertex(self, goal: int, percept: Percept) -> None:
        super().augment_by_vertex(goal, percept)
        self.here = self.s.turn(self.here, -1)


class MirrorImage(Algorithm1):
    """Line 22: the answer is the mirror image of S."""

    def answer(self) -> Estimate:
        right = super().answer()
        return Estimate(right.map.mirrored(), right.here)


class DartsExchanged(Algorithm1):
    """Line 22: the answer has the first two darts of a vertex of degree 3 or more exchanged."""

    def answer(self) -> Estimate:
        right = super().answer()
        sigma = list(right.map.sigma)
        large = [vertex for vertex in right.map.vertices if len(vertex) >= 3]
        if large:
            a, b, *_, last = large[0]
            sigma[last], sigma[b], sigma[a] = b, a, sigma[b]
        return Estimate(CombinatorialMap(sigma, right.map.alpha), right.here)


class PoseLost(Algorithm1):
    """Line 22: the map is right, but the robot is said to stand where it began."""

    def answer(self) -> Estimate:
        return Estimate(super().answer().map, 0)


class LuckyGuess(Algorithm1):
    """Line 2: with two darts left in U it guesses that they are one edge, and stops."""

    def take_from_u(self) -> int:
        return self.s.unexplored[0]

    def explore(self) -> Stage[Estimate]:
        walk = super().explore()
        reply: Any = None
        while len(self.s.unexplored) != 2:
            try:
                reply = yield walk.send(reply)
            except StopIteration as stop:
                return stop.value  # type: ignore[no-any-return]
        self.s.add_loop(*self.s.unexplored)
        return self.answer()


class WalksTooMuch(Algorithm1):
    """Before it answers it walks its last edge once more each way for every edge there is."""

    def explore(self) -> Stage[Estimate]:
        estimate = yield from super().explore()
        for _ in range(estimate.map.edge_count):
            yield Move(0)
            yield Move(0)
        return estimate


class WrongInOneWorld(Algorithm1):
    """Right everywhere but in one rooted map with three edges, whose pose it forgets."""

    world = CombinatorialMap((1, 2, 0, 4, 5, 3), (1, 0, 3, 2, 5, 4))

    def answer(self) -> Estimate:
        right = super().answer()
        return Estimate(right.map, 0) if right.map == self.world else right


class NeverStops(Algorithm1):
    """Line 2: U is never empty, so it walks for ever."""

    def explore(self) -> Stage[Estimate]:
        yield from super().explore()
        while True:
            yield Move(1)


class NearestOnly(Algorithm1):
    """An explorer that always takes the nearest open dart, from copy to copy for ever."""

    def __init__(self, first: Percept, choices: Choices) -> None:
        super().__init__(first, choices)
        self.first = first

    def explore(self) -> Stage[Estimate]:
        """Stage without tests, to the nearest open dart each time."""
        return (yield from explore_folding(self.first, to_nearest))


def to_nearest(log: FoldedLog, here: int) -> list[int]:
    """The way to the open dart that is nearest to the robot."""
    return way(log, here, lambda dart: log.beyond(dart) == OPEN)


class CrashesAtLeaves(Algorithm1):
    """Fails on the degree that is easiest to forget: 1."""

    def augment_by_vertex(self, goal: int, percept: Percept) -> None:
        if percept.degree == 1:
            raise IndexError("a vertex without another dart")
        super().augment_by_vertex(goal, percept)


class DropsMarkers(Algorithm1):
    """Written for a robot with markers in hand."""

    def follow(self, goal: int) -> Stage[Percept]:
        yield Drop()
        return (yield from super().follow(goal))


class NoAnswer(Algorithm1):
    """Forgets to return what it has found."""

    def explore(self) -> Stage[Estimate]:
        yield from super().explore()
        return None  # type: ignore[return-value]


class StateKept(Algorithm1):
    """Explores the other way round in every second episode of a process."""

    episodes = count()

    def __init__(self, first: Percept, choices: Choices) -> None:
        super().__init__(first, choices)
        self.backwards = next(self.episodes) % 2

    def take_from_u(self) -> int:
        return self.s.unexplored[-1] if self.backwards else super().take_from_u()


class DegreeIgnored(Algorithm1):
    """Line 6 without the degree: every unmarked open dart is a hypothesis."""

    def hypotheses(self, goal: int, percept: Percept) -> list[int]:
        if percept.marks:
            return super().hypotheses(goal, percept)
        expected = self.s.expected
        return [d for d in self.s.unexplored if d != goal and not expected[d].marks]


class WrongExplorer(Struct, frozen=True):
    """A mutant of Algorithm 1.

    Attributes:
        kind: the class that does one thing wrong.
        equivalent: why it is right all the same; empty for one that must be killed.
    """

    kind: type[Algorithm1]
    equivalent: str = ""

    lighthouse = "directional"
    task = "map"

    @property
    def name(self) -> str:
        """The class's name in words, such as ``no-retracing``."""
        words = "".join(f"-{c.lower()}" if c.isupper() else c for c in self.kind.__name__)
        return words.strip("-").replace("-u", "-U") if words.endswith("-u") else words.strip("-")

    @property
    def breaks(self) -> str:
        """The explorer's mistake, in words."""
        return (self.kind.__doc__ or "").strip()

    def explorer(self) -> Callable[..., Generator[Any, Any, Estimate]]:
        """The generator function, which runs in this process."""
        kind = self.kind

        def explore(
            first: Percept, *, choices: Choices | None = None
        ) -> Generator[Any, Any, Estimate]:
            return (yield from kind(first, choices or Choices()).explore())

        explore.__module__, explore.__qualname__ = "mutants", self.name
        return explore


WRONG_EXPLORERS = tuple(
    map(
        WrongExplorer,
        (
            BearingIgnored,
            MarkerIgnored,
            NoRetracing,
            OrientationNotRestored,
            PartnerLeftInU,
            PartnerShownInU,
            PlaceShownWrong,
            PassWithoutProgress,
            OneHypothesisOnly,
            SecondEntryForgotten,
            ConfirmedTooEarly,
            WrongEntryLabel,
            MirrorImage,
            DartsExchanged,
            PoseLost,
            LuckyGuess,
            WalksTooMuch,
            WrongInOneWorld,
            NeverStops,
            NearestOnly,
            CrashesAtLeaves,
            DropsMarkers,
            NoAnswer,
            StateKept,
        ),
    )
)
"""The explorers that must be refuted."""

EQUIVALENT_EXPLORERS = (
    WrongExplorer(
        DegreeIgnored,
        "a test that matches to the end proves its hypothesis whatever the degree at its "
        "beginning, and a true hypothesis always matches; the bound counts every open dart as a "
        "hypothesis anyway",
    ),
)
"""The explorers that do something else and are right."""


def doubtful_for_no_reason(right: Answer) -> Answer:
    """Doubts where only one world looks so: in place of a map it answers with a quotient."""
    if isinstance(right, Ambiguous):
        return right
    map_ = right.map
    degree = [map_.degree_at[dart] for dart in map_.darts]
    return Ambiguous(map_.sigma, map_.alpha, degree, [0] * len(degree), right.here)


def degrees_of_the_quotient(right: Answer) -> Answer:
    """Counts the darts round a vertex of the quotient, and not those that are sensed there."""
    if not isinstance(right, Ambiguous):
        return right
    round_it = {dart: len(cycle) for cycle in cycles(right.sigma) for dart in cycle}
    return replace(right, degree=[round_it[dart] for dart in range(len(right.sigma))])


class WrongLearner(Struct, frozen=True):
    """A mutant of the explorer ``quotient``.

    Attributes:
        slip: what becomes of the right answer.
        equivalent: why it is right all the same; empty for one that must be killed.
    """

    slip: Callable[[Answer], Answer]
    equivalent: str = ""

    lighthouse = BUILT_IN["quotient"].lighthouse
    task = "map"

    @property
    def name(self) -> str:
        """The name of the slip, with hyphens."""
        return self.slip.__name__.replace("_", "-")

    @property
    def breaks(self) -> str:
        """The learner's mistake, in words."""
        return (self.slip.__doc__ or "").strip()

    def explorer(self) -> Callable[..., Generator[Any, Any, Answer]]:
        """The generator function, which runs in this process."""
        slip = self.slip

        def explore(first: Percept) -> Generator[Any, Any, Answer]:
            return slip((yield from BUILT_IN["quotient"].explore(first)))

        explore.__module__, explore.__qualname__ = "mutants", self.name
        return explore


WRONG_LEARNERS = (WrongLearner(doubtful_for_no_reason), WrongLearner(degrees_of_the_quotient))
"""The learners that must be refuted."""


def __getattr__(name: str) -> Callable[..., Generator[Any, Any, Estimate]]:
    """Find a mutant by its name with underscores, as findings name it: ``no_retracing``."""
    for mutant in (*WRONG_EXPLORERS, *EQUIVALENT_EXPLORERS):
        if mutant.name.replace("-", "_") == name:
            return mutant.explorer()
    raise AttributeError(f"there is no mutant {name!r}")


__all__ = [
    "EQUIVALENT_EXPLORERS",
    "WRONG_EXPLORERS",
    "WRONG_LEARNERS",
    "WrongExplorer",
    "WrongLearner",
]
