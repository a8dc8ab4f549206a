"""The dearest run of every size that a check has met, played again."""

from __future__ import annotations

from collections.abc import Iterator

from allworlds.checker.report import Report
from allworlds.checker.single import SingleRun, single_run
from allworlds.findings import Rules
from allworlds.inputs import InputError
from allworlds.isolation import subject_of
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.runs import AtRun
from allworlds.work import Limits
from allworlds.world import World


def dearest_runs(report: Report) -> Iterator[SingleRun]:
    """The dearest run of each size, ascending; nothing if the explorer has no name.

    Of several it is the least.

    Cost: an episode each.
    """
    limits, rules = Limits(), report.scope.rules
    try:
        subject = subject_of(report.explorer, limits)
    except InputError:  # it was handed over as a function that no name leads to
        return
    for _, row in sorted(report.tally.rows.items()):
        if row.dearest is not None:
            world = world_at(row.dearest, rules)
            yield single_run(subject, world, rules, row.dearest.choices, limits)


def world_at(run: AtRun, rules: Rules) -> World:
    """The world in which it was run under these rules."""
    map_ = CombinatorialMap(run.sigma, run.alpha)
    return World(map_, [*rules.kind.places(map_, 0)][run.place], 0)
