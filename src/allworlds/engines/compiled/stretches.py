"""Users' explorers in the compiled engine: stretches of runs, played twice, and judged between.

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

from allworlds.document import replace
from allworlds.engines.compiled.requests import level_of
from allworlds.engines.compiled.tallies import tally_of
from allworlds.engines.isolation.player_pair import PlayerPair
from allworlds.engines.isolation.shared_logs import StretchMemory
from allworlds.engines.kernel.batches import LaidOutRuns, UnitJudge
from allworlds.engines.kernel.rows import BrokenRun, Rows
from allworlds.engines.kernel.stretch import LONGEST_STRETCH
from allworlds.engines.kernel.writing import LogEnd, read_log
from allworlds.engines.python.comparison import nondeterministic
from allworlds.engines.python.examiner import LOST, Outcome, Referee
from allworlds.engines.python.players import OneRun, placed_run
from allworlds.engines.python.python_engine import PythonEngine
from allworlds.engines.python.run_counter import REPORT_EVERY, EnginesDisagree
from allworlds.engines.python.runs_of_unit import GivenWorlds, LevelRuns, NumberedRun, UnitOfRuns
from allworlds.engines.python.second_play import PlayedTwice
from allworlds.engines.python.tally import Tally
from allworlds.judging import Fault, Log, UncheckedAnswer, Violation, retold
from allworlds.maps import Code, CombinatorialMap, rooted_code
from allworlds.world import World

AGREEMENT_EDGES = 3
"""The largest m for which both judges judge every log, and must agree, and the general engine plays
everything, too."""

AT_FIRST, AFTER_LOSS, LEAST = 64, 64, 16
"""The runs of the first stretch, of the one after a loss, and of the shortest.  Each stretch has
twice as many as the one before, or half as many, if that took long."""

MOST_DIFFERING = 16
"""The number of runs whose plays differ that are played anew in one stretch."""

DIFFERENT = "the second walk or answer differs"

THIRD = "when it was played once more, the walk or the answer was another"


@dataclass(slots=True)
class PlayedByStretches:
    """The engine with a user's explorer.

    Attributes:
        engine, explorer, players: as for the general engine.
    """

    engine: PythonEngine
    explorer: str
    players: PlayerPair
    _general: PlayedTwice = field(init=False)
    _referee: Referee = field(init=False)
    _most: int = AT_FIRST
    _worst: Tally = field(init=False)

    def __post_init__(self) -> None:
        self._general = PlayedTwice(self.engine, self.explorer, self.players)
        self._referee = Referee(self.explorer, self.engine.scope.rules)
        self._worst = Tally(self.engine.keep)

    def parts(self, unit: UnitOfRuns, start: int = 0) -> Iterator[tuple[int, Tally]]:
        """Yield the number of the next run and the tally since, after each stretch."""
        if start or not isinstance(unit, LevelRuns):
            # The rest of a unit whose referee was lost.
            yield from self._general.parts(unit, start)
            return
        scope = self.engine.scope
        level = level_of(self.explorer, scope.rules, scope.extent, unit.edges)
        first, second = _memory(unit.edges)
        keep = self.engine.keep
        judge = UnitJudge(level, unit.prefix, keep, first.stretch, second.stretch)
        batch = None
        while batch is None or not batch.last:
            began = time.monotonic()
            batch = judge.lay_out(self._most)
            tally = self._compiled(unit, judge, batch)
            if tally is None:
                self._most = AFTER_LOSS
                judge.skip(batch)
                tally = self._by_the_general_engine(unit, batch)
            else:
                slow = time.monotonic() - began > REPORT_EVERY
                most = self._most // 2 if slow else 2 * self._most
                self._most = max(LEAST, min(most, LONGEST_STRETCH))
                if unit.edges <= AGREEMENT_EDGES:
                    general = self._by_the_general_engine(unit, batch)
                    tally.remarks.update(general.remarks)
                    for found in general.findings:
                        tally.find(found)
            yield batch.until, tally
            yield from self._general.ended_if_given_up(batch.until)

    def _compiled(self, unit: LevelRuns, judge: UnitJudge, batch: LaidOutRuns) -> Tally | None:
        """The tally of a stretch; None if the general engine must make it."""
        first, second = _memory(unit.edges)
        policy, size = self.engine.scope.rules.policy, 0
        if batch.runs:
            played = first.play(self.players, "first", batch.runs, policy)
            if played is None:
                return None
            size = played
        rows, readable = judge.judge(batch, size)
        if not readable:
            return None
        if unit.edges <= AGREEMENT_EDGES:
            self._compare(unit, batch, judge, rows)
        differing: list[int] = []
        if batch.runs:
            played = second.play(self.players, "second", batch.runs, policy)
            if played is None:
                return None
            differing = judge.differing(played)
        tally = tally_of(rows, unit, self.engine.scope, self.engine.tally())
        if not differing:
            self._find_broken(unit, batch, judge, rows.broken, tally)
            return tally
        if not self._general.goes_by_hashes:
            self._find_differing(unit, [judge.number(row) for row in differing], tally)
        return None if self._general.goes_by_hashes else tally

    def _find_broken(
        self,
        unit: LevelRuns,
        batch: LaidOutRuns,
        judge: UnitJudge,
        broken: Sequence[BrokenRun],
        tally: Tally,
    ) -> None:
        """Find the broken runs of a stretch."""
        for each in broken:
            if not self._find(unit, each, tally):
                self._confirm(unit, batch, judge, each)
                self._find(unit, each, tally, otherwise=nondeterministic(THIRD))

    def _runs(self, unit: LevelRuns, batch: LaidOutRuns) -> Iterator[NumberedRun]:
        """The runs of a stretch."""
        return islice(self.engine.runs(unit, batch.first), batch.until - batch.first)

    def _by_the_general_engine(self, unit: LevelRuns, batch: LaidOutRuns) -> Tally:
        tally, runs = self.engine.tally(), self._runs(unit, batch)
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
        kernels, pythons = _counts_of(counted), _counts_of(judged)
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
        """The outcome of each run of a stretch, by its first log, as the Python judge has it."""
        row = 0
        for run in self._runs(unit, batch):
            world = self.engine.count_run(run, tally)
            if world is not None:
                episode = retold(_log(judge.log(row)), world)
                outcome = self._referee.outcome(world, episode, ())
                yield OneRun(run.number, run.place, world), outcome
                row += 1

    def _find(
        self,
        unit: LevelRuns,
        broken: BrokenRun,
        tally: Tally,
        otherwise: Violation | None = None,
    ) -> bool:
        """Find a broken run by the general engine, if it may be among the smallest.

        Return False if another law is broken then, or none; if ``otherwise`` is given, find that.
        """
        key = _key(unit, broken)
        # In small levels each unit must find what the general engine finds in it.
        small = unit.edges <= AGREEMENT_EDGES
        worst = self._worst.findings
        if not small and len(worst) >= self.engine.keep and key >= worst[-1].key:
            return True
        one = self._placed(broken.sigma, broken.alpha, key[-1])
        given = GivenWorlds(((one.world, one.place),))
        for again, outcome in self._general.outcomes(given, {0: one}):
            if not isinstance(outcome, Outcome):
                tally.find(self._general.finding(again, outcome))
                continue
            settled, law = outcome, _law(outcome)
            # Of a run without an answer the general engine alone knows why.
            unknown = law and broken.law == "illegal-action"
            if not unknown and law not in (broken.law, "nondeterministic", *LOST):
                if otherwise is None:
                    return False
                settled = replace(outcome, violation=otherwise)
            finding = self._general.finding(again, settled)
            tally.find(finding)
            self._worst.find(finding)
        return True

    def _placed(self, sigma: Sequence[int], alpha: Sequence[int], place: int) -> OneRun:
        """The run in this map, rooted at dart 0, at that place of the lighthouse."""
        map_ = CombinatorialMap(sigma, alpha)
        lighthouse = next(islice(self.engine.scope.rules.kind.places(map_, 0), place, None))
        return OneRun(0, place, World(map_, lighthouse, 0))

    def _confirm(
        self, unit: LevelRuns, batch: LaidOutRuns, judge: UnitJudge, broken: BrokenRun
    ) -> None:
        """Raise EnginesDisagree unless the Python judge judges the same log as the kernel did."""
        law = ""
        for one, outcome in self._outcomes(unit, batch, judge, self.engine.tally()):
            map_ = one.world.map
            code = rooted_code(map_.sigma, map_.alpha, 0)
            if (*code, one.place) == (broken.sigma, broken.alpha, broken.place):
                law = _law(outcome)
        if law != broken.law:
            raise EnginesDisagree(
                f"the kernel says that {broken.law} is broken, the python engine that "
                f"{law or 'none'} is, in the world sigma={list(broken.sigma)} "
                f"alpha={list(broken.alpha)} place={broken.place}"
            )

    def _find_differing(self, unit: LevelRuns, differing: Sequence[int], tally: Tally) -> None:
        """Find runs whose plays differ, even if they agree when they are played once more."""
        wanted = {*differing}
        runs = islice(self.engine.runs(unit), max(wanted) + 1)
        chosen = [run for run in runs if run.number in wanted]
        chosen.sort(key=lambda run: run.map.vertex_count)
        placed = {run.number: placed_run(run) for run in chosen[:MOST_DIFFERING]}
        for one, outcome in self._general.outcomes(unit, placed):
            if not isinstance(outcome, Outcome) or _law(outcome) == "nondeterministic":
                tally.find(self._general.finding(one, outcome))
            else:
                settled = replace(outcome, violation=nondeterministic(DIFFERENT))
                tally.find(self._general.finding(one, settled))


def _law(outcome: Outcome) -> str:
    return outcome.violation.law if outcome.violation else ""


def _counts_of(tally: Tally) -> object:
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


def _log(log: bytes) -> Log:
    """A first log in the form of the general engine."""
    motions, published, ending = read_log(log)
    checkpoints = tuple([(steps, *parts) for steps, parts in published])
    if not isinstance(ending, LogEnd):
        return Log(motions, checkpoints, UncheckedAnswer(*ending))
    without = ending is LogEnd.WITHOUT_ANSWER
    return Log(motions, checkpoints, Fault("illegal-action" if without else "budget", "", ""))


@cache
def _memory(edges: int) -> tuple[StretchMemory, StretchMemory]:
    """This process's memory for stretches, shared with the first and with the second player."""
    return StretchMemory(edges), StretchMemory(edges)
