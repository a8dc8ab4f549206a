"""A lane: one judge with its two players, all of them at work at the same time.

    unit --> first player (in worlds) --> logs --> judge --> tally, findings
                                          second player (percepts only) --> the same logs?

The second player is another process with another hash seed; it plays what the judge has recorded,
in an order that is drawn, and holds no world.  Equal logs, or ``nondeterministic``.  If they
differ, both plays are repeated by fresh players, twice, in two orders, each under its own seed:
only if all are as before, the seeds explain it.  Python allows an explorer to go by the order of a
set of texts; it is right if it is right with each seed, and that it goes so is a remark.

A player that is lost is replaced, and its run tried once more alone; lost again, that is the
finding, and further losses count at once.  What a fresh player does not repeat refutes nothing.
"""

import time
from collections import Counter, deque
from collections.abc import Callable, Sequence
from functools import partial
from random import Random
from typing import Any, NamedTuple

from allworlds.documents.document import replace
from allworlds.engines import limits, tally, units
from allworlds.engines.across import OTHER_SEED, Across, At, FirstLog
from allworlds.engines.batch import FIRST, SECOND, Due, Recorded, RunBatch, Work
from allworlds.engines.judge import PythonJudge
from allworlds.engines.players import (
    Logs,
    Lost,
    PlayerHere,
    PlayerProcess,
    Setup,
    Unsettled,
    answered,
    lost_log,
    started,
    wait,
)
from allworlds.explorers.loading import Subject, is_program
from allworlds.judging.differences import difference_of, nondeterministic, overruled
from allworlds.judging.episode import fault_of
from allworlds.judging.referee import Outcome
from allworlds.log import Log

SIX_MORE = (OTHER_SEED, 3, 4, 5, 6, 7)
"""Other seeds under which some records of larger worlds are played."""

SMALL = 3
"""The largest m whose every log both judges read."""

KEPT = 64
"""The number of records of larger worlds that are played under six seeds more."""

DEPTH = 2
"""The batches that a player has: it begins the next one while its answer is judged."""

LEAST, MOST = 16, 256
"""The number of runs of a batch: at first, and at most."""

MOST_SETTLED = 16
"""The number of runs of a batch whose plays differ that are played anew."""

MOST_LOSSES = 20
"""The number of losses that are put down to the machine, if no fresh player repeats them."""

SILENT_RUNS, MOST_WAITED = 4, 60.0
"""The silent runs, and the seconds in them, after both of which no other run is waited for."""

GOES_BY_HASHES = "the explorer goes by hashes: where PYTHONHASHSEED is another one, so is its walk"
"""The remark on an explorer whose plays with one seed are always the same."""

OTHER_CHOICES = (
    "the choices of one schedule are not those of the next, as far as they are asked for"
)


PLAYED_ONCE_MORE = "when it was played once more, the walk or the answer was another"


class RunsToPlay(NamedTuple):
    """Runs of a batch that a player is to play, by their numbers there."""

    batch: RunBatch
    rows: Sequence[int]


class Lane:
    """A judge with its players.

    Args:
        subject: the explorer.
        counter: counts, and knows the scope.
        limits: of the time for an answer, and of memory.
        given: the choices of the only run, whose record is not played under other seeds; None for
            those that the scope asks for.
        seeds: the hash seeds of both players.
        first_lane: whether it is the one of all lanes that compiles, and that tries six seeds.

    Attributes:
        given_up: why too much is silent to go on; empty where it is not.
    """

    def __init__(
        self,
        subject: Subject,
        counter: tally.RunCounter,
        limits: limits.Limits,
        *,
        given: tuple[int, ...] | None = None,
        seeds: tuple[int, int] = (FIRST, SECOND),
        first_lane: bool = True,
    ) -> None:
        self.subject, self.counter = subject, counter
        self.judge = PythonJudge(counter, subject.name, given)
        self._setup = Setup(subject, limits)
        self._twice = subject.from_user
        self._apart = subject.from_user and subject.importable
        library = subject.compiled
        self._seeds = [seeds[0], seeds[0] if library or not self._apart else seeds[1]]
        self._players: dict[int, PlayerProcess | PlayerHere] = {}
        self._works: list[Work] = []
        self._waiting: deque[RunBatch] = deque()
        self._done: list[units.PartialResult] = []
        self._reported = time.monotonic()
        self._random = Random()  # noqa: S311  # from the system; no verdict depends on it
        self._size, self._losses, self._silences = LEAST, 0, 0
        self._repeated, self._unrepeated = set[str](), Counter[str]()
        # A program that is another one has a seed of its own, and a library has none.
        different = self._seeds == [FIRST, SECOND] and not is_program(subject.name)
        self._seeds_more = given is None and self._twice and different
        self._kept: list[tuple[RunBatch, int]] = []
        self._compiled: Any = None
        self._small: list[RunBatch] = []
        self._across: Across | None = None
        self._first_logs: dict[At, FirstLog] = {}
        self._first_lane, self._compiling = first_lane, False
        self._due = self._judged = self._settled_runs = 0
        self.given_up = ""

    # ---------------------------------------------------------------- units

    def offer(self, unit: units.UnitOfRuns) -> None:
        """Take a unit."""
        work = Work(unit, self.counter.tally())
        if isinstance(unit, units.AcrossUnit):
            work.open, seeds = 1, (FIRST, self._seeds[SECOND] and OTHER_SEED)
            self._across = Across(self._setup, self.judge, work, seeds)
            self._works.append(work)
            return
        work.batches = self._judge_of(unit).batches(work, lambda: self._size)
        self._works.append(work)

    def _judge_of(self, unit: units.UnitOfRuns) -> Any:
        """The judge in compiled code if the level is worth its loading, and it is compiled."""
        least = self.counter.compiled_from
        if least is None or not isinstance(unit, units.LevelUnit):
            return self.judge
        extent = self.counter.scope.extent
        following = min(unit.edges + 1, extent.levels[-1])  # it is kept for them, too
        if max(units.level_size(extent, edges) for edges in (unit.edges, following)) < least:
            return self.judge
        if self._compiled is None and (least == 0 or self._is_compiled()):
            from allworlds.engines.compiled_judge import CompiledJudge

            native = self.subject.compiled
            seed = partial(self._random.getrandbits, 63)
            self._compiled = CompiledJudge(self.judge, seed, native=native)
            self._compiled.compare_with(self._small)
            self._small.clear()
        return self._compiled or self.judge

    def _is_compiled(self) -> bool:
        """Whether compiled code is kept; if not, another process compiles, and this one goes on."""
        from allworlds.engines.compiled_engine import compile_apart, is_kept

        kept = is_kept()
        if not kept and self._first_lane and not self._compiling:
            self._compiling = True
            compile_apart()
        return kept

    @property
    def hungry(self) -> bool:
        """Whether another unit could be begun."""
        return len(self._works) < 2 * DEPTH and all(work.batches is None for work in self._works)

    @property
    def busy(self) -> bool:
        """Whether there is work."""
        return bool(self._works)

    @property
    def keeps(self) -> bool:
        """Whether there is something left to be played under other seeds."""
        return bool(self._kept) and self._seeds_more

    def turn(self, others: Sequence[int] = ()) -> list[units.PartialResult]:
        """Go on for a moment; return the parts of units that are done.

        Args:
            others: descriptors; the turn ends when something has come there.

        Raises:
            InputError: if the explorer cannot be loaded, or of a model of the user's.
            Unsettled: if processes are lost again and again, or too much is silent.
            HarnessError: if a player fails by our mistake.
        """
        if self.given_up:
            raise Unsettled(self.given_up)
        self._give()
        across = self._across.players if self._across else []
        if any(player.jobs for player in (*self._players.values(), *across)):
            wait([*self._players.values(), *across], limits.POLL, others)
            for which in (FIRST, SECOND):
                if which in self._players:
                    self._hear(which, self._players[which])
        if self._across and len(self._works) == 1:  # the units of the runs are done
            self._hear_across(self._across)
        self._hand_over()
        done, self._done = self._done, []
        return done

    def end(self) -> Any:
        """The tally of what other seeds show at the end, and of nothing else."""
        if not self._kept:
            return self.counter.tally()
        work = Work(self._kept[0][0].work.unit, self.counter.tally())
        runs = [batch.record(row) for batch, row in self._kept]
        for seed in SIX_MORE:
            order = self._random.sample(range(len(runs)), len(runs))
            logs, lost = self._anew_from(seed, self.judge.records_message(runs, order))
            if not lost:  # what is lost is tried in the other players, too
                self._compare_under(seed, self._kept, logs, work)
            if not self._seeds_more:
                break
        self._kept = []
        return work.tally

    def close(self) -> None:
        """End all players."""
        for player in self._players.values():
            player.close()
        self._players.clear()
        if self._across:
            self._across.close()

    def _hand_over(self) -> None:
        """Hand over the units that are done, and at intervals what was counted of the others."""
        late = bool(self.given_up) or time.monotonic() > self._reported + tally.REPORT_EVERY
        for work in [*self._works]:
            whole = work.batches is None and not work.more and not work.open
            if whole:
                self._works.remove(work)
                if not self._works and not self._due == self._judged == self._settled_runs:
                    raise RuntimeError("runs were left out")
                for due, cost in work.best.values():
                    self.counter.count_best(due.world, cost, work.tally)
            if whole or late:
                self._done.append(units.PartialResult(work.unit, work.tally, whole))
                work.tally = self.counter.tally()
                self._reported = time.monotonic()

    # ---------------------------------------------------------------- batches

    def _give(self) -> None:
        """Give the players what they have room for."""
        while self._room(FIRST) and (batch := self._next()):
            self._due += len(batch)
            self._play_first(batch)
        while self._waiting and self._room(SECOND):
            batch = self._waiting.popleft()
            # Of a run in which a player was lost there is nothing to compare.
            rows = [row for row in range(len(batch)) if row not in batch.lost]
            for row in batch.lost:
                batch.take(SECOND, [row], [batch.logs[FIRST][row]])
            if rows:
                self._player(SECOND).give(
                    RunsToPlay(batch, rows), self._message(SECOND, batch, rows)
                )
            else:
                self._played(SECOND, batch)

    def _play_first(self, batch: RunBatch) -> None:
        rows = range(len(batch))
        self._player(FIRST).give(RunsToPlay(batch, rows), batch.by.worlds(batch, rows))

    def _room(self, which: int) -> bool:
        return which not in self._players or len(self._players[which].jobs) < DEPTH

    def _next(self) -> RunBatch | None:
        """The next batch; None if there is none yet."""
        for work in self._works:
            batch: RunBatch | None = None
            if work.batches is not None:
                batch = next(work.batches, None)
                if batch is None:
                    work.batches = None
            if batch is None and work.more and (len(work.more) >= MOST or not work.open):
                some, work.more = work.more[:MOST], work.more[MOST:]
                batch = RunBatch(self.judge, work, some)
            if batch is not None:
                work.open += 1
                return batch
        return None

    def _player(self, which: int) -> PlayerProcess | PlayerHere:
        if which not in self._players:
            self._players[which] = started(self._setup, self._seeds[which], self._notice)
        return self._players[which]

    def _notice(self, event: str) -> None:
        """Count an event of a built-in explorer, in the batch that is being played."""
        job, _ = self._players[FIRST].jobs[0]
        job.batch.tally.witnesses[event] += 1

    def _hear(self, which: int, player: PlayerProcess | PlayerHere) -> None:
        began = time.monotonic()
        try:
            answers = player.heard()
        except Lost as lost:
            assert isinstance(player, PlayerProcess)
            self._lose(which, player, lost)
            return
        for job, logs in answers:
            if logs is None:
                job.batch.plain = True
                player.give(job, self._message(which, job.batch, job.rows))
                continue
            job.batch.take(which, job.rows, logs)
            self._played(which, job.batch)
        if answers and which == FIRST:
            slow = isinstance(player, PlayerHere) and time.monotonic() > began + tally.REPORT_EVERY
            self._size = max(1, self._size // 2) if slow else min(MOST, 2 * self._size)

    def _played(self, which: int, batch: RunBatch) -> None:
        """Go on with a batch of which one more play is whole, if it is."""
        if len(batch.logs[which]) < len(batch):
            return
        if which == FIRST:
            if not batch.by.judge(batch):  # Python plays them
                batch.plain = True
                batch.logs[FIRST] = {}
                self._play_first(batch)
                return
            self._judged += len(batch)
            self._remember(batch)
            if self._compiled is None and isinstance(batch.work.unit, units.LevelUnit):
                edges = batch.work.unit.edges
                self._small += [batch] if edges <= SMALL and self.counter.compiled_from else []
            batch.work.more += batch.follow_ups()
            if self._twice:
                self._waiting.append(batch)
                return
        self._settle(batch, self._differing(batch) if self._twice else [])
        self._settled_runs += len(batch)
        batch.work.tally.add(batch.tally)
        batch.work.open -= 1
        if self._twice and self._seeds_more:
            self._keep(batch)

    def _differing(self, batch: RunBatch) -> list[tuple[int, Log]]:
        """The runs whose logs differ, with the second ones."""
        found: list[tuple[int, Log]] = []
        first, again = batch.logs
        if isinstance(first, Logs) and isinstance(again, Logs) and first.message == again.message:
            return found
        for row in range(len(batch)):
            if first[row] != again[row]:
                second = Log(again[row])
                if self._differ(batch.outcome(row).log, second):
                    found.append((row, second))
        return found

    def _differ(self, one: Log, other: Log) -> bool:
        return difference_of(one, other, choices=self.judge.every) is not None

    # ---------------------------------------------------------------- what is wrong

    def _settle(self, batch: RunBatch, differing: Sequence[tuple[int, Log]]) -> None:
        """Find what is wrong with a batch."""
        outcomes = {row: self._in_words(batch, row) for row in batch.without_words}
        outcomes = {row: self._own(batch, row) for row in batch.broken} | outcomes
        if differing:
            outcomes |= self._explained(batch, batch.work, differing)
        for row, outcome in sorted(outcomes.items()):
            self._find(batch, batch.work, row, outcome)

    def _find(self, batch: RunBatch, work: Work, row: int, outcome: Outcome) -> None:
        due = batch.runs[row]
        self.counter.settle(self.judge.referee, due.world, due.place, outcome, work.tally)

    def _own(self, batch: RunBatch, row: int) -> Outcome:
        """The outcome of a run by its first play."""
        one = batch.outcome(row)
        if not one.fits:
            return replace(one.outcome, violation=nondeterministic(OTHER_CHOICES))
        return one.outcome

    def _in_words(self, batch: RunBatch, row: int) -> Outcome:
        """The outcome of a run whose log compiled code has written, by a play in Python."""
        before, batch.plain = batch.outcome(row), True
        (log,), _ = self._anew_from(self._seeds[FIRST], batch.by.worlds(batch, [row]))
        one = self.judge.judged(batch.runs[row], log)
        if not self._differ(before.log, one.log):
            return one.outcome
        return replace(one.outcome, violation=nondeterministic(PLAYED_ONCE_MORE))

    def _explained(
        self, batch: RunBatch, work: Work, differing: Sequence[tuple[int, Log]]
    ) -> dict[int, Outcome]:
        """The outcomes of runs whose plays differ."""
        few, (first, second) = differing[:MOST_SETTLED], self._seeds
        rows = [row for row, _ in few]
        orders = rows, rows[::-1]
        firsts = [self._fresh(first, partial(batch.by.worlds, batch), order) for order in orders]
        seconds = [self._fresh(second, partial(batch.by.records, batch), order) for order in orders]
        before = {row: batch.outcome(row).log for row in rows}
        if first != second and not any(
            self._differ(old, play[row])
            for row, other in few
            for old, plays in ((before[row], firsts), (other, seconds))
            for play in plays
        ):
            return self._by_seed(batch, work, [row for row, _ in differing])
        found = {}
        for row, other in few:
            one, anew = batch.outcome(row), None
            faults = fault_of(one.log), fault_of(other)
            if any(fault and fault.machine for fault in faults):  # it may be the machine's
                anew = self._alike(batch, work, row, other)
            found[row] = anew or overruled(one.outcome, one.log, other, choices=self.judge.every)
        return found

    def _alike(self, batch: RunBatch, work: Work, row: int, other: Log) -> Outcome | None:
        """The outcome of a run by two later plays of it alone; None if they are not alike.

        What has happened once, and in no fresh process, refutes nothing.  The second play has the
        record of the later one: that of the run may be too short.
        """
        due, one = batch.runs[row], batch.outcome(row).log
        log = self._fresh(self._seeds[FIRST], partial(batch.by.worlds, batch), [row])[row]
        anew = self._anew(due, log)
        message = self.judge.records_message([Recorded.of(due, anew.episode)])
        if self._differ(log, self._fresh(self._seeds[SECOND], lambda _: message, [row])[row]):
            return None
        fault = fault_of(one if self._differ(one, log) else other)
        ended = fault.seen if fault else "it ended with an answer"
        work.tally.remark(f"a run ended otherwise when it was tried again; at first: {ended}")
        return anew

    def _anew(self, due: Due, log: Log) -> Outcome:
        episode = self.judge.episode(due.world, log)
        return self.judge.referee.outcome(due.world, episode, tuple(log.choices))

    def _by_seed(self, batch: RunBatch, work: Work, rows: list[int]) -> dict[int, Outcome]:
        """The outcomes of runs of an explorer that goes by hashes, in their worlds by each seed."""
        work.tally.remark(GOES_BY_HASHES)
        first, second = self._seeds
        found = {row: self._own(batch, row) for row in rows}
        found = {row: replace(out, hash_seed=first) for row, out in found.items() if out.violation}
        for row, log in self._fresh(second, partial(batch.by.worlds, batch), rows).items():
            other = self._anew(batch.runs[row], log)
            if other.violation is not None and row not in found:
                found[row] = replace(other, hash_seed=second)
        return found

    def _fresh(
        self, seed: int, message: Callable[[Sequence[int]], dict[str, Any]], rows: Sequence[int]
    ) -> dict[int, Log]:
        """The logs of these runs by a fresh player; each alone if it is lost over them."""
        logs, lost = self._anew_from(seed, message(rows))
        if lost and len(rows) > 1:
            return {row: self._fresh(seed, message, [row])[row] for row in rows}
        return dict(zip(rows, map(Log, logs), strict=True))

    def _anew_from(self, seed: int, message: dict[str, Any]) -> tuple[Sequence[bytes], Lost | None]:
        """The logs of a fresh player, and its loss, whose log is then the only one."""
        player = started(self._setup, seed)
        try:
            return answered(player, message | {"hear": message["runs"] == 1}), None
        except Lost as lost:
            return [lost_log(bytes(player.part), lost)], lost
        finally:
            player.close()

    # ---------------------------------------------------------------- other seeds

    def _keep(self, batch: RunBatch) -> None:
        """Keep some records of large worlds."""
        edges, last = batch.runs[0].world.map.edge_count, self.counter.scope.extent.levels[-1]
        if edges > SMALL and edges == last and self._first_lane:
            rows = [(batch, row) for row in range(len(batch))]
            self._kept += rows[: KEPT - len(self._kept)]

    def _compare_under(
        self, seed: int, rows: Sequence[tuple[RunBatch, int]], logs: Sequence[bytes], work: Work
    ) -> None:
        """Find what differs under another seed; then no more are tried."""
        for (batch, row), log in zip(rows, logs, strict=True):
            second = Log(log)
            if self._differ(batch.outcome(row).log, second):
                self._explain_under(seed, batch, work, [(row, second)])
                self._seeds_more = False
                return

    def _explain_under(
        self, seed: int, batch: RunBatch, work: Work, differing: Sequence[tuple[int, Log]]
    ) -> None:
        """Find what is wrong with runs whose second logs, under this seed, differ."""
        usual, self._seeds = self._seeds, [self._seeds[FIRST], seed]
        for row, outcome in self._explained(batch, work, differing).items():
            self._find(batch, work, row, outcome)
        self._seeds = usual

    # ---------------------------------------------------------------- across units

    def _remember(self, batch: RunBatch) -> None:
        """Remember the logs in small worlds, in the order in which they were played."""
        unit, logs, broken = batch.work.unit, batch.logs[FIRST], {*batch.broken}
        if not isinstance(unit, units.LevelUnit | units.GivenUnit):
            return
        if batch.plain and unit.edges <= units.ACROSS:  # a library draws the order
            for row, due in enumerate(batch.runs):
                one = FirstLog(due, logs[row], right=row not in broken)
                self._first_logs.setdefault((due.world.map, due.place), one)

    def _hear_across(self, across: Across) -> None:
        """Hear all runs that are played in both orders; settle them when they are whole.

        If a loss was repeated, the explorer is refuted, and would be lost in these plays, too.
        """
        if not (across.begun or self._repeated):
            across.begin(self._first_logs)
        elif self._repeated or across.hear(self._note):
            across.close()
            across.settle()
            for row, outcome in across.found.items():
                self._find(across.batch, across.work, row, outcome)
            if across.odd:
                seed = self._seeds[SECOND] and OTHER_SEED
                self._explain_under(seed, across.batch, across.work, across.odd)
            across.work.open, self._across = 0, None

    # ---------------------------------------------------------------- losses

    def _lose(self, which: int, player: PlayerProcess, lost: Lost) -> None:
        """Go on after the loss of a player: its run is tried once more alone."""
        if which == FIRST:
            self._first_logs.clear()  # they are of several processes
        if player.jobs and player.description is not None:
            job, _ = player.jobs[0]
            number = player.beat[0]
            if 0 <= number < len(job.rows):
                batch, row = job.batch, job.rows[number]
                log = self._alone(which, batch, row, lost)
                batch.take(which, [row], [log])
                waited = self._silences * self._setup.limits.answer_timeout
                if self._silences >= SILENT_RUNS and waited >= MOST_WAITED:
                    self._give_up(which, batch)
                    return
                rest = [each for each in job.rows if each not in batch.logs[which]]
                if rest:
                    player.jobs[0] = (RunsToPlay(batch, rest), self._message(which, batch, rest))
                else:
                    player.jobs.popleft()
                player.again()
                self._played(which, batch)
                return
            self._note(job.batch.work, lost)
        player.again()

    def _give_up(self, which: int, batch: RunBatch) -> None:
        """Find what is wrong with the runs of a batch that is not finished; nothing is counted."""
        for row in batch.lost:
            one = self.judge.judged(batch.runs[row], batch.logs[FIRST][row])
            second = Log(batch.logs[which][row])
            outcome = overruled(one.outcome, one.log, second, choices=self.judge.every)
            self._find(batch, batch.work, row, outcome)
        self.given_up = (
            f"the explorer was silent in {self._silences} runs, for "
            f"{self._setup.limits.answer_timeout:g} s each, and the other runs would take too long"
        )

    def _message(self, which: int, batch: RunBatch, rows: Sequence[int]) -> dict[str, Any]:
        if which == FIRST:
            return batch.by.worlds(batch, rows)
        order = self._random.sample(range(len(rows)), len(rows))
        if self._random.getrandbits(1):  # who counts runs does not know which comes
            order.insert(self._random.randrange(len(order)), self._random.choice(order))
        return batch.by.records(batch, rows, order)

    def _alone(self, which: int, batch: RunBatch, row: int, lost: Lost) -> bytes:
        """The log of a run in which a player was lost, by a fresh player that plays it alone."""
        if lost.law == "timeout":
            self._silences += 1
        if lost.law in self._repeated:
            batch.lost.add(row)
            return lost_log(b"", lost)
        message = (
            batch.by.worlds(batch, [row]) if which == FIRST else batch.by.records(batch, [row])
        )
        (log,), again = self._anew_from(self._seeds[which], message)
        if again:
            self._repeated.add(again.law)
            batch.lost.add(row)
            return log
        self._unrepeated[lost.law] += 1
        if not lost.machine or (lost.law == "timeout" and self._unrepeated["timeout"] > 1):
            batch.lost.add(row)
            after = " when it was played after others; by itself it was not"
            return lost_log(b"", Lost(lost.law, lost.seen + after, machine=False))
        self._note(batch.work, lost)
        return log

    def _note(self, work: Work, lost: Lost) -> None:
        """Remark on a loss that a fresh process has not repeated: it refutes nothing.

        Raises:
            Unsettled: if there are too many of them.
        """
        work.tally.remark(
            f"a player was lost ({lost.seen}), and a fresh one was not: no refutation"
        )
        self._losses += 1
        if self._losses > MOST_LOSSES:
            raise Unsettled(
                f"{self._losses} players were lost, the last by {lost.seen}, and each time a fresh "
                "one was not"
            )
