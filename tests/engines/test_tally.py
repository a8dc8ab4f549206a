from collections import Counter
from dataclasses import astuple, fields, replace
from itertools import permutations
from types import SimpleNamespace

import pytest
from msgspec import Struct

from allworlds.engines import tally as tallying, units
from allworlds.engines.kernel.schedules import ScheduleCosts
from allworlds.engines.lanes import workers_for
from allworlds.engines.limits import Limits
from allworlds.engines.single import subject_of
from allworlds.engines.tally import AtRun, Row, RunCounter, Tally
from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.judging.rules import Rules
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import rooted_code
from allworlds.maps.enumeration import FINGERPRINTS, fingerprint, rooted_maps
from allworlds.robots.team import TeamRow
from allworlds.studies.count import Counted
from allworlds.studies.fuzz.sample_sweep import SampleCounter
from allworlds.studies.fuzz.sampling import batches
from allworlds.studies.worst.compiled_engine import _joined
from allworlds.world.lighthouses.kinds import lighthouse_kind


class Found:
    def __init__(self, *key, kind=None):
        self.key = self.rank = key
        self.kind = kind or key


def tallies():
    for i in (1, 2, 3):
        tally = Tally(2)
        tally.row(i, 2).add(Row(i, 2 * i, 2 * i, 5, 3, max_cost=i, bound=None if i == 2 else i))
        tally.row(1, 1).add(Row(1, 1, 1, 1, 1, max_cost=7 - i, bound=i))
        tally.witnesses["loop"] = i
        tally.left_out = tally.checkpoints = i
        tally.find(Found(i, 2))
        tally.find(Found(4 - i, 1))
        yield tally


def test_the_order_of_the_parts_does_not_matter():
    sums = []
    for order in permutations(range(3)):
        total, parts = Tally(2), list(tallies())
        for i in order:
            total.add(parts[i])
        keys = [found.key for found in total.findings]
        sums.append((total.rows, total.witnesses, total.left_out, total.checkpoints, keys))
    assert all(each == sums[0] for each in sums)
    assert sums[0][0][1, 1] == Row(3, 3, 3, 3, 3, max_cost=6, bound=3)
    assert sums[0][4] == [(1, 1), (1, 2)]


def test_only_what_may_be_among_the_smallest_is_wanted():
    tally = Tally(1)
    assert tally.wants(9, 9)
    tally.find(Found(2, 2))
    assert tally.wants(2, 2)
    assert tally.wants(1, 9)
    assert not tally.wants(2, 3)


def test_the_largest_of_negative_bounds_is_negative():
    row = Row(bound=-5)
    row.add(Row(bound=-7))
    row.add(Row())
    assert row.bound == -5
    row.bound_of(None)
    row.bound_of(-3)
    assert row.bound == -3


def test_of_each_kind_the_smallest_is_kept_whatever_comes_first():
    found = [Found(i, kind=kind) for i, kind in enumerate("aababcbdca")]
    for order in permutations(found[:6]):
        tally = Tally(2)
        for one in order:
            tally.find(one)
        assert [(kept.key, kept.kind) for kept in tally.findings] == [((0,), "a"), ((2,), "b")]
    parts = [Tally(3), Tally(3)]
    for i, one in enumerate(reversed(found)):
        parts[i % 2].find(one)
    parts[0].add(parts[1])
    assert [kept.key for kept in parts[0].findings] == [(0,), (2,), (5,)]


LEVELS = units.Scope(Extent(MapClass.MAPS, 3), Rules())
DRAWN = units.Scope(Extent(MapClass.MAPS, 8), Rules(), coverage=units.Sample(40))


@pytest.mark.parametrize("scope", [LEVELS, DRAWN])
def test_a_run_counts_once_both_of_its_plays_are_compared(monkeypatch, scope):
    monkeypatch.setattr(tallying, "REPORT_EVERY", -1.0)
    plays, total, unfinished = 0, Tally(1), 0

    def explorer(first, choices):
        nonlocal plays
        plays += 1
        return (yield from algorithm1(first, choices))

    limits = Limits()
    subject = subject_of(explorer, limits)
    counter = SampleCounter(scope, 1, subject=subject, limits=limits)
    pieces = batches(scope.coverage)
    if scope is LEVELS:
        counter, pieces = RunCounter(scope, 1), units.units_of_level(scope.extent, 3)
    with workers_for(subject, limits) as transport:
        for part in transport.map(counter, pieces):
            total.add(part.result)
            unfinished += not part.last
            episodes = sum(row.episodes for row in total.rows.values())
            assert episodes == total.runs <= plays // 2
    assert unfinished
    assert total.worlds == (74 if scope is LEVELS else 40)


# ---------------------------------------------------------------- sums


def of_numbers(kind, first):
    """A value of a class whose fields are all different numbers, from the first one on."""
    return kind(**{field.name: first + i for i, field in enumerate(fields(kind))})


def test_the_counts_of_two_parts_add_up_field_by_field():
    whole = of_numbers(TeamRow, 10)
    whole.add(of_numbers(TeamRow, 100))
    largest = {"most", "longest"}
    assert [*astuple(whole)] == [
        (0 if field.name in largest else 10 + i) + 100 + i
        for i, field in enumerate(fields(TeamRow))
    ]
    whole.add(replace(of_numbers(TeamRow, 0), schedules=None))
    assert whole.schedules is None
    whole.add(of_numbers(TeamRow, 0))
    assert whole.schedules is None


def test_the_rows_of_two_tallies_add_up_field_by_field():
    costs = {"max_cost": 6, "bound": -7, "best_cost": 8, "fingerprint": FINGERPRINTS - 1}
    whole = Row(1, 2, 3, 4, 5, **costs)
    whole.add(Row(10, 20, 30, 40, 50, max_cost=5, bound=-9, best_cost=9, fingerprint=3))
    assert [*astuple(whole)] == [11, 22, 33, 44, 55, 6, -7, None, 9, 2]
    whole.add(Row(bound=None, best_cost=None))
    assert (whole.bound, whole.best_cost) == (-7, 9)


def test_counts_of_maps_add_up_field_by_field():
    whole = Counted(Counter({(1, 0): 2}), Counter({(1, 0): 3}), 4, 5)
    whole.add(Counted(Counter({(1, 0): 20, (2, 1): 1}), Counter({(1, 0): 30}), 40, 50))
    assert whole.cells == {(1, 0): 22, (2, 1): 1}
    assert (whole.fixed, whole.mirrored, whole.dual) == ({(1, 0): 33}, 44, 55)


def test_the_costs_of_schedules_add_up_and_keep_the_most_expensive():
    def costs(worst, sigma, *numbers):
        rooted, best, tests, wrong = numbers
        return ScheduleCosts(2, rooted, worst, best, tests, wrong, sigma, (1, 0))

    joined = _joined(costs(7, (0, 1), 1, 9, 3, 4), costs(7, (1, 0), 10, 20, 30, 40))
    assert (joined.worst, joined.sigma) == (7, (0, 1))
    assert (joined.rooted, joined.best, joined.tests, joined.wrong) == (11, 20, 33, 44)
    assert _joined(costs(7, (0, 1), 1, 9, 3, 4), costs(8, (1, 0), 1, 9, 3, 4)).worst == 8


def test_the_parts_of_a_check_add_up_field_by_field():
    whole, part = Tally(1), Tally(1)
    assert [*astuple(Row())] == [0, 0, 0, 0, 0, 0, None, None, None, 0]
    for number, tally in enumerate((whole, part), 1):
        tally.witnesses["loop"] = tally.remarks["odd"] = tally.covered["n", 2] = number
        tally.left_out += 10 * number
        tally.checkpoints += 100 * number
        tally.row(number, 1).add(Row(1, 2, 3, 4, 5, max_cost=number))
    whole.add(part)
    assert (whole.witnesses, whole.remarks, whole.covered) == (
        {"loop": 3},
        {"odd": 3},
        {("n", 2): 3},
    )
    assert (whole.left_out, whole.checkpoints) == (30, 300)
    assert (whole.worlds, whole.runs, whole.traversals) == (2, 4, 8)
    assert [*whole.costs_by_size] == [(1, 1, 1), (2, 1, 2)]


def test_of_the_most_expensive_runs_the_first_is_kept():
    first, second, third = (AtRun((number,), (0,), 0, ()) for number in (1, 2, 3))
    row = Row()
    for cost, where, most in ((0, third, third), (0, second, second), (0, third, second)):
        row.cost_of(cost, where)
        assert (row.max_cost, row.most_expensive) == (0, most)
    for cost, where in ((4, third), (3, first)):
        row.cost_of(cost, where)
        assert (row.max_cost, row.most_expensive) == (4, third)
    part = Row(max_cost=4)
    part.most_expensive = second
    row.add(part)
    row.add(Row(max_cost=4))
    assert row.most_expensive == second
    assert row == Row(max_cost=4)


def test_the_largest_cost_of_a_cheapest_schedule_is_kept_even_if_it_is_nothing():
    row = Row()
    for cost, best in ((None, None), (0, 0), (3, 3), (2, 3)):
        row.best_of(cost)
        assert row.best_cost == best


def test_whether_a_finding_is_wanted_depends_on_the_largest_that_is_kept():
    tally = Tally(2)
    for key in ((1, 1, 0), (2, 2, 0)):
        tally.find(Found(*key))
    assert tally.wants(2, 2)
    assert not tally.wants(2, 3)


def test_of_findings_of_one_rank_the_earlier_is_kept():
    one, other, last = Found(1, kind="a"), Found(1, kind="a"), Found(1, kind="b")
    tally = Tally(1)
    for found in (one, other, last):
        tally.find(found)
    assert tally.findings == [one]
    tally = Tally(2)
    for found in (one, other):
        tally.find(found)
    assert tally.findings == [one]


def counted(kind, edges=2):
    """The tally of a level after the count of its runs, and those of them that have a place."""
    counter = RunCounter(units.Scope(Extent(MapClass.MAPS, edges), Rules(lighthouse_kind(kind))), 1)
    tally, placed = counter.tally(), []
    for unit in units.units_of_level(counter.scope.extent, edges):
        for run in counter.runs(unit):
            world = counter.count_run(run, tally)
            assert (world is None) == (run.lighthouse is None)
            placed += [(world, run.place)] if world else []
    return counter, tally, placed


def test_the_first_run_of_a_world_counts_the_world():
    _, tally, placed = counted("directional")
    maps = [*rooted_maps(2)]
    assert (tally.worlds, tally.runs, tally.left_out) == (len(maps), len(placed), 0)
    loops, parallels = (
        sum(bool(getattr(map_, f"{kind}_count")) for map_ in maps) for kind in ("loop", "parallel")
    )
    assert tally.witnesses == {"loop-edge": loops, "parallel-edge": parallels}
    for n in (1, 2, 3):
        of_size = [fingerprint(map_) for map_ in maps if map_.vertex_count == n]
        row = tally.rows[2, n]
        assert (row.worlds, row.fingerprint) == (len(of_size), sum(of_size) % FINGERPRINTS)
        assert row.runs == sum(world.map.vertex_count == n for world, _ in placed)


def test_a_world_without_a_place_is_left_out_and_has_no_run():
    _, tally, placed = counted("natural")
    assert tally.left_out == len([*rooted_maps(2)]) - len({world.map for world, _ in placed}) > 0
    assert tally.runs == len(placed)


def test_an_outcome_counts_in_the_row_of_its_world():
    counter, _, placed = counted("directional")
    tally = Tally(1)
    worlds = {world.map.vertex_count: world for world, _ in placed}
    world = worlds[2]
    code, another = (rooted_code(world.map.sigma, world.map.alpha, dart) for dart in (0, -1))
    assert code != another
    for place, cost in ((3, 5), (2, 7), (1, 7), (0, 1)):
        episode = SimpleNamespace(checkpoints=[1, 2])
        outcome = SimpleNamespace(cost=cost, bound=cost, choices=(9 - place,), episode=episode)
        counter.count_outcome(world, place, outcome, tally)
    row = tally.rows[2, 2]
    assert row == Row(0, 0, 4, 20, 1, 7, 7)
    assert row.most_expensive == (*code, 1, (8,))
    assert tally.checkpoints == 8


@pytest.mark.parametrize("schedules", ["one", "all"])
def test_the_cheapest_schedule_counts_if_every_one_is_tried(schedules):
    (world, _), tally = counted("directional")[2][0], Tally(1)
    scope = units.Scope(Extent(MapClass.MAPS, 2), Rules(), schedules=schedules)
    RunCounter(scope, 1).count_best(world, 4, tally)
    best = {row.best_cost for row in tally.rows.values()}
    assert best == ({4} if schedules == "all" else set())


def test_a_finding_is_made_only_of_a_broken_law_and_if_it_is_wanted():
    counter, _, ((world, place), *_) = counted("directional")
    referee = SimpleNamespace(finding=lambda *_: Found(world.map.edge_count, 0))
    tally = Tally(1)
    counter.settle(referee, world, place, SimpleNamespace(violation=None), tally)
    assert tally.findings == []
    counter.settle(referee, world, place, SimpleNamespace(violation="map"), tally)
    (found,) = tally.findings
    assert found.key == (2, 0)
    tally.findings = [Found(1, 1)]
    referee.finding = None
    counter.settle(referee, world, place, SimpleNamespace(violation="map"), tally)


class Kept(Struct):
    under: Rules | None = None


def test_the_rules_of_the_job_are_put_into_every_finding():
    tally, rules = Tally(2, findings=[Kept(), Kept()]), Rules()
    assert tally.under(rules) is tally
    assert tally.findings == [Kept(rules), Kept(rules)]
