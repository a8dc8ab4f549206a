"""Damaged tables and damaged lists of work: each dies by name, and none as a crash."""

import pytest

from allworlds import check
from allworlds.documents.document import replace
from allworlds.engines import compiled_engine as compiled
from allworlds.engines.compiled_engine import compare_engines
from allworlds.engines.kernel.engine import judge, walk
from allworlds.engines.kernel.worlds import gluing_rule
from allworlds.engines.tally import EnginesDisagree
from allworlds.engines.units import Scope, units_of_level
from allworlds.explorers.loading import load
from allworlds.judging.rules import Rules
from allworlds.maps import CombinatorialMap, MapClass, rooted_maps, unrooted_code
from allworlds.maps.classes import Extent
from allworlds.maps.enumeration import prefixes
from allworlds.outcome import Verdict
from engines import test_mutants as quick
from engines.test_mutants import table_of

fresh_comparison = quick.fresh_comparison

pytestmark = pytest.mark.usefixtures("compiled")


def too_small(honest):
    """The bound of worlds with two vertices is half as large."""

    def bounds(*arguments):
        table = honest(*arguments)
        table[2] = [[bound // 2 for bound in row] for row in table[2]]
        return table

    return bounds


def a_gluing_forgotten(honest):
    """No decision leads to two darts owed and two open, from four edges on."""

    def rule(edges):
        viable = honest(edges)
        if edges >= 4:
            viable[2, 2] = 0
        return viable

    return rule


def dead_ends_allowed(honest):
    def rule(edges):
        viable = honest(edges)
        viable[:, 0] = 1
        return viable

    return rule


MUTANTS = [
    ("allworlds.engines.compiled_engine.bounds_of", compiled.bounds_of, too_small),
    ("allworlds.engines.kernel.engine.gluing_rule", gluing_rule, a_gluing_forgotten),
    ("allworlds.engines.kernel.engine.gluing_rule", gluing_rule, dead_ends_allowed),
]


@pytest.mark.slowest
@pytest.mark.parametrize(
    ("where", "honest", "mutant"), MUTANTS, ids=lambda part: getattr(part, "__name__", part)
)
@pytest.mark.parametrize("compares", [True, False])
def test_a_check_with_a_damaged_table_ends_as_an_internal_error(
    monkeypatch, where, honest, mutant, compares
):
    monkeypatch.setattr(where, mutant(honest))
    if not compares:
        monkeypatch.setattr(compiled, "compare_engines", lambda *_: None)
    report = check(edges=6, engine="kernel", workers=2)
    assert report.verdict is Verdict.ERROR
    assert report.exit_code == 70
    if compares:
        assert report.ending.reason


@pytest.mark.slowest
@pytest.mark.parametrize("damage", ["doubled", "lost"])
def test_work_that_is_doubled_or_lost_fails_at_the_count_gate(monkeypatch, damage):
    units = units_of_level

    def damaged(extent, edges, *more):
        for i, unit in enumerate(units(extent, edges, *more)):
            copies = {"doubled": 2, "lost": 0}[damage] if (edges, i) == (6, 40) else 1
            yield from [unit] * copies

    monkeypatch.setattr("allworlds.engines.units.units_of_level", damaged)
    report = check(edges=6, engine="kernel", workers=2)
    assert report.verdict is Verdict.ERROR
    wrong = [cell for cell in report.cells if not cell.agrees]
    assert wrong
    assert {cell.edges for cell in wrong} == {6}
    assert all((cell.enumerated > cell.counted) == (damage == "doubled") for cell in wrong)


@pytest.mark.slowest
def test_both_modes_break_in_the_same_worlds():
    allowed = [4, 20, 20, 20, 20, 20]
    level = asked(5, bounds=table_of([0, *allowed]))
    for prefix in prefixes(5, depth=1):
        walked, judged = (does(level, prefix, keep=10_000) for does in (walk, judge))
        # A walk stands for every bearing, of which the judge keeps the least.
        assert [(world.vertices, world.sigma, world.alpha, 0) for world in walked.broken] == [
            (run.vertices, run.sigma, run.alpha, run.place) for run in judged.broken
        ]
        assert walked.counts == judged.counts


@pytest.mark.slowest
def test_a_disagreement_names_the_world(monkeypatch):
    honest = walk

    def without_retracing(*arguments, **options):
        rows = honest(*arguments, **options)
        return replace(rows, counts=tuple(replace(row, largest=8) for row in rows.counts))

    monkeypatch.setattr("allworlds.engines.kernel.engine.walk", without_retracing)
    scope = Scope(Extent(MapClass.MAPS, 6), Rules())
    with pytest.raises(EnginesDisagree, match=r"one walk for every bearing, .*sigma=\["):
        compare_engines(scope, load("algorithm1"))


def asked(edges, **given):
    """The question of a level, with these values."""
    level = compiled.level_of("algorithm1", Rules(), Extent(MapClass.MAPS, edges), edges)
    return replace(level, **given)


def test_the_least_broken_worlds_come_first():
    level = asked(4, bounds=table_of([0, 0, 0, 10, 10, 10]), budgets=(2000,))
    for prefix in prefixes(4, depth=1):
        few, all_ = (walk(level, prefix, keep=keep).broken for keep in (3, 500))
        codes = [(world.vertices, world.sigma, world.alpha) for world in all_]
        assert codes == sorted(codes)
        assert few == all_[:3]
    # With one vertex 4 loops cost 4 traversals, and 0 are allowed: all 105 rooted maps are broken.
    # They are 18 maps without a root (OEIS A007769), of each of which the least is kept.
    assert len(walk(level, (-8,), keep=500).broken) == 18


def test_a_walk_that_fails_half_way_blames_every_completion():
    # Out of fuel from the first pass on: every world of the unit is broken, and all are met.
    broken = walk(asked(4, budgets=(0,)), (-3,), keep=1000)
    honest = walk(asked(4), (-3,))
    assert [row.worlds for row in broken.counts] == [row.worlds for row in honest.counts]
    maps = [CombinatorialMap(world.sigma, world.alpha) for world in broken.broken]
    blamed = {unrooted_code(map_) for map_ in maps}
    assert blamed == {unrooted_code(map_) for map_ in rooted_maps(4, prefix=(-3,))}
    assert len(blamed) == len(maps)  # the least of each
    assert all(row.traversals == 0 for row in broken.counts)
