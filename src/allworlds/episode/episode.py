"""One run: metered, budgeted and recorded; whatever the explorer does wrong becomes a value."""

from __future__ import annotations

import signal
import traceback
from collections.abc import Generator, MutableSequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any, Protocol, TypeAlias

from allworlds.maps.combinatorial import CombinatorialMap, Dart, InvalidMap, integer
from allworlds.protocol import (
    Action,
    Checkpoint,
    Choices,
    Drop,
    Estimate,
    ExplorerFault,
    Move,
    Percept,
    Pick,
    Transcript,
)
from allworlds.world import IllegalAction, World


class Player(Protocol):
    """An explorer ready to run: its optional keywords are already bound."""

    def __call__(
        self, first: Percept, choices: Choices, told: int | None
    ) -> Generator[Any, Any, Any]:
        """The generator of one run."""


@dataclass(frozen=True, slots=True)
class Answered:
    """The explorer has returned a well-formed estimate."""

    estimate: Estimate


@dataclass(frozen=True, slots=True)
class Fault:
    """The run ended without an answer.

    Attributes:
        law: ``crash``, ``timeout``, ``illegal-action``, ``no-estimate`` or ``budget``.
        expected, seen: a sentence each.
        detail: a traceback, or the tail of a program's stderr; may be empty.
    """

    law: str
    expected: str
    seen: str
    detail: str = ""


Ending: TypeAlias = Answered | Fault


@dataclass(frozen=True, slots=True)
class Episode:
    """What happened in one run.

    Attributes:
        transcript: the log.
        checkpoints: each with the number of steps of the transcript before it.
        ending: the answer, or what went wrong.
    """

    transcript: Transcript
    checkpoints: tuple[tuple[int, Checkpoint], ...]
    ending: Ending


_ANSWER = "an action, or an estimate at the end"
_MOVES = tuple(Move(k) for k in range(64))


def default_step_budget(bound: int) -> int:
    """The traversals after which a run is stopped: 8 x ((1) + (2)) + 100."""
    return 8 * bound + 100


def play(
    world: World,
    player: Player,
    choices: Choices,
    budget: int,
    beat: MutableSequence[int] | None = None,
) -> Episode:
    """Run one explorer in one world to its end.

    Args:
        world: is not changed and not shown.
        player: the explorer.
        choices: given to an explorer that takes choices.
        budget: the largest legal number of traversals, and of checkpoints.
        beat: ``beat[1]`` grows at each turn of the explorer and is 0 when it has ended, so
            that someone else can see a silent explorer.

    Cost: linear in the steps, besides the explorer's own.
    """
    run = _Run(world, budget, beat if beat is not None else [0, 0])
    ending = run.play(player, choices)
    return Episode(Transcript(world.first, tuple(run.steps)), tuple(run.checkpoints), ending)


@dataclass(slots=True)
class _Run:
    world: World
    budget: int
    beat: MutableSequence[int]
    steps: list[tuple[Action, Percept]] = field(default_factory=list)
    checkpoints: list[tuple[int, Checkpoint]] = field(default_factory=list)
    cost: int = 0

    def play(self, player: Player, choices: Choices) -> Ending:
        world, beat = self.world, self.beat
        state: Dart = world.start
        reply: Percept | None = None
        ticks = 1
        beat[1] = ticks
        try:
            generator = player(world.first, choices, world.told)
            while True:
                message = generator.send(reply)
                ticks += 1
                beat[1] = ticks
                if type(message) is Checkpoint:
                    fault, reply = self._publish(message), None
                else:
                    fault, state, reply = self._act(state, message)
                if fault:
                    _close(generator)
                    return fault
        except StopIteration as stop:
            return _answer(stop.value)
        except ExplorerFault as error:
            return Fault(error.law, _ANSWER, error.seen, error.detail)
        except KeyboardInterrupt as error:
            # Where interrupts are ignored (a worker) only the explorer can have raised it.
            if signal.getsignal(signal.SIGINT) is not signal.SIG_IGN:
                raise
            return _crash(error)
        except BaseException as error:  # noqa: BLE001  # an explorer may raise anything
            return _crash(error)
        finally:
            beat[1] = 0

    def _publish(self, message: Checkpoint) -> Fault | None:
        if len(self.checkpoints) > self.budget:
            return Fault(
                "budget",
                f"at most {self.budget + 1} checkpoints",
                f"checkpoint {len(self.checkpoints) + 1}",
            )
        try:
            sigma = tuple([integer(d) for d in message.sigma])
            alpha = tuple([integer(d) for d in message.alpha])
            here = integer(message.here)
        except Exception:  # noqa: BLE001  # the explorer's own sequences may raise anything
            return Fault(
                "illegal-action",
                "a checkpoint of two sequences of integers and an integer",
                describe(message),
            )
        self.checkpoints.append((len(self.steps), Checkpoint(sigma, alpha, here)))
        return None

    def _act(self, state: Dart, message: object) -> tuple[Fault | None, Dart, Percept | None]:
        action = _action(message, self.world.percepts[state].degree)
        if isinstance(action, Fault):
            return action, state, None
        if type(action) is Move:
            if self.cost == self.budget:
                fault = Fault(
                    "budget",
                    f"an estimate within {self.budget} traversals",
                    f"traversal {self.cost + 1}",
                )
                return fault, state, None
            self.cost += 1
        try:
            state, percept = self.world.step(state, action)
        except IllegalAction as error:
            return Fault("illegal-action", str(error), describe(message)), state, None
        self.steps.append((action, percept))
        return None, state, percept


def _action(message: object, degree: int) -> Action | Fault:
    if type(message) is Move:
        k = message.k
        if type(k) is not int:
            try:
                k = integer(k)
            except BaseException:  # noqa: BLE001  # __index__ is the explorer's code
                return Fault("illegal-action", "Move(k) with an integer k", describe(message))
        k %= degree
        return _MOVES[k] if k < len(_MOVES) else Move(k)
    if type(message) is Drop or type(message) is Pick:
        return message
    return Fault("illegal-action", "a Move, Drop, Pick or Checkpoint", describe(message))


def _answer(answer: object) -> Ending:
    expected = "Estimate(map, here) with a dart of the map"
    if type(answer) is not Estimate:
        return Fault("no-estimate", expected, describe(answer))
    answered: object = answer.map
    if not isinstance(answered, CombinatorialMap):
        return Fault("no-estimate", expected, f"a map that is {describe(answered)}")
    try:
        # Anew: what an explorer hands over may be a subclass, or have been tampered with.
        map_ = CombinatorialMap(answered.sigma, answered.alpha)
        here = integer(answer.here)
    except InvalidMap as error:
        return Fault("no-estimate", expected, f"no map: {error}")
    except Exception:  # noqa: BLE001  # as above
        return Fault("no-estimate", expected, f"here = {describe(answer.here)}")
    if here not in map_.darts:
        return Fault(
            "no-estimate", expected, f"here = {here}, but the darts are 0..{len(map_.sigma) - 1}"
        )
    return Answered(Estimate(map_, here))


def _crash(error: BaseException) -> Fault:
    frames = error.__traceback__.tb_next if error.__traceback__ else None
    lines = traceback.format_exception(type(error), error, frames)
    what = traceback.format_exception_only(type(error), error)[-1].strip()
    return Fault("crash", _ANSWER, what, "".join(lines))


def _close(generator: Generator[Any, Any, Any]) -> None:
    # The run has been decided; whatever the explorer does now, nobody asks any more.
    with suppress(BaseException):
        generator.close()


def describe(value: object) -> str:
    """A short text for any object, also for one whose repr fails."""
    try:
        text = repr(value)
    except BaseException:  # noqa: BLE001  # repr is the explorer's code
        text = f"an object of type {type(value).__name__} whose repr fails"
    return text if len(text) <= 200 else text[:197] + "..."
