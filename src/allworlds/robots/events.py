"""The events of a run: the activated robots, their percepts and actions, the adversary's choice."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

from allworlds.protocol.actions import IllegalAction
from allworlds.protocol.turns import Sensed
from allworlds.robots.graph import Broken, Transition
from allworlds.robots.minds import ProgramFault

if TYPE_CHECKING:
    from allworlds.robots.configurations import Search


class Turn(NamedTuple):
    """A robot's turn in an event; or, if the turn takes two events, its Look or its Move.

    Attributes:
        robot: the number of the robot.
        sensed: the robot's percept; None if it looked in an earlier event and moves in this event.
        did: the robot's action, the end of its program, or the fault of its program.
        later: whether the action is done in a later event.
    """

    robot: int
    sensed: Sensed | None
    did: Any
    later: bool = False

    @property
    def phase(self) -> str:
        """The letter of the turn in a schedule; empty for a whole turn.

        ``L`` stands for a look whose move comes later, ``M`` for the move of an earlier look.
        """
        return "L" if self.later else "M" if self.sensed is None else ""


class Event(NamedTuple):
    """One step of some robots at once, with a choice of the adversary.

    Attributes:
        turns: the turns of the robots that are activated.
        adversary: the index of the adversary's choice, among the states that the model yields.
        world: the adversary's choice in words; may be empty.
        choices: the number of choices among which the adversary chooses.
        state: the state after the event; the state before the event, if an action is illegal or a
            program has a fault.
    """

    turns: tuple[Turn, ...]
    adversary: int
    world: str
    choices: int
    state: Any

    @property
    def written(self) -> str:
        """The event as it is written in a schedule, for example ``0M+1L`` or ``0+1:2``.

        Each activated robot is given by its number, then ``L`` for a look whose move comes later,
        ``M`` for the move of an earlier look, or no letter for a whole turn.  Between two robots
        stands ``+``; ``-`` stands for no robot.  Behind a colon is the index of the adversary's
        choice, if there are several choices.
        """
        who = "+".join(f"{turn.robot}{turn.phase}" for turn in self.turns) or "-"
        return f"{who}:{self.adversary}" if self.choices > 1 else who


def event_of(search: Search, transition: Transition) -> Event:
    """The event of a transition.

    The event is made from stored replies; no program is asked.
    """
    state, minds, _ = search.configuration(transition.before)
    group = [robot for robot in range(len(search.program_of)) if transition.bits >> robot & 1]
    turns, acts, due = [], dict[int, Any](), dict[int, Any]()
    for robot in group:
        moves = minds[robot] < 0
        sensed = None if moves else search.percept(transition.before, robot)
        mind = ~minds[robot]
        if sensed is not None:
            mind = search.minds.resolved(search.minds.look(minds[robot], sensed))
        value = search.minds.value[mind]
        acting = search.is_action(value)
        later = acting and search.timing.scheduler == "async" and not moves
        turns.append(Turn(robot, sensed, value, later))
        if acting:
            (due if later else acts)[robot] = value
    if any(type(turn.did) is ProgramFault for turn in turns):
        return Event(tuple(turns), 0, "", 1, state)
    try:
        following = search.following(state, acts, due)
    except IllegalAction:
        return Event(tuple(turns), 0, "", 1, state)
    after, words = following[transition.adversary]
    return Event(tuple(turns), transition.adversary, words, len(following), after)


def events_of(search: Search, broken: Broken) -> Iterator[Event]:
    """The events of the run in ``broken``; if the run ends in a cycle, this cycle comes once."""
    for number in search.way(broken.at)[1:]:
        yield event_of(search, search.graph.discovery(number))
    if broken.group:
        bits = sum(1 << robot for robot in broken.group)
        yield event_of(search, Transition(broken.at, bits, 0))
    at = broken.at
    for index in broken.cycle:
        yield event_of(search, search.graph.transition(at, index))
        at = search.graph.target(index)
