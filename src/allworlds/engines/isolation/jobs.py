"""What the processes say to each other: small frozen values."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

from allworlds.engines.python.play import Record
from allworlds.engines.python.python_engine import PythonEngine, WorkerEngine
from allworlds.engines.python.runs_of_unit import UnitOfRuns
from allworlds.engines.python.scope import Schedule
from allworlds.explorers import ExplorerSource, Subject
from allworlds.judging import Log, Rules
from allworlds.protocol import Percept
from allworlds.world import World


class HarnessError(RuntimeError):
    """A process of ours has failed, and no explorer is to blame."""


# ---------------------------------------------------------------- to and from a player


@dataclass(frozen=True, slots=True)
class Casting:
    """A player's first message: which explorer it is to be.

    Answered by :class:`Described`, or an error.

    Attributes:
        name: of the explorer.
        source: the text of its file, if it has been read.
        answer_timeout: seconds after which a silent foreign program is given up.
        memory: MB of address space, or None.
    """

    name: str
    source: ExplorerSource | None
    answer_timeout: float
    memory: int | None


@dataclass(frozen=True, slots=True)
class Described:
    """What the explorer takes, and the digest of the code that it is, where it is known."""

    keywords: frozenset[str]
    digest: str


@dataclass(frozen=True, slots=True)
class PlayRuns:
    """Play runs of a unit, in an order that tells nothing; answered by :class:`Played`.

    Attributes:
        examination: the scope, with its rules.
        unit: the unit.
        numbers: of the runs within the unit, ascending.
        order: seed of the order in which they are played.
        script: answers to the first choices of each run; None plays every schedule that the
            scope asks for.
    """

    examination: PythonEngine
    unit: UnitOfRuns
    numbers: tuple[int, ...]
    order: int
    script: tuple[int, ...] | None = None


class Played(NamedTuple):
    """Some of the logs, each with the number of its run; ``done``: the runs that have no more."""

    logs: list[tuple[int, Log]]
    done: list[int]


@dataclass(frozen=True, slots=True)
class PlayRecords:
    """Play against recorded percepts alone, without a world; answered by one list of logs."""

    records: tuple[Record, ...]
    policy: str
    order: int


@dataclass(frozen=True, slots=True)
class PlayStretch:
    """Play many runs that stand in shared memory, and leave their logs there.

    Answered by :class:`Stretched`.

    Attributes:
        memory: a file that both sides see, laid out by the kernel.
        edges: of each world.
        runs: how many.
        order: seed of the order in which they are played.
        policy: answers the explorer's choices.
        again: against the percepts that stand there, and not in worlds.
    """

    memory: str
    edges: int
    runs: int
    order: int
    policy: str
    again: bool


class Stretched(NamedTuple):
    """The number of bytes of the logs (-1: there was no room), and of threads left behind."""

    size: int
    threads: int


@dataclass(frozen=True, slots=True)
class Trace:
    """Play one world and tell every step at once, because the process may not survive it.

    The schedules are all, or the policy's after the choices of ``script``.
    """

    rules: Rules
    world: World
    schedules: Schedule
    script: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class TraceEvent:
    """Answer to a :class:`Trace`: a new schedule (None), a choice, or an action and its percept."""

    what: int | tuple[int, Percept] | None


# ---------------------------------------------------------------- to and from a referee


@dataclass(frozen=True, slots=True)
class Appointment:
    """A referee's first message: whose runs it is to judge.

    Attributes:
        subject: the explorer; the referee itself never loads foreign code.
        answer_timeout, memory: of its players.
        order: from which every order of runs is drawn.
    """

    subject: Subject
    answer_timeout: float
    memory: int | None
    order: int


@dataclass(frozen=True, slots=True)
class UnitJob:
    """Examine a unit from run ``start`` on; answered by :class:`Tallied`, some time and again."""

    examination: WorkerEngine
    unit: UnitOfRuns
    start: int


@dataclass(frozen=True, slots=True)
class Tallied:
    """Answer to a :class:`UnitJob`: what came since, up to the run ``next_run``."""

    next_run: int
    result: Any
    last: bool


Kind = Literal["timeout", "crash"]
