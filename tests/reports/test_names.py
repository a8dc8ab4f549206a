"""Rooms have the names that the user gave, in every form of every report."""

import csv
import io
import json
import re
from itertools import pairwise
from xml.etree import ElementTree as ET

import pytest

import allworlds
from allworlds import Estimate, Move
from allworlds.documents.document import replace
from allworlds.judging.findings.finding import Finding
from allworlds.maps import CombinatorialMap, named_map
from allworlds.reports.drawing.layout import DISC
from allworlds.reports.drawing.svg import BESIDE, BEYOND, STEEP, _beside, draw, drawing
from allworlds.reports.drawing.text import draw as in_characters
from allworlds.reports.formats import file_of, text
from allworlds.reports.parts import Scene, scene_of
from allworlds.world import Labelling, World

ROOMS = ("hall", "kitchen", "bedroom 1", "bedroom 2", "bath", "F")
PLAN = World(
    CombinatorialMap(
        [12, 4, 0, 8, 1, 7, 3, 10, 6, 11, 5, 9, 2, 13],
        [1, 0, 3, 2, 5, 4, 7, 6, 9, 8, 11, 10, 13, 12],
    ),
    "directional",
    labels=Labelling("tower", ROOMS, ((0, 0), (2, 0), (0, 2), (2, 2), (1, 3.2), (-2, 0.5))),
)
NUMBER = re.compile(r"(?<!/)\bv[0-9]+\b(?!\.[0-9]+\.[0-9])")
FORMS = ("html", "markdown", "json", "sarif", "annotations")


def wrong(turns, answer):
    """An explorer of this process that turns so, and then answers that."""

    def explore(first):
        percept = first
        for turn in turns:
            percept = yield Move(turn % percept.degree)
        return Estimate(answer, 0)

    return explore


GOES_ROUND = wrong([1, 1, 1], CombinatorialMap([1, 2, 0, 3], [1, 0, 3, 2]))
GUESSES = wrong([0, 0], PLAN.map)


@pytest.fixture(scope="module")
def report():
    given = [World(PLAN.map, None, start, labels=PLAN.labels) for start in PLAN.map.darts]
    return allworlds.check(GOES_ROUND, worlds=given, max_findings=1)


def content(form, result):
    """The words of a form for people, in one line: of a page without its style and script."""
    made = re.sub(r"<(style|script)[^>]*>.*?</\1>", "", file_of(form, result), flags=re.DOTALL)
    return " ".join(made.replace("%2C", ",").split())


@pytest.mark.parametrize("form", FORMS)
def test_every_form_of_a_finding_has_the_names_and_no_number(form, report):
    made = content(form, report)
    assert not NUMBER.search(made)
    assert all(room in made for room in (ROOMS if form != "annotations" else ["tower"]))
    assert "in the world tower, with 7 edges and 6 vertices" in made or form == "json"


def test_the_finding_has_the_names_of_its_world_and_keeps_them(report):
    (finding,) = report.findings
    again = Finding.from_json(finding.text)
    assert again.world.labels == finding.world.labels
    assert again.world.labels.name == "tower"
    assert {*finding.world.labels.vertices} == {*ROOMS}
    replayed = allworlds.replay(again, GOES_ROUND)
    assert replayed.again.finding.world.labels == finding.world.labels
    for result in (report, replayed, allworlds.explain(again)):
        said = " ".join(text(result, 100).split())
        assert not NUMBER.search(said)
        assert "in the world tower, with 7 edges and 6 vertices" in said
        assert "hall -> " in said
        assert all(room in said for room in ROOMS)


def test_every_step_leads_from_room_to_room(report):
    (finding,) = report.findings
    steps = re.findall(r"^ +\d  move \d  (.+?) -> (.+?), dart", text(report, 200), re.MULTILINE)
    assert len(steps) == 3
    assert all(there == here for (_, there), (here, _) in pairwise(steps))
    edges = {*map(frozenset, steps)}
    map_, names = finding.world.map, finding.world.labels.vertices
    doors = {frozenset(names[map_.vertex_of[d]] for d in edge) for edge in map_.edges}
    assert edges <= doors


def test_rows_of_a_walk_have_the_names_beside_the_numbers():
    run = allworlds.run("algorithm1", PLAN)
    rows = [*csv.DictReader(io.StringIO(file_of("csv", run)))]
    assert len(rows) == run.cost + 1
    assert all(ROOMS[int(row["vertex"])] == row["name"] for row in rows)
    plain = allworlds.run("algorithm1", World(PLAN.map))
    assert "name" not in file_of("csv", plain).partition("\n")[0]
    assert json.loads(file_of("json", run))["world"]["names"] == [*ROOMS]


def test_a_run_and_its_answer_are_drawn_with_the_names():
    said = text(allworlds.run("algorithm1", PLAN), 200)
    assert not NUMBER.search(said)
    world, answer = re.findall(r"^ hall ●.*", said, re.MULTILINE)
    assert world == answer
    guessed = text(allworlds.run(GUESSES, PLAN), 200)
    assert "Another world, with the same percepts" in guessed
    assert not NUMBER.search(guessed)


def test_the_most_expensive_runs_of_given_worlds_have_the_names():
    given = [World(PLAN.map, None, start, labels=PLAN.labels) for start in (0, 5)]
    page = content("html", allworlds.check("algorithm1", worlds=given))
    assert all(room in page for room in ROOMS)
    assert not NUMBER.search(page)


def test_a_finding_of_a_corpus_keeps_its_names_where_it_is_tried_again(tmp_path):
    given = World(named_map("path-3"), "directional", labels=Labelling("", ("ab", "cd", "ef")))
    (first,) = allworlds.check(GOES_ROUND, worlds=[given], max_findings=1).findings
    (tmp_path / first.file_name).write_text(first.text, encoding="utf-8")
    past = allworlds.check(GOES_ROUND, edges=2, corpus=tmp_path, max_findings=1)
    assert past.corpus.reproduced == (first.file_name,)
    assert past.findings[0].world.labels == first.world.labels


def test_the_page_of_play_has_the_names():
    page = content("html", replace(allworlds.play(PLAN), path="play.html"))
    assert all(line in page for line in (">kitchen<", ">bedroom 1<", ">bedroom 2<"))
    assert not NUMBER.search(page)


def test_worlds_that_look_alike_are_shown_with_the_names():
    one, other = (World(PLAN.map, "none", start, labels=PLAN.labels) for start in (0, 1))
    apart = text(allworlds.ambiguity.twins(one, other), 200)
    same = allworlds.ambiguity.twins(one, one.mirrored().mirrored())
    rows = [*csv.DictReader(io.StringIO(file_of("csv", same)))]
    assert [row["name"] for row in rows] == [ROOMS[v] for v in PLAN.map.vertex_of] * 2
    assert not NUMBER.search(apart + text(same, 200))
    assert "hall" in apart


@pytest.mark.parametrize(
    ("names", "shown"),
    [
        (["hall", "F", "bath"], ["hall", "F", "bath"]),
        (["bedroom 1", "bedroom 2", "bedr…"], ["bed…0", "bed…1", "bedr…"]),
        (["bedroom 1", "bedroom 2", "bedroom 3"], ["bed…0", "bed…1", "bed…2"]),
    ],
)
def test_no_two_names_become_one_where_they_are_cut(names, shown):
    scene = Scene(named_map("path-3"), vertices=tuple(names))
    assert scene.short_names(5) == shown
    cut = [f"{short} {name}" for short, name in zip(shown, names, strict=True) if short != name]
    assert scene.cut_names(5) == cut


def test_sixteen_characters_of_a_name_stand_in_a_text():
    names = ("sixteen letters!", "seventeen letters", "hall")
    drawn = in_characters(Scene(named_map("path-3"), vertices=names), 200)
    assert "sixteen letters!" in drawn.split("\n\n")[0]
    assert "seventeen letters" not in drawn.split("\n\n")[0]


def test_thousands_of_names_that_begin_alike_stay_apart():
    names = tuple(f"the room with the number {i}" for i in range(1200))
    shown = Scene(named_map("path-1200"), vertices=names).short_names(3)
    assert len({*shown}) == 1200


def test_long_names_stand_whole_beside_their_rooms():
    svg = ET.fromstring(draw(PLAN).svg)
    names = [text for text in svg.iter() if (text.get("class") or "").startswith("name")]
    shown = ["".join(text.itertext()) for text in names]
    assert shown == ["hall", "kitchen", "bedroom 1", "bedroom 2", "bath", "F"]
    beside = [text for text in names if text.get("class") == "name beside"]
    assert ["".join(text.itertext()) for text in beside] == ["kitchen", "bedroom 1", "bedroom 2"]
    assert all(abs(float(text.get("y"))) > DISC for text in beside)
    assert "legend" not in {text.get("class") for text in svg.iter()}


def test_a_name_beside_a_room_is_clear_of_its_doors_and_in_the_picture():
    names = ("a room with a long name, at the left", "hall", "another one, at the far right")
    places = ((0.0, 0.0), (1.0, 0.0), (2.0, 0.0))
    path = named_map("path-3")
    svg = ET.fromstring(drawing(Scene(path, 0, vertices=names, positions=places), "plan").svg)
    left, _, width, _ = map(float, svg.get("viewBox").split())
    rooms = [one for one in svg.iter() if one.get("class") == "vertex"]
    for room, name in zip(rooms, names, strict=True):
        across = float(room.get("transform").split("(")[1].split()[0])
        assert left <= across - 3 * len(name)
        assert across + 3 * len(name) <= left + width
    assert _beside([1, -1]) == BESIDE
    assert (_beside([1j]), _beside([-1j]), _beside([1j, -1j])) == (-BESIDE, BESIDE, BEYOND)
    assert _beside([complex(0.6, STEEP)]) == BESIDE
    assert _beside([1j, complex(0.6, -STEEP)]) == -BESIDE


def test_long_names_are_cut_in_characters_and_stand_in_the_legend():
    names = tuple(f"the {word} room behind the stairs" for word in ("red", "blue", "red, small"))
    world = World(named_map("path-3"), "none", labels=Labelling("", names))
    said = in_characters(scene_of(world), 100)
    assert "the red room b…0" in said
    assert all(name in said for name in names)
    table = in_characters(scene_of(world), 20)
    assert "→the red room b…0." in table
    assert not NUMBER.search(said + table)
