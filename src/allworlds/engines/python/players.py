"""The two players of a user's explorer, the runs that they are given, and the scripts of these."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Protocol, TypeAlias

from msgspec import Struct

from allworlds.engines.python.play import Record
from allworlds.engines.python.run_counter import RunCounter
from allworlds.engines.python.runs_of_unit import NumberedRun, UnitOfRuns
from allworlds.judging import Log, LostRun
from allworlds.protocol import are_due, next_script
from allworlds.world import World

Seeds: TypeAlias = tuple[int | None, int | None]
"""The hash seeds of the first and of the second player, each of which a nursery with that seed
forks; None: the guardian forks it, whose seed is 0."""

OTHER_SEED = 1
"""The hash seed of second players."""

SEEDS: Seeds = (None, OTHER_SEED)
"""The hash seeds in a check."""

GOES_BY_HASHES = "the explorer goes by hashes: where PYTHONHASHSEED is another one, so is its walk"
"""The remark on an explorer whose plays with one seed are always the same."""


class Players(Protocol):
    """The two players of an explorer: in this process, or in others that may be lost.

    Attributes:
        seeds: the hash seeds of both; other ones are those of other processes.
    """

    seeds: Seeds

    def play_runs(
        self,
        engine: RunCounter,
        unit: UnitOfRuns,
        numbers: Sequence[int],
        script: tuple[int, ...] | None = None,
    ) -> Iterator[list[tuple[int, Log]]]:
        """Yield the logs of these runs of the unit, some at a time, each with its number.

        A run that has killed its process twice has one log, with that fault.
        """

    def send_records(self, records: Sequence[Record], policy: str) -> None:
        """Begin to play these once more, in another order, without a world."""

    @property
    def answer_timeout(self) -> float:
        """The seconds after which a silent run is given up; infinite if it is waited for."""

    def receive_logs(self) -> list[Log]:
        """Return the logs of the records that were sent, in their order."""

    def restart(self) -> None:
        """Go on in fresh processes."""


class OneRun(Struct, frozen=True):
    """A run of a unit: its number there, the number of its place, and its world."""

    number: int
    place: int
    world: World


def placed_run(run: NumberedRun) -> OneRun:
    """A run that has a place."""
    assert run.lighthouse is not None
    return OneRun(run.number, run.place, World(run.map, run.lighthouse, 0))


class ScriptTracker(Struct):
    """The script of each run's next log: one log for a run, or one for each schedule.

    Attributes:
        every: whether every schedule is due.
        scripts: for each run the first choices of its next log, all others being 0 where
            every schedule is due; None behind the last.
    """

    every: bool
    scripts: dict[int, tuple[int, ...] | None]

    def take(self, number: int, log: Log) -> tuple[tuple[int, ...], bool]:
        """The script of the next log of a run, and whether this is its log.

        Raises:
            RuntimeError: if the run has no more logs.
        """
        script = self.scripts.get(number)
        if script is None:
            raise RuntimeError(f"a player has told more of run {number} than it was asked for")
        if isinstance(log.ending, LostRun) or not self.every:
            self.scripts[number] = None
            return script, True
        self.scripts[number] = next_script(script, log.choices, log.widths)
        return script, are_due(script, log.choices, log.widths)

    def finish(self) -> None:
        """Raise RuntimeError unless every run has had its last log."""
        left = [number for number, script in self.scripts.items() if script is not None]
        if left:
            raise RuntimeError(f"a player has told that run {left[0]} is done, and not how")
