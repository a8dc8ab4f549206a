"""The least and the largest cost of a world over every schedule, in the rows of ``check``."""

import pytest

from allworlds import check, merge
from allworlds.explorers.loading import load
from allworlds.judging.referee import Examiner
from allworlds.judging.rules import Rules
from allworlds.maps import rooted_maps
from allworlds.protocol.actions import Move
from allworlds.reports.content.check import size_table
from allworlds.reports.formats import text
from allworlds.world import Directional, World
from schedules import schedules


def by_hand(name, edges):
    """{vertices: (largest, best)} by playing every schedule of every run here."""
    examiner, found = Examiner(load(name), Rules("directional")), {}
    for map_ in rooted_maps(edges):
        for place in Directional.places(map_, 0):
            world = World(map_, place, 0)
            costs = [examiner.examine(world, choices).cost for choices in schedules()]
            most, least = found.get(map_.vertex_count, (0, 0))
            found[map_.vertex_count] = max(most, *costs), max(least, min(costs))
    return found


def costs_of(report, edges):
    return {r.vertices: (r.max_cost, r.best_cost) for r in report.rows if r.edges == edges}


@pytest.mark.parametrize("edges", [2])
def test_the_costs_are_those_of_every_schedule_played_by_hand(edges):
    report = check("algorithm1", edges=edges, schedules="all", workers=2)
    assert costs_of(report, edges) == by_hand("algorithm1", edges)
    assert any(row.best_cost < row.max_cost for row in report.rows)


def test_costs_of_shards_add_up(tmp_path):
    parts = [tmp_path / str(k) for k in range(2)]
    for k, part in enumerate(parts):
        check("algorithm1", edges=2, schedules="all", shard=(k, 2), run=part)
    assert merge(*parts).rows == check("algorithm1", edges=2, schedules="all").rows


def stays_or_goes(first, choices):
    if choices.pick([0, 1], "edge"):
        yield Move(0)
    return first


@pytest.mark.usefixtures("without_workers")
def test_the_cheapest_schedule_may_cost_nothing():
    report = check(stays_or_goes, edges=1, schedules="all", laws=["pose"])
    assert [(row.max_cost, row.best_cost) for row in report.rows] == [(1, 0), (1, 0)]
    assert report.to_json()["rows"][0]["best_cost"] == 0


def test_the_best_cost_is_told_of_every_schedule_alone():
    one, every = (check("algorithm1", edges=1, schedules=which) for which in ("one", "all"))
    assert all("best_cost" not in row for row in one.to_json()["rows"] + one.records())
    assert all(row["best_cost"] == 1 for row in every.to_json()["rows"] + every.records())
    assert ("max cheapest" in text(every, 100)) > ("max cheapest" in text(one, 100))
    first, *others = ["edges", "vertices", "worlds", "runs", "schedules", "traversals"]
    assert [*size_table(every).header] == [first, *others, "max cheapest", "max cost", "bound"]
