"""Batches, which are some runs of a unit with their logs, and the protocol of their judges.

A batch is data.  Its judge lays out the runs and judges the logs, the owner of the players gives
the players the runs, and the lane settles the batch.
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
"""The numbers of the two plays of a run and of the two players, and the default hash seeds."""

Message: TypeAlias = dict[str, Any]
"""A message to a player."""

Indices: TypeAlias = Sequence[int]
"""The indices of some runs in their batch."""

LogsByIndex: TypeAlias = dict[int, bytes] | Sequence[bytes]
"""Logs by the indices of their runs in a batch; a sequence if all logs came in one message."""


class Due(NamedTuple):
    """A run to be played: its number in the unit, its place, its world, and its first choices."""

    number: int
    place: int
    world: World
    script: tuple[int, ...] = ()


class Recorded(NamedTuple):
    """A run as the second player gets it: its percepts in place of its world.

    Attributes:
        percepts: the percept at the start and after each action.
        world: the world; only its size and what its lighthouse tells are passed on.
        script: the first choices.
        over: whether the task ended the run, because all was done.
    """

    percepts: Iterable[Percept]
    world: World
    script: tuple[int, ...] = ()
    over: bool = False

    @classmethod
    def of(cls, due: Due, episode: Episode) -> "Recorded":
        """The run with the percepts of this episode, in which it was played."""
        over = isinstance(episode.ending, Over)
        return cls(episode.walk.percepts, due.world, due.script, over)


class Judged(NamedTuple):
    """A run that the judge in Python has judged.

    Attributes:
        log: the log of the run.
        outcome: the outcome of the run.
        fits: whether the log makes the choices that were due.
    """

    log: Log
    outcome: Outcome
    fits: bool = True


@dataclass(slots=True)
class Work:
    """A unit that a lane is doing.

    Attributes:
        unit: the unit.
        tally: the counts since the last partial result was returned.
        batches: the batches that have not been laid out yet; None if there are no more.
        more: the runs with further schedules.
        open: the number of batches that are being played.
        best: the cost of the cheapest schedule of each run, if every schedule is tried.
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
        by: the judge.
        work: the unit.
        tally: the counts of these runs, added to the unit's once both plays of each are compared.
        logs: the logs of the first and of the second play.
        plain: whether Python plays the runs.
        broken: the runs that break a law, or that did not make the choices that were due; if
            compiled code has judged the batch, only the least of them.
        lost: the runs in which a player was lost; the walk, or the end of it, is unknown.
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
        """The run of this index."""
        return self._runs[index]

    def __len__(self) -> int:
        return len(self.runs)

    def take(self, which: int, indices: Indices, logs: Sequence[bytes]) -> None:
        """Store the logs of these runs in one of the two plays."""
        if isinstance(logs, Logs) and len(logs) == len(self):
            self.logs[which] = logs
            return
        known = self.logs[which]
        if not isinstance(known, dict):
            known = self.logs[which] = dict(enumerate(known))
        known.update(zip(indices, logs, strict=True))

    def unplayed(self, which: int, indices: Indices) -> list[int]:
        """The runs among these that have no log of this play yet."""
        known = self.logs[which]
        return [index for index in indices if index not in known] if isinstance(known, dict) else []

    def outcome(self, index: int) -> Judged:
        """The run of this index, judged by the Python judge."""
        if index not in self.judged:
            self.judged[index] = self.by.judged(self.due(index), self.logs[FIRST][index])
        return self.judged[index]

    def record(self, index: int) -> Recorded:
        """Return the percepts of a run, which is all that the second player gets."""
        return Recorded.of(self.due(index), self.outcome(index).outcome.episode)

    def follow_ups(self) -> list[Due]:
        """The runs with their next schedules; none unless every schedule is due."""
        if not self.by.every:
            return []
        logs = ((due, self.outcome(index).log) for index, due in enumerate(self.runs))
        scripts = ((due, next_script(due.script, log.choices, log.widths)) for due, log in logs)
        return [due._replace(script=script) for due, script in scripts if script is not None]


class Judge(Protocol):
    """A judge lays out the runs of a unit, makes messages to players, and judges their logs.

    Attributes:
        counter: the counter of the runs, which also holds the scope.
        every: whether every schedule is due.
    """

    counter: RunCounter
    every: bool

    def batches(self, work: Work, size: Callable[[], int]) -> Iterator[RunBatch]:
        """Yield the runs of a unit in batches of this size."""

    def judge(self, batch: RunBatch) -> bool:
        """Judge and count the logs of a batch's first play; return whether all could be read."""

    def judged(self, due: Due, log: bytes) -> Judged:
        """One run with its log, judged by the judge in Python."""

    def worlds(self, batch: RunBatch, indices: Indices) -> Message:
        """The message that tells a player to play these runs in their worlds."""

    def percepts(self, batch: RunBatch, indices: Indices, order: Indices = ()) -> Message:
        """The message that tells a player to play these runs by their percepts, without a world."""
