"""One episode: metered, budgeted and recorded; every fault of the explorer becomes a value."""

from __future__ import annotations

import traceback
from collections.abc import Callable, Generator, Iterable, MutableSequence
from pathlib import Path
from typing import Any, NamedTuple, Protocol, TypeAlias

from msgspec import Struct, field

from allworlds.inputs import SHOWN, InputError, integer, let_users_interrupt, show
from allworlds.judging.endings import (
    AN_ESTIMATE,
    BUILT,
    MOST_DARTS,
    NO_MAP,
    Ending,
    Fault,
    Over,
    TooManyDarts,
    UncheckedEnding,
    answered,
    ending_of,
    integers,
)
from allworlds.maps import InvalidMap
from allworlds.protocol import (
    Action,
    Checkpoint,
    Choices,
    Drop,
    ExplorerFault,
    Move,
    Percept,
    Pick,
    Player,
    Told,
    Transcript,
    Write,
    action_numbered,
    number_of,
)
from allworlds.world import IllegalAction


class Environment(Protocol):
    """The environment of an explorer: a world, or recorded percepts in place of one."""

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


EndingOf: TypeAlias = Callable[[object, int], UncheckedEnding]
"""Makes an ending of what an explorer returns, with so many darts at most."""

Shown: TypeAlias = tuple[int, tuple[int, ...], tuple[int, ...], int]
"""A checkpoint: the number of actions before it, sigma, alpha, and here."""


class Log(NamedTuple):
    """The explorer's side of one run, without the world.

    Attributes:
        actions: as numbers (see :func:`allworlds.protocol.actions.number_of`).
        checkpoints: the published S and U.
        ending: the answer, or the fault.
        choices: the index taken at each choice.
        widths: the number of options at each choice, if every schedule is tried; else empty.
    """

    actions: tuple[int, ...]
    checkpoints: tuple[Shown, ...]
    ending: UncheckedEnding
    choices: tuple[int, ...] = ()
    widths: tuple[int, ...] = ()


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


ADAPTERS_LAWS = ("crash", "timeout", "illegal-action", "no-estimate")
FREE = 10
"""The drops and picks that are legal for each traversal of the budget, and as many more: they are
free, and without a limit an explorer could go on so for ever."""

LONGEST = 20_000
"""The number of characters that are kept of a traceback."""

_OF_MAPS = str(Path(__file__).parents[1] / "maps")
"""The folder of the code that raises InvalidMap; the explorer's own line is outside."""

_ANSWER = "an action, or an estimate at the end"


def default_step_budget(bound: int) -> int:
    """The traversals after which a run is stopped: 8 x ((1) + (2)) + 100."""
    return 8 * bound + 100


def own_copy(percept: Percept) -> Percept:
    """A copy of a percept for the explorer alone: those of world and log are shared."""
    return Percept(percept.degree, percept.marks, percept.bearing)


def told_copy(told: Told) -> Told:
    """A copy of the value that is told, for the explorer alone."""
    return told if told is None or isinstance(told, int) else dict(told)


def the_same(percept: Percept) -> Percept:
    """The percept itself, for an explorer that is known not to change it."""
    return percept


def play(
    world: Environment,
    player: Player,
    choices: Choices,
    budget: int,
    beat: MutableSequence[int] | None = None,
    hand: Callable[[Percept], Percept] = own_copy,
    ended: EndingOf = ending_of,
) -> Episode:
    """Run one explorer in one world to its end.

    Args:
        world: is not changed and not shown.
        player: the explorer.
        choices: given to an explorer that takes choices.
        budget: the largest legal number of traversals; one checkpoint more is legal.
        beat: ``beat[1]`` grows at each turn of the explorer and is 0 when it has ended, so
            that someone else can see a silent explorer.
        hand: makes the percept that the explorer gets; a copy costs some 3 % of a run.
        ended: what is made of what the explorer returns.

    Cost: linear in the steps, besides the explorer's own.
    """
    run = _Run(world, budget, beat if beat is not None else [0, 0], hand, ended)
    ending = answered(run.play(player, choices))
    return Episode(Transcript(world.first, tuple(run.steps)), _published(run.checkpoints), ending)


def perform(
    world: Environment,
    player: Player,
    choices: Choices,
    budget: int,
    beat: MutableSequence[int] | None = None,
    hand: Callable[[Percept], Percept] = own_copy,
    ended: EndingOf = ending_of,
) -> Log:
    """Run as :func:`play` does, and return a log that says nothing of the world."""
    run = _Run(world, budget, beat if beat is not None else [0, 0], hand, ended)
    ending = run.play(player, choices)
    actions = tuple(
        [action.k if type(action) is Move else number_of(action) for action, _ in run.steps]
    )
    shown = tuple(run.checkpoints)
    return Log(actions, shown, ending, tuple(choices.record), tuple(choices.widths))


def retold(log: Log, world: Environment) -> Episode:
    """The log of a run in this world as an episode: walked anew, and its answer checked.

    Raises:
        IllegalAction: if it is no log of this world.
    """
    state, steps = world.initial, []
    for number in log.actions:
        action = action_numbered(number)
        state, percept = world.step(state, action)
        steps.append((action, percept))
    transcript = Transcript(world.first, tuple(steps))
    return Episode(transcript, _published(log.checkpoints), answered(log.ending))


def _published(shown: Iterable[Shown]) -> tuple[tuple[int, Checkpoint], ...]:
    return tuple([(steps, Checkpoint(sigma, alpha, here)) for steps, sigma, alpha, here in shown])


class _Run(Struct):
    world: Environment
    budget: int
    beat: MutableSequence[int]
    hand: Callable[[Percept], Percept]
    ended: EndingOf
    steps: list[tuple[Action, Percept]] = field(default_factory=list)
    checkpoints: list[Shown] = field(default_factory=list)
    cost: int = 0
    degree: int = 0
    broken: InputError | None = None

    def play(self, player: Player, choices: Choices) -> UncheckedEnding:
        world, beat = self.world, self.beat
        state, told = world.initial, told_copy(world.told)
        self.degree = world.first.degree
        reply: Percept | None = None
        ticks = 1
        beat[1] = ticks
        generator = None
        try:
            generator = player(self.hand(world.first), choices, told)
            while not self._over():
                message = generator.send(reply)
                ticks += 1
                beat[1] = ticks
                if type(message) is Checkpoint:
                    fault, reply = self._publish(message), None
                else:
                    fault, state, reply = self._act(state, message)
                if fault:
                    return fault
            return Over()
        except StopIteration as stop:
            return self.ended(stop.value, self._most_darts())
        except BaseException as error:
            if error is self.broken:  # of a model of the user's, and no fault of the explorer's
                raise
            return _raised(error)
        finally:
            closed(generator)
            beat[1] = 0

    def _over(self) -> bool:
        try:
            return self.world.over
        except InputError as error:
            self.broken = error
            raise

    def _most_darts(self) -> int:
        """The largest number of darts of a map that can be known within the budget, or checked."""
        return max(MOST_DARTS, 2 * self.budget)

    def _publish(self, message: Checkpoint) -> Fault | None:
        if len(self.checkpoints) > self.budget:
            return Fault(
                "budget",
                f"at most {self.budget + 1} checkpoints",
                f"checkpoint {len(self.checkpoints) + 1}",
            )
        try:
            most = self._most_darts()
            sigma, alpha = integers(message.sigma, most), integers(message.alpha, most)
            here = integer(message.here)
        except TooManyDarts as error:
            return Fault("illegal-action", "a checkpoint of what has been walked along", str(error))
        except BaseException as error:  # noqa: BLE001  # the parts are the explorer's code
            let_users_interrupt(error)
            return Fault(
                "illegal-action",
                "a checkpoint of two sequences of integers and an integer",
                show(message),
            )
        self.checkpoints.append((len(self.steps), sigma, alpha, here))
        return None

    def _act(self, state: Any, message: object) -> tuple[Fault | None, Any, Percept | None]:
        action = _action(message, self.degree)
        if isinstance(action, Fault):
            return action, state, None
        if type(action) is Move:
            if self.cost == self.budget:
                fault = Fault(
                    "budget",
                    f"{'an estimate' if self.ended is ending_of else 'an answer'} within "
                    f"{self.budget} traversals",
                    f"traversal {self.cost + 1}",
                )
                return fault, state, None
            self.cost += 1
        elif len(self.steps) - self.cost == FREE * (self.budget + 1):
            free = "numbers written" if type(action) is Write else "markers dropped and picked up"
            fault = Fault(
                "budget",
                f"at most {FREE * (self.budget + 1)} {free}",
                f"{show(message)} as number {FREE * (self.budget + 1) + 1}",
            )
            return fault, state, None
        try:
            state, percept = self.world.step(state, action)
        except IllegalAction as error:
            return Fault("illegal-action", str(error), show(message)), state, None
        except InputError as error:
            self.broken = error
            raise
        self.steps.append((action, percept))
        self.degree = percept.degree
        return None, state, self.hand(percept)


def _action(message: object, degree: int) -> Action | Fault:
    if type(message) is Move:
        try:
            k = message.k
            if type(k) is not int:
                k = integer(k)
        except BaseException as error:  # noqa: BLE001  # __index__ is the explorer's code
            let_users_interrupt(error)
            return Fault("illegal-action", "Move(k) with an integer k", show(message))
        return action_numbered(k % degree)
    if type(message) is Drop or type(message) is Pick:
        return message
    if type(message) is Write:
        try:
            number = integer(message.k)
        except BaseException as error:  # noqa: BLE001  # as above
            let_users_interrupt(error)
            return Fault("illegal-action", "Write(k) with an integer k", show(message))
        if number >= 0:
            return Write(number)
        return Fault("illegal-action", "Write(k) with k from 0 on", show(message))
    return Fault("illegal-action", "a Move, Drop, Pick, Write or Checkpoint", show(message))


def _raised(error: BaseException) -> Fault:
    let_users_interrupt(error)
    if type(error) is ExplorerFault and error.law in ADAPTERS_LAWS:
        return Fault(error.law, _ANSWER, error.seen, error.detail, error.machine)
    name = type(error).__name__
    try:
        if isinstance(error, InvalidMap):
            return _no_map(error)
        frames = error.__traceback__.tb_next if error.__traceback__ else None
        message = str.__str__(str(error))[:SHOWN]
        detail = "".join(traceback.format_exception(type(error), error, frames))
    except BaseException as another:  # noqa: BLE001  # an exception may not even be printable
        let_users_interrupt(another)
        return Fault("crash", _ANSWER, f"{name}, which cannot be shown")
    seen = f"{name}: {message}" if message else name
    return Fault("crash", _ANSWER, seen, detail[-LONGEST:], isinstance(error, MemoryError))


def _no_map(error: InvalidMap) -> Fault:
    """The fault of an explorer that raised InvalidMap while it built its answer."""
    built = [
        f"{BUILT}in {frame.filename}, line {frame.lineno}, in {frame.name}: {frame.line}"
        for frame in traceback.extract_tb(error.__traceback__)[1:]
        if not frame.filename.startswith(_OF_MAPS)
    ]
    detail = "\n\n".join(filter(None, (error.tried, *built[-1:])))
    return Fault(
        "no-estimate", AN_ESTIMATE, f"{NO_MAP}{str.__str__(str(error))[:SHOWN]}", detail[:LONGEST]
    )


def closed(generator: Generator[Any, Any, Any] | None) -> None:
    """Close the generator, and ignore every exception that it raises then."""
    try:
        if generator is not None:
            generator.close()
    except BaseException as error:  # noqa: BLE001  # the run has been decided all the same
        let_users_interrupt(error)
