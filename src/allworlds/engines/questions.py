"""Questions to the kernel, level by level, in its plain numbers; and tallies of its rows."""

from __future__ import annotations

from functools import cache

from allworlds.engines.kernel import engine as kernel
from allworlds.engines.kernel.rows import Level, LevelBounds, Rows, Tables, tables
from allworlds.engines.obstacles import kind_of
from allworlds.engines.scope import LevelRuns, Scope
from allworlds.engines.tally import AtRun, Row, Tally
from allworlds.inputs.checks import InputError
from allworlds.judging.findings.rules import Rules
from allworlds.maps.classes import Extent


@cache
def level_of(explorer: str, rules: Rules, extent: Extent, edges: int) -> Level:
    """The kernel's question for a level."""
    budgets = _budgets(rules, edges)
    return Level(
        edges,
        extent.vertex_limit(edges),
        extent.map_class.simple,
        extent.map_class.planar,
        explorer,
        kind_of(rules.kind),
        rules.policy,
        rules.applying,
        _bounds(rules, edges),
        budgets,
        level_tables(rules, edges),
    )


def _budgets(rules: Rules, edges: int) -> tuple[int, ...]:
    """The step budgets by vertices."""
    return (0, *(rules.budget_by_size(n, edges) for n in range(1, edges + 2)))


def _bounds(rules: Rules, edges: int) -> LevelBounds:
    bound = rules.the_bound

    def value(n: int, d0: int, largest: int) -> int | None:
        try:
            return bound.value(n, edges, d0, largest, 0, 0)  # see obstacles
        except InputError:
            return kernel.UNDEFINED

    return LevelBounds(value, "d0" in bound.variables, "D" in bound.variables)


def level_tables(rules: Rules, edges: int) -> Tables:
    """The tables that the kernel looks values up in; a walk's bound depends on n alone."""
    bounds = _bounds(rules, edges)
    plain = not (bounds.by_d0 or bounds.by_largest)
    values = [bounds.value(n, 0, 0) if plain else None for n in range(1, edges + 2)]
    return tables(edges, max(_budgets(rules, edges)), values)


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
    tally.witnesses = +tally.witnesses  # as the Python engine has them: without zeros
    return tally
