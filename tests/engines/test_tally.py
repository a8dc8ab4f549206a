from collections import Counter
from dataclasses import astuple, fields, replace
from itertools import permutations

import pytest

from allworlds.engines import tally as tallying, units
from allworlds.engines.kernel.schedules import ScheduleCosts
from allworlds.engines.lanes import workers_for
from allworlds.engines.limits import Limits
from allworlds.engines.single import subject_of
from allworlds.engines.tally import Row, RunCounter, Tally
from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.judging.rules import Rules
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.maps.enumeration import FINGERPRINTS
from allworlds.robots.team import TeamRow
from allworlds.studies.count import Counted
from allworlds.studies.fuzz.sample_sweep import SampleCounter
from allworlds.studies.fuzz.sampling import batches
from allworlds.studies.worst.compiled_engine import _joined


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
