"""Every schedule: the compiled program, its readable twin, and every run of the Python engine."""

import pytest

from allworlds import check
from allworlds.explorers.loading import load
from allworlds.judging.referee import Examiner
from allworlds.judging.rules import Rules
from allworlds.maps import MapClass, rooted_maps
from allworlds.studies.worst.all_worlds import worst
from allworlds.studies.worst.every_schedule import EverySchedule
from allworlds.world import Directional, World
from schedules import schedules
from studies import test_all_worlds as quick
from studies.test_all_worlds import rows_of, twin

report = quick.report

pytestmark = pytest.mark.usefixtures("compiled")


@pytest.mark.parametrize("map_class", ["simple", "planar", "planar-simple"])
def test_other_classes_agree_with_the_twin(map_class):
    report = worst(edges=4, map_class=map_class)
    for edges in (1, 2, 3, 4):
        assert rows_of(report, edges) == twin(edges, "simple", MapClass(map_class))
    assert report.exit_code == 0


@pytest.mark.slowest
def test_in_each_world_every_run_of_the_python_engine_costs_what_the_twin_says():
    examiner = Examiner(load("algorithm1"), Rules())
    for edges in (1, 2, 3):
        for map_ in rooted_maps(edges):
            costs = {
                examiner.examine(World(map_, Directional(0), 0), choices).cost
                for choices in schedules()
            }
            every = EverySchedule(map_, 0, "simple")
            assert (every.worst, every.best) == (max(costs), min(costs))


@pytest.mark.slowest
def test_the_check_of_all_schedules_finds_the_same_largest_costs():
    checked = check(edges=3, schedules="all", workers=2)
    report = worst(edges=3)
    largest = {(row.edges, row.vertices): row.max_cost for row in checked.rows}
    assert largest == {(row.edges, row.vertices): row.worst for row in report.rows}


def test_any_simple_path_may_be_dearer_than_a_shortest_one_and_not_cheaper():
    shortest, simple = (worst(edges=5, transit=way).rows for way in ("shortest", "simple"))
    assert all(
        a.worst <= b.worst and a.best == b.best for a, b in zip(shortest, simple, strict=True)
    )
    assert any(a.worst < b.worst for a, b in zip(shortest, simple, strict=True))
