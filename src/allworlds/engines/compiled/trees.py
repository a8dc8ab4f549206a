"""Users' explorers that can be copied: the runs of a unit as one tree, walked twice.

The first player walks a chunk of the tree and decides the worlds on the way. The referee judges it
and cuts it into segments. The second player walks these, in another order, from copies of its
own. With each chunk some runs of earlier ones are played from their start, without a copy.

Where something is wrong with a chunk, the unit is played run by run
(:mod:`allworlds.engines.compiled.stretches`), which finds the law that is broken.  If nothing is
found so, a copy has gone another way than a run from its start: in the run in which the two walks
differ, or in the one that breaks a law in both.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator
from typing import NamedTuple

from msgspec import Struct, field

from allworlds.document import replace
from allworlds.engines.compiled.stretches import (
    AGREEMENT_EDGES,
    DIFFERENT,
    PlayedByStretches,
    counts_of,
)
from allworlds.engines.compiled.tallies import tally_of
from allworlds.engines.isolation.failures import Unsettled
from allworlds.engines.isolation.player_pair import PlayerPair
from allworlds.engines.isolation.shared_logs import TreeMemoryPair
from allworlds.engines.kernel.chunks import RunOfTree, UnitTree
from allworlds.engines.kernel.on_demand import KINDS
from allworlds.engines.kernel.rows import BrokenRun, Rows
from allworlds.engines.kernel.tree_memory import MOST_RUNS, MOST_SINGLES
from allworlds.engines.kernel.tree_requests import TreeRequest
from allworlds.engines.python.comparison import nondeterministic
from allworlds.engines.python.earlier_plays import EarlierPlays
from allworlds.engines.python.examiner import Outcome
from allworlds.engines.python.runs_of_unit import LevelRuns, UnitOfRuns
from allworlds.engines.python.tally import Tally
from allworlds.engines.python.tour import SPELL
from allworlds.explorers import is_library
from allworlds.judging import COPIES

COMPARED_EDGES, OF_A_LIBRARY = 4, 5
"""The largest m for which runs that are walked as a tree are also played by themselves; a library
plays some hundred times as many in the same time."""

BEGINNING, LATER = 64, 8
"""The number of chunks that are the beginning, with as many single runs as there is room for, and
the number of runs of each later chunk that are kept to be played from their start."""

MOST_GIVEN_UP = 3
"""The number of units one after the other after which no more are walked as trees."""

MOST_LOST = 2
"""The number of walks that may be lost, if no single run is."""

MEND = "mend the copying, or leave it out"
"""The advice where copies go wrong and no run can be named."""


class WalkedTree(NamedTuple):
    """The outcome of a unit that was walked as a tree.

    Attributes:
        rows: of the whole unit; None if it was given up.
        suspect: a run in which a copy perhaps went another way.
        lost: whether a player was lost, or could not repeat the walk.
        unlike: whether the two walks differ.
    """

    rows: Rows | None
    suspect: RunOfTree | BrokenRun | None = None
    lost: bool = False
    unlike: bool = False


class PlayedByTrees(Struct):
    """The engine with a user's explorer that perhaps can be copied.

    Attributes:
        stretches: the engine that plays run by run.
    """

    stretches: PlayedByStretches
    _memory: TreeMemoryPair | None = None
    _kept: EarlierPlays[RunOfTree] = field(default_factory=EarlierPlays)
    _given_up: int = 0
    _lost: int = 0
    _chunks: int = 0

    @property
    def _players(self) -> PlayerPair:
        return self.stretches.players

    def parts(self, unit: UnitOfRuns, start: int = 0) -> Iterator[tuple[int, Tally]]:
        """Yield the number of the next run and the tally since.

        A tree yields its tally at its end.  In the smallest levels it is compared with single runs.
        """
        if start or not isinstance(unit, LevelRuns) or not self._can_walk(unit):
            yield from self.stretches.parts(unit, start)
            return
        engine = self.stretches.engine
        walking = self._walk(unit)
        while True:
            try:
                next(walking)
            except StopIteration as end:
                walked: WalkedTree = end.value
                break
            yield 0, engine.tally()
        tally, walked = self._tally(unit, walked)
        self._given_up = self._given_up + 1 if tally is None else 0
        compared = OF_A_LIBRARY if is_library(self.stretches.explorer) else COMPARED_EDGES
        if tally is not None and unit.edges > compared:
            yield tally.runs + tally.left_out, tally
        else:
            yield from self._run_by_run(unit, walked, tally)

    def _run_by_run(
        self, unit: LevelRuns, walked: WalkedTree, tally: Tally | None
    ) -> Iterator[tuple[int, Tally]]:
        """Yield the parts of the unit, run by run, and what they say of the tree.

        Raises:
            Unsettled: if trees alone go wrong, and no run can be named.
        """
        whole, number = self.stretches.engine.tally(), 0
        for number, part in self.stretches.parts(unit):
            whole.add(part)
            yield number, part
        if tally is not None and tally.findings:
            # Some may be of runs that go wrong from copies alone.
            yield number, self._findings_of(tally)
            return
        if whole.findings or whole.remarks:
            return
        if tally is not None and counts_of(tally) != counts_of(whole):
            raise Unsettled(
                f"runs from copies of the explorer count otherwise than runs from the start: "
                f"{counts_of(tally)} and {counts_of(whole)} in the unit {unit.key}; {MEND}"
            )
        if walked.lost:
            self._lost += 1
            if self._lost >= MOST_LOST:
                raise Unsettled(
                    f"{self._lost} walks from copies of the explorer were lost, and no single run "
                    f"was; {MEND}"
                )
        if walked.suspect:
            found = self.stretches.engine.tally()
            self._find_out_of_step(walked.suspect, found)
            yield number, found
        elif walked.unlike:
            raise Unsettled(
                f"two walks from copies of the explorer differ, and no single run is wrong; {MEND}"
            )

    def _findings_of(self, tally: Tally) -> Tally:
        """A tally with these findings alone."""
        found = self.stretches.engine.tally()
        for finding in tally.findings:
            found.find(finding)
        return found

    def _can_walk(self, unit: LevelRuns) -> bool:
        """Whether the unit can be walked as a tree."""
        one = self.stretches.engine.scope.schedules == "one"
        if not one or unit.edges <= AGREEMENT_EDGES or self._given_up >= MOST_GIVEN_UP:
            return False
        return self._players.in_trees and self.stretches.level(unit).lighthouse in KINDS

    def _tally(self, unit: LevelRuns, walked: WalkedTree) -> tuple[Tally | None, WalkedTree]:
        """The tally of a tree; None if it was given up, or a law is not broken in single runs.

        A run of the tree that breaks a law, and by itself does not, is then the suspect.
        """
        if walked.rows is None:
            return None, walked
        engine = self.stretches.engine
        tally = tally_of(walked.rows, unit, engine.scope, engine.tally())
        for broken in walked.rows.broken:
            if not self.stretches.find(unit, broken, tally):
                return None, WalkedTree(None, broken)
        return tally, walked

    def _find_out_of_step(self, run: RunOfTree | BrokenRun, tally: Tally) -> None:
        """Find a run that goes another way from copies than from its start."""
        assert run.place is not None
        one = self.stretches.placed(run.sigma, run.alpha, run.place)
        for again, outcome in self.stretches.outcomes(one):
            settled = outcome
            if isinstance(outcome, Outcome) and outcome.violation is None:
                settled = replace(outcome, violation=nondeterministic(f"{DIFFERENT}; {COPIES}"))
            tally.find(self.stretches.finding(again, settled))

    def _walk(self, unit: LevelRuns) -> Generator[None, None, WalkedTree]:
        """Yield after each chunk of the tree of the unit; return the outcome."""
        level, players = self.stretches.level(unit), self._players
        memory = self._memory = self._memory or TreeMemoryPair()
        request = TreeRequest(
            level.edges,
            level.limit,
            level.simple,
            level.planar,
            level.lighthouse,
            level.policy,
            level.budgets,
            unit.prefix,
        )
        keep = self.stretches.engine.keep
        tree = UnitTree(level, request, keep, memory.first, memory.second, players.random)
        while tree.next is not None:
            # At first the second player changes soon.
            most = MOST_RUNS if players.tour.complete else SPELL
            played = memory.play(players, request, tree.next, most)
            if played is None or played.size < 0:
                return WalkedTree(None, lost=played is None)
            self._chunks += 1
            early = self._chunks <= BEGINNING
            singles = self._kept.draw(MOST_SINGLES if early else 2 * LATER)
            samples = MOST_SINGLES if early else LATER
            runs = tree.judge(played.size, singles, last=played.last, samples=samples)
            if runs is None or tree.undefined:
                return WalkedTree(None)
            again = memory.play_again(players, level.policy, tree.roots, runs + len(singles))
            if again is None or again.size < 0:
                return WalkedTree(None, lost=True)
            differ = tree.difference()
            if differ is not None:
                self._kept.forget()
                return WalkedTree(None, tree.run_at(differ), unlike=True)
            for run in tree.kept():
                self._kept.keep(run)
            yield
        return WalkedTree(tree.rows)
