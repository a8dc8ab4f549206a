"""Every run of a user's explorer played twice: in worlds, and against the recorded percepts.

The second play is not in the order of the first, and, where the explorer can be played in other
processes, not in the process of the first nor in one that holds any world.  An explorer that
keeps a memory from one run to the next, or reads more than its percepts, plays differently the
second time.  The orders are drawn anew for each check, and among the second plays are
some of worlds that came long before, so that only its percepts tell an explorer which world it
is in.

A player's messages are believed of its runs alone.  The referee knows by itself which runs and
which choices are due, and that none is left out; the second play gets the choices that were due,
and not those that the first play reported.

Where the second player has another hash seed than the first, plays that differ are repeated with
either seed (:mod:`allworlds.engines.python.hash_seeds`).  If that explains the difference, the
explorer goes by hashes, and is right if it is right with each seed.

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
from allworlds.engines.python.earlier_plays import BEGINNING, FEW, EarlierPlays
from allworlds.engines.python.examiner import Outcome, Referee, name_run
from allworlds.engines.python.hash_seeds import (
    GOES_BY_HASHES,
    GoesByHashes,
    SeededPlays,
    seeds_explain,
)
from allworlds.engines.python.play import Record
from allworlds.engines.python.players import OneRun, Players, ScriptTracker, placed_run
from allworlds.engines.python.run_counter import REPORT_EVERY, RunCounter
from allworlds.engines.python.runs_of_unit import GivenWorlds, NumberedRun, UnitOfRuns
from allworlds.engines.python.tally import Tally
from allworlds.explorers import is_library
from allworlds.judging import Episode, Fault, Finding, Log, LostRun, Over, retold
from allworlds.protocol import DEFAULT_POLICY
from allworlds.world import IllegalAction

MANY = 1024
"""The greatest number of runs among which the order is drawn."""

ENOUGH = 32
"""The number of second plays that catches an explorer which goes by their number."""

PLAYS = 3
"""The largest number of plays of a run, on the average; those that are repeated where something
was wrong are not counted."""

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


class _Due(NamedTuple):
    """Plays that have been sent to the second player.

    ``plays``: their number; ``order``: of their plays, by index; ``earlier``: those behind them.
    """

    plays: int
    order: list[int]
    earlier: list[_Play]


class _Unlike(NamedTuple):
    """A first play with hash seed 0, a second one that differs, and the second one's hash seed.

    ``belated``: whether the first play has been counted before.
    """

    play: _Play
    second: Log
    seed: int
    outcome: Outcome
    belated: bool = False


@dataclass(slots=True)
class PlayedTwice:
    """The engine with a user's explorer, which plays each run twice.

    Attributes:
        engine: the scope, with its rules.
        explorer: its name.
        players: its players.
        earlier: plays that are played again among later ones.
        alone: whether there is this one run alone; else an explorer that goes by hashes raises
            :class:`GoesByHashes`.
        given_up: why too much is silent to go on; empty where it is not.
    """

    engine: RunCounter
    explorer: str
    players: Players
    earlier: EarlierPlays[_Play] = field(default_factory=EarlierPlays)
    alone: bool = False
    _belated: list[tuple[OneRun, Outcome | LostRun]] = field(default_factory=list)
    given_up: str = field(default="", init=False)
    _silences: int = 0
    _window: int = FEW
    _again: int = 0
    _seeds_explain: bool = True
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
            if isinstance(outcome, Outcome):
                self.engine.count_outcome(self._referee, one.world, one.place, outcome, tally)
                best[one.number] = min(outcome.cost, best.get(one.number, outcome.cost))
            elif matters(one):
                tally.find(self.finding(one, outcome))
            if isinstance(outcome, LostRun) and outcome.law == "timeout" and not outcome.machine:
                self.given_up = f"the explorer keeps a state: {outcome.seen}"
                break
        for number, cost in best.items():
            self.engine.count_best(placed[number].world, cost, tally)
        for one, outcome in self._belated:
            if matters(one):
                tally.find(self.finding(one, outcome))
        self._belated.clear()
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
            due = self._send(whole)
            # Judged while they are played once more.
            outcomes = [
                self._referee.outcome(play.one.world, play.episode, play.log.choices)
                for play in whole
            ]
            seconds = self._receive(due, unlike)
            seed = self.players.tour.turn
            for play, outcome, again in zip(whole, outcomes, seconds, strict=True):
                second = differing_or_first(play.log, again)
                if not play.fits:
                    yield play.one, replace(outcome, violation=nondeterministic(OTHER_CHOICES))
                elif may_be_the_machine(play.log, second) and matters(play.one):
                    doubtful.append(play)
                elif self._may_go_by_seed and difference_of(play.log, second):
                    unlike.append(_Unlike(play, second, seed, outcome))
                else:
                    settled = overruled(outcome, play.log, second)
                    if settled.violation is None:
                        self.earlier.keep(play)
                    yield play.one, self._seeded(settled)
            if self._waited_enough():
                break
        else:
            scripts.finish()
        # The players are at rest: now they may be ended.
        yield from self._settle(unit, doubtful, remark)
        if unlike:
            yield from self._by_seed(unlike, remark)

    def _send(self, plays: list[_Play]) -> _Due:
        """Send these plays to the second player, some of them more than once, and earlier ones."""
        self.earlier.spare += (PLAYS - 2) * len(plays)
        earlier = self.earlier.draw_for(len(plays))
        # A run that ended in a fault is played again once: a silence is not waited out often.
        lively = [i for i, play in enumerate(plays) if not isinstance(play.log.ending, Fault)]
        rounds = self._rounds(len(lively), len(earlier))
        self.earlier.spare -= len(earlier) + (rounds - 1) * len(lively)
        order = [*range(len(plays)), *lively * (rounds - 1)]
        due = [*(plays[i] for i in order), *earlier]
        self.players.send_records([play.record for play in due], self._policy)
        return _Due(len(plays), order, earlier)

    def _receive(self, due: _Due, unlike: list[_Unlike]) -> list[list[Log]]:
        """The logs of each play that was sent; earlier plays that differ now are noted."""
        logs = self.players.receive_logs()
        self._look_back(due.earlier, logs[len(due.order) :], unlike)
        seconds: list[list[Log]] = [[] for _ in range(due.plays)]
        for i, log in zip(due.order, logs, strict=False):
            seconds[i].append(log)
        return seconds

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
        return replace(lost, hash_seed=self.players.tour.hash_seed)

    def _by_seed(
        self, unlike: list[_Unlike], remark: Callable[[str], None]
    ) -> Iterator[tuple[OneRun, Outcome | LostRun]]:
        """The outcomes of runs whose two plays differ, where the players had different seeds.

        Raises:
            GoesByHashes: if the seeds explain it, and there are more runs than this one.
        """
        seed = unlike[0].seed
        known = [
            SeededPlays(one.play.record, one.play.log, one.second)
            for one in unlike
            if one.seed == seed
        ]
        self._seeds_explain = seeds_explain(self.players, seed, known, self._policy)
        if self._seeds_explain and not self.alone:
            raise GoesByHashes(self.explorer)
        self.players.take_places(0, seed, alike=False)
        for each in unlike:
            settled: Outcome | LostRun
            if not self._seeds_explain:
                settled = overruled(each.outcome, each.play.log, each.second)
            elif each.outcome.violation is not None:
                settled = replace(each.outcome, hash_seed=0)
            else:
                settled = self._with_seed(each, remark)
            if not each.belated:
                yield each.play.one, settled
            elif isinstance(settled, LostRun) or settled.violation is not None:
                self._belated.append((each.play.one, settled))

    def _with_seed(self, unlike: _Unlike, remark: Callable[[str], None]) -> Outcome | LostRun:
        """The outcome of a run with the other seed if it is wrong, or else that with seed 0."""
        remark(GOES_BY_HASHES)
        self.players.take_places(unlike.seed, 1, alike=True)
        unit, one = _by_itself(unlike.play.one)
        given = self._script(unlike.play)
        ((_, outcome),) = self.outcomes(unit, {one.number: one}, remark=remark, given=given)
        wrong = isinstance(outcome, LostRun) or outcome.violation
        return outcome if wrong else unlike.outcome

    def _script(self, play: _Play) -> tuple[int, ...]:
        """The script of a play: all of its choices if every schedule is due, else the given ones.

        A player with a script lets the rules' policy answer all later choices.
        """
        return play.log.choices if self._every else play.record.choices

    @property
    def _may_go_by_seed(self) -> bool:
        """Whether a difference of two plays may be one of their hash seeds: C has none."""
        differ = self.players.tour.differ and not is_library(self.explorer)
        return differ and self._seeds_explain

    def _seeded(self, outcome: Outcome) -> Outcome:
        """The outcome with the hash seed, if it makes a difference."""
        broken = outcome.violation
        if broken is None or broken.law == "nondeterministic":
            return outcome
        return replace(outcome, hash_seed=self.players.tour.hash_seed)

    @property
    def _every(self) -> bool:
        return self.engine.scope.schedules == "all"

    @property
    def _policy(self) -> str:
        """The policy that answers the choices that no script answers."""
        return DEFAULT_POLICY if self._every else self.engine.scope.rules.policy

    def _look_back(self, plays: list[_Play], again: list[Log], unlike: list[_Unlike]) -> None:
        """Note the earlier plays that differ now, unless the machine may be the cause."""
        for play, log in zip(plays, again, strict=True):
            if difference_of(play.log, log) and not may_be_the_machine(play.log, log):
                outcome = self._referee.outcome(play.one.world, play.episode, play.log.choices)
                if self._may_go_by_seed:
                    seed = self.players.tour.turn
                    unlike.append(_Unlike(play, log, seed, outcome, belated=True))
                else:
                    self._belated.append((play.one, overruled(outcome, play.log, log)))

    def _rounds(self, records: int, others: int) -> int:
        """The number of plays of these records: a few may agree by chance in one order."""
        if not records:
            return 1
        wanted = max(ENOUGH - self._again - others, FEW if self._again < BEGINNING else 1)
        # Half of what may be played is left for later.
        spare = max(0, self.earlier.spare - others) // 2
        rounds = min(-(-wanted // records), 1 + spare // records)
        self._again += rounds * records
        return rounds

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


def _by_itself(one: OneRun) -> tuple[UnitOfRuns, OneRun]:
    """A unit of that run alone, and the run in it."""
    return GivenWorlds(((one.world, one.place),)), replace(one, number=0)
