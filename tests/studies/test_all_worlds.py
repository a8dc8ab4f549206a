"""Every schedule: the compiled program, its readable twin, and every run of the Python engine."""

from types import SimpleNamespace

import pytest

from allworlds import run
from allworlds.documents.document import replace
from allworlds.engines import units
from allworlds.explorers.loading import load
from allworlds.inputs.checks import InputError
from allworlds.judging.referee import Examiner
from allworlds.judging.rules import Rules
from allworlds.maps import CombinatorialMap, MapClass, rooted_maps
from allworlds.maps.counting import rooted_maps as counted
from allworlds.reports.content.sizes import _mismatch
from allworlds.reports.formats import text
from allworlds.studies.worst import compiled_engine
from allworlds.studies.worst.all_worlds import SchedulesSweep, WorstRequest, worst
from allworlds.studies.worst.every_schedule import EverySchedule, WrongTest
from allworlds.world import Directional, World

pytestmark = pytest.mark.usefixtures("compiled")


def twin(edges, transit, map_class=MapClass.MAPS):
    """{vertices: (worst, best)} by the readable twin."""
    rows = {}
    for map_ in rooted_maps(edges, map_class):
        schedules = EverySchedule(map_, 0, transit)
        most, least = rows.get(map_.vertex_count, (0, 0))
        rows[map_.vertex_count] = max(most, schedules.worst), max(least, schedules.best)
    return rows


def rows_of(report, edges):
    return {row.vertices: (row.worst, row.best) for row in report.rows if row.edges == edges}


@pytest.fixture(scope="module", params=["shortest", "simple"])
def report(request):
    return worst(edges=5, transit=request.param, workers=2)


def test_the_compiled_program_agrees_with_its_twin(report):
    for edges in (1, 2, 3, 4):
        assert rows_of(report, edges) == twin(edges, report.request.transit)


def test_no_start_dart_of_a_vertex_is_better_than_another():
    for map_ in rooted_maps(3):
        for dart in map_.vertices[map_.vertex_of[0]]:
            one, other = EverySchedule(map_, 0), EverySchedule(map_, dart)
            assert (one.worst, one.best) == (other.worst, other.best)


def test_the_most_expensive_schedules_cost_what_an_independent_program_found(report):
    # Over all worlds with 1, 2, 3, 4 edges: 1, 4, 11, 22, by a program in C.
    worst_of = [max(cost for cost, _ in rows_of(report, m).values()) for m in (1, 2, 3, 4)]
    assert worst_of == [1, 4, 11, 22]


def test_every_row_is_attained_in_its_world(report):
    assert report.exit_code == 0
    for row in report.rows:
        again = run("algorithm1", row.world, choices=row.choices)
        assert again.finding is None
        assert again.outcome.cost == row.worst == row.replayed
        # The choices are all there: no policy has helped.
        assert again.outcome.choices == row.choices
        assert row.best <= row.worst <= row.bound
        assert row.wrong_tests == 0


def test_the_worlds_are_all_there(report):
    for edges in (1, 2, 3, 4, 5):
        assert {r.vertices: r.worlds for r in report.rows if r.edges == edges} == counted(edges)


def test_no_policy_walks_less_than_the_best_or_more_than_the_worst_schedule():
    for policy in ("fifo", "lifo", "nearest"):
        rules = Rules(policy=policy)
        examiner = Examiner(load("algorithm1"), rules)
        for map_ in rooted_maps(3):
            cost = examiner.examine(World(map_, Directional(0), 0), rules.choices("")).cost
            schedules = EverySchedule(map_, 0)
            assert schedules.best <= cost <= schedules.worst


def test_a_robot_that_cannot_see_the_bearing_confirms_a_false_hypothesis():
    class Blind(EverySchedule):
        def _sensed(self, dart):
            degree, marked = super()._sensed(dart)
            return degree, None if marked is None else 0

    def errs(map_):
        try:
            Blind(map_, 0).worst  # noqa: B018
        except WrongTest:
            return True
        return False

    assert any(errs(map_) for map_ in rooted_maps(3))


def test_a_replay_that_costs_something_else_is_an_internal_error(report):
    damaged = replace(report.rows[3], replayed=report.rows[3].worst - 1)
    broken = replace(report, rows=(*report.rows[:3], damaged))
    assert broken.exit_code == 70
    assert f"the worst cost is {damaged.worst}, but its replay in Python costs" in text(broken, 100)
    doubled = replace(report, rows=(replace(report.rows[0], worlds=2),))
    assert doubled.exit_code == 70
    refuted = replace(report, rows=(replace(report.rows[0], wrong_tests=1),))
    assert refuted.exit_code == 1


def test_a_size_that_was_not_met_is_an_internal_error(monkeypatch):
    cells_of_level = units.cells_of_level
    monkeypatch.setattr(units, "cells_of_level", lambda *level: {**cells_of_level(*level), 5: 1})
    lost = worst(edges=2)
    assert lost.exit_code == 70
    assert "no map with 1 edge and 5 vertices" in text(lost, 100)
    assert worst(edges=2, shard=(0, 2)).exit_code == 0


def test_a_wrong_kernel_is_found_out_by_the_replay(monkeypatch):
    honest = compiled_engine._joined

    def damaged(a, b):
        merged = honest(a, b)
        return merged._replace(worst=merged.worst + 1)

    monkeypatch.setattr(compiled_engine, "_joined", damaged)
    assert worst(edges=3).exit_code == 70


def test_the_document_and_the_text(report):
    document = report.to_json()
    assert document["schema"] == 2
    assert document["scope"]["transit"] == report.request.transit
    row = document["rows"][-1]
    assert {"edges", "vertices", "worst", "best", "bound", "world", "choices"} <= set(row)
    assert row["world"]["start"] == 0
    told = text(report, 100)
    assert "all rejected" in told
    assert "the python engine reproduced every worst cost" in told


def test_threads_change_nothing():
    assert worst(edges=4, workers=1) == worst(edges=4, workers=3)


@pytest.mark.parametrize(
    ("options", "value"),
    [
        ({"map_class": "round"}, "'round'"),
        ({"transit": "fast"}, "'fast'"),
        ({"edges": 0}, "0"),
        ({"edges": 13}, "13"),
        ({"workers": 0}, "0"),
        (
            {"explore": "folding"},
            "not of 'folding'; 'allworlds check EXPLORER --schedules all' has",
        ),
    ],
)
def test_bad_options_are_refused_by_name(options, value):
    with pytest.raises(InputError, match=value):
        worst(**options)


def test_the_passes_of_a_path_cost_more_the_further_they_lead():
    path = CombinatorialMap((0, 2, 1, 4, 3, 5), (1, 0, 3, 2, 5, 4))
    passes = EverySchedule(path, 0).most_expensive_passes()
    met = [(each.vertices, each.explored, each.cost) for each in passes]
    assert met == [(1, 0, 1), (2, 1, 1), (3, 2, 1)]
    back = EverySchedule(path, 2).most_expensive_passes()
    assert {(each.vertices, each.explored) for each in back} == {(1, 0), (2, 1), (3, 2)}


def test_of_several_rows_the_first_that_does_not_agree_is_told():
    rows = [
        SimpleNamespace(edges=2, vertices=n, agrees=n < 2, counted=5, worlds=4 + (n < 2))
        for n in (1, 2, 3)
    ]
    said = _mismatch(SimpleNamespace(disagreement="", rows=rows, source="Tutte"))
    assert said == (
        "the enumeration found 4 maps with 2 edges and 2 vertices, but the independent count "
        "(Tutte) is 5"
    )


def test_a_run_without_an_answer_has_no_cost_and_no_choices():
    def gives_up(first, *, choices):
        raise ValueError("no")
        yield

    sweep = SimpleNamespace(
        request=SimpleNamespace(transit="shortest"),
        _subject=SimpleNamespace(player=lambda: gives_up),
    )
    world = World(CombinatorialMap((1, 0), (1, 0)), Directional(0), 0)
    assert SchedulesSweep._replayed(sweep, world, 3) == ((), None)


def test_twelve_edges_are_the_most():
    assert WorstRequest(edges=12).extent.levels[-1] == 12
    with pytest.raises(InputError, match="edges = 13, but there is room for 12 at most"):
        worst(edges=13)
