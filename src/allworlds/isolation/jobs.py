"""What parent and worker say to each other: small frozen values."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from allworlds.episode import Answered, Fault
from allworlds.findings import Rules
from allworlds.protocol import Action, Percept, Transcript
from allworlds.runs import Examines, Schedule, Worlds
from allworlds.world import World

BEAT_WORDS = 2
"""The shared memory: the number of the current run, and the turns of the explorer in it."""

NO_RUN = (1 << 64) - 1
"""The number of the current run before the first."""


@dataclass(frozen=True, slots=True)
class Setup:
    """What a worker must know before its first job."""

    explorer: str
    answer_timeout: float
    memory: int | None


@dataclass(frozen=True, slots=True)
class UnitJob:
    """Examine a unit from run ``start`` on, without the runs of ``skip``."""

    examination: Examines
    unit: Worlds
    start: int
    skip: frozenset[int]


@dataclass(frozen=True, slots=True)
class RunJob:
    """Play and judge one run."""

    rules: Rules
    world: World
    script: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class TraceJob:
    """Play one world and tell every step at once, because the process may not survive it.

    The schedules are all, or the policy's after the choices of ``script``.
    """

    rules: Rules
    world: World
    schedules: Schedule
    script: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class ReplayJob:
    """Play against recorded percepts alone, without a world."""

    rules: Rules
    budget: int
    told: int | None
    transcript: Transcript
    choices: tuple[int, ...]


Job = UnitJob | RunJob | TraceJob | ReplayJob
"""Everything that a worker can be asked to do after its setup."""


@dataclass(frozen=True, slots=True)
class Tallied:
    """Answer to a :class:`UnitJob`: what has come of the runs before ``next_run``."""

    next_run: int
    result: Any
    last: bool


@dataclass(frozen=True, slots=True)
class Traced:
    """Answer to a :class:`TraceJob`: a new schedule (None), a choice, or a step."""

    what: int | tuple[Action, Percept] | None


@dataclass(frozen=True, slots=True)
class Ended:
    """The end of a trace or a replay: the actions taken, and how the run ended."""

    actions: tuple[Action, ...]
    ending: Answered | Fault


class HarnessError(RuntimeError):
    """A worker has failed, and no explorer is to blame."""
