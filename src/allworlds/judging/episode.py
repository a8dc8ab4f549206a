"""Episodes: an *episode* is the log of a run, followed through the world, with the run's ending.

The log holds only the explorer's messages.  All percepts come from the world; none is taken from a
player.
"""

import json
from collections.abc import Callable, MutableSequence
from typing import Any, TypeAlias

from msgspec import Struct

from allworlds import log as entries
from allworlds.inputs.checks import show
from allworlds.judging.walk import Walk
from allworlds.log import Log
from allworlds.maps.combinatorial import CombinatorialMap, InvalidMap, numbering
from allworlds.protocol import actions, playing
from allworlds.protocol.choices import Choices
from allworlds.world.world import World

RECORD_ENDS = "nothing: the record ends here"
"""The words in findings for the legal actions after the last recorded percept: there are none."""


class Answered(Struct, frozen=True):
    """The explorer has returned a well-formed answer.

    Attributes:
        answer: an estimate; a rooted quotient with valid permutations and ``here`` among the darts;
            or, if the task allows any answer, a JSON value.
    """

    answer: Any


class Over(Struct, frozen=True):
    """The run ended because its task was done."""


class Fault(Struct, frozen=True):
    """The run ended without an answer.

    Attributes:
        law: ``crash``, ``timeout``, ``illegal-action``, ``no-estimate`` or ``budget``.
        expected, seen: the legal behaviour, and the explorer's behaviour, each in words.
        detail: a traceback, or the tail of a program's stderr; may be empty.
        machine: whether the machine, not the explorer, may be the cause, for example if a signal
            ended the process, after a time-out, or for lack of memory.
    """

    law: str
    expected: str
    seen: str
    detail: str = ""
    machine: bool = False


EpisodeEnding: TypeAlias = Answered | Over | Fault


class Episode(Struct, frozen=True):
    """The log of one run in its world.

    Attributes:
        walk: the robot's walk in the world.
        checkpoints: the checkpoints, each with the number of steps before it.
        ending: the answer, the end of a task that was done, or the fault.
    """

    walk: Walk
    checkpoints: tuple[tuple[int, actions.Checkpoint], ...]
    ending: EpisodeEnding

    @property
    def transcript(self) -> actions.Transcript:
        """The actions and percepts of the log, without the world."""
        return self.walk.transcript


class AroundExplorer:
    """The surroundings of an explorer in one run: the world, and the robot's walk in it so far.

    The surroundings answer each action with a copy of the percept, which is all that the explorer
    gets.

    Args:
        world: the world.  An action adds a step to the walk, and does not change the world.
        over: the function that tells after each step whether the task is done, so that the run
            ends; None if the run never ends because of the task.
    """

    def __init__(self, world: World, over: Callable[[Walk], bool] | None = None) -> None:
        self._walk, self._over, self.told = Walk.begin(world), over, world.told
        self.first = _copy(world.first)

    @property
    def over(self) -> bool:
        """Whether the run ends here, because its task is done."""
        return self._over is not None and self._over(self._walk)

    def move(self, k: int) -> actions.Percept:
        """Make a motion ``k``, which is below the degree; return the percept after it."""
        return self.act(actions.action_numbered(k))

    def act(self, action: actions.Action) -> actions.Percept:
        """Perform an action, and return the percept after it.

        Raises:
            IllegalAction: if the action is illegal now.
        """
        return _copy(self._walk.step(action))


def _copy(percept: actions.Percept) -> actions.Percept:
    return actions.Percept(percept.degree, percept.marks, percept.bearing)


def play(
    world: World,
    player: actions.Player,
    choices: Choices,
    budget: int,
    beat: MutableSequence[int] | None = None,
    *,
    maps: bool = True,
    over: Callable[[Walk], bool] | None = None,
) -> Episode:
    """Play one run of an explorer in a world to its end, in this process.

    Args:
        world: the world; the run does not change it, and the explorer does not see it.
        player: the explorer.
        choices: the object that makes the choices, for an explorer that takes choices.
        budget: the largest legal number of traversals of the run.  In the whole run ``budget + 1``
            checkpoints are legal.
        beat: two numbers that another process reads; if they stay the same for too long, the
            explorer is silent.  ``beat[0]``, the number of the run, is not changed here.
            ``beat[1]`` is 1 at the start of the run, grows by 1 with each message of the explorer,
            and is 0 after the end of the run.  None: no process reads them.
        maps: whether the task asks for a map; else any answer is allowed.
        over: the function that tells whether the task is done, so that the run ends; None if the
            run never ends because of the task.

    Cost: linear in the steps, and the explorer's own cost.
    """
    beat = [0, 0] if beat is None else beat
    log = playing.play_run(
        AroundExplorer(world, over), player, choices, budget, beat, any_answer=not maps
    )
    return followed(Log(log), world, budget, maps=maps)


def followed(log: Log, world: World, budget: int, *, maps: bool = True) -> Episode:
    """The episode of a log: the log's actions, followed in this world, and its ending.

    Args:
        log: the log.
        world: the world.
        budget: the largest legal number of traversals in the run; only named in faults.
        maps: whether the task asks for a map; only important for the words of a fault.

    Raises:
        IllegalAction: if the log goes on after an action that is illegal in this world.

    Cost: linear in the steps.
    """
    walk, numbers = Walk.begin(world), log.actions
    too_often = log.ending[:1] == (entries.FREE_TOO_OFTEN,)
    if too_often:
        numbers = numbers[:-1]  # the last checkpoint was one too many
    refused: Fault | None = None
    for number in numbers:
        if refused:
            raise actions.IllegalAction(refused.expected)
        action = actions.action_numbered(number)
        try:
            walk.step(action)
        except actions.IllegalAction as error:
            refused = Fault("illegal-action", str(error), show(action))
    if refused and too_often:
        raise actions.IllegalAction(refused.expected)
    ending = refused or ending_of(log, budget, maps=maps)
    shown = tuple(
        [(at, actions.Checkpoint(sigma, alpha, here)) for at, sigma, alpha, here in log.checkpoints]
    )
    return Episode(walk, shown, ending)


def fault_of(log: Log, budget: int = 0, *, maps: bool = True) -> Fault | None:
    """The fault with which a log ends; None if the log ends with an answer, or with a done task.

    ``budget``, the largest legal number of traversals, and ``maps``, whether the task asks for a
    map, only change the words of the fault; whoever reads just its law may leave them out.
    """
    code, *parts = log.ending
    match code:
        case entries.FAULT:
            return Fault(*parts)
        case entries.OVER_BUDGET:
            what = "an estimate" if maps else "an answer"
            cost = sum(number >= 0 for number in log.actions)
            return Fault("budget", f"{what} within {budget} traversals", f"traversal {cost + 1}")
        case entries.SHOWN_TOO_OFTEN:
            count = len(log.checkpoints)
            return Fault("budget", f"at most {budget + 1} checkpoints", f"checkpoint {count + 1}")
        case entries.REFUSED | entries.BEYOND | entries.FREE_TOO_OFTEN:
            action = actions.action_numbered(log.actions[-1])
        case _:
            return None
    if code != entries.FREE_TOO_OFTEN:
        # A play by percepts does not know why the action is refused.
        legal = RECORD_ENDS if code == entries.BEYOND else "a legal action"
        return Fault("illegal-action", legal, show(action))
    free = "numbers written" if type(action) is actions.Write else "markers dropped and picked up"
    most = playing.FREE * (budget + 1)
    return Fault("budget", f"at most {most} {free}", f"{show(action)} as number {most + 1}")


def ending_of(log: Log, budget: int = 0, *, maps: bool = True) -> EpisodeEnding:
    """The ending of a log: an answer, a done task, or a fault, such as a malformed answer.

    ``budget``, the largest legal number of traversals, and ``maps``, whether the task asks for a
    map, only change the words of a fault, see :func:`fault_of`.
    """
    code, *parts = log.ending
    match code:
        case entries.ANSWERED | entries.LONG_ANSWER:
            return _estimate(*parts)
        case entries.QUOTIENT:
            quotient = actions.Ambiguous(*parts)
            flaw = _flaw(quotient)
            return Fault("no-estimate", playing.A_QUOTIENT, flaw) if flaw else Answered(quotient)
        case entries.VALUE:
            (text,) = parts
            try:
                return Answered(json.loads(text))
            except (ValueError, RecursionError):
                return Fault("no-estimate", playing.A_VALUE, show(text))
    return fault_of(log, budget, maps=maps) or Over()


def _estimate(sigma: tuple[int, ...], alpha: tuple[int, ...], here: int) -> Answered | Fault:
    try:
        map_ = CombinatorialMap(sigma, alpha)
    except InvalidMap as error:
        return Fault("no-estimate", playing.AN_ESTIMATE, f"{playing.NO_MAP}{error}", error.tried)
    if here not in map_.darts:
        last = len(map_.sigma) - 1
        return Fault(
            "no-estimate", playing.AN_ESTIMATE, f"here = {show(here)}, but the darts are 0..{last}"
        )
    return Answered(actions.Estimate(map_, here))


def _flaw(said: actions.Ambiguous) -> str:
    """The reason why the answer ``said`` is no rooted quotient; empty if it is one."""
    size = len(said.sigma)
    for name, values in (("alpha", said.alpha), ("degree", said.degree), ("marks", said.marks)):
        if len(values) != size:
            return f"{name} has {len(values)} entries, and sigma {size}"
    for name, values in (("degree", said.degree), ("marks", said.marks)):
        for value in values:
            if value.bit_length() > 63:
                return f"{name} holds {show(value)}, which is sensed nowhere"
    if said.here not in range(size):
        return f"here = {show(said.here)}, but the darts are 0..{size - 1}"
    for name, values in (("sigma", said.sigma), ("alpha", said.alpha)):
        if sorted(values) != list(range(size)):
            return f"{name} = {show(list(values))} is no permutation of 0..{size - 1}"
    if any(said.alpha[other] != dart for dart, other in enumerate(said.alpha)):
        return f"alpha = {show(list(said.alpha))} is no involution"
    reached = len(numbering(said.sigma, said.alpha, said.here))
    return "" if reached == size else f"only {reached} of {size} darts are reached from here"
