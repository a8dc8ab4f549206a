"""Damaged tables and damaged lists of work: each dies by name, and none as a crash."""

import pytest

from allworlds import check
from allworlds.engines import compiled_engine as compiled, questions
from allworlds.engines.compiled_engine import compare_engines
from allworlds.engines.kernel.engine import judge, walk
from allworlds.engines.kernel.rows import LevelBounds, tables
from allworlds.engines.scope import Scope
from allworlds.engines.tally import EnginesDisagree
from allworlds.explorers.loading import load
from allworlds.judging.findings.rules import Rules
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.maps.enumeration import prefixes
from allworlds.outcome import Verdict
from engines import test_mutants as quick
from engines.test_mutants import WHOLE, asked

fresh_comparison = quick.fresh_comparison

pytestmark = pytest.mark.usefixtures("compiled")


def percepts_mixed_up(table):
    """The robot takes a vertex of degree 3 for one of degree 2."""
    table.sensed[3:4] = 2
    return table


def percepts_too_large(table):
    """The robot takes every vertex for one of the greatest degree."""
    table.sensed[1:] = len(table.sensed) - 1
    return table


def retracing_for_nothing(table):
    return table._replace(back_weight=0)


def retracing_counted_twice(table):
    return table._replace(back_weight=2)


def a_bound_too_small(table):
    table.bound[2] //= 2
    return table


def no_fuel(table):
    return table._replace(fuel=3)


def a_gluing_forgotten(table):
    """No decision leads to two darts owed and two open, from four edges on."""
    if len(table.viable) > 8:
        table.viable[2, 2] = 0
    return table


def dead_ends_allowed(table):
    table.viable[:, 0] = 1
    return table


TABLES = [
    percepts_mixed_up,
    percepts_too_large,
    retracing_for_nothing,
    retracing_counted_twice,
    a_bound_too_small,
    no_fuel,
    a_gluing_forgotten,
    dead_ends_allowed,
]


@pytest.mark.parametrize("mutant", TABLES, ids=lambda mutant: mutant.__name__)
def test_a_check_with_a_damaged_table_ends_as_an_internal_error(monkeypatch, mutant):
    monkeypatch.setattr(questions, "level_tables", lambda *a: mutant(WHOLE(*a)))
    report = check(edges=6, engine="kernel", workers=2)
    assert report.verdict is Verdict.ERROR
    assert report.exit_code == 70
    assert report.ending.reason


@pytest.mark.parametrize("mutant", TABLES, ids=lambda mutant: mutant.__name__)
def test_without_the_comparison_a_damaged_table_is_found_out_as_well(monkeypatch, mutant):
    monkeypatch.setattr(questions, "level_tables", lambda *a: mutant(WHOLE(*a)))
    monkeypatch.setattr(compiled, "compare_engines", lambda *_: None)
    report = check(edges=6, engine="kernel")
    if mutant in (retracing_for_nothing, retracing_counted_twice):
        # Only another engine can know what a walk should have cost.
        monkeypatch.undo()
        questions.level_of.cache_clear()
        honest = check(edges=6, engine="kernel")
        assert report.tally.traversals != honest.tally.traversals
        return
    assert report.exit_code == 70


@pytest.mark.parametrize("damage", ["doubled", "lost"])
def test_work_that_is_doubled_or_lost_fails_at_the_count_gate(monkeypatch, damage):
    units = Scope.units

    def damaged(self, edges):
        for i, unit in enumerate(units(self, edges)):
            copies = {"doubled": 2, "lost": 0}[damage] if (edges, i) == (6, 40) else 1
            yield from [unit] * copies

    monkeypatch.setattr(Scope, "units", damaged)
    report = check(edges=6, engine="kernel", workers=2)
    assert report.verdict is Verdict.ERROR
    wrong = [cell for cell in report.cells if not cell.agrees]
    assert wrong
    assert {cell.edges for cell in wrong} == {6}
    assert all((cell.enumerated > cell.counted) == (damage == "doubled") for cell in wrong)


def test_both_modes_break_in_the_same_worlds():
    allowed = [4, 20, 20, 20, 20, 20]
    bounds = LevelBounds(lambda n, _d0, _largest: allowed[n - 1])
    level = asked(5, tables=tables(5, 2000, allowed), bounds=bounds)
    for prefix in prefixes(5, depth=1):
        walked, judged = (does(level, prefix, keep=10_000) for does in (walk, judge))
        # A walk stands for every bearing, of which the judge keeps the least.
        assert [(world.vertices, world.sigma, world.alpha, 0) for world in walked.broken] == [
            (run.vertices, run.sigma, run.alpha, run.place) for run in judged.broken
        ]
        assert walked.counts == judged.counts


def test_a_disagreement_names_the_world(monkeypatch):
    monkeypatch.setattr(questions, "level_tables", lambda *a: retracing_for_nothing(WHOLE(*a)))
    scope = Scope(Extent(MapClass.MAPS, 6), Rules())
    with pytest.raises(EnginesDisagree, match=r"sigma=\[.*place=0"):
        compare_engines(scope, load("algorithm1"))
