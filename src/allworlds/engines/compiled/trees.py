"""Users' explorers that can be copied: the runs of a unit as one tree, walked twice, judged between.

The first player walks a chunk of the tree and decides the worlds on the way; the referee judges it and
cuts it into segments; the second player walks these, in another order, from copies of its own.
With each chunk some runs of earlier ones are played from their start, without a copy.

Where something is wrong with a chunk, the unit is left to the engine that plays run by run
(:mod:`allworlds.engines.compiled.stretches`), which also finds the law that is broken.  If that one
finds nothing, a copy has gone another way than a run from its start does.
"""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass, field
from typing import NamedTuple

from allworlds.engines.isolation.jobs import Unsettled
from allworlds.engines.isolation.player_pair import PlayerPair
from allworlds.engines.isolation.shared_logs import TreeMemoryPair
from allworlds.engines.kernel.chunks import SingleRun, UnitTree
from allworlds.engines.kernel.on_demand import KINDS
from allworlds.engines.kernel.rows import Level, Rows
from allworlds.engines.kernel.tree_requests import TreeRequest
from allworlds.engines.kernel.trees import MOST_RUNS, MOST_SINGLES
from allworlds.engines.python.runs_of_unit import LevelRuns
from allworlds.engines.python.second_play import EarlierPlays
from allworlds.engines.python.tour import SPELL

MOST_GIVEN_UP = 3
"""The number of units one after the other after which no more are walked as trees."""

MOST_LOST = 2
"""The number of times that a player may be lost in a tree, if it is not lost run by run."""


class Walked(NamedTuple):
    """The outcome of a unit that was walked as a tree.

    Attributes:
        rows: of the whole unit; None if it was given up.
        suspect: a run in which a copy perhaps went another way.
        lost: whether a player was lost.
    """

    rows: Rows | None
    suspect: SingleRun | None = None
    lost: bool = False


@dataclass(slots=True)
class TreesOfRuns:
    """The trees of a user's explorer.

    Attributes:
        players: as for the general engine.
        keep: the number of broken runs that are kept.
    """

    players: PlayerPair
    keep: int
    _memory: TreeMemoryPair | None = None
    _kept: EarlierPlays[SingleRun] = field(default_factory=EarlierPlays)
    _given_up: int = 0
    _lost: int = 0

    def can_walk(self, level: Level) -> bool:
        """Whether the units of this level can be walked as trees."""
        if self._given_up >= MOST_GIVEN_UP or not self.players.in_trees:
            return False
        return level.lighthouse in KINDS

    def walk(self, unit: LevelRuns, level: Level) -> Generator[None, None, Walked]:
        """Yield after each chunk of the unit; return the outcome."""
        walked = yield from self._walk(unit, level)
        self._given_up = 0 if walked.rows else self._given_up + 1
        return walked

    def settle_loss(self, *, repeated: bool) -> None:
        """Note that a player was lost in a tree, and whether it was lost run by run, too.

        Raises:
            Unsettled: if it was not, again and again.
        """
        self._lost += not repeated
        if self._lost >= MOST_LOST:
            raise Unsettled(
                f"{self._lost} players were lost while they went on from copies of the explorer's "
                "state, and none of them when they played run by run; mend the copying, or leave it out"
            )

    def _walk(self, unit: LevelRuns, level: Level) -> Generator[None, None, Walked]:
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
        random = self.players.random
        tree = UnitTree(level, request, self.keep, memory.first, memory.second, random)
        while tree.next is not None:
            # At first the second player changes soon.
            most = MOST_RUNS if self.players.tour.complete else SPELL
            played = memory.play(self.players, request, tree.next, most)
            if played is None or played.size < 0:
                return Walked(None, lost=played is None)
            singles = self._kept.draw(MOST_SINGLES)
            runs = tree.judge(played.size, singles, last=played.last)
            if runs is None or tree.undefined:
                return Walked(None)
            count = runs + len(singles)
            again = memory.play_again(self.players, level.policy, tree.roots, count)
            if again is None or again.size < 0:
                return Walked(None, lost=again is None)
            differ = tree.difference()
            if differ is not None:
                self._kept.forget()
                return Walked(None, tree.run_at(differ))
            for run in tree.kept():
                self._kept.keep(run)
            yield
        return Walked(tree.rows)
