"""The events of a run: who was activated, what each sensed and did, and what the adversary did."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

from allworlds.protocol.actions import IllegalAction
from allworlds.protocol.turns import Sensed
from allworlds.robots.graph import Broken, GraphStep
from allworlds.robots.minds import Ended, ProgramFault

if TYPE_CHECKING:
    from allworlds.robots.configurations import Search


class Turn(NamedTuple):
    """The part of one robot in an event.

    Attributes:
        robot: its number.
        sensed: what it sensed; None if it only moves now, by what it sensed before.
        did: the action that is done, or due; the end of its program, or the fault.
        later: whether the action is done in a later event.
    """

    robot: int
    sensed: Sensed | None
    did: Any
    later: bool = False

    @property
    def phase(self) -> str:
        """``L`` for a look whose move comes later, ``M`` for that move, else empty."""
        return "L" if self.later else "M" if self.sensed is None else ""


class Event(NamedTuple):
    """One step of a set of robots at once.

    Attributes:
        turns: of each robot that is activated.
        adversary: the index of what the adversary does, among what the model yields.
        world: the same in words; may be empty.
        choices: the number of what it could do.
        state: the state after it; of a step that is illegal that before it.
    """

    turns: tuple[Turn, ...]
    adversary: int
    world: str
    choices: int
    state: Any

    @property
    def written(self) -> str:
        """The event as a schedule has it: ``0L``, ``0M+1L``, ``0+1:2``."""
        who = "+".join(f"{turn.robot}{turn.phase}" for turn in self.turns) or "-"
        return f"{who}:{self.adversary}" if self.choices > 1 else who


def event_of(search: Search, step: GraphStep) -> Event:
    """The event of a step; nothing is asked of a program."""
    state, minds, _ = search.configuration(step.before)
    group = [robot for robot in range(len(search.team)) if step.group >> robot & 1]
    turns, acts, due = [], dict[int, Any](), dict[int, Any]()
    for robot in group:
        moves = minds[robot] < 0
        sensed = None if moves else search.percept(step.before, robot)
        mind = ~minds[robot]
        if sensed is not None:
            mind = search.minds.settled(search.minds.look(minds[robot], sensed))
        value = search.minds.value[mind]
        acting = search.acts(value)
        later = acting and search.time.scheduler == "async" and not moves
        turns.append(Turn(robot, sensed, value, later))
        if acting:
            (due if later else acts)[robot] = value
    if any(type(turn.did) is ProgramFault for turn in turns):
        return Event(tuple(turns), 0, "", 1, state)
    try:
        following = search.following(state, acts, due)
    except IllegalAction:
        return Event(tuple(turns), 0, "", 1, state)
    after, words = following[step.adversary]
    return Event(tuple(turns), step.adversary, words, len(following), after)


def events_of(search: Search, broken: Broken) -> Iterator[Event]:
    """The events of the run that breaks a law, those of its cycle once, at the end."""
    for number in search.way(broken.at)[1:]:
        yield event_of(search, search.graph.came(number))
    if broken.group:
        bits = sum(1 << robot for robot in broken.group)
        yield event_of(search, GraphStep(broken.at, bits, 0))
    at = broken.at
    for step in broken.cycle:
        yield event_of(search, search.graph.step(at, step))
        at = search.graph.to(step)


def answers_of(search: Search, number: int) -> list[Any]:
    """The answer of each robot in a configuration; None of one that has not ended."""
    _, minds, _ = search.configuration(number)
    values = [search.minds.value[max(mind, ~mind)] for mind in minds]
    return [value.answer if type(value) is Ended else None for value in values]
