"""A wrong convention is named: the explorer is right behind a translator, and only behind that."""

import re
import shutil

import pytest

from allworlds import explain
from allworlds.document import replace
from allworlds.engines import finding_from_record, finding_to_record
from allworlds.explorers import CONVENTIONS
from allworlds.inputs import InputError
from allworlds.judging import Finding, explain as told_of_run
from allworlds.maps import MapClass, rooted_maps
from allworlds.studies.check import check
from native_libraries import EXAMPLES

pytestmark = pytest.mark.usefixtures("without_workers")

MISREADING = """
from allworlds import Estimate, Move, Percept
from allworlds.explorers import algorithm1


def reading(motion, bearing):
    def turned(percept):
        if percept is None or percept.bearing is None:
            return percept
        return Percept(percept.degree, percept.marks, bearing(percept.bearing) % percept.degree)

    def explore(first):
        explorer, percept = algorithm1(turned(first)), None
        while True:
            try:
                action = explorer.send(percept)
            except StopIteration as end:
                return end.value
            if isinstance(action, Move):
                percept = turned((yield Move(motion(action.k))))
            elif POINTS:
                percept = yield action
            else:
                percept = None

    return explore


POINTS = False
anticlockwise = reading(lambda k: -k, lambda b: b)
from_1 = reading(lambda k: k + 1, lambda b: b)
from_next = reading(lambda k: k - 1, lambda b: b)
bearings = reading(lambda k: k, lambda b: -b)
twice = reading(lambda k: 2 * k, lambda b: b)


def raising(first):
    edges = {}
    walk = anticlockwise(first)
    percept = None
    for step in range(50):
        try:
            percept = yield walk.send(percept)
        except StopIteration as end:
            return end.value
    return edges["lost"]


def forgetful(first):
    estimate = yield from algorithm1(first)
    return Estimate(estimate.map, estimate.map.sigma[estimate.here])
"""

SLIPS = {
    "anticlockwise": "motions-anticlockwise",
    "from_1": "motions-from-1",
    "from_next": "motions-from-next",
    "bearings": "bearings-anticlockwise",
    "raising": "motions-anticlockwise",
}


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    """A file of explorers, each with one slip."""
    file = tmp_path_factory.mktemp("misreading") / "misreading.py"
    file.write_text(MISREADING, encoding="utf-8")
    return file


def first_finding(name, **rules):
    return check(name, **{"edges": 3, **rules}).findings[0]


def test_there_is_a_slip_for_each_convention():
    assert {*SLIPS.values()} == {*CONVENTIONS}


def test_the_page_names_each_convention():
    page = (EXAMPLES.parent / "docs" / "protocol.md").read_text(encoding="utf-8")
    told = page.partition("`translated:CONVENTION:EXPLORER`")[2].partition("##")[0]
    assert re.findall("`(motions-[^`]+|bearings-[^`]+)`", told) == [*CONVENTIONS]


@pytest.mark.parametrize("slip", SLIPS)
def test_the_slip_is_named_first_and_the_translator_shows_it(slip, file):
    finding = first_finding(f"{file}:{slip}")
    told = told_of_run(finding)
    assert told.slip == SLIPS[slip].replace("-", " ")
    assert told.sentences[0].startswith(f"The explorer {CONVENTIONS[SLIPS[slip]].wrong}")
    name = f"translated:{SLIPS[slip]}:{file}:{slip}"
    assert name in told.sentences[2]
    assert check(name, edges=3).exit_code == 0


def test_checkpoints_do_not_hide_it(tmp_path):
    file = tmp_path / "pointing.py"
    file.write_text(MISREADING.replace("POINTS = False", "POINTS = True"), encoding="utf-8")
    finding = first_finding(f"{file}:anticlockwise")
    assert finding.step is not None
    assert told_of_run(finding).slip == "motions anticlockwise"


@pytest.mark.parametrize("slip", ["twice", "forgetful"])
def test_another_slip_is_none_of_these(slip, file):
    finding = first_finding(f"{file}:{slip}")
    assert finding.misreading is None
    assert "right for it" not in " ".join(explain(finding).sentences)


@pytest.mark.parametrize("convention", CONVENTIONS)
def test_a_translator_makes_a_right_explorer_wrong(convention):
    report = check(f"translated:{convention}:allworlds.explorers.builtin.greedy:greedy", edges=3)
    assert report.exit_code == 1


def test_all_small_worlds_were_tried(file):
    misreading = first_finding(f"{file}:anticlockwise").misreading
    worlds = [map_ for m in (1, 2, 3) for map_ in rooted_maps(m, MapClass.PLANAR)]
    assert misreading.edges == 3
    assert misreading.runs == sum(map_.degree_at[0] for map_ in worlds)


def test_what_was_seen_is_kept_with_the_finding_and_not_in_its_document(file):
    finding = first_finding(f"{file}:from_1")
    assert finding_from_record(finding_to_record(finding)).misreading == finding.misreading
    assert "misreading" not in finding.to_json()


def test_a_finding_that_was_read_is_tried_anew_unless_its_explorer_has_changed(file, tmp_path):
    own = tmp_path / "own.py"
    shutil.copy(file, own)
    finding = first_finding(f"{own}:from_1")
    read = Finding.from_json(finding.to_json())
    assert read.misreading is None
    assert explain(read).sentences == told_of_run(finding).sentences
    own.write_text(MISREADING.replace("k + 1", "k + 2"), encoding="utf-8")
    assert explain(read).slip is None


def test_a_finding_without_its_explorer_is_explained_all_the_same(file):
    finding = replace(first_finding(f"{file}:from_1"), explorer="gone.py:explore")
    assert explain(Finding.from_json(finding.to_json())).slip is None


def test_a_convention_that_is_none_is_refused():
    with pytest.raises(InputError, match=r"convention 'x' is not one of motions-anticlockwise, "):
        check("translated:x:greedy")
    with pytest.raises(InputError, match=r"convention '' is not one of"):
        check("translated:")


@pytest.mark.slow
def test_the_slip_of_a_program_is_named(tmp_path):
    if shutil.which("node") is None:
        pytest.skip("there is no node")
    text = (EXAMPLES / "javascript" / "algorithm1.js").read_text(encoding="utf-8")
    right = "{ move: value }"
    assert right in text
    file = tmp_path / "slip.js"
    file.write_text(text.replace(right, "{ move: -value }"), encoding="utf-8")
    finding = first_finding(f"exec:node {file}")
    assert told_of_run(finding).slip == "motions anticlockwise"
