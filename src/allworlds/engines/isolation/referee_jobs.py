"""Messages between the owner of a check and a referee: small frozen values."""

from __future__ import annotations

from typing import Any

from msgspec import Struct

from allworlds.engines.isolation.worker_engine import WorkerEngine
from allworlds.engines.python.runs_of_unit import UnitOfRuns
from allworlds.engines.units.effort import Limits
from allworlds.explorers import Subject


class RefereeSetup(Struct, frozen=True):
    """A referee's first message: the explorer whose runs it judges.

    Attributes:
        subject: the explorer; the referee itself never loads users' code.
        limits: of its players.
        order: seed of every order of runs.
    """

    subject: Subject
    limits: Limits
    order: int


class UnitJob(Struct, frozen=True):
    """Do a unit from run ``start`` on; answered by :class:`UnitProgress`, more than once."""

    engine: WorkerEngine
    unit: UnitOfRuns
    start: int


class UnitProgress(Struct, frozen=True):
    """Answer to a :class:`UnitJob`: the result since the last one, up to the run ``next_run``."""

    next_run: int
    result: Any
    last: bool
