"""The compiled engine of a check: rows of the kernel into tallies.

In small worlds every run is played and judged by itself.  From
:data:`allworlds.engines.compiled.sizes.WALKED_FROM` edges on Algorithm 1 with its
directional lighthouse is walked once in each rooted map, and the walk is counted for every
bearing, because the marker's direction only tells the darts of v0 apart.  That premise, and the
kernel itself, are compared with the general engine before the first level
(:mod:`allworlds.engines.compiled.agreement`).  A broken law is reported only as the general
engine finds it.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from typing import Any, Self

from msgspec import Struct, field

from allworlds.engines.compiled.agreement import AGREEMENT_EDGES, compare_engines
from allworlds.engines.compiled.obstacles import walks
from allworlds.engines.compiled.requests import level_of
from allworlds.engines.compiled.sizes import WALKED_FROM
from allworlds.engines.engine_table import Job
from allworlds.engines.kernel import engine as kernel
from allworlds.engines.kernel.capabilities import COMPILING
from allworlds.engines.kernel.compiling import is_compiled
from allworlds.engines.kernel.rows import BrokenRun, Rows
from allworlds.engines.kernel.runs import examine
from allworlds.engines.python.examiner import Examiner
from allworlds.engines.python.run_counter import EnginesDisagree
from allworlds.engines.python.runs_of_unit import LevelRuns
from allworlds.engines.python.scope import Scope
from allworlds.engines.python.tally import AtRun, Row, Tally
from allworlds.engines.units import level_size
from allworlds.explorers import Subject
from allworlds.maps import CombinatorialMap, InvalidMap
from allworlds.world import World

BATCH = 8
"""Units that a thread does at a time, so that handing them over costs little."""

SOON, SOON_WALKED = 10_000, 2_000_000
"""The number of worlds that are judged, or walked, in a tenth of a second: about the time until the
workers of a cluster are busy, and then until all have sent their results."""

SYMMETRY = (
    f"from m = {WALKED_FROM} on each rooted map is walked once, at bearing 0, and counted for "
    "every bearing: the walk does not depend on it, as the python engine confirms on every "
    f"bearing up to m = {AGREEMENT_EDGES}"
)


class CompiledEngine(Struct, frozen=True):
    """The engine in which the kernel plays and judges, or walks, all runs of a unit.

    Attributes:
        scope, subject, keep: as for the general engine.
        flag: its entry 0 tells the kernel to give up.
        reached: by edges and vertices, the cost of some walk: a cheaper run is not the most
            expensive.
    """

    scope: Scope
    subject: Subject
    keep: int
    flag: Any = field(default_factory=kernel.flag)
    reached: dict[int, Any] = field(default_factory=dict)

    @classmethod
    def ready(cls, job: Job) -> Self:
        """The engine, after it has been compared with the general one.

        Raises:
            EnginesDisagree: naming the first world in which they do.
        """
        if not is_compiled(examine):
            job.notice(COMPILING)
        compare_engines(job.scope, job.subject)
        return cls(job.scope, job.subject, job.keep)

    def halt(self) -> None:
        """Make all threads give up their work."""
        self.flag[0] = 1

    def is_soon_done(self, unit: LevelRuns) -> bool:
        """Whether the level of a unit is small: sending it away would take longer than doing it."""
        most = SOON_WALKED if walks(self.scope, self.subject, unit.edges) else SOON
        return level_size(self.scope.extent, unit.edges) <= most

    def parts(self, unit: LevelRuns) -> Iterator[Tally]:
        """The tally of the unit, equal to the general engine's.

        Raises:
            EnginesDisagree: if the general engine does not confirm a broken law.
            InputError: for a bound that has no value in a world.
        """
        scope = self.scope
        level = level_of(self.subject.name, scope.rules, scope.extent, unit.edges)
        if walks(scope, self.subject, unit.edges):
            known = self.reached.setdefault(unit.edges, kernel.reached_in(unit.edges))
            rows = kernel.walk(level, unit.prefix, keep=self.keep, reached=known, halt=self.flag)
        else:
            rows = kernel.judge(level, unit.prefix, keep=self.keep, halt=self.flag)
        yield self._tally(unit, rows)

    def _tally(self, unit: LevelRuns, rows: Rows) -> Tally:
        tally = tally_of(rows, unit, self.scope, Tally(self.keep))
        tally.witnesses.update(rows.events)
        tally.witnesses = +tally.witnesses
        for broken in rows.broken:
            self._blame(broken, tally)
        return tally

    def _blame(self, broken: BrokenRun, tally: Tally) -> None:
        """Find the runs by the general engine in which the kernel finds a law broken.

        Raises:
            EnginesDisagree: if the general engine finds another law broken, or none.
        """
        try:
            map_ = CombinatorialMap(broken.sigma, broken.alpha)
        except InvalidMap as error:
            raise EnginesDisagree(f"the kernel met a world that is none: {error}") from None
        rules = self.scope.rules
        examiner = Examiner(self.subject, rules)
        places = enumerate(rules.kind.places(map_, 0))
        only = slice(None) if broken.place is None else slice(broken.place, broken.place + 1)
        for place, lighthouse in islice(places, only.start, only.stop):
            world = World(map_, lighthouse, 0)
            outcome = examiner.examine(world, rules.choices(""))
            law = outcome.violation.law if outcome.violation else ""
            if not law or broken.law not in ("", law):
                raise EnginesDisagree(
                    f"the kernel says that {broken.law or 'a law'} is broken, the python engine "
                    f"that {law or 'none'} is, in the world sigma={list(map_.sigma)} "
                    f"alpha={list(map_.alpha)} place={place}"
                )
            tally.find(examiner.finding(world, place, outcome))


def tally_of(rows: Rows, unit: LevelRuns, scope: Scope, tally: Tally) -> Tally:
    """The empty tally with the kernel's counts, without the events and the findings."""
    most_expensive = {
        n: AtRun(sigma, alpha, place, ()) for n, sigma, alpha, place in rows.most_expensive
    }
    for counts in rows.counts:
        row = tally.row(unit.edges, counts.vertices)
        row.add(
            Row(
                counts.worlds,
                counts.runs,
                counts.runs,
                counts.traversals,
                counts.traversals_rooted,
                counts.largest,
                most_expensive=most_expensive.get(counts.vertices),
            )
        )
        tally.checkpoints += counts.checkpoints
        tally.left_out += counts.left_out
        tally.witnesses["loop-edge"] += counts.loops
        tally.witnesses["parallel-edge"] += counts.parallels
    for n, d0, largest in rows.met:
        # Where a run has a bound without a value, this says so.
        bound = scope.rules.the_bound.value(n, unit.edges, d0, largest, 0, 0)
        tally.row(unit.edges, n).bound_of(bound)
    return tally
