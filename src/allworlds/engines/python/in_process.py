"""Players in this process, for an explorer that no other process can find.

The explorer's prints are dropped, apart from those of the run that is told.
"""

from __future__ import annotations

import secrets
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import islice
from math import inf

from allworlds.engines.python.play import ExplorerRunner, Record
from allworlds.engines.python.players import Seeds
from allworlds.engines.python.prints import Prints, Silence, printing_to
from allworlds.engines.python.run_counter import RunCounter
from allworlds.engines.python.runs_of_unit import UnitOfRuns
from allworlds.engines.python.world_runner import WorldRunner
from allworlds.explorers import Subject
from allworlds.judging import Log

CHUNK = 64
"""The number of logs, and of ends of runs, that are handed over at a time."""


@dataclass(slots=True)
class InProcessPlayers:
    """Players in this process, each with its own order; a silent explorer cannot be stopped."""

    subject: Subject
    seeds: Seeds = (None, None)
    _runner: ExplorerRunner = field(init=False)
    _in_worlds: WorldRunner = field(init=False)
    _logs: list[Log] = field(default_factory=list)

    def __post_init__(self) -> None:
        self._runner = ExplorerRunner(self.subject.player())
        self._in_worlds = WorldRunner(self._runner)

    @property
    def answer_timeout(self) -> float:
        """No end: a silent explorer cannot be stopped."""
        return inf

    def play_runs(
        self,
        engine: RunCounter,
        unit: UnitOfRuns,
        numbers: Sequence[int],
        script: tuple[int, ...] | None = None,
    ) -> Iterator[list[tuple[int, Log]]]:
        """The logs of these runs, some at a time."""
        order = secrets.randbits(64)
        played = self._in_worlds.play_runs(engine, unit, numbers, order, script)
        while True:
            with printing_to(Silence()):
                some = list(islice(played, CHUNK))
            if not some:
                return
            yield [(number, log) for number, log in some if log is not None]

    def send_records(self, records: Sequence[Record], policy: str) -> None:
        """Take records that are played once more."""
        order = secrets.randbits(64)
        with printing_to(Silence()):
            self._logs = self._runner.play_records(records, policy, order)

    def printed(self, record: Record, policy: str) -> str:
        """The prints of the explorer while it plays a record once more."""
        prints = Prints()
        with printing_to(prints):
            self._runner.play_records([record], policy, 0)
        return prints.text

    def receive_logs(self) -> list[Log]:
        """The logs of the records that were sent."""
        return self._logs

    def restart(self) -> None:
        """Go on in this process, which cannot be replaced."""
