"""A player's plays in worlds: runs of a unit, and one run that is sent step by step.

A second player needs none of it.  It is loaded before the explorer is, by the process that forks
the player: an explorer may break what loads modules.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from typing import TypeVar

from allworlds.engines.isolation.jobs import PlayRuns, Trace
from allworlds.engines.isolation.messages import Message, RecordLogs, RunLogs, TraceEvent
from allworlds.engines.python.examiner import name_run
from allworlds.engines.python.play import ExplorerRunner, ending_maker
from allworlds.engines.python.world_runner import WorldRunner
from allworlds.judging import Environment, Log, perform
from allworlds.protocol import Action, Choices, Kind, Percept, Schedules, number_of
from allworlds.world import State

T = TypeVar("T")

CHUNK, CHUNK_SECONDS = 64, 0.1
"""The number of logs, or of seconds, after which logs are sent."""


def load() -> None:
    """Load this module, and with it all that plays in worlds need."""


class WorldPlayer:
    """A player's plays in worlds.

    Args:
        runner: plays the explorer.
        send: sends a message to the owner.
    """

    def __init__(self, runner: ExplorerRunner, send: Callable[[Message], None]) -> None:
        self._runner, self._send = runner, send
        self._in_worlds = WorldRunner(runner)

    def play_runs(self, job: PlayRuns) -> None:
        """Play runs of a unit, and send their logs, some at a time."""
        logs: list[tuple[int, Log]] = []
        finished: list[int] = []
        due = time.monotonic() + CHUNK_SECONDS
        for number, log in self._in_worlds.play_runs(
            job.engine, job.unit, job.numbers, job.order, job.script
        ):
            if log is None:
                finished.append(number)
            # Never between the last log of a run and its end: it would be played again.
            if logs and (len(logs) >= CHUNK or time.monotonic() > due):
                self._send(RunLogs(logs, finished))
                logs, finished = [], []
                due = time.monotonic() + CHUNK_SECONDS
            if log is not None:
                logs.append((number, log))
        if logs or finished:
            self._send(RunLogs(logs, finished))

    def trace(self, job: Trace) -> None:
        """Play one world, and send each step at once."""
        rules = job.rules
        name = name_run(rules, job.world)
        every = job.schedules == "all"
        for choices in Schedules() if every else [rules.choices(name, job.script)]:
            self._send(TraceEvent(None))
            world: Environment = rules.task.environment(job.world)
            log = perform(
                TracedWorld(world, self._send),
                self._runner.player,
                TracedChoices(choices, self._send),
                rules.budget(job.world.map),
                self._runner.beat,
                ended=ending_maker(any_answer=not rules.task.is_map),
            )
            self._runner.intact()
        self._send(RecordLogs([log]))


class TracedWorld:
    """A world that reports each step before the explorer sees its outcome."""

    def __init__(self, world: Environment, send: Callable[[Message], None]) -> None:
        self._world, self._send = world, send
        self.initial, self.first, self.told = world.initial, world.first, world.told

    @property
    def over(self) -> bool:
        """Whether the world ends the run."""
        return self._world.over

    def step(self, state: State, action: Action) -> tuple[State, Percept]:
        """Step the world, and report the step to the owner."""
        after, percept = self._world.step(state, action)
        self._send(TraceEvent((number_of(action), percept)))
        return after, percept


class TracedChoices(Choices):
    """Choices that report each pick."""

    def __init__(self, choices: Choices, send: Callable[[Message], None]) -> None:
        super().__init__()
        self._choices, self._send = choices, send
        self.record = choices.record

    def pick(self, options: Sequence[T], of: Kind, cost: Sequence[int] | None = None) -> T:
        """Pick one of the options, and report the choice to the owner."""
        picked = self._choices.pick(options, of, cost)
        self._send(TraceEvent(self.record[-1]))
        return picked
