"""Messages between the owner of a check and a referee: small frozen values."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from allworlds.engines.isolation.player_pair import WorkerEngine
from allworlds.engines.python.runs_of_unit import UnitOfRuns
from allworlds.engines.units.effort import Limits
from allworlds.explorers import Subject


@dataclass(frozen=True, slots=True)
class RefereeSetup:
    """A referee's first message: the explorer whose runs it judges.

    Attributes:
        subject: the explorer; the referee itself never loads users' code.
        limits: of its players.
        order: seed of every order of runs.
    """

    subject: Subject
    limits: Limits
    order: int


@dataclass(frozen=True, slots=True)
class UnitJob:
    """Do a unit from run ``start`` on; answered by :class:`UnitProgress`, more than once."""

    engine: WorkerEngine
    unit: UnitOfRuns
    start: int


@dataclass(frozen=True, slots=True)
class UnitProgress:
    """Answer to a :class:`UnitJob`: the result since the last one, up to the run ``next_run``."""

    next_run: int
    result: Any
    last: bool
