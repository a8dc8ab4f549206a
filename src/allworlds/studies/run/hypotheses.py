"""The hypotheses that Algorithm 1 tests in a run, observed while the run is played once more.

No explorer says what it supposes: the protocol has no word for it, and none is needed.  The
built-in ones ask for every choice, and tell a listener how each test ends.  So the same explorer
is played again, against the recorded percepts, with the recorded choices; which hypothesis it
takes up is heard where it chooses.  What is heard counts only if it walks as it did.
"""

from __future__ import annotations

from collections.abc import Generator, Sequence
from typing import Any, TypeVar

from msgspec import Struct

from allworlds.engines.single import SingleRun
from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.explorers.loading import built_in
from allworlds.judging.episode import AroundExplorer, Environment, Log, followed
from allworlds.judging.findings.walks import true_trail
from allworlds.maps.combinatorial import Dart
from allworlds.protocol.actions import Action, Percept
from allworlds.protocol.answers import Checkpoint
from allworlds.protocol.choices import Choices, Kind
from allworlds.protocol.player import Told
from allworlds.protocol.playing import play_run
from allworlds.world.world import World

T = TypeVar("T")

TELLING = ("algorithm1", "algorithm1-cluster", "algorithm1-natural")
"""The explorers whose options are darts of S."""

DECIDED = {"case-1": False, "case-2": False, "case-3": True}
"""How a test ends, by the event that tells of it: whether the hypothesis is right."""


class Hypothesis(Struct, frozen=True):
    """A hypothesis under test: the dart of entry of a vertex not known yet is this known dart.

    Attributes:
        dart: of the world, the known dart.
        first: the number of steps when it was taken up.
        supposed: where the robot is if it is right, from then on to the end of the test.
        right: whether it is.
    """

    dart: Dart
    first: int
    supposed: tuple[Dart, ...]
    right: bool

    @property
    def last(self) -> int:
        """The number of steps at which it was decided."""
        return self.first + len(self.supposed) - 1


def hypotheses_in(run: SingleRun) -> tuple[Hypothesis, ...]:
    """Every test of a run, in order.

    Empty for an explorer that reports no tests or walks differently.

    Cost: that of the run.
    """
    episode, world = run.outcome.episode, run.world
    if run.explorer not in TELLING:
        return ()
    stage = _Replayed(world.told, episode.transcript.percepts)
    heard = _Heard(stage, run.outcome.choices)
    explore, keywords = BUILT_IN[run.explorer].explore, built_in(run.explorer).keywords

    def player(first: Percept, choices: Choices, told: Told) -> Generator[Any, Any, Any]:
        tells = {"told": told} if "told" in keywords else {}
        listened: Generator[Any, Any, Any]
        listened = explore(first, choices=choices, notice=heard.notice, **tells)
        return listened

    budget = episode.transcript.cost
    log = play_run(AroundExplorer(stage), player, heard, budget, [0, 0])
    again = followed(Log.of(log), world, budget)
    if (again.transcript, again.checkpoints) != (episode.transcript, episode.checkpoints):
        return ()
    trail = true_trail(world, episode.transcript)
    tests = [_test(world, trail, episode.checkpoints, one) for one in heard.tests]
    return tuple(test for test in tests if test)


def embedded(checkpoint: Checkpoint, world: World, robot: Dart) -> dict[Dart, Dart] | None:
    """The dart of the world for each dart of S; None if S does not lie so in the world."""
    sigma, alpha, map_ = checkpoint.sigma, checkpoint.alpha, world.map
    place = {checkpoint.here: robot}
    for dart in (queue := [checkpoint.here]):
        around = [(sigma[dart], map_.sigma[place[dart]])]
        if alpha[dart] != dart:
            around.append((alpha[dart], map_.alpha[place[dart]]))
        for near, true in around:
            if near not in place:
                place[near] = true
                queue.append(near)
            elif place[near] != true:
                return None
    return place if len(place) == len(sigma) else None


class _Replayed(Environment):
    """A stand-in for the world: it returns the recorded percepts and counts the steps."""

    def __init__(self, told: Told, percepts: Sequence[Percept]) -> None:
        self._told, self._percepts = told, percepts
        self.steps = 0

    @property
    def initial(self) -> None:
        return None

    @property
    def first(self) -> Percept:
        return self._percepts[0]

    @property
    def over(self) -> bool:
        """A replay ends where the log does."""
        return False

    @property
    def told(self) -> Told:
        return self._told

    def step(self, _state: None, _action: Action) -> tuple[None, Percept]:
        self.steps += 1
        return None, self._percepts[self.steps]


class _Taken(Struct):
    """A hypothesis as observed: the steps at arrival, and at the start and end of its test."""

    dart: Dart
    arrived: int
    first: int
    last: int = -1
    right: bool = False


class _Heard(Choices):
    """A listener that answers with the recorded choices and records the tests."""

    def __init__(self, stage: _Replayed, script: Sequence[int]) -> None:
        super().__init__(script=script)
        self._stage, self._arrived = stage, -1
        self.tests: list[_Taken] = []

    def pick(self, options: Sequence[T], of: Kind, cost: Sequence[int] | None = None) -> T:
        picked = super().pick(options, of, cost)
        steps = self._stage.steps
        if of == "edge":
            self._arrived = -1
        elif of == "hypothesis":
            if self._arrived < 0:
                self._arrived = steps
            assert isinstance(picked, int)
            self.tests.append(_Taken(picked, self._arrived, steps))
        return picked

    def notice(self, event: str) -> None:
        """Record how the test ended that was begun last."""
        if event in DECIDED:
            test = self.tests[-1]
            test.last, test.right = self._stage.steps, DECIDED[event]


def _test(
    world: World,
    trail: Sequence[Dart],
    checkpoints: Sequence[tuple[int, Checkpoint]],
    heard: _Taken,
) -> Hypothesis | None:
    """The test in the world's darts; None if S, gone wrong, is not embedded in the world.

    Whatever is supposed, the same motions are made: where the robot then were is found along
    the world's own map, in which S lies.
    """
    map_ = world.map
    place = _darts_of_s(world, trail, checkpoints, heard.arrived)
    if place is None:
        return None
    at = place[heard.dart]
    # After tests that failed the robot stands turned against the dart of entry.
    turn = map_.offset(trail[heard.arrived], trail[heard.first])
    supposed = [map_.turn(at, turn)]
    for here, there in zip(
        trail[heard.first : heard.last], trail[heard.first + 1 : heard.last + 1], strict=True
    ):
        motion = map_.offset(here, map_.alpha[there])
        supposed.append(map_.alpha[map_.turn(supposed[-1], motion)])
    return Hypothesis(at, heard.first, tuple(supposed), heard.right)


def _darts_of_s(
    world: World, trail: Sequence[Dart], checkpoints: Sequence[tuple[int, Checkpoint]], step: int
) -> dict[Dart, Dart] | None:
    """The dart of the world for each dart that S has at a step; at first it has those of v0."""
    shown = [(at, checkpoint) for at, checkpoint in checkpoints if at < step]
    if not shown:
        start = world.start
        return {k: world.map.turn(start, k) for k in range(world.map.degree_at[start])}
    at, checkpoint = shown[-1]
    return embedded(checkpoint, world, trail[at])
