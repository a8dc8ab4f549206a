"""Answers that name no map: from Python, over a pipe, in findings and in words."""

import json
import re
import sys
from pathlib import Path

import pytest

import allworlds
from allworlds.judging.findings.finding import Finding
from allworlds.reports.formats import text
from allworlds.studies.ambiguity import class_of
from allworlds.world import Directional, Position, World
from small import EDGE, PLANE, TORUS

pytestmark = pytest.mark.usefixtures("without_workers")

FILE = str(Path(__file__).parents[1] / "support" / "explorers_for_tests" / "quotients.py")


def run(name, map_, lighthouse=Position):
    return allworlds.run(f"{FILE}:{name}", World(map_, lighthouse(0)))


@pytest.mark.parametrize("map_", [PLANE, TORUS])
def test_two_loops_look_alike_in_the_plane_and_on_the_torus_and_saying_so_is_right(map_):
    found = run("two_loops", map_)
    assert (found.verdict.value, found.exit_code) == ("holds", 0)
    document = found.to_json()
    assert document["estimate"] is None
    assert document["ambiguous"] == {
        "sigma": [0],
        "alpha": [0],
        "degree": [4],
        "marks": [1],
        "here": 0,
    }
    told = text(found, 100)
    assert "several worlds look alike" in told
    assert "HOLDS" in told


def test_where_one_world_looks_so_it_is_refuted_confirmed_explained_and_replayed():
    report = allworlds.check(f"{FILE}:two_loops", edges=2, lighthouse="position", workers=1)
    finding = report.findings[0]
    assert finding.law == "ambiguity"
    assert finding.confirmed
    assert finding.world.map.edge_count == 1
    again = Finding.from_json(json.loads(json.dumps(finding.to_json())))
    assert again.law == "ambiguity"
    assert "several worlds look alike" in text(allworlds.explain(again), 1000)
    assert allworlds.replay(again).outcome == "reproduced"
    assert text(report, 100)


def test_under_a_lighthouse_that_leaves_nothing_open_it_is_no_estimate():
    found = run("two_loops", PLANE, Directional)
    assert found.finding.law == "no-estimate"
    assert "directional" in found.finding.expected


@pytest.mark.parametrize(
    ("name", "seen"),
    [
        ("short_degrees", "degree has 0 entries, and sigma 1"),
        ("here_beyond", "here = 1, but the darts are 0..0"),
        ("no_permutation", r"sigma = \[1\] is no permutation of 0..0"),
        ("no_involution", r"alpha = \[1, 2, 0\] is no involution"),
        ("apart", "only 1 of 2 darts are reached from here"),
        ("no_integers", "Ambiguous"),
    ],
)
def test_what_is_no_rooted_quotient_is_no_estimate(name, seen):
    finding = run(name, PLANE).finding
    assert finding.law == "no-estimate"
    assert finding.expected.startswith("Ambiguous(sigma, alpha, degree, marks, here)")
    assert re.search(seen, finding.seen)


def test_it_is_right_where_a_class_has_two_members_and_a_map_may_be_a_lucky_guess():
    assert class_of(World(PLANE, Position(0))).size == 2
    assert run("the_plane", PLANE).verdict.value == "holds"
    assert run("the_plane", TORUS).finding.law == "map"


PROGRAM = """
import json, sys
for line in sys.stdin:
    degree = json.loads(line)["percept"]["degree"]
    said = {"sigma": [0], "alpha": [0], "degree": [degree], "marks": [1], "here": 0}
    for key in sys.argv[1:]:
        del said[key]
    print(json.dumps({"ambiguous": said if "sigma" in said else 3}), flush=True)
"""


def program(tmp_path, *without):
    script = tmp_path / "program.py"
    script.write_text(PROGRAM)
    return "exec:" + " ".join([sys.executable, str(script), *without])


def test_a_program_says_so_too(tmp_path):
    assert allworlds.run(program(tmp_path), World(PLANE, Position(0))).verdict.value == "holds"
    assert allworlds.run(program(tmp_path), World(EDGE, Position(0))).finding.law == "ambiguity"


def test_a_quotient_that_lacks_something_is_no_estimate(tmp_path):
    lacking = allworlds.run(program(tmp_path, "marks"), World(PLANE, Position(0))).finding
    assert lacking.law == "no-estimate"
    assert lacking.seen.startswith("a quotient without marks")
    none = allworlds.run(program(tmp_path, "sigma"), World(PLANE, Position(0))).finding
    assert none.seen.startswith("a quotient that is no object")
