"""Messages to players: small frozen values.

What players answer is in :mod:`allworlds.engines.isolation.messages`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

from allworlds.engines.python.play import Record
from allworlds.engines.python.run_counter import RunCounter
from allworlds.engines.python.runs_of_unit import UnitOfRuns
from allworlds.engines.units.effort import Limits
from allworlds.explorers import ExplorerSource, Subject
from allworlds.judging import Rules
from allworlds.protocol import Schedule
from allworlds.world import World


class HarnessError(RuntimeError):
    """A process of ours has failed, and no explorer is to blame."""


# ---------------------------------------------------------------- to a player


@dataclass(frozen=True, slots=True)
class PlayerSetup:
    """A player's first message: the explorer that it loads.

    Answered by an ``ExplorerDescription``, or a ``Refusal``.

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

    @classmethod
    def of(cls, subject: Subject, limits: Limits) -> Self:
        """The setup of a player of that explorer."""
        return cls(subject.name, subject.source, limits.answer_timeout, limits.memory)


@dataclass(frozen=True, slots=True)
class PlayRuns:
    """Play runs of a unit in a drawn order; answered by ``RunLogs``, more than once.

    Attributes:
        engine: the scope, with its rules.
        unit: the unit.
        numbers: of the runs within the unit, ascending.
        order: seed of the order in which they are played.
        script: answers to the first choices of each run; None plays every schedule that the
            scope asks for.
    """

    engine: RunCounter
    unit: UnitOfRuns
    numbers: tuple[int, ...]
    order: int
    script: tuple[int, ...] | None = None


@dataclass(frozen=True, slots=True)
class PlayRecords:
    """Play against recorded percepts alone, without a world; answered by ``RecordLogs``."""

    records: tuple[Record, ...]
    policy: str
    order: int


@dataclass(frozen=True, slots=True)
class PlayStretch:
    """Play many runs that stand in shared memory, and write their logs there.

    Answered by a ``StretchResult``.

    Attributes:
        memory: a file that both sides see, laid out by the kernel.
        edges: of each world.
        runs: how many.
        order: seed of the order in which they are played.
        policy: answers the explorer's choices.
        again: against the recorded percepts that stand there, and not in worlds.
    """

    memory: str
    edges: int
    runs: int
    order: int
    policy: str
    again: bool


@dataclass(frozen=True, slots=True)
class Trace:
    """Play one world and send every step at once, because the process may not survive it.

    The schedules are all, or the policy's after the choices of ``script``.
    """

    rules: Rules
    world: World
    schedules: Schedule
    script: tuple[int, ...] = ()
