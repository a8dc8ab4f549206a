"""Notebooks and ``print``: drawings with their own style, and texts of the command line."""

import re
import sys
from types import SimpleNamespace
from xml.etree import ElementTree as ET

import pytest

import allworlds
from allworlds import maps
from allworlds.engines import progress
from allworlds.inputs import InputError
from allworlds.reports import text
from allworlds.reports.drawing.standalone import STYLE, draw
from allworlds.reports.notebook import verb_of
from allworlds.reports.schemas import reports_of
from allworlds.verbs import VERBS
from allworlds.world import Directional, World

SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def world():
    return World(maps.named_map("theta-torus"), Directional(1))


def test_the_names_that_one_looks_for_are_found_by_dir():
    assert {"World", "draw", "maps", "strategies", "testing"} <= set(dir(allworlds))
    assert allworlds.maps is maps
    assert callable(allworlds.strategies.worlds)


def test_a_saved_drawing_carries_its_style(world, tmp_path):
    drawing = draw(world)
    drawing.save(tmp_path / "world.svg")
    root = ET.parse(tmp_path / "world.svg").getroot()
    assert root.find(f"{SVG}style").text == STYLE
    # No edge is a black area: each class of a shape that is drawn has a rule.
    shapes = [one for one in root.iter() if one.tag.removeprefix(SVG) in ("path", "circle", "rect")]
    styled = set(re.findall(r"\.([a-z]+)", STYLE))
    assert len(shapes) > 10
    for shape in shapes:
        hidden = {"stub", "robot"} & set(shape.get("class").split())
        assert hidden or styled & set(shape.get("class").split()), shape.attrib


def test_a_notebook_shows_maps_and_worlds_as_their_drawings(world):
    assert world._repr_svg_() == draw(world).svg == draw(world)._repr_svg_()
    assert world.map._repr_svg_() == draw(world.map).svg != draw(world).svg
    assert str(draw(world)).startswith(" ")
    with pytest.raises(InputError, match="neither a CombinatorialMap nor a World"):
        draw("k4")


def test_a_report_is_printed_as_on_the_command_line():
    report = allworlds.check("algorithm1", edges=2)
    assert str(report) == text("check", report, 100).rstrip("\n")
    assert str(report).startswith("HOLDS")
    assert "12 worlds" in report._repr_html_()


@pytest.mark.parametrize("verb", VERBS, ids=lambda verb: verb.name)
def test_every_report_knows_its_verb(verb):
    for kind in reports_of(verb):
        if verb.name != "merge":  # which hands on that of another verb
            other = verb_of(kind)
            same = {"fuzz": "check"}.get(verb.name, verb.name)
            assert other == same


@pytest.mark.slow
def test_runs_transcripts_and_findings_are_shown(world):
    run = allworlds.run("greedy", world)
    assert "srcdoc=" in run._repr_html_()
    rows = ET.fromstring(run.transcript._repr_html_()).find("tbody")
    assert len(rows) == len(run.transcript.steps) + 1
    (finding,) = allworlds.check("dudek91", edges=2).findings
    assert finding.law in finding._repr_html_()


def test_a_page_in_a_frame_cannot_end_it():
    def explore(_):
        return '"></iframe><script>'
        yield

    (finding,) = allworlds.check(explore, edges=1).findings
    shown = finding._repr_html_()
    assert shown.count("</iframe>") == 1
    assert "<script" not in shown


def test_a_job_shows_a_bar_in_a_notebook_and_nothing_elsewhere(monkeypatch):
    assert isinstance(progress.usual_listener(), progress.Silent)
    shown = []
    handle = SimpleNamespace(update=shown.append)

    def display(bar, display_id):
        assert display_id
        shown.append(bar)
        return handle

    ipython = SimpleNamespace(
        get_ipython=lambda: SimpleNamespace(kernel=1), display=SimpleNamespace(display=display)
    )
    monkeypatch.setitem(sys.modules, "IPython", ipython)
    allworlds.check("algorithm1", edges=2)
    assert repr(shown[0]) == "edges 1: 0 of 2 worlds"
    assert repr(shown[-1]) == "edges 2: 10 of 10 worlds"
    assert '<progress value="10" max="10">' in shown[-1]._repr_html_()
