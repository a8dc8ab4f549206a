"""Explaining a finding of a report: where its world is its own mirror image, and elsewhere."""

import json

import pytest

from allworlds import explain, replay
from allworlds.judging.findings.finding import Finding
from allworlds.studies.check.exhaustive import check
from allworlds.studies.explain import explained

pytestmark = pytest.mark.usefixtures("without_workers")

SPOILED = """
from allworlds import CombinatorialMap, Estimate, Move, Percept
from allworlds.explorers.builtin.algorithm1 import algorithm1


def mirrored(first):
    estimate = yield from algorithm1(first)
    return Estimate(estimate.map.mirrored(), estimate.here)


def turned(first):
    estimate = yield from algorithm1(first)
    return Estimate(estimate.map, estimate.map.sigma[estimate.here])


def no_map(first):
    yield Move(0)
    return Estimate(CombinatorialMap([1, 0, 3, 3], [1, 0, 3, 2]), 0)


def no_darts(first):
    yield Move(0)
    return Estimate(CombinatorialMap([1, 0], [1, None]), 0)


def no_lists(first):
    yield Move(0)
    return Estimate(CombinatorialMap(3, 3), 0)


def counting_bearings_anticlockwise(first):
    def turned(percept):
        if percept is None or percept.bearing is None:
            return percept
        return Percept(percept.degree, percept.marks, -percept.bearing % percept.degree)

    explorer, percept = algorithm1(turned(first)), None
    while True:
        try:
            action = explorer.send(percept)
        except StopIteration as end:
            return end.value
        percept = turned((yield action))
"""


@pytest.fixture
def report_of(tmp_path):
    """The report of a check of a spoiled explorer."""
    file = tmp_path / "spoiled.py"
    file.write_text(SPOILED, encoding="utf-8")
    return lambda name: check(f"{file}:{name}", edges=3, max_findings=3)


@pytest.mark.parametrize("name", ["turned", "mirrored"])
def test_a_world_that_is_its_own_mirror_image_does_not_show_which_slip_it_is(name, report_of):
    (finding, *_) = report_of(name).findings
    told = explain(finding)
    assert told.slip == "off by a turn"
    assert told.sentences[0].startswith(
        "Either 'here' is wrong, or sigma of the answer goes anticlockw"
    )
    assert "its own mirror image" in told.sentences[1]


def test_a_finding_whose_explorer_is_gone_is_explained_all_the_same(report_of):
    finding = report_of("mirrored").findings[0]
    document = finding.to_json() | {"explorer": "gone.py:explore"}
    assert explain(Finding.from_json(document)).sentences == explain(finding).sentences


def test_bearings_of_the_wrong_sign_are_named_where_the_map_is_right_by_symmetry(report_of):
    finding = report_of("counting_bearings_anticlockwise").findings[0]
    assert finding.law == "pose"
    assert "or the bearings are counted anticlockwise" in explain(finding).sentences[0]


def test_any_finding_of_a_report_is_explained_and_replayed(report_of, tmp_path, cli, refused):
    report, file = report_of("turned"), tmp_path / "report.json"
    file.write_text(json.dumps(report.to_json()), encoding="utf-8")
    assert len(report.findings) == 3
    for number, finding in enumerate(report.findings, 1):
        code, out, _ = cli("explain", file, "--finding", number, "--json")
        told = json.loads(out)
        assert (code, told["number"], told["findings"]) == (0, number, 3)
        assert told["world"] == finding.world.to_json()
    assert "finding 1 of 3" in cli("explain", file)[1]
    code, out, _ = cli("replay", file, "--finding", 3, "--json")
    assert (code, json.loads(out)["run"]["world"]) == (0, report.findings[2].world.to_json())
    assert "findings 1 to 3" in refused("explain", file, "--finding", 4)
    assert "finding = 0" in refused("explain", file, "--finding", 0)


def test_an_answer_that_is_no_map_is_told_once_with_what_was_tried(report_of, tmp_path, cli):
    report, file = report_of("no_map"), tmp_path / "report.json"
    assert {finding.law for finding in report.findings} == {"no-estimate"}
    assert report.findings[0].confirmed
    file.write_text(json.dumps(report.to_json()), encoding="utf-8")
    _, out, _ = cli("explain", file)
    assert " ".join(out.split()).count("sigma[2] = sigma[3] = 3") == 1
    assert out.count("sigma [1, 0, 3, 3]") == 1
    assert " ".join(out.split()).count("line 18, in no_map: return Estimate(") == 1


def test_of_a_rotation_that_is_none_the_sense_of_counting_is_told(report_of):
    told = {name: explain(report_of(name).findings[0]) for name in ("no_map", "no_lists")}
    sense = "Bearings, motions and ways back count darts clockwise."
    assert [sense in told[name].sentences for name in told] == [True, False]


def test_what_was_tried_is_shown_only_if_it_can_be(report_of, cli):
    _, out, _ = cli("check", report_of("no_darts").explorer, "--edges", 1, "-v")
    assert "alpha [1, None]" in out
    _, out, _ = cli("check", report_of("no_lists").explorer, "--edges", 1, "-v")
    assert "sigma must be a sequence of darts, not 3" in " ".join(out.split())
    assert "the permutations that were tried" not in out


def test_a_finding_of_such_an_answer_that_was_recorded_as_a_crash_is_reproduced(report_of):
    finding = report_of("no_map").findings[0]
    seen = "InvalidMap: sigma[2] = sigma[3] = 3, but sigma must be a permutation"
    old = Finding.from_json(finding.to_json() | {"law": "crash", "seen": seen})
    again = replay(old)
    assert (again.outcome, again.law, again.law_now) == ("reproduced", "crash", "no-estimate")


def test_a_finding_alone_is_the_only_one_of_its_report(report_of):
    (finding, *_) = report_of("turned").findings
    alone = explained(finding)
    assert (alone.number, alone.findings) == (1, 1)
