"""The page: complete, self-contained, and the same every time."""

import hashlib
import json
import re
from base64 import b64encode
from collections import Counter

import pytest

from allworlds import Estimate, Move, run
from allworlds.corpus.explorers import WRONG_EXPLORERS
from allworlds.documents.document import replace
from allworlds.maps import named_map
from allworlds.reports import parts
from allworlds.reports.drawing.svg import legal
from allworlds.reports.formats import file_of
from allworlds.reports.web.sections import table_element
from allworlds.studies.check.exhaustive import check
from allworlds.studies.check.report import GateCell
from allworlds.studies.explain import explain
from allworlds.studies.fuzz.sample_sweep import fuzz
from allworlds.words import escaped
from html_tree import read


def page(report):
    return file_of("html", report)


HOSTILE = (
    "</script><script>alert(1)</script><!-- <b title='x\"'> &amp; \0 \x1b \ud800 \ufffe \u202e"
)


def mutant(name):
    return next(m for m in WRONG_EXPLORERS if m.name == name).explorer()


@pytest.fixture(scope="module")
def refuted():
    return check(mutant("wrong-entry-label"), edges=3, laws=("map", "pose"), max_findings=3)


@pytest.fixture(scope="module")
def root(refuted):
    return read(page(refuted))


def test_the_answer_stands_beside_the_world(refuted, root):
    viewer = next(root.all(class_="viewer"))
    world, answer = viewer.all("figure")
    assert len([*world.all(class_="edge")]) + len([*world.all(class_="edge walked")]) == (
        refuted.findings[0].world.map.edge_count
    )
    darts = [group for group in answer.all("g") if "data-dart" in group.attributes]
    assert len(darts) == len(refuted.findings[0].seen.map.sigma)
    (here,) = answer.all("g", class_="dart here")
    assert here.attributes["data-dart"] == str(refuted.findings[0].seen.here)


def test_every_step_is_at_a_dart_of_its_picture_and_every_motion_along_an_edge(root):
    for viewer in root.all(class_="viewer"):
        for frame in viewer.all(class_="frame"):
            follows = frame.attributes["data-follows"]
            darts = {
                g.attributes["data-dart"] for g in frame.all("g") if "data-dart" in g.attributes
            }
            for item in viewer.all("li"):
                assert item.attributes[f"data-{follows}"] in darts


def test_the_explanation_and_the_command_are_there(refuted, root):
    finding = refuted.findings[0]
    story = root.one(id="finding-1").one(class_="story").text
    assert all(sentence in story for sentence in explain(finding).sentences)
    assert root.one(id="finding-1-command").text == finding.reproduce


def test_names_are_unique_and_every_reference_to_one_is_kept(root):
    nodes = list(root.all())
    ids = Counter(node.attributes["id"] for node in nodes if "id" in node.attributes)
    assert set(ids.values()) == {1}
    for node in nodes:
        refers = node.attributes.get("aria-labelledby", "").split()
        refers += [node.attributes[k] for k in ("data-copy",) if k in node.attributes]
        refers += [node.attributes["href"][1:]] if "href" in node.attributes else []
        assert all(name in ids for name in refers)


def test_the_page_refers_to_nothing_outside(refuted, root):
    for node in root.all():
        for name, value in node.attributes.items():
            assert name not in ("src", "srcset", "action", "style", "xlink:href")
            assert not name.startswith("on")
            assert name != "href" or value.startswith("#")
            assert name == "xmlns" or "//" not in value
    assert not [*root.all("link"), *root.all("img"), *root.all("iframe"), *root.all("base")]
    style = root.one("style").text
    assert not re.search(r"url\(|@import|@font-face|//", style)
    script = list(root.all("script"))[-1].text
    assert not re.search(r"fetch|XMLHttp|import\(|innerHTML|https?:|eval", script)


def test_only_the_pages_own_style_and_script_are_allowed(root):
    meta = root.one("meta", http_equiv="Content-Security-Policy").attributes["content"]
    rules = dict(rule.strip().split(" ", 1) for rule in meta.split(";"))
    assert rules["default-src"] == rules["base-uri"] == rules["form-action"] == "'none'"
    assert set(rules) == {"default-src", "style-src", "script-src", "base-uri", "form-action"}
    for rule, text in (
        ("style-src", root.one("style").text),
        ("script-src", list(root.all("script"))[-1].text),
    ):
        digest = b64encode(hashlib.sha256(text.encode()).digest()).decode()
        assert rules[rule] == f"'sha256-{digest}'"


def test_whatever_an_explorer_says_is_text():
    def explore(first):
        raise ValueError(HOSTILE)
        yield

    report = replace(check(explore, edges=1), explorer=HOSTILE)
    text = page(report)
    text.encode("utf-8")
    assert not re.search("[\0\x1b\ud800\ufffe\u202e]", text)
    root = read(text)
    scripts = [block.attributes.get("type") for block in root.all("script")]
    assert scripts == ["application/json"] * 3 + [None]
    assert not list(root.all("b", title='x"')), "no element comes from the text"
    assert legal(escaped(HOSTILE)) in root.one("h1").text
    assert legal(escaped(HOSTILE)) in root.one(id="finding-1-detail").text
    finding = json.loads(root.one(id="finding-1-json").text)
    assert finding == report.findings[0].to_json()
    assert HOSTILE in finding["detail"]


def test_an_answer_in_which_the_marker_has_no_place_is_drawn_without_it():
    def explore(first):
        yield Move(0)
        return Estimate(named_map("edge"), 0)

    report = check(explore, edges=2, max_findings=50, laws=("map",))
    root = read(page(report))
    assert len([*root.all("figure")]) == 2 * len(report.findings) > 2


def test_a_check_that_holds_has_a_page_without_findings():
    root = read(page(check(edges=2)))
    assert root.one(class_="verdict holds")
    assert not [*root.all(id="finding-1")]
    assert "every start and place" in root.one(class_="scope").text


def test_a_mismatch_of_the_count_gate_is_told():
    report = check(edges=1)
    report = replace(
        report,
        cells=(
            *report.cells,
            GateCell(edges=1, vertices=1, enumerated=3, counted=99, source="somebody"),
        ),
    )
    assert "is 99" in read(page(report)).one(class_="scope").text


def test_a_sample_has_a_page_too():
    root = read(page(fuzz(edges=6, runs=5)))
    assert root.one(class_="verdict not-refuted")
    assert root.one("h1").text.startswith("allworlds fuzz")


def test_a_finding_of_the_corpus_says_so(tmp_path):
    explorer = mutant("pose-lost")
    assert "from the corpus" not in page(check(explorer, edges=2, corpus=tmp_path))
    assert "from the corpus" in page(check(explorer, edges=2, corpus=tmp_path))


def test_a_cell_of_more_than_thirty_characters_may_be_broken():
    cells = ["x" * 30, "x" * 31, 7]
    (row,) = table_element(parts.Table(["a", "b", "c"], [cells])).iterfind("tbody/tr")
    assert [cell.get("class") for cell in row] == ["words", "sentence", None]


def test_of_a_long_walk_the_first_states_alone_are_on_the_page(monkeypatch):
    monkeypatch.setattr("allworlds.reports.web.sections.LONGEST", 5)
    shown = page(run("algorithm1", "k4"))
    assert "The first 4 of" in shown
    ways = re.search(r'class="ways">(.*?)</script>', shown, re.DOTALL)[1]
    assert len(json.loads(ways)["walk"]) == 5
