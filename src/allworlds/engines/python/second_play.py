"""Every run of a user's explorer played twice: in worlds, and against the recorded percepts.

The second play is not in the order of the first, and, where the explorer can be played in other
processes, not in the process of the first nor in one that holds any world.  An explorer that
keeps a memory from one run to the next, or reads more than its percepts, plays differently the
second time.  The orders are drawn anew for each check.

A player's messages are believed of its runs alone.  The referee knows by itself which runs and
which choices are due, and that none is left out; the second play gets the choices that were due,
and not those that the first play reported.

Where the second player has another hash seed than the first, plays that differ are repeated with
each seed in a fresh process.  If each gives the same plays again, the seeds explain the difference:
Python allows an explorer to go by the order of a set of strings.  It is right if it is right with
each seed, so runs whose plays differ are also played in their worlds with the other one.

A failure that the machine may have caused is tried once more in fresh processes before it is
believed: a run that has killed its process, or that crashed, or was silent, in one of its plays
alone.

An explorer that is silent only after other runs, and was so again, would be silent in each process
after some runs, and each silence takes the whole time-out.  So its unit, and with it the job, ends
with that finding.  So it does when silences have taken :data:`MOST_WAITED`: a level in which most
runs are silent would take hours, and tell nothing more.

:class:`PlayedTwice` alone decides what two plays that differ mean.  The compiled engine
(:mod:`allworlds.engines.compiled.stretches`) compares whole stretches byte by byte, and gives the
runs that differ, or break a law, to it; it orders its own second plays
(:mod:`allworlds.engines.isolation.shared_logs`).
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import islice
from typing import NamedTuple

from allworlds.document import replace
from allworlds.engines.isolation.failures import Unsettled
from allworlds.engines.python.comparison import (
    difference_of,
    differing_or_first,
    ending_in_words,
    may_be_the_machine,
    nondeterministic,
    overruled,
)
from allworlds.engines.python.examiner import Outcome, Referee, name_run
from allworlds.engines.python.play import Record
from allworlds.engines.python.players import (
    GOES_BY_HASHES,
    OTHER_SEED,
    OneRun,
    Players,
    ScriptTracker,
    placed_run,
)
from allworlds.engines.python.run_counter import REPORT_EVERY, RunCounter
from allworlds.engines.python.runs_of_unit import NumberedRun, UnitOfRuns
from allworlds.engines.python.tally import Tally
from allworlds.judging import Episode, Fault, Finding, Log, LostRun, Over, retold
from allworlds.protocol import DEFAULT_POLICY
from allworlds.world import IllegalAction

FEW, MANY = 16, 1024
"""The least and the greatest number of runs among which the order is drawn."""

ENOUGH = 8
"""The number of plays that do not agree by chance: a few runs are played more than once, at the
beginning of a check, and to tell whether seeds explain a difference."""

MOST_WAITED, WAITS = 60.0, 2
"""The seconds after which silent runs have taken too long, and how often each is waited for; the
first silent run alone never takes too long."""

OTHER_CHOICES = (
    "the choices of one schedule are not those of the next, as far as they are asked for"
)


class _Play(NamedTuple):
    """A first play, walked anew in its world, with the record by which it is played again.

    ``fits``: whether it made the choices that were due.
    """

    one: OneRun
    log: Log
    episode: Episode
    record: Record
    fits: bool


class _Unlike(NamedTuple):
    """A first play with hash seed 0, its outcome, and a second play that differs."""

    play: _Play
    outcome: Outcome
    second: Log


@dataclass(slots=True)
class PlayedTwice:
    """The engine with a user's explorer, which plays each run twice.

    Attributes:
        engine: the scope, with its rules.
        explorer: its name.
        players: its players.
        given_up: why too much is silent to go on; empty where it is not.
        goes_by_hashes: whether seeds explain that plays differ; None: none has differed yet.
    """

    engine: RunCounter
    explorer: str
    players: Players
    given_up: str = field(default="", init=False)
    goes_by_hashes: bool | None = field(default=None, init=False)
    _silences: int = 0
    _window: int = FEW
    _repeated: int = ENOUGH
    _referee: Referee = field(init=False)

    def __post_init__(self) -> None:
        self._referee = Referee(self.explorer, self.engine.scope.rules)

    def parts(self, unit: UnitOfRuns, start: int = 0) -> Iterator[tuple[int, Tally]]:
        """Yield the number of the next run and the tally since, after some runs and at the end."""
        runs = self.engine.runs(unit, start)
        after = start
        while window := list(islice(runs, self._window)):
            began = time.monotonic()
            yield (after := window[-1].number + 1), self.tally(unit, window)
            yield from self.ended_if_given_up(after)
            slow = time.monotonic() - began > REPORT_EVERY / 2
            self._window = max(FEW, self._window // 2) if slow else min(MANY, self._window * 2)
        if after == start:
            yield after, self.engine.tally()

    def ended_if_given_up(self, after: int) -> Iterator[tuple[int, Tally]]:
        """Yield an empty part and raise Unsettled if too much is silent to go on.

        The part before is handed over when there is another one.
        """
        if self.given_up:
            yield after, self.engine.tally()
            raise Unsettled(self.given_up)

    def tally(self, unit: UnitOfRuns, window: Sequence[NumberedRun]) -> Tally:
        """The tally of these runs of a unit; without the rest, if too much is silent to go on."""
        tally = self.engine.tally()
        placed, best = {}, dict[int, int]()
        for run in window:
            world = self.engine.count_run(run, tally)
            if world is not None:
                placed[run.number] = OneRun(run.number, run.place, world)

        def matters(one: OneRun) -> bool:
            return tally.wants(one.world.map.edge_count, one.world.map.vertex_count)

        for one, outcome in self.outcomes(unit, placed, matters, tally.remark):
            if isinstance(outcome, Outcome) and not outcome.hash_seed:
                self.engine.count_outcome(self._referee, one.world, one.place, outcome, tally)
                best[one.number] = min(outcome.cost, best.get(one.number, outcome.cost))
            elif matters(one):
                tally.find(self.finding(one, outcome))
            if isinstance(outcome, LostRun) and outcome.law == "timeout" and not outcome.machine:
                self.given_up = f"the explorer keeps a state: {outcome.seen}"
                break
        for number, cost in best.items():
            self.engine.count_best(placed[number].world, cost, tally)
        return tally

    def outcomes(
        self,
        unit: UnitOfRuns,
        placed: Mapping[int, OneRun],
        matters: Callable[[OneRun], bool] = lambda _: True,
        remark: Callable[[str], None] = lambda _: None,
        given: tuple[int, ...] | None = None,
    ) -> Iterator[tuple[OneRun, Outcome | LostRun]]:
        """The outcomes of these runs of a unit, in any order.

        Those that are wrong with another hash seed alone come besides, and last.

        Args:
            unit: the unit.
            placed: the runs, by their numbers.
            matters: whether a run is worth another try in fresh processes.
            remark: takes the text of an event that refutes nothing.
            given: the script of the choices; None for every schedule that the scope asks for.
        """
        scripts = ScriptTracker(self._every and given is None, dict.fromkeys(placed, given or ()))
        doubtful: list[_Play] = []
        unlike: list[_Unlike] = []
        for logs in self.players.play_runs(self.engine, unit, [*placed], given):
            whole = []
            for number, log in logs:
                script, fits = scripts.take(number, log)
                self._silences += _is_silent(log)
                if isinstance(log.ending, LostRun):
                    yield placed[number], log.ending
                else:
                    whole.append(self._play(placed[number], log, script, fits))
            due = [play.record for play in whole] * self._rounds(whole)
            self.players.send_records(due, self._policy)
            # Judged while they are played once more.
            outcomes = [
                self._referee.outcome(play.one.world, play.episode, play.log.choices)
                for play in whole
            ]
            again = self.players.receive_logs()
            for place, (play, outcome) in enumerate(zip(whole, outcomes, strict=True)):
                second = differing_or_first(play.log, again[place :: len(whole)])
                if not play.fits:
                    yield play.one, replace(outcome, violation=nondeterministic(OTHER_CHOICES))
                elif may_be_the_machine(play.log, second) and matters(play.one):
                    doubtful.append(play)
                elif self._may_go_by_seed and difference_of(play.log, second):
                    unlike.append(_Unlike(play, outcome, second))
                else:
                    yield play.one, self._seeded(overruled(outcome, play.log, second))
            if self._waited_enough():
                break
        else:
            scripts.finish()
        # The players are at rest: now they may be ended.
        yield from self._settle(unit, doubtful, remark)
        if unlike:
            yield from self._by_seed(unit, unlike, remark, given)

    def _rounds(self, plays: Sequence[_Play]) -> int:
        """How often each of these is played again; once if one is silent, which takes long."""
        if not plays or any(isinstance(play.log.ending, Fault) for play in plays):
            return 1
        rounds = max(1, self._repeated // len(plays))
        self._repeated -= rounds * len(plays)
        return rounds

    def _seeds_explain(self, unlike: list[_Unlike]) -> bool:
        """Whether each seed gives the same plays as before, in fresh processes."""
        usual, plays = self.players.seeds, unlike * -(-ENOUGH // len(unlike))
        records = [each.play.record for each in plays]

        def repeats(seed: int, before: Iterable[Log]) -> bool:
            self.players.seeds = seed, seed
            self.players.send_records(records, self._policy)
            return not any(map(difference_of, before, self.players.receive_logs()))

        self.players.restart()
        explained = repeats(0, [each.play.log for each in plays])
        explained = explained and repeats(OTHER_SEED, [each.second for each in plays])
        self.players.restart()
        self.players.seeds = usual
        return explained

    def _by_seed(
        self,
        unit: UnitOfRuns,
        unlike: list[_Unlike],
        remark: Callable[[str], None],
        given: tuple[int, ...] | None,
    ) -> Iterator[tuple[OneRun, Outcome | LostRun]]:
        """The outcomes of runs whose two plays differ, where the players had different seeds.

        If the seeds explain it, these are those with seed 0, and all wrong ones with the other.
        """
        if self.goes_by_hashes is None:
            self.goes_by_hashes = self._seeds_explain(unlike)
        if not self.goes_by_hashes:
            for each in unlike:
                yield each.play.one, overruled(each.outcome, each.play.log, each.second)
            return
        remark(GOES_BY_HASHES)
        for each in unlike:
            wrong = each.outcome.violation is not None
            yield each.play.one, replace(each.outcome, hash_seed=0) if wrong else each.outcome
        runs = sorted((each.play.one for each in unlike), key=lambda one: one.number)
        placed = {one.number: one for one in runs}
        usual, self.players.seeds = self.players.seeds, (OTHER_SEED, OTHER_SEED)
        try:
            for one, outcome in self.outcomes(unit, placed, remark=remark, given=given):
                if isinstance(outcome, LostRun):
                    yield one, outcome
                elif outcome.violation is not None:
                    yield one, replace(outcome, hash_seed=OTHER_SEED)
        finally:
            self.players.seeds = usual

    def _waited_enough(self) -> bool:
        """Give the unit up if silences have taken too long; return whether they have."""
        each = self.players.answer_timeout
        if self._silences < 2 or self._silences * WAITS * each < MOST_WAITED:
            return False
        told = f"the explorer was silent in {self._silences} runs, for {each:g} s each"
        self.given_up = f"{told}, and the other runs would take too long"
        return True

    def _settle(
        self, unit: UnitOfRuns, doubtful: Iterable[_Play], remark: Callable[[str], None]
    ) -> Iterator[tuple[OneRun, Outcome | LostRun]]:
        """The outcomes of runs that are tried once more; of a unit that is given up one silence."""
        for play in doubtful:
            outcome = self._once_more(unit, play, remark)
            yield play.one, outcome
            if not _is_silent(play.log):
                continue
            if _law_of(outcome) != "timeout":
                self._silences -= 1
            elif self.given_up:
                return

    def played_once(
        self, unit: UnitOfRuns, runs: Sequence[NumberedRun]
    ) -> Iterator[tuple[OneRun, Outcome | LostRun]]:
        """The outcomes of these runs of a unit by their first play alone, in any order."""
        placed = {run.number: placed_run(run) for run in runs if run.lighthouse}
        scripts = ScriptTracker(self._every, dict.fromkeys(placed, ()))
        for logs in self.players.play_runs(self.engine, unit, [*placed]):
            for number, log in logs:
                script, fits = scripts.take(number, log)
                if isinstance(log.ending, LostRun):
                    yield placed[number], log.ending
                    continue
                play = self._play(placed[number], log, script, fits)
                outcome = self._referee.outcome(play.one.world, play.episode, log.choices)
                if not fits:
                    outcome = replace(outcome, violation=nondeterministic(OTHER_CHOICES))
                yield play.one, outcome
        scripts.finish()

    def finding(self, one: OneRun, outcome: Outcome | LostRun) -> Finding:
        """The finding of a run that breaks a law, or that was lost."""
        if isinstance(outcome, Outcome):
            return self._referee.finding(one.world, one.place, outcome)
        lost = self._referee.lost(one.world, one.place, outcome)
        return replace(lost, hash_seed=self._hash_seed)

    def _script(self, play: _Play) -> tuple[int, ...]:
        """The script of a play: all of its choices if every schedule is due, else the given ones.

        A player with a script lets the rules' policy answer all later choices.
        """
        return play.log.choices if self._every else play.record.choices

    @property
    def _hash_seed(self) -> int | None:
        """The seed of both players, if they have one; else None."""
        first, second = self.players.seeds
        return first if first == second else None

    @property
    def _may_go_by_seed(self) -> bool:
        """Whether a difference of two plays may be one of their hash seeds."""
        first, second = self.players.seeds
        return first != second and self.goes_by_hashes is not False

    def _seeded(self, outcome: Outcome) -> Outcome:
        """The outcome with the hash seed, if it makes a difference."""
        broken = outcome.violation
        if broken is None or broken.law == "nondeterministic":
            return outcome
        return replace(outcome, hash_seed=self._hash_seed)

    @property
    def _every(self) -> bool:
        return self.engine.scope.schedules == "all"

    @property
    def _policy(self) -> str:
        """The policy that answers the choices that no script answers."""
        return DEFAULT_POLICY if self._every else self.engine.scope.rules.policy

    def _play(self, one: OneRun, log: Log, script: tuple[int, ...], fits: bool = True) -> _Play:
        rules, world = self.engine.scope.rules, one.world
        try:
            episode = retold(log, world)
        except IllegalAction as error:
            raise RuntimeError(f"the log of a run is no walk in its world: {error}") from error
        record = Record(
            tuple(episode.transcript.percepts),
            world.told,
            script,
            rules.budget(world.map),
            name_run(rules, world),
            any_answer=not rules.task.is_map,
            over=isinstance(log.ending, Over),
        )
        return _Play(one, log, episode, record, fits)

    def _once_more(
        self, unit: UnitOfRuns, before: _Play, remark: Callable[[str], None]
    ) -> Outcome | LostRun:
        """The outcome of the run played anew, both times in fresh processes."""
        one, script = before.one, self._script(before)
        self.players.restart()
        (((_, log),),) = self.players.play_runs(self.engine, unit, [one.number], script)
        if isinstance(log.ending, LostRun):
            return log.ending
        play = self._play(one, log, script)
        self.players.send_records([play.record], self._policy)
        (second,) = self.players.receive_logs()
        if not may_be_the_machine(log, second) and log.ending != before.log.ending:
            ended = ending_in_words(before.log)
            remark(f"a run ended otherwise when it was tried again; at first: {ended}")
        outcome = self._referee.outcome(one.world, play.episode, log.choices)
        return overruled(outcome, log, second)


def _is_silent(log: Log) -> bool:
    return isinstance(log.ending, Fault) and log.ending.law == "timeout"


def _law_of(outcome: Outcome | LostRun) -> str:
    if isinstance(outcome, LostRun):
        return outcome.law
    return outcome.violation.law if outcome.violation else ""
