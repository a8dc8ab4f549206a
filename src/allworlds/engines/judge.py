"""The judge in Python: it takes runs and their logs, and knows every law, lighthouse and task.

It lays out the runs of a unit in batches, and walks each log anew in the true map; the percepts on
the way are what the second player gets.  It imports files of models, never an explorer.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, NamedTuple

from allworlds.engines import players, units
from allworlds.engines.tally import RunCounter, Tally
from allworlds.inputs.checks import InputError, show
from allworlds.judging.episode import Episode, Fault, Over, followed
from allworlds.judging.referee import LOST, Outcome, Referee, name_run
from allworlds.log import Log
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol import actions, playing
from allworlds.protocol.choices import DEFAULT_POLICY, are_due, next_script
from allworlds.world.state import State
from allworlds.world.world import World


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

    percepts: Iterable[actions.Percept]
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

    unit: units.UnitOfRuns
    tally: Tally
    batches: Iterator[Any] | None = None
    more: list[Due] = field(default_factory=list)
    open: int = 0
    best: dict[int, tuple[Due, int]] = field(default_factory=dict)


class RunBatch:
    """Some runs of a unit, with their logs once they are judged.

    Attributes:
        judge: the judge in Python.
        work: the unit.
        judged: each of them, once its log is.
        tally: of these runs; it counts once both plays of each are compared.
        logs: of the first and of the second play, by the numbers of the runs in the batch;
            a sequence if all came at once.
        by: what judges it.
        plain: whether Python plays the runs.
        lost: the runs in which a player was lost, and so is their walk, or its end.
    """

    def __init__(self, judge: "PythonJudge", work: Work, runs: Sequence[Due]) -> None:
        self.judge, self.work, self._runs = judge, work, [*runs]
        self.by: Any = judge
        self.judged: list[Judged] = []
        self.tally = judge.engine.tally()
        self.logs: list[Any] = [{}, {}]
        self.lost: set[int] = set()
        self.plain = True

    @property
    def runs(self) -> list[Due]:
        """The runs that are due."""
        return self._runs

    def __len__(self) -> int:
        return len(self.runs)

    def take(self, which: int, rows: Sequence[int], logs: Sequence[bytes]) -> None:
        """Take the logs of these runs, by one of the plays."""
        if isinstance(logs, players.Logs) and len(logs) == len(self):
            self.logs[which] = logs
            return
        if isinstance(self.logs[which], players.Logs):
            self.logs[which] = dict(enumerate(self.logs[which]))
        self.logs[which].update(zip(rows, logs, strict=True))

    def worlds(self, rows: Sequence[int]) -> dict[str, Any]:
        """The message to a player that plays these runs in their worlds."""
        return self.judge.worlds_message([self.runs[row] for row in rows])

    def records(self, rows: Sequence[int], order: Sequence[int] = ()) -> dict[str, Any]:
        """The message to a player that plays recorded percepts; nothing of a world."""
        return self.judge.records_message([self.record(row) for row in rows], order)

    def record(self, row: int) -> Recorded:
        """Return the record of a run: all that the second player gets of it."""
        return Recorded.of(self.runs[row], self.outcome(row).outcome.episode)

    def outcome(self, row: int) -> Judged:
        """A run, judged by the Python judge."""
        return self.judged[row]

    @property
    def broken(self) -> list[int]:
        """The runs that break a law, or did not make the choices that were due."""
        return [row for row, one in enumerate(self.judged) if one.outcome.violation or not one.fits]

    @property
    def without_words(self) -> list[int]:
        """Return no run: Python has written each log."""
        return []

    def follow_ups(self) -> list[Due]:
        """The runs with the next schedules, where every schedule is due."""
        if not self.judge.every:
            return []
        scripts = (
            (due, next_script(due.script, one.log.choices, one.log.widths))
            for due, one in zip(self.runs, self.judged, strict=True)
        )
        return [due._replace(script=script) for due, script in scripts if script is not None]


class PythonJudge:
    """The judge of a scope.

    Args:
        engine: counts, and knows the scope.
        explorer: its name.
        given: the choices of each run; None for those that the scope asks for.
    """

    name = "python"

    def __init__(
        self, engine: RunCounter, explorer: str, given: tuple[int, ...] | None = None
    ) -> None:
        self.engine, self.rules = engine, engine.scope.rules
        self.referee = Referee(explorer, self.rules)
        self.every = engine.scope.schedules == "all" and given is None
        self._given = given or ()

    def batches(self, work: Work, size: Callable[[], int]) -> Iterator[RunBatch]:
        """The runs of a unit, so many at a time."""
        batch = RunBatch(self, work, ())
        for run in self.engine.runs(work.unit):
            world = self.engine.count_run(run, batch.tally)
            if world is not None:
                batch.runs.append(Due(run.number, run.place, world, self._given))
            if len(batch) >= size():
                yield batch
                batch = RunBatch(self, work, ())
        if batch.runs:
            yield batch
        else:  # perhaps worlds without a place
            work.tally.add(batch.tally)

    def judge(self, batch: RunBatch) -> bool:
        """Judge the first logs of a batch, and count them; return True: it can read them all."""
        logs, work = batch.logs[0], batch.work
        for row, due in enumerate(batch.runs):
            one = self.judged(due, logs[row])
            batch.judged.append(one)
            self.engine.count_outcome(due.world, due.place, one.outcome, batch.tally)
            if self.every:
                _, least = work.best.get(due.number, (due, one.outcome.cost))
                work.best[due.number] = due, min(least, one.outcome.cost)
        return True

    def judged(self, due: Due, log: bytes) -> Judged:
        """One run with its log."""
        read, rules, world = Log(log), self.rules, due.world
        episode = self.episode(world, read)
        # Of a run that was lost the choices may be known less far than they were due.
        lost = isinstance(episode.ending, Fault) and episode.ending.law in LOST
        choices = max(tuple(read.choices), due.script if lost else (), key=len)
        outcome = self.referee.outcome(world, episode, choices)
        if isinstance(episode.ending, Over) and not rules.task.is_over(episode.walk):
            raise InputError(
                f"over of task {show(rules.task.name)} is no function of the run: it has ended "
                f"one in {world.map}, and says now that it goes on"
            )
        fits = not self.every or are_due(due.script, read.choices, read.widths)
        return Judged(read, outcome, fits)

    def episode(self, world: World, log: Log) -> Episode:
        """The episode of a log in this world."""
        rules = self.rules
        try:
            budget = rules.budget(world.map)
            return followed(log, world, budget, maps=rules.task.is_map)
        except actions.IllegalAction as error:
            if world.lighthouse.code is None:
                raise RuntimeError(f"the log of a run is no walk in its world: {error}") from None
            raise InputError(
                f"lighthouse {show(world.lighthouse.kind)} is no function of the run: an action in "
                f"{world.map} was legal, and is not when the log is followed: {error}"
            ) from None

    # ---------------------------------------------------------------- messages

    def worlds_message(self, runs: Sequence[Due]) -> dict[str, Any]:
        """The message to a player that plays these runs in their worlds."""
        task = self.rules.task
        worlds: Iterable[Any]
        if not task.ends_runs and all(each.world.lighthouse.static for each in runs):
            kind, worlds = "table", (table_of(each.world) for each in runs)
        else:
            kind, worlds = "model", ((each.world, task.over) for each in runs)
        rows = [self._row(due, world) for due, world in zip(runs, worlds, strict=True)]
        return self.message(kind, rows)

    def records_message(
        self, runs: Sequence[Recorded], order: Sequence[int] = ()
    ) -> dict[str, Any]:
        """The message to a player that plays these runs against recorded percepts."""
        rows = [self._row(each, playing.numbers_of(each.percepts), over=each.over) for each in runs]
        return self.message("record", rows, order)

    def _row(self, run: Due | Recorded, place: Any, *, over: bool = False) -> tuple[Any, ...]:
        """The row of a message for a run: where it is played, and what is said of it."""
        rules, world = self.rules, run.world
        told: Any = world.told
        if not (told is None or type(told) is int):  # marshal writes no other mapping
            told = dict(told)
        return place, told, over, rules.budget(world.map), name_run(rules, world), run.script

    def message(self, kind: str, rows: Any, order: Sequence[int] = ()) -> dict[str, Any]:
        """A message to a player: rows of a world or a record, and what is said of its run.

        Without an order they are played one after the other.
        """
        return {
            "kind": kind,
            "rows": rows,
            "runs": len(rows),
            "order": [*(order or range(len(rows)))],
            "policy": DEFAULT_POLICY if self.every else self.rules.policy,
            "every": self.every,
            "any_answer": not self.rules.task.is_map,
            "hear": False,
            "lines": False,
        }


def table_of(world: World) -> bytes | tuple[int, ...]:
    """The world as a table; see :class:`allworlds.protocol.playing.TableWorld`.

    Args:
        world: with a lighthouse that is static.
    """
    map_, numbers = world.map, list[int]()
    first = _vertex_by_vertex(map_, world.start)
    row = {dart: number for number, dart in enumerate(first)}
    for dart, begin in first.items():
        after, _ = world.step(State(dart), BACK)
        p = world.percepts[dart]
        bearing = 0 if p.bearing is None else p.bearing + 1
        numbers += (begin, row[after.dart], p.degree, p.marks, bearing)
    return playing.packed(numbers)


BACK = actions.Move(0)
"""The motion through the door by which the robot came."""


@lru_cache(1)
def _vertex_by_vertex(map_: CombinatorialMap, start: Dart) -> dict[Dart, int]:
    """The darts, from the start on; each with the place of the first one of its vertex.

    Those of each vertex stand one behind the other, clockwise.
    """
    first: dict[Dart, int] = {}
    for dart in (start, *map_.darts):
        begin, each = len(first), dart
        while each not in first:
            first[each] = begin
            each = map_.sigma[each]
    return first
