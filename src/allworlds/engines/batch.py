"""A batch: some runs of a unit on their way, with their logs; and what judges it.

A batch is data.  What stands in it is laid out and judged by its judge, given to the players by
their owner, and settled by the lane.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple, Protocol, TypeAlias

from allworlds.engines.players import Logs
from allworlds.engines.tally import RunCounter, Tally
from allworlds.engines.units import UnitOfRuns
from allworlds.judging.episode import Episode, Over
from allworlds.judging.referee import Outcome
from allworlds.log import Log
from allworlds.protocol.actions import Percept
from allworlds.protocol.choices import next_script
from allworlds.world.world import World

FIRST, SECOND = 0, 1
"""The numbers of the two plays of a run, of their players, and their hash seeds."""

Message: TypeAlias = dict[str, Any]
"""A message to a player."""

Indices: TypeAlias = Sequence[int]
"""The indices of some runs in their batch."""

LogsByIndex: TypeAlias = dict[int, bytes] | Sequence[bytes]
"""Logs by the indices of their runs in a batch; a sequence if all came at once."""


class Due(NamedTuple):
    """A run that is due: its number in its unit, its place, its world, and its first choices."""

    number: int
    place: int
    world: World
    script: tuple[int, ...] = ()


class Recorded(NamedTuple):
    """A run without its world, of which only the size counts, and what was told.

    Attributes:
        percepts: at the start and after each action.
        world: of the run.
        script: the first choices.
        over: whether the run was ended, since all was done.
    """

    percepts: Iterable[Percept]
    world: World
    script: tuple[int, ...] = ()
    over: bool = False

    @classmethod
    def of(cls, due: Due, episode: Episode) -> "Recorded":
        """The record of an episode of that run."""
        over = isinstance(episode.ending, Over)
        return cls(episode.walk.percepts, due.world, due.script, over)


class Judged(NamedTuple):
    """A log, judged.

    Attributes:
        log: what it says.
        outcome: of the run.
        fits: whether it made the choices that were due.
    """

    log: Log
    outcome: Outcome
    fits: bool = True


@dataclass(slots=True)
class Work:
    """A unit at work.

    Attributes:
        unit: what is to be done.
        tally: what was counted since a part was handed over.
        batches: that are still to be laid out; None if there are no more.
        more: runs with further schedules.
        open: the number of batches that are under way.
        best: of each run the cost of its cheapest schedule, where every schedule is tried.
    """

    unit: UnitOfRuns
    tally: Tally
    batches: "Iterator[RunBatch] | None" = None
    more: list[Due] = field(default_factory=list)
    open: int = 0
    best: dict[int, tuple[Due, int]] = field(default_factory=dict)


class RunBatch:
    """Some runs of a unit, with their logs once they are judged.

    Attributes:
        by: what judges it.
        work: the unit.
        tally: of these runs; it counts once both plays of each are compared.
        logs: of the first and of the second play.
        plain: whether Python plays the runs.
        broken: the runs that break a law, or did not make the choices that were due; of those that
            compiled code has judged the least.
        lost: the runs in which a player was lost, and so is their walk, or its end.
        judged: the runs that the Python judge has judged.
    """

    def __init__(self, by: "Judge", work: Work, runs: Iterable[Due]) -> None:
        self.by, self.work, self._runs = by, work, [*runs]
        self.tally = by.counter.tally()
        self.logs: list[LogsByIndex] = [{}, {}]
        self.plain = True
        self.broken: list[int] = []
        self.lost: set[int] = set()
        self.judged: dict[int, Judged] = {}

    @property
    def runs(self) -> list[Due]:
        """The runs that are due."""
        return self._runs

    def due(self, index: int) -> Due:
        """A run."""
        return self._runs[index]

    def __len__(self) -> int:
        return len(self.runs)

    def take(self, which: int, indices: Indices, logs: Sequence[bytes]) -> None:
        """Take the logs of these runs, by one of the plays."""
        if isinstance(logs, Logs) and len(logs) == len(self):
            self.logs[which] = logs
            return
        known = self.logs[which]
        if not isinstance(known, dict):
            known = self.logs[which] = dict(enumerate(known))
        known.update(zip(indices, logs, strict=True))

    def unplayed(self, which: int, indices: Indices) -> list[int]:
        """Those of these runs of which a play is not known."""
        known = self.logs[which]
        return [index for index in indices if index not in known] if isinstance(known, dict) else []

    def outcome(self, index: int) -> Judged:
        """A run, judged by the Python judge."""
        if index not in self.judged:
            self.judged[index] = self.by.judged(self.due(index), self.logs[FIRST][index])
        return self.judged[index]

    def record(self, index: int) -> Recorded:
        """Return the record of a run: all that the second player gets of it."""
        return Recorded.of(self.due(index), self.outcome(index).outcome.episode)

    def follow_ups(self) -> list[Due]:
        """The runs with the next schedules, where every schedule is due."""
        if not self.by.every:
            return []
        logs = ((due, self.outcome(index).log) for index, due in enumerate(self.runs))
        scripts = ((due, next_script(due.script, log.choices, log.widths)) for due, log in logs)
        return [due._replace(script=script) for due, script in scripts if script is not None]


class Judge(Protocol):
    """A judge lays out the runs of a unit, says what players are told, and judges their logs.

    Attributes:
        counter: counts, and knows the scope.
        every: whether every schedule is due.
    """

    counter: RunCounter
    every: bool

    def batches(self, work: Work, size: Callable[[], int]) -> Iterator[RunBatch]:
        """The runs of a unit, so many at a time."""

    def judge(self, batch: RunBatch) -> bool:
        """Judge the first logs of a batch, and count them; return whether it can read them all."""

    def judged(self, due: Due, log: bytes) -> Judged:
        """One run with its log, judged by the judge in Python."""

    def worlds(self, batch: RunBatch, indices: Indices) -> Message:
        """The message to a player that plays these runs in their worlds."""

    def percepts(self, batch: RunBatch, indices: Indices, order: Indices = ()) -> Message:
        """The message to a player that plays recorded percepts; nothing of a world."""
