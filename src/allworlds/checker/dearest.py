"""The dearest run of every size that a check has met, played again."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from allworlds.checker.report import Report
from allworlds.checker.single import SingleRun, single_run
from allworlds.findings import Rules
from allworlds.inputs import InputError
from allworlds.isolation import subject_of, workers_for
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.progress import Silent
from allworlds.runs import (
    AtRun,
    Costing,
    CostTally,
    Examiner,
    InUnit,
    Scope,
    Unit,
    name_run,
    numbered_runs,
)
from allworlds.subjects import Subject
from allworlds.work import Limits, gather
from allworlds.world import World


def dearest_runs(report: Report) -> Iterator[SingleRun]:
    """The dearest run of each size, ascending; nothing if the explorer has no name.

    Of several it is the least, or one of the first unit that has one.

    Cost: an episode each; where the compiled engine has counted, up to a unit of them.
    """
    limits = Limits()
    try:
        subject = subject_of(report.explorer, limits)
    except InputError:  # it was handed over as a function that no name leads to
        return
    for (edges, vertices), row in sorted(report.tally.rows.items()):
        where: AtRun | None
        match row.dearest:
            case InUnit(prefix):
                sought = _Sought(vertices, row.max_cost, Unit(edges, prefix))
                where = sought.found(subject, report.scope, limits)
            case where:
                pass
        if where is not None:
            yield _played(subject, report.scope.rules, where, limits)


def _played(subject: Subject, rules: Rules, where: AtRun, limits: Limits) -> SingleRun:
    map_ = CombinatorialMap(where.sigma, where.alpha)
    lighthouse = [*rules.kind.places(map_, 0)][where.place]
    return single_run(subject, World(map_, lighthouse, 0), rules, where.choices, limits)


@dataclass(frozen=True, slots=True)
class _Sought:
    """A run of that cost in a map of that size, which is known to be in that unit."""

    vertices: int
    cost: int
    unit: Unit

    def found(self, subject: Subject, scope: Scope, limits: Limits) -> AtRun | None:
        """The first; None if there is none after all."""
        if subject.foreign:
            return self._apart(subject, scope, limits)
        examiner = Examiner(subject, scope.rules)
        for run in numbered_runs(self.unit, scope.extent, scope.rules.kind):
            if run.lighthouse is None or run.map.vertex_count != self.vertices:
                continue
            world = World(run.map, run.lighthouse, 0)
            for choices in scope.schedule(name_run(scope.rules, world)):
                outcome = examiner.examine(world, choices)
                if outcome.cost == self.cost:
                    return AtRun(run.map.sigma, run.map.alpha, run.place, outcome.choices)
        return None

    def _apart(self, subject: Subject, scope: Scope, limits: Limits) -> AtRun | None:
        """The least, where foreign code is played: in processes of its own."""
        tally = CostTally(1)
        with workers_for(subject, limits) as transport:
            gather(transport, Costing(scope, 1), [self.unit], tally, Silent())
        return min(
            (
                AtRun(sigma, alpha, place, cost.choices)
                for ((_, vertices, sigma, alpha), place), cost in tally.costs.items()
                if vertices == self.vertices and cost.dearest == self.cost
            ),
            default=None,
        )
