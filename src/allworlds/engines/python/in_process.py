"""Players in this process, for an explorer that no other process can find."""

from __future__ import annotations

import secrets
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from allworlds.engines.python.play import ExplorerRunner, Record
from allworlds.engines.python.run_counter import RunCounter
from allworlds.engines.python.runs_of_unit import UnitOfRuns
from allworlds.engines.python.tour import Tour
from allworlds.explorers import Subject
from allworlds.judging import Log

CHUNK = 64
"""The number of logs that are handed over at a time."""


@dataclass(slots=True)
class InProcessPlayers:
    """Players in this process, each with its own order; a silent explorer cannot be stopped."""

    subject: Subject
    tour: Tour = field(default_factory=lambda: Tour(0, stays=True))
    _runner: ExplorerRunner = field(init=False)
    _logs: list[Log] = field(default_factory=list)

    def __post_init__(self) -> None:
        second = self.subject.second_player()
        self._runner = ExplorerRunner(self.subject.player(), second=second)

    @property
    def copies(self) -> bool:
        """Whether the second play is one of copies."""
        return self.subject.copies

    def play_runs(
        self,
        engine: RunCounter,
        unit: UnitOfRuns,
        numbers: Sequence[int],
        script: tuple[int, ...] | None = None,
    ) -> Iterator[list[tuple[int, Log]]]:
        """The logs of these runs, some at a time."""
        logs: list[tuple[int, Log]] = []
        order = secrets.randbits(64)
        for number, log in self._runner.play_runs(engine, unit, numbers, order, script):
            if log is not None:
                logs.append((number, log))
            if len(logs) == CHUNK:
                yield logs
                logs = []
        if logs:
            yield logs

    def send_records(self, records: Sequence[Record], policy: str, *, plain: bool = False) -> None:
        """Take records that are played once more."""
        order = secrets.randbits(64)
        self._logs = self._runner.play_records(records, policy, order, plain=plain)

    def receive_logs(self) -> list[Log]:
        """The logs of the records that were sent."""
        return self._logs

    def restart(self) -> None:
        """Go on in this process, which cannot be replaced."""

    def take_seeds(self, seed: int, *, alike: bool) -> None:
        """Go on in this process, which keeps its hash seed."""
