import pytest

from allworlds.engines.limits import TimeIsUp
from allworlds.studies.fuzz.sample_sweep import fuzz
from allworlds.studies.fuzz.shrinking import shrink


@pytest.mark.slowest
@pytest.mark.parametrize(("begins", "edges", "runs"), [((5, 4), 9, 100), ((9, 6), 16, 500)])
def test_an_error_that_begins_at_some_size_is_found_and_shrunk(planted_file, begins, edges, runs):
    report = fuzz(planted_file(*begins), edges=edges, runs=runs, workers=2)
    assert (report.verdict, report.exit_code) == ("refuted", 1)
    assert not report.ending.reason
    (finding,) = report.findings
    assert (finding.law, finding.world.map.edge_count) == ("pose", begins[0])
    assert finding.confirmed
    assert not report.complete
    assert not finding.minimal


@pytest.mark.slowest
def test_the_report_does_not_depend_on_the_number_of_workers(planted_file):
    explore = planted_file(5, 4)
    one, three = (
        fuzz(explore, edges=7, runs=60, seed=3, workers=workers).to_json() for workers in (1, 3)
    )
    assert one == three
    assert one["findings"]


@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize("map_class", ["maps", "simple", "planar", "planar-simple"])
def test_the_sample_follows_its_class_and_its_seed(map_class):
    one, again, other = (
        fuzz(edges=8, runs=30, seed=seed, map_class=map_class).to_json() for seed in (1, 1, 2)
    )
    assert one == again
    assert one["rows"] != other["rows"]


def test_what_has_been_reached_when_the_time_is_up_is_reported(planted, monkeypatch):
    reached = []

    def out_of_time(finding, scope, refute):
        step = next(shrink(finding, scope, refute))
        reached.append(step)
        yield step
        raise TimeIsUp

    monkeypatch.setattr("allworlds.studies.fuzz.shrinking.shrink", out_of_time)
    report = fuzz(planted(5, 4), edges=7, runs=40, seed=1)
    assert report.verdict == "refuted"
    assert [found.key for found in report.findings] == [found.key for found in reached]


def test_a_time_limit_leaves_an_unfinished_sample_inconclusive():
    report = fuzz("algorithm1", edges=60, runs=100_000, time_limit=0.5)
    assert (report.verdict, report.exit_code) == ("inconclusive", 3)
    assert "time limit of 0.5 s" in report.ending.reason


@pytest.mark.processes
def test_a_finding_is_confirmed_by_a_second_play(tmp_path):
    (tmp_path / "gives_up.py").write_text("def explore(first):\n    return\n    yield")
    found, *_ = fuzz(f"{tmp_path / 'gives_up.py'}:explore", edges=4, runs=2).findings
    assert (found.law, found.confirmed) == ("no-estimate", True)
