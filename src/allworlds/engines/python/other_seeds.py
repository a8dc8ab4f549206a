"""An explorer that goes by hashes, played with other hash seeds, too.

Runs are counted as they are with hash seed 0.  Then each unit is played once more with seeds that
its name determines, so that the findings do not depend on the order of the units.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import islice
from typing import Any
from zlib import crc32

from msgspec import Struct

from allworlds.document import replace
from allworlds.engines.python.examiner import Outcome
from allworlds.engines.python.hash_seeds import GOES_BY_HASHES
from allworlds.engines.python.run_counter import PartwiseEngine
from allworlds.engines.python.runs_of_unit import LevelRuns, UnitOfRuns
from allworlds.engines.python.second_play import MANY, PlayedTwice
from allworlds.engines.python.tally import Tally
from allworlds.engines.python.tour import SEEDS

SMALL = 3
"""The largest m of levels in which each run is played with every seed; in larger ones each unit
has one.  Samples, and worlds that the user has chosen, have every seed."""


def other_seeds(unit: UnitOfRuns) -> Sequence[int]:
    """The seeds with which a unit is played, besides 0."""
    every = range(1, SEEDS)
    if isinstance(unit, LevelRuns) and unit.edges > SMALL:
        return [every[crc32(unit.key.encode()) % len(every)]]
    return every


class WithOtherSeeds(Struct):
    """An engine that plays each unit once more with other seeds.

    Attributes:
        inside: the engine that counts.
        plays: plays the runs with other seeds.
        empty: makes an empty tally.
    """

    inside: PartwiseEngine
    plays: PlayedTwice
    empty: Callable[[], Tally]

    def parts(self, unit: UnitOfRuns, start: int = 0) -> Iterator[tuple[int, Any]]:
        """Yield the number of the next run and the result since, at intervals and at the end."""
        after = start
        for after, result in self.inside.parts(unit, start):
            yield after, result
        for seed in other_seeds(unit):
            for tally in self._tallies(unit, seed):
                yield after, tally
        tally = self.empty()
        tally.remark(GOES_BY_HASHES)
        yield after, tally

    def _tallies(self, unit: UnitOfRuns, seed: int) -> Iterator[Tally]:
        """Yield the findings among the runs of a unit with a seed; nothing is counted."""
        plays, players = self.plays, self.plays.players
        turn = players.tour.turn
        players.take_places(seed, 1, alike=True)
        runs = plays.engine.runs(unit)
        while some := list(islice(runs, MANY)):
            tally = self.empty()
            for one, outcome in plays.played_once(unit, some):
                size = one.world.map.edge_count, one.world.map.vertex_count
                wrong = not isinstance(outcome, Outcome) or outcome.violation
                if wrong and tally.wants(*size):
                    tally.find(replace(plays.finding(one, outcome), hash_seed=seed))
            yield tally
        players.take_places(0, turn, alike=True)
