"""Damaged tables and damaged lists of work: each dies by name, and none as a crash."""

from dataclasses import replace

import pytest

from allworlds import check
from allworlds.checker import compiled
from allworlds.findings import Rules
from allworlds.kernel import engine
from allworlds.kernel.tables import tables
from allworlds.maps.enumeration import prefixes
from allworlds.outcome import Verdict
from allworlds.runs import Scope

pytestmark = pytest.mark.usefixtures("compiled")

WHOLE = compiled.level_tables


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
    table.bound[2] -= 4
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


@pytest.fixture(autouse=True)
def fresh_comparison():
    compiled.compare_engines.cache_clear()
    yield
    compiled.compare_engines.cache_clear()


@pytest.mark.parametrize("mutant", TABLES, ids=lambda mutant: mutant.__name__)
def test_a_check_with_a_damaged_table_ends_as_an_internal_error(monkeypatch, mutant):
    monkeypatch.setattr(compiled, "level_tables", lambda *a: mutant(WHOLE(*a)))
    report = check(edges=6, engine="kernel", workers=2)
    assert report.verdict is Verdict.ERROR
    assert report.exit_code == 70
    assert report.ending.reason


@pytest.mark.parametrize("mutant", TABLES, ids=lambda mutant: mutant.__name__)
def test_without_the_comparison_a_damaged_table_is_found_out_as_well(monkeypatch, mutant):
    monkeypatch.setattr(compiled, "level_tables", lambda *a: mutant(WHOLE(*a)))
    monkeypatch.setattr(compiled, "compare_engines", lambda *_: None)
    report = check(edges=6, engine="kernel")
    if mutant in (retracing_for_nothing, retracing_counted_twice):
        # Only another engine can know what a walk should have cost.
        honest = check(edges=6, engine="kernel") if monkeypatch.undo() else check(edges=6)
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
    wrong = [cell for cell in report.gate if not cell.agrees]
    assert wrong
    assert {cell.edges for cell in wrong} == {6}
    assert all((cell.enumerated > cell.counted) == (damage == "doubled") for cell in wrong)


@pytest.mark.parametrize("mode", ["walk", "thorough"])
def test_the_least_broken_worlds_come_first(mode):
    table = tables(4, 2000, [0, 0, 10, 10, 10])
    broken = []
    for prefix in prefixes(4, depth=1):
        rows = engine.examine(4, 5, "fifo", prefix, table, mode=mode, keep=3)
        assert list(rows.broken) == sorted(rows.broken)
        assert len(rows.broken) == min(3, sum(row.broken for row in rows.counts))
        broken += rows.broken
    # With one vertex 4 loops cost 4 traversals, and 0 are allowed: all 105 maps are broken.
    whole = engine.examine(4, 5, "fifo", (-8,), table, mode=mode, keep=500)
    assert len(whole.broken) == 105
    assert min(broken) == whole.broken[0]


def test_both_modes_break_in_the_same_worlds():
    table = tables(5, 2000, [4, 20, 20, 20, 20, 20])
    for prefix in prefixes(5, depth=1):
        walked, thorough = (
            engine.examine(5, 6, "fifo", prefix, table, mode=mode, keep=10_000)
            for mode in ("walk", "thorough")
        )
        assert walked == thorough


def test_a_walk_that_fails_half_way_blames_every_completion():
    # Out of fuel from the first pass on: every world of the unit is broken, and all are met.
    table = tables(4, 0)
    rows = engine.examine(4, 5, "fifo", (-3,), table, keep=1000)
    honest = engine.examine(4, 5, "fifo", (-3,), tables(4, 2000))
    assert [row.worlds for row in rows.counts] == [row.worlds for row in honest.counts]
    assert len({*rows.broken}) == sum(row.worlds for row in honest.counts)
    assert all(row.broken == row.worlds and row.traversals == 0 for row in rows.counts)


def test_a_disagreement_names_the_world():
    rules = Rules()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(compiled, "level_tables", lambda *a: retracing_for_nothing(WHOLE(*a)))
        with pytest.raises(compiled.EnginesDisagree, match=r"sigma=\[.*bearing=0"):
            compiled.compare_engines(rules.policy, 4)


def test_rules_are_left_as_they_were():
    rules = Rules(bound="m * n")
    assert WHOLE(rules, 3).bound.tolist() == [0, 3, 6, 9, 12]
    assert WHOLE(replace(rules, bound="none"), 3).bound.min() == 0
