"""One episode: the log of a run, followed through its world; it trusts no percept of the player."""

from __future__ import annotations

from collections.abc import MutableSequence, Sequence
from typing import Any, NamedTuple, Protocol

from msgspec import Struct

from allworlds import log as entries
from allworlds.inputs.checks import show
from allworlds.judging.endings import (
    Ending,
    Fault,
    Over,
    UncheckedAmbiguous,
    UncheckedAnswer,
    UncheckedEnding,
    UncheckedValue,
    answered,
)
from allworlds.protocol.actions import Action, Percept, Write, action_numbered
from allworlds.protocol.answers import Checkpoint
from allworlds.protocol.choices import Choices
from allworlds.protocol.faults import IllegalAction
from allworlds.protocol.player import Player, Told
from allworlds.protocol.playing import FREE, play_run
from allworlds.protocol.transcript import Transcript

RECORD_ENDS = "nothing: the record ends here"
"""The expectation at the end of the recorded percepts of an explorer."""


class Environment(Protocol):
    """A world in which a log is followed: it may end the run."""

    @property
    def initial(self) -> Any:
        """The state at the start, of a type of the environment's own."""

    @property
    def first(self) -> Percept:
        """The percept before any motion."""

    @property
    def told(self) -> Told:
        """The value that the lighthouse tells before the start; None if there is none."""

    @property
    def over(self) -> bool:
        """Whether the task of the run is done, so that the run ends here."""

    def step(self, state: Any, action: Action) -> tuple[Any, Percept]:
        """Return the state after the action, and the percept there; may raise IllegalAction."""


class Log(NamedTuple):
    """The content of a log, before it is followed.

    Attributes:
        actions: as numbers (see :func:`allworlds.protocol.actions.number_of`).
        checkpoints: the published S and U: the number of actions before, sigma, alpha, and here.
        ending: the byte of its end, and what belongs to it.
        choices: the index taken at each choice.
        widths: the number of options at each choice; 0 where it is not known.
    """

    actions: Sequence[int]
    checkpoints: Sequence[tuple[int, tuple[int, ...], tuple[int, ...], int]]
    ending: tuple[Any, ...]
    choices: tuple[int, ...] = ()
    widths: tuple[int, ...] = ()

    @classmethod
    def of(cls, log: bytes) -> Log:
        """The content of a log in bytes.

        Raises:
            ValueError: if it is none.
        """
        read = entries.Read(log)
        return cls(read.actions, read.shown, read.end, tuple(read.choices), tuple(read.widths))


class Episode(Struct, frozen=True):
    """The log of one run in its world.

    Attributes:
        transcript: the log.
        checkpoints: each with the number of steps of the transcript before it.
        ending: the answer, or the fault.
    """

    transcript: Transcript
    checkpoints: tuple[tuple[int, Checkpoint], ...]
    ending: Ending


class AroundExplorer:
    """A world in which an explorer walks: it gets copies of the percepts.

    Args:
        world: is not changed and not shown.
    """

    def __init__(self, world: Environment) -> None:
        self._world, self._state, self.told = world, world.initial, world.told
        self.first = _copy(world.first)

    @property
    def over(self) -> bool:
        """Whether the task of the run is done."""
        return self._world.over

    def move(self, k: int) -> Percept:
        """The percept behind a motion."""
        return self.act(action_numbered(k))

    def act(self, action: Action) -> Percept:
        """The percept after an action; raises IllegalAction for one that is illegal."""
        self._state, percept = self._world.step(self._state, action)
        return _copy(percept)


def _copy(percept: Percept) -> Percept:
    return Percept(percept.degree, percept.marks, percept.bearing)


def play(
    world: Environment,
    player: Player,
    choices: Choices,
    budget: int,
    beat: MutableSequence[int] | None = None,
    *,
    maps: bool = True,
) -> Episode:
    """Run one explorer in one world to its end, in this process.

    Args:
        world: is not changed and not shown.
        player: the explorer.
        choices: given to an explorer that takes choices.
        budget: the largest legal number of traversals; one checkpoint more is legal.
        beat: see :func:`allworlds.protocol.playing.play_run`.
        maps: whether the task asks for a map.

    Cost: linear in the steps, besides the explorer's own.
    """
    beat = [0, 0] if beat is None else beat
    log = play_run(AroundExplorer(world), player, choices, budget, beat, any_answer=not maps)
    return followed(Log.of(log), world, budget, maps=maps)


def default_step_budget(bound: int) -> int:
    """The traversals after which a run is stopped: 8 x ((1) + (2)) + 100."""
    return 8 * bound + 100


def followed(log: Log, world: Environment, budget: int, *, maps: bool = True) -> Episode:
    """The episode of a log, walked in this world.

    Args:
        log: the log.
        world: the world.
        budget: the largest legal number of traversals.
        maps: whether the task asks for a map.

    Raises:
        IllegalAction: if the log goes on behind an action that is illegal here.

    Cost: linear in the steps.
    """
    state, steps, step = world.initial, list[tuple[Action, Percept]](), world.step
    refused: Fault | None = None
    for number in log.actions:
        if refused:
            raise IllegalAction(refused.expected)
        action = action_numbered(number)
        try:
            state, percept = step(state, action)
        except IllegalAction as error:
            refused = Fault("illegal-action", str(error), show(action))
            continue
        steps.append((action, percept))
    too_often = log.ending[:1] == (entries.FREE_TOO_OFTEN,)
    if too_often and refused is None:
        steps.pop()  # it was one too many
    known = None if too_often else refused
    ending = known or answered(_unchecked(log, budget, maps=maps))
    shown = tuple(
        [(at, Checkpoint(sigma, alpha, here)) for at, sigma, alpha, here in log.checkpoints]
    )
    return Episode(Transcript(world.first, tuple(steps)), shown, ending)


def _unchecked(log: Log, budget: int, *, maps: bool) -> UncheckedEnding:
    """The ending of a log, whose integers are not checked yet."""
    code, *parts = log.ending
    match code:
        case entries.REFUSED:  # as the world says; of a play against a record it is not known why
            return Fault("illegal-action", "a legal action", show(action_numbered(log.actions[-1])))
        case entries.ANSWERED | entries.LONG_ANSWER:
            return UncheckedAnswer(*parts)
        case entries.QUOTIENT:
            sigma, alpha, degree, marks, here = parts
            return UncheckedAmbiguous(sigma, alpha, here, degree, marks)
        case entries.VALUE:
            return UncheckedValue(*parts)
        case entries.OVER:
            return Over()
        case entries.FAULT:
            return Fault(*parts)
        case entries.BEYOND:
            last = show(action_numbered(log.actions[-1]))
            return Fault("illegal-action", RECORD_ENDS, last)
        case entries.OVER_BUDGET:
            what = "an estimate" if maps else "an answer"
            cost = sum(number >= 0 for number in log.actions)
            return Fault("budget", f"{what} within {budget} traversals", f"traversal {cost + 1}")
        case entries.SHOWN_TOO_OFTEN:
            count = len(log.checkpoints)
            return Fault("budget", f"at most {budget + 1} checkpoints", f"checkpoint {count + 1}")
    last_action = action_numbered(log.actions[-1])
    free = "numbers written" if type(last_action) is Write else "markers dropped and picked up"
    most = FREE * (budget + 1)
    return Fault("budget", f"at most {most} {free}", f"{show(last_action)} as number {most + 1}")


def unchecked(log: Log) -> UncheckedEnding:
    """How a log ends, as far as its world does not matter."""
    return _unchecked(log, 0, maps=True)
