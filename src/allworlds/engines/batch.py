"""Batches, and the protocol of judges; a batch holds some runs of a unit, with their logs.

A batch is data, and other modules act on it.  A judge makes the batch, and judges the logs of its
runs.  A lane gives the runs to players, and adds the counts of the batch to those of the unit.
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
"""The numbers of the two plays of a run, and of the two players.

These numbers are also the default hash seeds of the players.
"""

Message: TypeAlias = dict[str, Any]
"""A message to a player: its parts by their names, such as ``kind`` and ``content``."""

Indices: TypeAlias = Sequence[int]
"""The indices of some runs in their batch."""

LogsByIndex: TypeAlias = dict[int, bytes] | Sequence[bytes]
"""Logs by the indices of their runs in a batch; a sequence if all logs came in one message."""


class Due(NamedTuple):
    """A run to be played.

    Attributes:
        number: the number of the run in its unit.
        place: the number of the lighthouse's place.
        world: the world.
        script: one index for each of the explorer's first choices in the run: the index of the
            option to be taken at this choice (:mod:`allworlds.protocol.choices`).  At later choices
            the policy decides; if every schedule is tried, the first option is taken.
    """

    number: int
    place: int
    world: World
    script: tuple[int, ...] = ()


class Recorded(NamedTuple):
    """A run as the second player gets it: its percepts in place of its world.

    Attributes:
        percepts: the percept at the start and after each action.
        world: the world; the player gets only some data of the world, such as the value that the
            lighthouse tells before the start.
        script: the script of the run, as in :class:`Due`.
        over: whether the task ended the run, because the robot had done all that the task demands.
    """

    percepts: Iterable[Percept]
    world: World
    script: tuple[int, ...] = ()
    over: bool = False

    @classmethod
    def of(cls, due: Due, episode: Episode) -> "Recorded":
        """The run ``due`` with the percepts of its episode."""
        over = isinstance(episode.ending, Over)
        return cls(episode.walk.percepts, due.world, due.script, over)


class Judged(NamedTuple):
    """A run that the judge in Python has judged by a log.

    Attributes:
        log: the log.
        outcome: the outcome of the run.
        fits: whether the explorer took the options of the run's script, and the first option at
            each later choice; always True unless every schedule is tried.
    """

    log: Log
    outcome: Outcome
    fits: bool = True


@dataclass(slots=True)
class Work:
    """A unit that a lane is doing.

    Attributes:
        unit: the unit.
        tally: the counts that the lane has not returned yet; a lane returns the result of a unit in
            several parts.
        batches: the iterator over the batches that have not been made yet; None at its end.
        more: used if every schedule is tried: the runs that are to be played again, each with the
            script of its next schedule.
        open: the number of batches that are being played or compared.
        best: used if every schedule is tried, to count the cost of the cheapest schedule: a
            dictionary from the number of a run to a pair of the run and the least cost so far.
    """

    unit: UnitOfRuns
    tally: Tally
    batches: "Iterator[RunBatch] | None" = None
    more: list[Due] = field(default_factory=list)
    open: int = 0
    best: dict[int, tuple[Due, int]] = field(default_factory=dict)


class RunBatch:
    """Some runs of a unit, with their logs once players have made these logs.

    Attributes:
        by: the judge that has made the batch.
        work: the unit, with the state of the work on it.
        tally: the counts of these runs; they are added to the counts of the unit once both plays of
            each run have been compared.
        logs: the logs of the first play, and the logs of the second play.
        plain: whether Python plays the runs, and not compiled code.
        broken: the indices of the runs that break a law, or that did not make the choices of their
            scripts; if compiled code has judged the batch, only the smallest of these runs.
        lost: the indices of the runs in which a player was lost; their logs are missing or
            incomplete.
        judged: the runs that the Python judge has judged, by their indices.
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
        """The runs of the batch."""
        return self._runs

    def due(self, index: int) -> Due:
        """The run of this index."""
        return self._runs[index]

    def __len__(self) -> int:
        return len(self.runs)

    def take(self, which: int, indices: Indices, logs: Sequence[bytes]) -> None:
        """Store logs that a player has made, in :attr:`logs`.

        Args:
            which: the number of the player, :data:`FIRST` or :data:`SECOND`.
            indices: the indices of the runs in the batch.
            logs: the log of each of these runs.
        """
        if isinstance(logs, Logs) and len(logs) == len(self):
            self.logs[which] = logs
            return
        known = self.logs[which]
        if not isinstance(known, dict):
            known = self.logs[which] = dict(enumerate(known))
        known.update(zip(indices, logs, strict=True))

    def unplayed(self, which: int, indices: Indices) -> list[int]:
        """Those of the given indices whose runs have no log yet of the player number ``which``."""
        known = self.logs[which]
        return [index for index in indices if index not in known] if isinstance(known, dict) else []

    def outcome(self, index: int) -> Judged:
        """The Python judge's judgement of the run of this index, from the log of its first play."""
        if index not in self.judged:
            self.judged[index] = self.by.judged(self.due(index), self.logs[FIRST][index])
        return self.judged[index]

    def record(self, index: int) -> Recorded:
        """The run of this index in the form in which the second player gets it."""
        return Recorded.of(self.due(index), self.outcome(index).outcome.episode)

    def follow_ups(self) -> list[Due]:
        """The runs to be played again, each with the script of its next schedule.

        A run whose last schedule has been played is left out.  The list is empty unless every
        schedule is tried.
        """
        if not self.by.every:
            return []
        logs = ((due, self.outcome(index).log) for index, due in enumerate(self.runs))
        scripts = ((due, next_script(due.script, log.choices, log.widths)) for due, log in logs)
        return [due._replace(script=script) for due, script in scripts if script is not None]


class Judge(Protocol):
    """A judge arranges the runs of a unit in batches, writes messages to players, and judges logs.

    Attributes:
        counter: the object that lists the runs of a unit, and adds runs and their outcomes to a
            tally; it also holds the scope.
        every: whether every schedule of each run is tried.
    """

    counter: RunCounter
    every: bool

    def batches(self, work: Work, size: Callable[[], int]) -> Iterator[RunBatch]:
        """Yield the runs of a unit in batches.

        ``size`` is a function that returns about how many runs the next batch shall have.
        """

    def judge(self, batch: RunBatch) -> bool:
        """Judge the runs of a batch by the logs of their first play, and count the runs.

        Return False if logs are missing.  Then compiled code could not write them, and Python must
        play the runs again.
        """

    def judged(self, due: Due, log: bytes) -> Judged:
        """Return the judgement of the judge in Python about one run, whose log is ``log``.

        A judge in compiled code judges whole batches only, and calls the judge in Python here.
        """

    def worlds(self, batch: RunBatch, indices: Indices) -> Message:
        """The message that tells a player to play these runs of the batch in their worlds."""

    def percepts(self, batch: RunBatch, indices: Indices, order: Indices = ()) -> Message:
        """The message that tells a player to play these runs of the batch by their percepts.

        The message holds no world.  ``order`` is the order of the play, as positions in
        ``indices``; if ``order`` is empty, the runs are played in the order of ``indices``.
        """
