"""``run``: one world, told step by step; and the hypotheses that Algorithm 1 tests in it.

No explorer says what it supposes: the protocol has no word for it, and none is needed.  The
built-in ones ask for every choice, and tell a listener how each test ends.  So the same explorer
is played again, against the recorded percepts, with the recorded choices; which hypothesis it
takes up is heard where it chooses.  What is heard counts only if it walks as it did.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Generator, Iterable, Sequence
from typing import Annotated, Any, TypeVar

from msgspec import Struct

from allworlds.document.report import Report
from allworlds.document.struct import Text, about
from allworlds.engines.effort import AskedPatience
from allworlds.engines.single import SingleRun, single_run, subject_of, unused_choice
from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.explorers.loading import HASH_SEED, built_in
from allworlds.inputs.checks import InputError, an_integer, show
from allworlds.inputs.requests import RULES, Option, Taken, answers
from allworlds.judging.episode import Log, followed
from allworlds.judging.findings.rules import AskedRules
from allworlds.judging.findings.walks import true_trail
from allworlds.judging.laws.invariants import BrokenInvariant, embed
from allworlds.maps.combinatorial import Dart
from allworlds.protocol.actions import Action, Percept
from allworlds.protocol.answers import Checkpoint
from allworlds.protocol.choices import Choices, Kind
from allworlds.protocol.player import Told
from allworlds.protocol.playing import play_run
from allworlds.world.lighthouses.kinds import kind_of
from allworlds.world.named import AskedWorld
from allworlds.world.world import World


def index_list(text: str) -> tuple[int, ...]:
    """The indices of a text, integers from 0 on with commas between."""
    if not re.fullmatch(r"[0-9]{1,9}(,[0-9]{1,9})*", text):
        raise InputError(f"choices {show(text)} are not indices from 0 on with commas")
    return tuple(int(part) for part in text.split(","))


def _indices(choices: object) -> tuple[int, ...]:
    if isinstance(choices, str) or not isinstance(choices, Iterable):
        raise InputError(f"choices = {show(choices)} is not a list of indices")
    return tuple(an_integer(f"choices[{i}]", index) for i, index in enumerate(choices))


class AskedRun(AskedPatience, AskedRules, AskedWorld):
    """Options for one run: the world, how it is played and judged."""

    choices: Annotated[
        Taken[Sequence[int], tuple[int, ...]],
        Option(
            RULES,
            "I,I,...",
            "Answers to the first choices, by index; then the policy goes on.",
            parse=index_list,
        ),
    ] = Taken(_indices, ())


class RunRequest(AskedRun, kw_only=False):
    """Request of ``run``: an explorer, a world and the rules."""

    explore: Annotated[str | Callable[..., Any], "a name or a generator function"]
    world: Annotated[
        World | str | None,
        "map, lighthouse and start; or what :func:`allworlds.world.named.world_named` reads; None: "
        "the one of ``family``",
    ] = None


class WorldNames(Report):
    """Report of 'run --list'.

    The names that a WORLD can have; a capital letter stands for a number.
    """

    maps: Annotated[tuple[Text, ...], about("small maps")]
    families: Annotated[tuple[Text, ...], about("families of maps, small or large")]
    corpus: Annotated[tuple[Text, ...], about("worlds of the corpus")]


@answers(RunRequest)
def run(request: RunRequest) -> SingleRun:
    """Run an explorer once, and judge the run.

    A user's explorer that another process can import is played in a process of its own, as in a
    check; any other one in this process. Its hash seed is the one in the environment variable
    ``PYTHONHASHSEED``, if it is set.

    Raises:
        InputError: naming the offending option and what would be legal, or the first choice
            that was not taken.
    """
    limits = request.patience
    subject = subject_of(request.explore, limits)
    world = request.meant(request.world, subject.lighthouse)
    rules = request.rules_of(subject, kind_of(world.lighthouse))
    played = single_run(subject, world, rules, request.choices, limits, _asked_hash_seed())
    if unused := unused_choice(request.choices, played):
        raise InputError(unused)
    return played


def _asked_hash_seed() -> int | None:
    """The hash seed that the environment names; None if it names none."""
    seed = os.environ.get(HASH_SEED, "")
    return int(seed) if re.fullmatch("[0-9]{1,9}", seed) else None


# ---------------------------------------------------------------- hypotheses

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
    around = _Replayed(world.told, episode.transcript.percepts)
    heard = _Heard(around, run.outcome.choices)
    explore, keywords = BUILT_IN[run.explorer].explore, built_in(run.explorer).keywords

    def player(first: Percept, choices: Choices, told: Told) -> Generator[Any, Any, Any]:
        tells = {"told": told} if "told" in keywords else {}
        listened: Generator[Any, Any, Any]
        listened = explore(first, choices=choices, notice=heard.notice, **tells)
        return listened

    budget = episode.transcript.cost
    log = Log.of(play_run(around, player, heard, budget, [0, 0]))
    again = followed(log, world, budget)
    if (again.transcript, again.checkpoints) != (episode.transcript, episode.checkpoints):
        return ()
    trail = true_trail(world, episode.transcript)
    tests = [_test(world, trail, episode.checkpoints, one) for one in heard.tests]
    return tuple(test for test in tests if test)


class _Replayed:
    """The surroundings of a replay: it returns the recorded percepts and counts the steps."""

    over = False

    def __init__(self, told: Told, percepts: Sequence[Percept]) -> None:
        self.told, self.first, self._percepts = told, percepts[0], percepts
        self.steps = 0

    def move(self, _k: int) -> Percept:
        self.steps += 1
        return self._percepts[self.steps]

    def act(self, _action: Action) -> Percept:
        return self.move(0)


class _Taken(Struct):
    """A hypothesis as observed: the steps at arrival, and at the start and end of its test."""

    dart: Dart
    arrived: int
    first: int
    last: int = -1
    right: bool = False


class _Heard(Choices):
    """A listener that answers with the recorded choices and records the tests."""

    def __init__(self, around: _Replayed, script: Sequence[int]) -> None:
        super().__init__(script=script)
        self._around, self._arrived = around, -1
        self.tests: list[_Taken] = []

    def pick(self, options: Sequence[T], of: Kind, cost: Sequence[int] | None = None) -> T:
        picked = super().pick(options, of, cost)
        steps = self._around.steps
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
            test.last, test.right = self._around.steps, DECIDED[event]


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
) -> Sequence[Dart] | None:
    """The dart of the world for each dart that S has at a step; at first it has those of v0."""
    shown = [(at, checkpoint) for at, checkpoint in checkpoints if at < step]
    if not shown:
        return [world.map.turn(world.start, k) for k in range(world.map.degree_at[world.start])]
    at, checkpoint = shown[-1]
    place = embed(world.map, trail[at], checkpoint)
    return None if isinstance(place, BrokenInvariant) else place
