"""The worst of any explorer: its runs, its schedules, and what refutes it."""

import pytest

from allworlds import check, worst
from allworlds.document import replace
from allworlds.engines import Examiner
from allworlds.explorers import load
from allworlds.inputs import InputError
from allworlds.judging import Rules
from allworlds.maps import rooted_maps
from allworlds.outcome import Interrupted
from allworlds.protocol import Estimate, Schedules
from allworlds.reports import text
from allworlds.world import Directional, World
from small import long


def by_hand(name, edges):
    """{vertices: (worst, best)} by playing every schedule of every run here."""
    examiner, found = Examiner(load(name), Rules("directional")), {}
    for map_ in rooted_maps(edges):
        for place in Directional.places(map_, 0):
            world = World(map_, place, 0)
            costs = [examiner.examine(world, choices).cost for choices in Schedules()]
            most, least = found.get(map_.vertex_count, (0, 0))
            found[map_.vertex_count] = max(most, *costs), max(least, min(costs))
    return found


@pytest.mark.slow
@pytest.mark.long
def test_worst_and_best_are_those_of_every_schedule_played_by_hand():
    report = worst("remembering", edges=3, workers=2)
    assert report.exit_code == 0
    assert report.schedules == "all"
    for edges in (2, 3):
        rows = {r.vertices: (r.worst, r.best) for r in report.rows if r.edges == edges}
        assert rows == by_hand("remembering", edges)
    assert all(row.replayed == row.worst for row in report.rows)
    assert any(row.choices for row in report.rows)
    assert "every schedule of remembering" in text("worst", report, 100)


def test_an_explorer_without_choices_has_one_schedule():
    report = worst("greedy", edges=3)
    rows = {(r["edges"], r["vertices"]): r for r in check("greedy", edges=3).to_json()["rows"]}
    for row in report.rows:
        told = rows[row.edges, row.vertices]
        assert row.worst == row.best == told["max_cost"]
        assert (row.worlds, row.bound) == (told["worlds"], told["bound"])
    assert report.to_json()["scope"]["schedules"] == "one"
    assert "the one schedule" in text("worst", report, 100)


def test_the_worst_case_of_another_task_is_that_of_a_check_of_it():
    report = worst("dfs", edges=3, task="cover")
    told = {(r.edges, r.vertices): r.max_cost for r in check("dfs", edges=3, task="cover").rows}
    assert {(row.edges, row.vertices): row.worst for row in report.rows} == told
    of_the_map = {(row.edges, row.vertices): row.worst for row in worst("dfs", edges=3).rows}
    assert all(told[size] <= cost for size, cost in of_the_map.items())
    assert told[3, 1] == 0 < of_the_map[3, 1]
    assert report.to_json()["scope"]["task"] == "cover"
    assert "task cover: every vertex visited" in " ".join(text("worst", report, 100).split())


def test_algorithm_1_with_another_task_is_played_and_transit_is_refused_then():
    told = worst("algorithm1", edges=2, task="cover")
    assert told.schedules == "all"
    assert {row.worst for row in told.rows if row.vertices == 1} == {0}
    with pytest.raises(InputError, match="with the task map"):
        worst("algorithm1", edges=2, task="cover", transit="simple")


def test_algorithm_1_under_another_lighthouse_is_played():
    report = worst("algorithm1-cluster", edges=2, lighthouse="cluster")
    assert report.to_json()["scope"]["lighthouse"] == "cluster"
    assert report.exit_code == 0


@pytest.mark.early
@pytest.mark.parametrize("edges", [2, long(3)])
def test_the_least_world_and_the_first_choices_are_told_whoever_was_faster(edges):
    reports = [worst("remembering", edges=edges, workers=workers) for workers in (1, 2)]
    assert reports[0] == reports[1]


def stops_at_once(first):
    return Estimate(None, first.degree)
    yield


@pytest.mark.usefixtures("without_workers")
def test_a_broken_law_is_a_finding_and_the_last_level():
    report = worst(stops_at_once, edges=3)
    assert report.exit_code == 1
    assert {row.edges for row in report.rows} == {1}
    assert "REFUTED" in text("worst", report, 100)
    assert report.to_json()["findings"][0]["law"] == "no-estimate"


def test_a_replay_or_a_count_that_disagrees_is_exit_70():
    report = worst("greedy", edges=1)
    for wrong in ({"replayed": 7}, {"counted": 0}):
        told = replace(report, rows=(replace(report.rows[0], **wrong), *report.rows[1:]))
        assert told.exit_code == 70
        assert "MISMATCH" in text("worst", told, 100)
    assert replace(report, ending=Interrupted()).exit_code == 130
    assert replace(report, rows=()).exit_code == 4


def test_what_is_for_algorithm_1_alone_is_refused():
    with pytest.raises(InputError, match="is for algorithm1"):
        worst("greedy", edges=1, transit="shortest")


def test_an_explorer_or_a_lighthouse_that_is_none_is_refused():
    with pytest.raises(InputError, match="lazy"):
        worst("lazy", edges=1)
    with pytest.raises(InputError, match="lamp"):
        worst("greedy", edges=1, lighthouse="lamp")
