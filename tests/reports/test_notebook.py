"""Notebooks and ``print``: drawings with their own style, and texts of the command line."""

import re
from pathlib import Path
from types import SimpleNamespace
from xml.etree import ElementTree as ET

import pytest

import allworlds
from allworlds import maps
from allworlds.inputs.checks import InputError
from allworlds.reports import notebook
from allworlds.reports.drawing import svg as drawn_by
from allworlds.reports.drawing.svg import draw
from allworlds.reports.formats import text
from allworlds.world import Directional, World

SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def world():
    return World(maps.named_map("theta-torus"), Directional(1))


def test_the_names_that_one_looks_for_are_found_by_dir():
    assert {"World", "draw", "maps", "strategies", "testing", "world"} <= set(dir(allworlds))
    kinds = {kind.__name__ for kind in allworlds.world.LIGHTHOUSES.values()}
    assert kinds <= set(dir(allworlds.world))
    assert {"family", "from_networkx", "rooted_maps"} <= set(dir(maps))
    assert allworlds.maps is maps
    assert callable(allworlds.strategies.worlds)


def test_a_saved_drawing_carries_its_style(world, tmp_path):
    drawing = draw(world)
    drawing.save(tmp_path / "world.svg")
    style = (Path(drawn_by.__file__).parent / "alone.css").read_text(encoding="utf-8")
    root = ET.parse(tmp_path / "world.svg").getroot()
    assert root.find(f"{SVG}style").text == style.replace("NAME", root.get("id"))
    # No edge is a black area: each class of a shape that is drawn has a rule.
    shapes = [one for one in root.iter() if one.tag.removeprefix(SVG) in ("path", "circle", "rect")]
    styled = set(re.findall(r"\.([a-z]+)", style))
    assert len(shapes) > 10
    for shape in shapes:
        hidden = {"stub", "robot"} & set(shape.get("class").split())
        assert hidden or styled & set(shape.get("class").split()), shape.attrib


def test_the_rules_of_a_drawing_reach_nothing_else_in_its_page(world):
    root = ET.fromstring(draw(world).svg)
    rules = root.find(f"{SVG}style").text
    for selectors in re.findall(r"([^{}]+)\{", rules):
        for selector in selectors.split(","):
            assert selector.strip().startswith(f"#{root.get('id')} ")


def test_drawings_of_one_map_have_other_names_under_another_lighthouse_or_start(world):
    map_ = world.map
    shown = [
        map_,
        world,
        World(map_, Directional(2)),
        World(map_, "position"),
        World(map_, None, 3),
    ]
    names = [ET.fromstring(draw(one).svg).get("id") for one in shown]
    assert len(set(names)) == len(shown)
    assert ET.fromstring(draw(map_).svg).get("id") == names[0]
    every = [one.get("id") for one in ET.fromstring(draw(world).svg).iter() if one.get("id")]
    assert len(every) == 3
    assert all(name.startswith(names[1]) for name in every)


@pytest.mark.parametrize("name", ["x.png", "x", "x.svg.txt"])
def test_a_file_of_another_kind_is_refused_and_not_written(name, world, tmp_path):
    with pytest.raises(InputError, match=r"does not end in \.svg"):
        draw(world).save(tmp_path / name)
    assert not any(tmp_path.iterdir())
    draw(world).save(str(tmp_path / "x.SVG"))


def test_a_notebook_shows_maps_and_worlds_as_their_drawings(world):
    assert world._repr_svg_() == draw(world).svg == draw(world)._repr_svg_()
    assert world.map._repr_svg_() == draw(world.map).svg != draw(world).svg
    assert str(draw(world)).startswith(" ")
    with pytest.raises(InputError, match="neither a CombinatorialMap nor a World"):
        draw("k4")


def test_a_report_is_printed_as_on_the_command_line():
    report = allworlds.check("algorithm1", edges=2)
    assert str(report) == text(report, 100).rstrip("\n")
    assert str(report).startswith("HOLDS")
    assert "12 worlds" in report._repr_html_()


def test_a_finding_and_a_transcript_are_printed_in_words():
    (finding,) = allworlds.check("dudek91", edges=2).findings
    assert str(finding).startswith("Finding 1: dudek91 breaks the law 'map'")
    assert "The walk" in str(finding)
    first, *lines = str(finding.transcript).splitlines()
    assert first.split() == ["step", "action", "sensed"]
    assert len(lines) == len(finding.transcript.percepts)
    assert lines[1].split()[:3] == ["1", *str(finding.transcript.actions[0]).split()]


def test_a_plain_ipython_shows_what_print_does():
    report = allworlds.check("dudek91", edges=2)
    for shown in (report, report.findings[0], report.findings[0].transcript):
        said = []
        # IPython takes what stands in a class itself before a repr of its bases.
        vars(type(shown))["_repr_pretty_"](shown, SimpleNamespace(text=said.append), cycle=False)
        assert said == [str(shown)]


def test_a_page_in_a_frame_cannot_end_it():
    def explore(_):
        return '"></iframe><script>'
        yield

    (finding,) = allworlds.check(explore, edges=1).findings
    shown = finding._repr_html_()
    assert shown.count("</iframe>") == 1
    assert "<script" not in shown


def test_a_notebook_shows_a_transcript_as_a_table():
    (finding,) = allworlds.check("dudek91", edges=2).findings
    table = ET.fromstring(finding.transcript._repr_html_()).find(".//thead/..")
    assert [cell.text for cell in table.find("thead").iter("th")] == ["step", "action", "sensed"]
    rows = [["".join(c.itertext()) for c in row] for row in table.find("tbody")]
    assert len(rows) == len(finding.transcript.percepts)
    assert rows[0] == ["0", "start", str(finding.transcript.first)]


@pytest.mark.parametrize(("lines", "more"), [(19, 0), (20, 0), (21, 2), (22, 3)])
def test_a_shell_shows_at_most_twenty_lines(lines, more, monkeypatch):
    whole = [f"line {number}" for number in range(lines)]
    monkeypatch.setattr(notebook, "text_of", lambda _: "\n".join(whole))
    shown = notebook.short_text_of(None).split("\n")
    if more:
        assert shown == [*whole[:18], f"... ({more} lines more: print it)", whole[-1]]
    else:
        assert shown == whole
