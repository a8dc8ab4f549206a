"""Messages to players: small frozen values.

The answers of players are in :mod:`allworlds.engines.isolation.messages`.
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Self

from msgspec import Struct

from allworlds.protocol import START_TIMEOUT, SourceText

if TYPE_CHECKING:  # a player loads what its messages hold, and nothing for the others
    from allworlds.engines.python.play import Record
    from allworlds.engines.python.run_counter import RunCounter
    from allworlds.engines.python.runs_of_unit import UnitOfRuns
    from allworlds.engines.units.effort import Limits
    from allworlds.explorers import Subject
    from allworlds.judging import Rules
    from allworlds.protocol import Schedule
    from allworlds.world import Adversary, World


class PlayerSetup(Struct, frozen=True):
    """A player's first message: the explorer that it loads.

    Answered by an ``ExplorerDescription``, or a ``Refusal``.

    Attributes:
        name: of the explorer.
        source: the text of its file, if it has been read.
        answer_timeout: seconds after which a silent program is given up.
        memory: MB of address space, or None.
        output: the path to which the explorer prints once it is loaded; before that, it is not
            read.  Empty: all prints go to stderr.
        start_timeout: seconds in which it must be loaded.
    """

    name: str
    source: SourceText | None
    answer_timeout: float
    memory: int | None
    output: str = os.devnull
    start_timeout: float = START_TIMEOUT

    @classmethod
    def of(cls, subject: Subject, limits: Limits, output: str = os.devnull) -> Self:
        """The setup of a player of that explorer."""
        patience = limits.answer_timeout, limits.memory, output, limits.start_timeout
        return cls(subject.name, subject.source, *patience)


class PlayRuns(Struct, frozen=True):
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


class PlayRecords(Struct, frozen=True):
    """Play against recorded percepts alone, without a world; answered by ``RecordLogs``."""

    records: tuple[Record, ...]
    policy: str
    order: int


class PlayStretch(Struct, frozen=True):
    """Play many runs that stand in shared memory, and write their logs there.

    Answered by a ``StretchResult``.

    Attributes:
        memory: a file that both sides share, laid out by the kernel.
        edges: the number of edges of each world.
        runs: the number of runs.
        order: seed of the order in which they are played.
        policy: answers the explorer's choices.
        again: whether the runs are played against the recorded percepts there, not in worlds.
    """

    memory: str
    edges: int
    runs: int
    order: int
    policy: str
    again: bool


class Trace(Struct, frozen=True):
    """Play one world and send every step at once, because the process may not survive it.

    The schedules are all, or the policy's after the choices of ``script``.  If there is an
    adversary, the explorer plays against it; the world is the one that it has at first.
    """

    rules: Rules
    world: World
    schedules: Schedule
    script: tuple[int, ...] = ()
    adversary: Adversary | None = None
