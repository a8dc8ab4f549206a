"""Foreign explorers in the compiled engine: stretches of runs, played twice, and judged between.

A stretch is laid out and judged by a referee, which has no foreign code in it; its two players play
it, the one in worlds, the other against what was sensed there, each in an order of its own.
Whatever goes wrong there, a lost player, threads left behind, logs that cannot be read, is left to
the general engine, which plays the stretch anew.  A run that breaks a law is played anew by it,
too: if it does otherwise then, and the Python judge says of the same log what the kernel says, the
explorer is not the same twice; if that says something else, nothing is believed.
"""

from __future__ import annotations

import time
from collections.abc import Iterator, MutableSequence, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from itertools import islice
from typing import NamedTuple

from allworlds.engines.compiled.requests import level_of
from allworlds.engines.compiled.tallies import tally_of
from allworlds.engines.isolation.cast import Cast
from allworlds.engines.isolation.process import guardian
from allworlds.engines.isolation.shared_logs import Shared
from allworlds.engines.job import Job
from allworlds.engines.kernel import engine as kernel
from allworlds.engines.kernel.batches import (
    LONGEST_STRETCH,
    MOST_EARLIER,
    LaidOutRuns,
    ReplayableRun,
    UnitJudge,
    load_native,
)
from allworlds.engines.kernel.compiling import is_compiled
from allworlds.engines.kernel.native import play_worlds
from allworlds.engines.kernel.rows import BrokenRun, Rows
from allworlds.engines.kernel.runs import examine
from allworlds.engines.kernel.writing import LogEnd, read_log
from allworlds.engines.python.examiner import LOST, Outcome, Referee, nondeterministic
from allworlds.engines.python.python_engine import (
    REPORT_EVERY,
    EnginesDisagree,
    PartwiseEngine,
    PythonEngine,
)
from allworlds.engines.python.runs_of_unit import GivenWorlds, LevelRuns, NumberedRun, UnitOfRuns
from allworlds.engines.python.scope import Scope
from allworlds.engines.python.second_play import Earlier, OneRun, PlayedTwice
from allworlds.engines.python.tally import Tally
from allworlds.explorers import Subject
from allworlds.judging import Fault, Log, UncheckedAnswer, retold
from allworlds.maps import Code, CombinatorialMap
from allworlds.world import World

AGREEMENT_EDGES = 3
"""Up to so many edges both judges look at every log, and must say the same; and the general engine
plays everything, too."""

AT_FIRST, AFTER_LOSS, LEAST = 64, 64, 16
"""The runs of the first stretch, and of the one after a loss; each next one has twice as many, but
half as many, though no fewer than so few, if it took long."""

MOST_DIFFERING = 16
"""So many runs whose plays differ are looked at in one stretch."""

KEPT, ANEW = 256, 8
"""So many plays are kept to be played again among later ones; of each stretch so many take the
place of others."""

DIFFERENT = "the second walk or answer differs"

THIRD = "when it was played once more, the walk or the answer was another"


def load() -> None:
    """Have all that is needed loaded, this module included."""
    load_native()


@dataclass(frozen=True, slots=True)
class StretchEngine:
    """All runs of a unit, played by a foreign explorer in stretches, and judged by the kernel.

    Attributes:
        scope, keep: as for the general engine.
    """

    scope: Scope
    keep: int

    @staticmethod
    def compiled(job: Job) -> None:
        """Have what is needed compiled or loaded once, for all processes that will be."""
        if not (is_compiled(play_worlds) and is_compiled(examine)):
            job.notice(kernel.COMPILING)
        guardian().prepare(__name__, load.__name__)

    def for_built_in(
        self,
        subject: Subject,
        beat: MutableSequence[int] | None = None,
    ) -> PartwiseEngine:
        """See :class:`~allworlds.engines.python.python_engine.WorkerEngine`."""
        return PythonEngine(self.scope, self.keep).for_built_in(subject, beat)

    def for_user(self, explorer: str, cast: Cast, earlier: Earlier) -> PartwiseEngine:
        """See :class:`allworlds.engines.isolation.cast.UserEngine`."""
        return PlayedByStretches(PythonEngine(self.scope, self.keep), explorer, cast, earlier)


class _Earlier(NamedTuple):
    """A play that was the same twice, to be played again among those of other units and levels."""

    unit: LevelRuns
    number: int
    kept: ReplayableRun


@dataclass(slots=True)
class PlayedByStretches:
    """The engine for a foreign explorer.

    Attributes:
        examination, explorer, cast, earlier: as for the general engine.
    """

    examination: PythonEngine
    explorer: str
    cast: Cast
    earlier: Earlier
    _general: PlayedTwice = field(init=False)
    _referee: Referee = field(init=False)
    _most: int = AT_FIRST
    _worst: Tally = field(init=False)
    _kept: list[_Earlier] = field(default_factory=list)

    def __post_init__(self) -> None:
        self._general = PlayedTwice(self.examination, self.explorer, self.cast, self.earlier)
        self._referee = Referee(self.explorer, self.examination.scope.rules)
        self._worst = Tally(self.examination.keep)

    def parts(self, unit: UnitOfRuns, start: int = 0) -> Iterator[tuple[int, Tally]]:
        """After each stretch the number of the next run and the tally since."""
        if start or not isinstance(unit, LevelRuns):
            # The rest of a unit whose referee was lost.
            yield from self._general.parts(unit, start)
            return
        scope, keep = self.examination.scope, self.examination.keep
        level = level_of(self.explorer, scope.rules, scope.extent, unit.edges)
        first, second = _memory(unit.edges)
        judge = UnitJudge(level, unit.prefix, keep, first.stretch, second.stretch)
        laid = None
        while laid is None or not laid.last:
            began = time.monotonic()
            laid = judge.lay_out(self._most)
            tally = self._compiled(unit, judge, laid)
            if tally is None:
                self._most = AFTER_LOSS
                judge.skip(laid)
                tally = self._by_the_general_engine(unit, laid)
            else:
                slow = time.monotonic() - began > REPORT_EVERY
                most = self._most // 2 if slow else 2 * self._most
                self._most = max(LEAST, min(most, LONGEST_STRETCH))
                if unit.edges <= AGREEMENT_EDGES:
                    general = self._by_the_general_engine(unit, laid)
                    tally.remarks.update(general.remarks)
                    for found in general.findings:
                        tally.find(found)
            yield laid.until, tally

    def _compiled(self, unit: LevelRuns, judge: UnitJudge, laid: LaidOutRuns) -> Tally | None:
        """The tally of a stretch; None where the general engine must make it."""
        first, second = _memory(unit.edges)
        policy, size = self.examination.scope.rules.policy, 0
        if laid.runs:
            played = first.played(self.cast, "first", laid.runs, policy)
            if played is None:
                return None
            size = played
        few = min(MOST_EARLIER, len(self._kept)) if laid.runs else 0
        earlier = self.cast.random.sample(self._kept, few)
        again = [play.kept for play in earlier]
        rows, readable = judge.judge(laid, size, again)
        if not readable:
            return None
        if unit.edges <= AGREEMENT_EDGES:
            self._compare(unit, laid, judge, rows)
        differing: list[int] = []
        if laid.runs:
            played = second.played(self.cast, "second", laid.runs + few, policy)
            if played is None:
                return None
            differing = judge.differing(laid, played, again)
        tally = tally_of(rows, unit, self.examination.scope, self.examination.keep)
        ours = [judge.number(row) for row in differing if row < laid.runs]
        if ours:
            self._find_differing(unit, ours, tally)
        else:
            for broken in rows.broken:
                self._find(unit, laid, judge, broken, tally)
        for play in (earlier[row - laid.runs] for row in differing if row >= laid.runs):
            self._find_differing(play.unit, [play.number], tally)
        if not differing:
            wanted = min(laid.runs, max(ANEW, KEPT - len(self._kept)))
            for row in self.cast.random.sample(range(laid.runs), wanted):
                kept = judge.kept(row)
                if kept.short:
                    self._keep(_Earlier(unit, judge.number(row), kept))
        return tally

    def _keep(self, play: _Earlier) -> None:
        """Keep a play to be played again later; of many the first stay for good."""
        if len(self._kept) < KEPT:
            self._kept.append(play)
        else:
            self._kept[self.cast.random.randrange(KEPT // 4, KEPT)] = play

    def _by_the_general_engine(self, unit: LevelRuns, laid: LaidOutRuns) -> Tally:
        tally = self.examination.tally()
        runs = islice(self.examination.runs(unit, laid.first), laid.until - laid.first)
        while some := list(islice(runs, AFTER_LOSS)):
            tally.add(self._general.tally(unit, some))
        return tally

    def _compare(self, unit: LevelRuns, laid: LaidOutRuns, judge: UnitJudge, rows: Rows) -> None:
        """Nothing, where the Python judge says the same of the same logs.

        Raises:
            EnginesDisagree: where it does not.
        """
        scope, keep = self.examination.scope, self.examination.keep
        counted, judged = tally_of(rows, unit, scope, keep), self.examination.tally()
        for one, outcome in self._outcomes(unit, laid, judge, judged):
            self.examination.count_outcome(self._referee, one.world, one.place, outcome, judged)
        kernels, pythons = (
            (
                tally.rows,
                _most_expensive(tally),
                tally.left_out,
                tally.checkpoints,
                +tally.witnesses,
            )
            for tally in (counted, judged)
        )
        broken = sorted((_key(unit, each), each.law) for each in rows.broken)
        found = sorted((each.key[:4], each.law) for each in judged.findings)
        if kernels != pythons or broken != found:
            raise EnginesDisagree(
                f"the kernel and the python engine count differently in the unit {unit.key}: "
                f"{kernels}, {broken} and {pythons}, {found}"
            )

    def _outcomes(
        self, unit: LevelRuns, laid: LaidOutRuns, judge: UnitJudge, tally: Tally
    ) -> Iterator[tuple[OneRun, Outcome]]:
        """Each run of a stretch, judged in Python by its first log."""
        row = 0
        for run in islice(self.examination.runs(unit, laid.first), laid.until - laid.first):
            world = self.examination.count_run(run, tally)
            if world is not None:
                episode = retold(_log(judge.kept(row)), world)
                outcome = self._referee.outcome(world, episode, ())
                yield OneRun(run.number, run.place, world), outcome
                row += 1

    def _find(
        self,
        unit: LevelRuns,
        laid: LaidOutRuns,
        judge: UnitJudge,
        broken: BrokenRun,
        tally: Tally,
    ) -> None:
        """A broken run, if it may be among the smallest, as the general engine finds it."""
        key = _key(unit, broken)
        # In small levels each unit must find what the general engine finds in it.
        small = unit.edges <= AGREEMENT_EDGES
        worst = self._worst.findings
        if not small and len(worst) >= self.examination.keep and key >= worst[-1].key:
            return
        map_, place = CombinatorialMap(broken.sigma, broken.alpha), key[-1]
        rules = self.examination.scope.rules
        lighthouse = next(islice(rules.kind.places(map_, 0), place, None))
        world = World(map_, lighthouse, 0)
        given = GivenWorlds(((world, place),))
        for one, outcome in self._general.outcomes(given, {0: OneRun(0, place, world)}):
            if not isinstance(outcome, Outcome):
                tally.find(self._referee.lost(one.world, one.place, outcome))
                continue
            told, law = outcome, outcome.violation.law if outcome.violation else ""
            # Of a run without an answer the general engine alone knows why.
            unknown = law and broken.law == "illegal-action"
            if not unknown and law not in (broken.law, "nondeterministic", *LOST):
                self._confirm(unit, laid, judge, broken)
                told = replace(outcome, violation=nondeterministic(THIRD))
            finding = self._referee.finding(one.world, one.place, told)
            tally.find(finding)
            self._worst.find(finding)

    def _confirm(
        self, unit: LevelRuns, laid: LaidOutRuns, judge: UnitJudge, broken: BrokenRun
    ) -> None:
        """Nothing, where the Python judge says what the kernel says of the same log.

        Raises:
            EnginesDisagree: where it does not.
        """
        law = ""
        for one, outcome in self._outcomes(unit, laid, judge, self.examination.tally()):
            map_ = one.world.map
            if (map_.sigma, map_.alpha, one.place) == (broken.sigma, broken.alpha, broken.place):
                law = outcome.violation.law if outcome.violation else ""
        if law != broken.law:
            raise EnginesDisagree(
                f"the kernel says that {broken.law} is broken, the python engine that "
                f"{law or 'none'} is, in the world sigma={list(broken.sigma)} "
                f"alpha={list(broken.alpha)} place={broken.place}"
            )

    def _find_differing(self, unit: LevelRuns, differing: Sequence[int], tally: Tally) -> None:
        """Runs whose plays differ, whatever they do when they are played once more."""
        wanted = {*differing}
        chosen = [
            run for run in self.examination.runs(unit) if run.number in wanted and run.lighthouse
        ]
        chosen.sort(key=lambda run: run.map.vertex_count)
        lit = {run.number: _one(run) for run in chosen[:MOST_DIFFERING]}
        for one, outcome in self._general.outcomes(unit, lit):
            if not isinstance(outcome, Outcome):
                tally.find(self._referee.lost(one.world, one.place, outcome))
                continue
            told = outcome
            if told.violation is None or told.violation.law != "nondeterministic":
                told = replace(outcome, violation=nondeterministic(DIFFERENT))
            tally.find(self._referee.finding(one.world, one.place, told))


def _one(run: NumberedRun) -> OneRun:
    assert run.lighthouse is not None
    return OneRun(run.number, run.place, World(run.map, run.lighthouse, 0))


def _most_expensive(tally: Tally) -> list[object]:
    """By size the least run that costs most, whatever it has chosen."""
    return [
        (size, row.most_expensive and row.most_expensive[:3])
        for size, row in sorted(tally.rows.items())
    ]


def _key(unit: LevelRuns, broken: BrokenRun) -> tuple[int, int, Code, int]:
    """What the finding of a broken run is sorted by."""
    assert broken.place is not None
    return unit.edges, broken.vertices, (broken.sigma, broken.alpha), broken.place


def _log(kept: ReplayableRun) -> Log:
    """A first log as the general engine would have it."""
    motions, published, ending = read_log(kept.log.tobytes())
    shown = tuple([(steps, *what) for steps, what in published])
    if not isinstance(ending, LogEnd):
        return Log(motions, shown, UncheckedAnswer(*ending))
    without = ending is LogEnd.WITHOUT_ANSWER
    return Log(motions, shown, Fault("illegal-action" if without else "budget", "", ""))


@cache
def _memory(edges: int) -> tuple[Shared, Shared]:
    """This process's memory for stretches, shared with the first and with the second player."""
    return Shared(edges), Shared(edges)
