"""Explaining where the world of a finding is its own mirror image: another world decides."""

import json

import pytest

from allworlds import explain, replay
from allworlds.document.struct import replace
from allworlds.engines.tally import finding_from_record, finding_to_record
from allworlds.judging.explanations.explanation import (
    chiral_worlds,
    chirality_in,
    explain as told_of_run,
    needs_a_chiral_world,
)
from allworlds.judging.findings.finding import Finding
from allworlds.maps import isomorphism
from allworlds.studies.check.exhaustive import check

pytestmark = pytest.mark.usefixtures("without_workers")

SPOILED = """
from allworlds import CombinatorialMap, Estimate, Move, Percept
from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.maps import isomorphism


def mirrored(first):
    estimate = yield from algorithm1(first)
    return Estimate(estimate.map.mirrored(), estimate.here)


def sometimes_mirrored(first):
    estimate = yield from algorithm1(first)
    if estimate.map.edge_count < 3 or not isomorphism(estimate.map, estimate.map.mirrored()):
        return Estimate(estimate.map.mirrored(), estimate.here)
    return estimate


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


def small(first):
    estimate = yield from algorithm1(first)
    if estimate.map.edge_count > 3:
        raise ValueError("too large")
    return Estimate(estimate.map, estimate.map.sigma[estimate.here])


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


def test_a_right_map_with_a_wrong_pose_is_told_as_that_although_its_world_cannot_tell(report_of):
    (finding, *_) = report_of("turned").findings
    assert needs_a_chiral_world(finding)
    told = explain(finding)
    assert told.slip == "off by a turn"
    assert told.sentences[0].startswith("The map is right, but 'here' is wrong")
    assert "clockwise, as they should be" in told.sentences[1]


def test_a_mirror_image_is_told_as_that_where_another_world_shows_it(report_of):
    (finding, *_) = report_of("mirrored").findings
    assert finding.law == "pose"
    told = explain(finding)
    assert told.slip == "mirror image"
    assert told.sentences[0].startswith("The answer is a mirror image")


def test_the_report_of_a_check_has_decided_already(report_of):
    (turned, *_), (mirrored, *_) = report_of("turned").findings, report_of("mirrored").findings
    assert turned.chirality.rotations == "clockwise"
    assert mirrored.chirality.rotations == "anticlockwise"
    assert told_of_run(turned).sentences == explain(turned).sentences
    assert told_of_run(mirrored).sentences == explain(mirrored).sentences
    assert "chirality" not in turned.to_json()


def test_what_a_check_has_seen_in_another_world_is_kept_with_the_finding(report_of):
    (finding, *_) = report_of("turned").findings
    assert finding_from_record(finding_to_record(finding)).chirality == finding.chirality


def test_where_no_world_decides_both_slips_are_told_and_why(report_of):
    (finding, *_) = report_of("small").findings
    told = explain(finding)
    assert told.slip == "off by a turn"
    assert told.sentences[0].startswith("Either 'here' is wrong, or the rotations are anticlock")
    assert "the law 'crash'" in told.sentences[1]


def test_rotations_are_anticlockwise_only_if_they_are_so_in_all_small_worlds(report_of):
    (finding, *_) = report_of("sometimes_mirrored").findings
    assert needs_a_chiral_world(finding)
    assert finding.chirality.rotations == "unknown"
    told = explain(finding)
    assert told.sentences[0].startswith("Either 'here' is wrong, or the rotations are anticlock")
    assert "elsewhere its answers are not known to be mirror images" in told.sentences[1]


def test_a_finding_whose_explorer_is_gone_is_explained_all_the_same(report_of):
    document = report_of("mirrored").findings[0].to_json()
    document["explorer"] = "gone.py:explore"
    told = explain(Finding.from_json(document))
    assert told.sentences[0].startswith("Either 'here' is wrong, or")
    assert "cannot be run" in told.sentences[1]
    assert "gone.py" in told.sentences[1]


def test_an_explorer_that_was_changed_decides_nothing(report_of, tmp_path):
    (finding, *_) = report_of("mirrored").findings
    file = tmp_path / "spoiled.py"
    text = file.read_text(encoding="utf-8")
    file.write_text(text.replace("estimate.map.mirrored()", "estimate.map"), encoding="utf-8")
    told = explain(Finding.from_json(finding.to_json()))
    assert told.sentences[0].startswith("Either 'here' is wrong, or")
    assert "the explorer has changed" in told.sentences[1]


def test_bearings_of_the_wrong_sign_are_named_where_the_map_is_right_by_symmetry(report_of):
    finding = report_of("counting_bearings_anticlockwise").findings[0]
    assert finding.law == "pose"
    told = explain(finding)
    assert told.slip == "bearings anticlockwise"
    undecided = told_of_run(replace(finding, chirality=None, misreading=None))
    assert "or the bearings are counted anticlockwise" in undecided.sentences[0]


def test_chiral_worlds_are_no_mirror_images_of_themselves_and_of_the_narrowest_class(report_of):
    worlds = [*chiral_worlds(report_of("turned").findings[0])]
    assert worlds
    for world in worlds:
        assert not isomorphism(world.map, world.map.mirrored())
        assert chirality_in(world, world.map).rotations == "clockwise"
        assert chirality_in(world, world.map.mirrored()).rotations == "anticlockwise"
    assert chirality_in(worlds[0], worlds[-1].map) is None


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
    assert out.count("sigma  1   0  [3] [3]") == 1
    assert "counted anticlockwise" in " ".join(out.split())
    assert " ".join(out.split()).count("line 26, in no_map: return Estimate(") == 1
    assert out.index("the permutations that were tried") < out.index("The world")


def test_what_was_tried_is_shown_only_if_it_can_be(report_of, cli):
    _, out, _ = cli("check", report_of("no_darts").explorer, "--edges", 1)
    assert "[None]" in out
    _, out, _ = cli("check", report_of("no_lists").explorer, "--edges", 1)
    assert "sigma must be a sequence of darts, not 3" in " ".join(out.split())
    assert "the permutations that were tried" not in out


def test_a_finding_of_such_an_answer_that_was_recorded_as_a_crash_is_reproduced(report_of):
    finding = report_of("no_map").findings[0]
    seen = "InvalidMap: sigma[2] = sigma[3] = 3, but sigma must be a permutation"
    old = Finding.from_json(finding.to_json() | {"law": "crash", "seen": seen})
    again = replay(old)
    assert (again.outcome, again.law, again.law_now) == ("reproduced", "crash", "no-estimate")
