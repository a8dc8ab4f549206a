"""The most expensive runs of a check, one for each size, played again."""

from __future__ import annotations

from collections.abc import Iterator

from allworlds.engines import AtRun, Limits, SingleRun, single_run, subject_of
from allworlds.inputs import InputError
from allworlds.judging import Rules
from allworlds.maps import CombinatorialMap
from allworlds.studies.check.report import CheckReport
from allworlds.world import World


def most_expensive_runs(report: CheckReport) -> Iterator[SingleRun]:
    """The most expensive run of each size, ascending; empty if the explorer has no name.

    Of several it is the least.

    Cost: an episode each.
    """
    limits, rules = Limits(), report.asked.rules
    try:
        subject = subject_of(report.explorer, limits)
    except InputError:  # it was handed over as a function that no name leads to
        return
    for _, row in sorted(report.tally.rows.items()):
        if row.most_expensive is not None:
            world = world_at(row.most_expensive, rules)
            yield single_run(subject, world, rules, row.most_expensive.choices, limits)


def world_at(run: AtRun, rules: Rules) -> World:
    """The world of the run under these rules."""
    map_ = CombinatorialMap(run.sigma, run.alpha)
    return World(map_, [*rules.kind.places(map_, 0)][run.place], 0)
