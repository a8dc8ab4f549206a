"""Users' explorers in the compiled engine: stretches of runs, played twice, and judged between.

A stretch has a log for each run, or, where every schedule is tried, one for each schedule of each
run; then it is played and judged in portions (:mod:`allworlds.engines.kernel.schedule_judge`).

A stretch is laid out and judged by a referee, which has no user's code in it; its two players play
it, the first in worlds, the second against the recorded percepts, each in an order of its own.
The general engine (:mod:`allworlds.engines.python.second_play`) plays a stretch anew in which
something went wrong: a player was lost, threads were left behind, or logs cannot be read.  It also
plays each run anew that breaks a law, or whose plays differ.  If a run that broke a law is right
then, and the Python judge judges the same log as the kernel did, the explorer is not the same
twice; if the judges differ, the engines disagree.
"""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cache
from itertools import islice
from typing import Any, NamedTuple

from allworlds.document import replace
from allworlds.engines.compiled.requests import level_of
from allworlds.engines.compiled.tallies import tally_of
from allworlds.engines.isolation.jobs import SCRIPTS_BEHIND, DueSchedules
from allworlds.engines.isolation.player_pair import PlayerPair
from allworlds.engines.isolation.shared_logs import StretchMemory
from allworlds.engines.kernel.batches import LaidOutRuns, ReplayableRun, UnitJudge
from allworlds.engines.kernel.rows import BrokenRun, Level, Rows
from allworlds.engines.kernel.schedule_judge import ScheduleJudge
from allworlds.engines.kernel.stretch import LONGEST_STRETCH, MOST_EARLIER
from allworlds.engines.kernel.writing import LogEnd, read_log
from allworlds.engines.python.comparison import nondeterministic
from allworlds.engines.python.costs import CostTally
from allworlds.engines.python.earlier_plays import KEPT, EarlierPlays
from allworlds.engines.python.examiner import LOST, Outcome, Referee
from allworlds.engines.python.players import OneRun, placed_run
from allworlds.engines.python.python_engine import PythonEngine
from allworlds.engines.python.run_counter import REPORT_EVERY, EnginesDisagree
from allworlds.engines.python.runs_of_unit import GivenWorlds, LevelRuns, NumberedRun, UnitOfRuns
from allworlds.engines.python.second_play import PLAYS, PlayedTwice
from allworlds.engines.python.tally import Tally
from allworlds.engines.python.tour import SPELL
from allworlds.judging import Fault, Finding, Log, LostRun, UncheckedAnswer, Violation, retold
from allworlds.maps import Code, CombinatorialMap, rooted_code
from allworlds.world import World

AGREEMENT_EDGES = 3
"""The largest m for which both judges judge every log, and must agree, and the general engine plays
everything, too."""

OF_EVERY_SCHEDULE = 2
"""The largest such m where every schedule is tried: with 3 edges a run has some 30 schedules."""

AT_FIRST, AFTER_LOSS, LEAST = 64, 64, 16
"""The runs of the first stretch, of the one after a loss, and of the shortest.  Each stretch has
twice as many as the one before, or half as many, if that took long."""

MOST_DIFFERING = 16
"""The number of runs whose plays differ that are played anew in one stretch."""

ANEW = 8
"""The number of plays of each stretch that take the place of earlier plays."""

DIFFERENT = "the second walk or answer differs"

OTHERWISE = "the second walk, answer or choices differ"
"""The difference of two plays where every schedule is tried; else it is the text above."""

THIRD = "when it was played once more, the walk or the answer was another"


class _EarlierRun(NamedTuple):
    """A play that was the same twice, with the number of its run in its unit."""

    unit: LevelRuns
    number: int
    kept: ReplayableRun


class _Chosen(NamedTuple):
    """A play: the number of its run in its unit, and its choices if every schedule is tried."""

    number: int
    choices: tuple[int, ...]


class _Differing(NamedTuple):
    """Plays that differ from their second ones: those of the stretch, and earlier ones."""

    here: list[_Chosen]
    earlier: list[_EarlierRun]


@dataclass(slots=True)
class PlayedByStretches:
    """The engine with a user's explorer.

    Attributes:
        engine, explorer, players, earlier: as for the general engine.
    """

    engine: PythonEngine
    explorer: str
    players: PlayerPair
    earlier: EarlierPlays[Any]
    _general: PlayedTwice = field(init=False)
    _referee: Referee = field(init=False)
    _most: int = AT_FIRST
    _worst: Tally = field(init=False)
    _kept: EarlierPlays[_EarlierRun] = field(default_factory=EarlierPlays)
    _seed: int | None = None
    _stash: list[Finding] = field(default_factory=list)

    def __post_init__(self) -> None:
        self._general = PlayedTwice(self.engine, self.explorer, self.players, self.earlier)
        self._referee = Referee(self.explorer, self.engine.scope.rules)
        self._worst = Tally(self.engine.keep)

    def parts(self, unit: UnitOfRuns, start: int = 0) -> Iterator[tuple[int, Tally]]:
        """Yield the number of the next run and the tally since, after each stretch."""
        if start or not isinstance(unit, LevelRuns):
            # The rest of a unit whose referee was lost.
            yield from self._general.parts(unit, start)
            return
        level = self.level(unit)
        first, second = _memory(unit.edges)
        keep = self.engine.keep
        kind = UnitJudge if self.engine.scope.schedules == "one" else ScheduleJudge
        judge = kind(level, unit.prefix, keep, first.stretch, second.stretch)
        batch = None
        while batch is None or not batch.last:
            began = time.monotonic()
            batch = judge.lay_out(self._most)
            tally = self._compiled(unit, judge, batch)
            if tally is None:
                self._most = AFTER_LOSS
                judge.skip(batch)
                tally = self._by_the_general_engine(unit, batch)
                for found in self._stash:
                    tally.find(found)
                self._stash.clear()
            else:
                slow = time.monotonic() - began > REPORT_EVERY
                most = self._most // 2 if slow else 2 * self._most
                self._most = max(LEAST, min(most, self._longest))
                if unit.edges <= self._compared:
                    general = self._by_the_general_engine(unit, batch)
                    tally.remarks.update(general.remarks)
                    for found in general.findings:
                        tally.find(found)
            yield batch.until, tally
            yield from self._general.ended_if_given_up(batch.until)

    def level(self, unit: LevelRuns) -> Level:
        """The kernel's request for the level of a unit."""
        scope = self.engine.scope
        return level_of(self.explorer, scope.rules, scope.extent, unit.edges)

    def outcomes(
        self, one: OneRun, choices: tuple[int, ...] = ()
    ) -> Iterator[tuple[OneRun, Outcome | LostRun]]:
        """The outcome of a run that is played anew, by the general engine."""
        given = GivenWorlds(((one.world, one.place),))
        return self._general.outcomes(given, {one.number: one}, given=choices)

    def finding(self, one: OneRun, outcome: Outcome | LostRun) -> Finding:
        """The finding of a run that breaks a law, or that was lost."""
        return self._general.finding(one, outcome)

    @property
    def _compared(self) -> int:
        """The largest m for which both judges and both engines are compared."""
        one = self.engine.scope.schedules == "one"
        return AGREEMENT_EDGES if one else OF_EVERY_SCHEDULE

    @property
    def _longest(self) -> int:
        """The largest number of plays in a stretch: at first the second player changes soon."""
        return LONGEST_STRETCH if self.players.tour.complete else SPELL

    def _compiled(self, unit: LevelRuns, judge: UnitJudge, batch: LaidOutRuns) -> Tally | None:
        """The tally of a stretch; None if the general engine must make it."""
        tally = self.engine.tally()
        while not judge.is_done(batch):
            part = self._portion(unit, judge, batch)
            if part is None:
                return None
            tally.add(part)
        return tally

    def _portion(self, unit: LevelRuns, judge: UnitJudge, batch: LaidOutRuns) -> Tally | None:
        """The tally of the next portion of a stretch, which may be all of it; None as above."""
        first, second = _memory(unit.edges)
        policy, size = self.engine.scope.rules.policy, 0
        row, script = judge.next
        due = DueSchedules(row, script, self._longest) if judge.every else None
        if row < batch.runs:
            played = first.play(self.players, "first", batch.runs, policy, due)
            if played is None:
                return None
            size = played
        if self._seed != self.players.tour.hash_seed:
            self._seed = self.players.tour.hash_seed
            self._kept.forget()
        earlier = self._kept.draw(MOST_EARLIER) if row < batch.runs else []
        again = [play.kept for play in earlier]
        rows, readable = judge.judge(batch, size, again)
        logs = judge.logs
        if not readable or not (logs or judge.is_done(batch)):
            return None
        if unit.edges <= self._compared:
            self._compare(unit, batch, judge, rows)
        differing: list[int] = []
        if logs:
            scripts = SCRIPTS_BEHIND if judge.every else None
            played = second.play(self.players, "second", logs + len(earlier), policy, scripts)
            if played is None:
                return None
            differing = judge.differing(played, again)
        tally = self._tally(rows, unit, judge)
        by_seed = self.players.tour.differ
        unlike = _Differing(
            [_chosen(judge, row) for row in differing if row < logs],
            [earlier[row - logs] for row in differing if row >= logs],
        )
        for _ in self._finding(unit, batch, judge, rows.broken, unlike, tally):
            if by_seed and self.players.tour.alike:
                # The explorer goes by hashes: the stretch is played anew, with one seed.
                self._stash += tally.findings
                return None
        if not differing:
            wanted = min(logs, max(ANEW, KEPT - len(self._kept)))
            for row in self.players.random.sample(range(logs), wanted):
                kept = judge.kept(row)
                if kept.short:
                    self._kept.keep(_EarlierRun(unit, judge.number(row), kept))
        return tally

    def _tally(self, rows: Rows, unit: LevelRuns, judge: UnitJudge) -> Tally:
        """A tally of the counts of a portion."""
        tally = tally_of(rows, unit, self.engine.scope, self.engine.tally())
        if isinstance(judge, ScheduleJudge):
            for each in rows.most_expensive:
                row = tally.row(unit.edges, each.vertices)
                assert row.most_expensive is not None
                choices = judge.choices_of_dearest(each.vertices)
                row.most_expensive = row.most_expensive._replace(choices=choices)
            if isinstance(tally, CostTally):
                for vertices, cost in judge.best.items():
                    tally.best_of(vertices, cost)
        return tally

    def _finding(
        self,
        unit: LevelRuns,
        batch: LaidOutRuns,
        judge: UnitJudge,
        broken: Sequence[BrokenRun],
        differing: _Differing,
        tally: Tally,
    ) -> Iterator[None]:
        """Find what is wrong with a stretch, part by part."""
        if differing.here:
            self._find_differing(unit, differing.here, tally)
            yield
        else:
            for number, each in enumerate(broken):
                choices = judge.choices_of_broken(number)
                if not self.find(unit, each, tally, choices):
                    self._confirm(unit, batch, judge, each, choices)
                    self.find(unit, each, tally, choices, otherwise=nondeterministic(THIRD))
                yield
        for play in differing.earlier:
            self._find_differing(play.unit, [_Chosen(play.number, play.kept.choices)], tally)
            yield

    def _runs(self, unit: LevelRuns, batch: LaidOutRuns) -> dict[int, NumberedRun]:
        """The runs of a stretch, by their numbers."""
        runs = islice(self.engine.runs(unit, batch.first), batch.until - batch.first)
        return {run.number: run for run in runs}

    def _by_the_general_engine(self, unit: LevelRuns, batch: LaidOutRuns) -> Tally:
        tally = self.engine.tally()
        runs = islice(self.engine.runs(unit, batch.first), batch.until - batch.first)
        while some := list(islice(runs, AFTER_LOSS)):
            tally.add(self._general.tally(unit, some))
            if self._general.given_up:
                break
        return tally

    def _compare(self, unit: LevelRuns, batch: LaidOutRuns, judge: UnitJudge, rows: Rows) -> None:
        """Raise EnginesDisagree unless the Python judge counts the same in the same logs."""
        scope, keep = self.engine.scope, self.engine.keep
        counted, judged = tally_of(rows, unit, scope, Tally(keep)), self.engine.tally()
        for one, outcome in self._outcomes(unit, batch, judge, judged):
            self.engine.count_outcome(self._referee, one.world, one.place, outcome, judged)
        kernels, pythons = counts_of(counted), counts_of(judged)
        broken = sorted((_key(unit, each), each.law) for each in rows.broken)
        found = sorted((each.key[:4], each.law) for each in judged.findings)
        if kernels != pythons or broken != found:
            raise EnginesDisagree(
                f"the kernel and the python engine count differently in the unit {unit.key}: "
                f"{kernels}, {broken} and {pythons}, {found}"
            )

    def _outcomes(
        self, unit: LevelRuns, batch: LaidOutRuns, judge: UnitJudge, tally: Tally
    ) -> Iterator[tuple[OneRun, Outcome]]:
        """The outcome of each first log of a portion, as the Python judge has it."""
        runs = self._runs(unit, batch)
        for number in judge.counted:
            self.engine.count_run(runs[number], tally)
        for row in range(judge.logs):
            one, kept = placed_run(runs[judge.number(row)]), judge.kept(row)
            episode = retold(_log(kept), one.world)
            yield one, self._referee.outcome(one.world, episode, kept.choices)

    def find(
        self,
        unit: LevelRuns,
        broken: BrokenRun,
        tally: Tally,
        choices: tuple[int, ...] = (),
        otherwise: Violation | None = None,
    ) -> bool:
        """Find a broken run by the general engine, if it may be among the smallest.

        ``choices`` are its own, if every schedule is tried.
        Return False if another law is broken then, or none; if ``otherwise`` is given, find that.
        """
        key = _key(unit, broken)
        # In small levels each unit must find what the general engine finds in it.
        small = unit.edges <= self._compared
        worst = self._worst.findings
        if not small and len(worst) >= self.engine.keep and key >= worst[-1].key:
            return True
        one = self.placed(broken.sigma, broken.alpha, key[-1])
        for again, outcome in self.outcomes(one, choices):
            if not isinstance(outcome, Outcome):
                tally.find(self.finding(again, outcome))
                continue
            settled, law = outcome, _law(outcome)
            # Of a run without an answer the general engine alone knows why.
            unknown = law and broken.law == "illegal-action"
            if not unknown and law not in (broken.law, "nondeterministic", *LOST):
                if otherwise is None:
                    return False
                settled = replace(outcome, violation=otherwise)
            finding = self.finding(again, settled)
            tally.find(finding)
            self._worst.find(finding)
        return True

    def placed(self, sigma: Sequence[int], alpha: Sequence[int], place: int) -> OneRun:
        """The run in this map, rooted at dart 0, at that place of the lighthouse."""
        map_ = CombinatorialMap(sigma, alpha)
        lighthouse = next(islice(self.engine.scope.rules.kind.places(map_, 0), place, None))
        return OneRun(0, place, World(map_, lighthouse, 0))

    def _confirm(
        self,
        unit: LevelRuns,
        batch: LaidOutRuns,
        judge: UnitJudge,
        broken: BrokenRun,
        choices: tuple[int, ...],
    ) -> None:
        """Raise EnginesDisagree unless the Python judge judges the same log as the kernel did."""
        law = ""
        for one, outcome in self._outcomes(unit, batch, judge, self.engine.tally()):
            if _is_at(broken, one.world.map, one.place) and outcome.choices == choices:
                law = _law(outcome)
        if law != broken.law:
            raise EnginesDisagree(
                f"the kernel says that {broken.law} is broken, the python engine that "
                f"{law or 'none'} is, in the world sigma={list(broken.sigma)} "
                f"alpha={list(broken.alpha)} place={broken.place}"
            )

    def _find_differing(self, unit: LevelRuns, differing: Sequence[_Chosen], tally: Tally) -> None:
        """Find plays that differ, even if they agree when they are played once more."""
        wanted = {each.number for each in differing}
        runs = islice(self.engine.runs(unit), max(wanted) + 1)
        found = {run.number: run for run in runs if run.number in wanted}
        chosen = sorted(differing, key=lambda each: found[each.number].map.vertex_count)
        by_choices: dict[tuple[int, ...], dict[int, OneRun]] = {}
        for number, choices in chosen[:MOST_DIFFERING]:
            by_choices.setdefault(choices, {})[number] = placed_run(found[number])
        tour = self.players.tour
        by_seed = tour.differ
        # Only for these plays: a library then leaves a process without compiled code again.
        tour.hold(PLAYS * sum(map(len, by_choices.values())))
        again = [
            each
            for choices, placed in by_choices.items()
            for each in self._general.outcomes(unit, placed, given=choices)
        ]
        explained = by_seed and tour.alike
        for one, outcome in again:
            if (
                not isinstance(outcome, Outcome)
                or _law(outcome) == "nondeterministic"
                or (explained and _law(outcome))
            ):
                tally.find(self._general.finding(one, outcome))
            elif not explained:
                seen = DIFFERENT if self.engine.scope.schedules == "one" else OTHERWISE
                settled = replace(outcome, violation=nondeterministic(seen))
                tally.find(self._general.finding(one, settled))


def _chosen(judge: UnitJudge, row: int) -> _Chosen:
    return _Chosen(judge.number(row), judge.kept(row).choices)


def _is_at(broken: BrokenRun, map_: CombinatorialMap, place: int) -> bool:
    """Whether a broken run is in this map, which is rooted at dart 0, at that place."""
    code = rooted_code(map_.sigma, map_.alpha, 0)
    return place == broken.place and code == (broken.sigma, broken.alpha)


def _law(outcome: Outcome) -> str:
    return outcome.violation.law if outcome.violation else ""


def counts_of(tally: Tally) -> object:
    """All that is counted of the runs of a unit."""
    rows = [row for _, row in sorted(tally.rows.items())]
    return rows, _most_expensive(tally), tally.left_out, tally.checkpoints, +tally.witnesses


def _most_expensive(tally: Tally) -> list[object]:
    """The least run that costs most, by size; its choices are left out."""
    return [
        (size, row.most_expensive and row.most_expensive[:3])
        for size, row in sorted(tally.rows.items())
    ]


def _key(unit: LevelRuns, broken: BrokenRun) -> tuple[int, int, Code, int]:
    """The key by which the finding of a broken run is sorted."""
    assert broken.place is not None
    return unit.edges, broken.vertices, (broken.sigma, broken.alpha), broken.place


def _log(kept: ReplayableRun) -> Log:
    """A first log in the form of the general engine."""
    motions, published, ending = read_log(kept.log.tobytes())
    checkpoints = tuple([(steps, *parts) for steps, parts in published])
    if not isinstance(ending, LogEnd):
        return Log(motions, checkpoints, UncheckedAnswer(*ending))
    without = ending is LogEnd.WITHOUT_ANSWER
    return Log(motions, checkpoints, Fault("illegal-action" if without else "budget", "", ""))


@cache
def _memory(edges: int) -> tuple[StretchMemory, StretchMemory]:
    """This process's memory for stretches, shared with the first and with the second player."""
    return StretchMemory(edges), StretchMemory(edges)
