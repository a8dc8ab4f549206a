"""Explorers side by side: against runs that are added up here, one by one."""

import csv
import io
import json
import sys
from collections import defaultdict
from fractions import Fraction
from statistics import geometric_mean
from types import SimpleNamespace

import pytest

from allworlds import check, compare, run
from allworlds.documents.document import replace
from allworlds.engines.limits import TimeIsUp
from allworlds.engines.players import Unsettled
from allworlds.inputs.checks import InputError
from allworlds.maps import rooted_maps
from allworlds.outcome import Completed, Disagreed, Interrupted, Stopped
from allworlds.protocol.actions import Estimate
from allworlds.reports.formats import file_of, text as text_of
from allworlds.studies.compare.comparison import SameWorlds
from allworlds.studies.compare.entrants import CompareRequest, Contest, _families
from allworlds.world import Directional, World
from kept_jobs import EXPLORERS
from listeners import Hears
from native_libraries import example

CLUSTER = "algorithm1-cluster"


@pytest.fixture(scope="module")
def report():
    return compare("algorithm1", "folding", "folding-oldest", edges=3, workers=2)


def costs_by_hand(name, edges):
    """{(vertices, map): costs over the bearings}."""
    found = defaultdict(list)
    for map_ in rooted_maps(edges):
        for place in Directional.places(map_, 0):
            outcome = run(name, World(map_, place, 0)).outcome
            found[map_.vertex_count, map_].append(outcome.cost)
    return found


def test_means_and_comparisons_are_those_of_single_runs(report):
    paper, mine = costs_by_hand("algorithm1", 3), costs_by_hand("folding", 3)
    means = {
        key: (Fraction(sum(paper[key]), len(paper[key])), Fraction(sum(mine[key]), len(mine[key])))
        for key in paper
    }
    for row in report.rows:
        if row.edges == 3:
            here = [pair for (vertices, _), pair in means.items() if vertices == row.vertices]
            assert row.worlds == len(here)
            assert row.mean["folding"] == round(float(sum(b for _, b in here) / len(here)), 6)
            ratios = [float(b / a) for a, b in here]
            assert row.ratio["folding"] == pytest.approx(geometric_mean(ratios), abs=1e-6)
            assert row.less["folding"] == sum(a < b for a, b in here)
            assert row.equal["folding"] == sum(a == b for a, b in here)
            assert row.more["folding"] == sum(a > b for a, b in here)
    most = max(abs(a - b) for a, b in means.values())
    costs = report.differ_most.costs
    assert abs(costs["algorithm1"] - costs["folding"]) == pytest.approx(float(most), abs=1e-5)
    # The least in the order of the enumeration.
    most_expensive = [key for key, (a, b) in means.items() if abs(a - b) == most]
    vertices, least = min(most_expensive, key=lambda key: (key[0], key[1].sigma, key[1].alpha))
    assert report.differ_most.world.map == least
    assert report.differ_most.world.map.vertex_count == vertices


def test_the_rows_agree_with_a_check(report):
    for name in report.names:
        checked = {(r["edges"], r["vertices"]): r for r in check(name, edges=3).to_json()["rows"]}
        for row in report.rows:
            told = checked[row.edges, row.vertices]
            assert row.worst[name] == told["max_cost"]
            assert row.worlds == told["worlds"]
            assert row.runs == 3 * told["runs"]


def test_an_explorer_beside_itself_under_another_name_differs_nowhere():
    other = "allworlds.explorers.builtin.algorithm1:algorithm1"
    report = compare("algorithm1", other, edges=2)
    assert report.exit_code == 0
    assert report.differ_most is None
    assert [*report.walks()] == []
    assert all(
        row.equal["allworlds.explorers.builtin.algorithm1:algorithm1"] == row.worlds
        for row in report.rows
    )


def test_a_map_without_a_place_for_one_is_left_out_for_all():
    report = compare("folding", CLUSTER, edges=2)
    assert [(row.edges, row.vertices, row.worlds) for row in report.rows] == [
        (1, 2, 1),
        (2, 2, 4),
        (2, 3, 2),
    ]
    assert compare("folding", CLUSTER, edges=1, vertices=2).exit_code == 0


def test_nothing_to_compare_is_vacuous():
    report = compare("folding", CLUSTER, family="bouquet:0", lighthouse="natural")
    assert (report.verdict.value, report.exit_code) == ("vacuous", 4)
    assert "no world" in text_of(report, 100)


def stops_at_once(first):
    return Estimate(None, first.degree)
    yield


def test_a_broken_law_ends_the_comparison_with_a_finding():
    report = compare("folding", stops_at_once, edges=3)
    assert (report.verdict.value, report.exit_code) == ("refuted", 1)
    assert {row.edges for row in report.rows} == {1}
    (finding,) = report.findings
    assert finding.law == "no-estimate"
    assert "broken a law" in text_of(report, 100)


def test_one_world_of_a_family_is_compared_over_every_place():
    report = compare("algorithm1", "dfs", family="lattice:4x4", holes="10%", seed=5)
    (row,) = report.rows
    assert (row.edges, row.vertices, row.worlds) == (22, 16, 1)
    assert row.mean["dfs"] <= 2 * 22 < row.mean["algorithm1"]
    assert row.ratio["dfs"] == pytest.approx(row.mean["dfs"] / row.mean["algorithm1"], abs=1e-6)
    document = report.to_json()
    scope = document["scope"]
    assert (scope["family"], scope["holes"], scope["seed"]) == (["lattice:4x4"], "10%", 5)
    assert scope["edges"] is None
    assert "one world: lattice:4x4 --holes 10% --seed 5" in text_of(report, 100)


def test_the_time_limit_and_an_interrupt_leave_finished_levels(monkeypatch):
    def ends(error):
        def units(contest, edges):
            if edges == 2:
                raise error
            yield from begun(contest, edges)

        return units

    begun = SameWorlds._units
    for error, code in ((TimeIsUp(), 3), (Unsettled("lost"), 3), (KeyboardInterrupt(), 130)):
        monkeypatch.setattr(SameWorlds, "_units", ends(error))
        report = compare("algorithm1", "folding", edges=3, time_limit=1000)
        assert report.exit_code == code
        assert [row.edges for row in report.rows] == [1, 1]
        assert "finished levels" in text_of(report, 100)
        assert report.to_json()["complete"] is False


def test_an_interrupt_goes_before_a_finding_and_a_count_that_disagrees_before_both(report):
    found = replace(report, findings=tuple(check(stops_at_once, edges=1).findings))
    assert (found.exit_code, replace(found, ending=Interrupted()).exit_code) == (1, 130)
    assert replace(found, ending=Interrupted(), all_counted=False).exit_code == 70


def test_a_count_that_disagrees_is_an_error(report):
    told = replace(report, all_counted=False)
    assert told.exit_code == 70
    assert "disagree" in text_of(told, 100)


def test_the_csv_has_a_line_for_each_size_and_explorer(report):
    rows = [*csv.DictReader(io.StringIO(file_of("csv", report)))]
    assert len(rows) == len(report.rows) * 3
    last = rows[-2]
    assert last["explorer"] == "folding"
    assert float(last["mean"]) == pytest.approx(float(report.rows[-1].mean["folding"]))
    assert int(last["more"]) == report.rows[-1].more["folding"]


def test_the_page_holds_both_walks_and_the_document(report):
    page = file_of("html", report)
    assert page.count('class="viewer"') == 3
    assert page.count("Where the costs differ most") == 3
    record = page.split('id="report-json"')[1].split(">", 1)[1].split("</script>")[0]
    assert json.loads(record.replace("\\u003c", "<"))["rows"] == report.to_json()["rows"]


@pytest.mark.parametrize(
    ("explorers", "options", "said"),
    [
        (["folding"], {"edges": 2}, "two explorers"),
        (["folding", "folding"], {"edges": 2}, "named twice"),
        (["folding", "folding-oldest"], {}, "edges, vertices, worlds or a family"),
        (
            ["folding", "folding-oldest"],
            {"edges": 2, "family": "cycle:3"},
            "'cycle:3', which is one world",
        ),
        (["folding", "folding-oldest"], {"edges": 2, "holes": "10%"}, "10%"),
        (["folding", "folding-oldest"], {"family": "ring:3"}, "ring:3"),
        (["folding", "folding-oldest"], {"edges": 0}, "0"),
        (["folding", "lazy"], {"edges": 1}, "lazy"),
        (["folding", "folding-oldest"], {"edges": 1, "lighthouse": "lamp"}, "lamp"),
    ],
)
def test_bad_input_is_named(explorers, options, said):
    with pytest.raises(InputError, match=said):
        compare(*explorers, **options)


def test_an_unknown_option_is_a_type_error():
    with pytest.raises(TypeError, match="colour"):
        compare("folding", "folding-oldest", edges=1, colour="red")


def test_the_command_writes_every_file(cli, tmp_path):
    names = {kind: tmp_path / f"report.{kind}" for kind in ("csv", "html")}
    options = [part for kind, path in names.items() for part in ("-o", path)]
    code, out, _ = cli("compare", "algorithm1", "folding", "--edges", 2, "--json", *options)
    assert code == 0
    assert json.loads(out)["explorers"][1]["name"] == "folding"
    assert names["csv"].read_text().startswith("edges,vertices")
    assert names["html"].read_text().startswith("<!DOCTYPE html>")


def program(kind):
    return " ".join([sys.executable, str(EXPLORERS / "program.py"), kind])


def test_a_program_and_a_shared_library_are_compared_like_any_other(cli):
    library = example("c/algorithm1.c")
    code, out, _ = cli(
        *("compare", "algorithm1", "--edges", 2, "--json"),
        *("--exec", program("right"), "--native", library),
    )
    document = json.loads(out)
    names = [explorer["name"] for explorer in document["explorers"]]
    assert code == 0
    assert names == ["algorithm1", f"exec:{program('right')}", f"native:{library}"]
    assert all(row["runs"] for row in document["rows"])


def test_a_level_has_the_maps_once_for_each_explorer():
    listener = Hears()
    compare("algorithm1", "folding", edges=2, listener=listener)
    # 2, 10 rooted maps (A000698).
    assert listener.heard == [(1, 4, 4), (2, 20, 20)]


def test_in_every_width_a_row_is_told_apart_by_its_size(report):
    for width, explorer in ((40, ""), (60, "  ")):
        heads = [line for line in text_of(report, width).splitlines() if line[:6] == "edges "]
        assert len(heads) > 2
        assert all(line.startswith("edges  vertices  worlds" + explorer) for line in heads)
    assert sum("worlds  explorer" in line for line in heads) == 2


@pytest.mark.parametrize("family", [5, True, 1.5])
def test_a_family_is_a_name_or_a_list_of_names(family):
    with pytest.raises(InputError, match=f"family = {family} is neither a name nor a list of name"):
        compare("algorithm1", "folding", family=family)


def test_families_are_named_once_each():
    assert [_families(given) for given in (None, "a,b,a", ["b", "a", "b"])] == [
        None,
        ("a", "b"),
        ("b", "a"),
    ]


def test_a_merge_lists_rows_by_what_is_asked():
    contest = SimpleNamespace(request=CompareRequest(explorers=("a", "b"), edges=1))
    Contest.list_by(contest, "world")
    assert (contest.request.by, contest.request.explorers) == ("world", ("a", "b"))


@pytest.mark.parametrize(
    ("ending", "completes"),
    [
        (Stopped("enough findings", final=True), True),
        (Stopped("the time is over"), False),
        (Interrupted(), False),
        (Disagreed("two engines disagree"), False),
        (Completed(), False),
    ],
)
def test_a_job_that_findings_have_stopped_is_complete_and_no_other_becomes_so(ending, completes):
    job = SimpleNamespace(_found={}, findings=["a finding"])
    assert Contest.conclude(job, ending) == (Completed() if completes else None)
    job.findings = []
    assert Contest.conclude(job, ending) is None
