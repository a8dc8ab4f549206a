"""The page of play: self-contained, and the world is in it without being seen."""

import hashlib
import json
import re
from base64 import b64encode

import pytest

from allworlds.inputs.checks import InputError
from allworlds.reports.formats import text
from allworlds.reports.web.play import costs_data, game as game_page
from allworlds.reports.web.sections import world_data
from allworlds.studies.run import play
from allworlds.world import LIGHTHOUSES
from html_tree import Reader
from small import LOLLIPOP


@pytest.mark.parametrize("kind", LIGHTHOUSES)
def test_the_page_holds_the_world_under_every_lighthouse(kind):
    made = play(json.dumps(LOLLIPOP.to_json()), lighthouse=kind)
    page = game_page(made)
    (held,) = re.findall(
        r'<script type="application/json" id="play-json">(.*?)</script>', page, re.DOTALL
    )
    data = json.loads(held)
    assert data.pop("costs") == costs_data(made)
    assert data == json.loads(json.dumps(world_data(made.world)))
    assert f"A {kind} lighthouse." in page
    assert ("You are told: " in page) == (made.world.told is not None)


def test_marks_of_the_users_own_kind_are_left_in_the_terminal_alone(tmp_path, monkeypatch):
    (tmp_path / "chalk.py").write_text(
        "from allworlds import Lighthouse\n\n\nclass Chalk(Lighthouse):\n"
        "    leaves_marks = True\n\n    @classmethod\n    def places(cls, map_, start):\n"
        "        yield cls()\n"
    )
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError, match=r"lighthouse chalk.py:Chalk .* leave -o out"):
        game_page(play("theta", lighthouse="chalk.py:Chalk"))


def test_the_page_allows_its_own_script_and_style_alone():
    page = game_page(play("theta"))
    (policy,) = re.findall(r'http-equiv="Content-Security-Policy" content="([^"]*)"', page)
    scripts = re.findall(r"<script>(.*?)</script>", page, re.DOTALL)
    styles = re.findall(r"<style>(.*?)</style>", page, re.DOTALL)
    assert len(scripts) == len(styles) == 1
    for own in scripts + styles:
        digest = b64encode(hashlib.sha256(own.encode()).digest()).decode()
        assert f"sha256-{digest}" in policy
    assert "http://" not in page.replace("http://www.w3.org/2000/svg", "")
    assert "https://" not in page


def test_whatever_the_script_asks_for_is_in_the_page():
    page = game_page(play("theta"))
    (script,) = re.findall(r"<script>(.*?)</script>", page, re.DOTALL)
    asked = {*re.findall(r'\bat\("([a-z-]+)"\)', script)}
    asked |= {
        *re.findall(r"^  ([a-z]+)(?:: |,$)", script.partition("const BUTTONS")[2], re.MULTILINE)
    }
    assert {"uncover", "claim", "notes", "sensed", "world"} < asked
    assert asked <= {*re.findall(r'\bid="([a-z-]+)"', page)}


def test_nothing_is_seen_of_the_world_before_it_is_uncovered():
    made = play("theta-torus")
    page = game_page(made)
    (game,) = re.findall(r'<div id="game"([^>]*)>', page)
    assert "hidden" in game
    title = re.findall(r"<title>(.*?)</title>|<h1>(.*?)</h1>", page)
    assert "theta" not in str(title)
    assert "theta" not in text(play("theta-torus"), 80).partition("the walk")[2]


SELECTED = {".walked, .here", "[data-darts]", '[data-dart="${dart}"]', ".frame"}
"""What the script looks for in the picture of the world; the next test says what it relies on."""


def selectors(script):
    asked = re.findall(
        r"querySelector(?:All)?\((['`\"])(.*?)\1\)", script.partition("// The page in")[2]
    )
    return {selector for _, selector in asked}


@pytest.mark.parametrize("name", ["theta-torus", "cube", "fig1-left"])
def test_the_picture_of_the_world_is_as_the_script_of_the_game_takes_it(name):
    page = game_page(play(name))
    (script,) = re.findall(r"<script>(.*?)</script>", page, re.DOTALL)
    assert selectors(script) == SELECTED
    map_ = play(name).world.map
    (drawn,) = Reader(page).root.one("div", id="world").all("svg")
    assert re.fullmatch(r"(-?\d+ ){2}\d+ \d+", drawn.attributes["viewbox"])
    edges = [n for n in drawn.all("path") if "data-darts" in n.attributes]
    assert all(edge.attributes["class"] == "edge" for edge in edges)
    ends = [tuple(map(int, edge.attributes["data-darts"].split(" "))) for edge in edges]
    assert sorted(ends) == sorted(map_.edges)
    seats = [n for n in drawn.all("g") if "data-dart" in n.attributes]
    assert sorted(int(seat.attributes["data-dart"]) for seat in seats) == [*map_.darts]
    for seat in seats:
        assert "here" not in seat.attributes["class"].split()
        assert seat.one("circle", class_="robot")


def test_whatever_the_script_draws_has_a_style():
    page = game_page(play("theta"))
    (script,) = re.findall(r"<script>(.*?)</script>", page, re.DOTALL)
    (style,) = re.findall(r"<style>(.*?)</style>", page, re.DOTALL)
    named = re.findall(r"(?:\bclass:|classes = |classes\.push|classList\.add)[^},;]*", script)
    classes = {one for part in named for one in " ".join(re.findall('"(.*?)"', part)).split()}
    assert {"exit", "pointed", "note-dart", "chosen", "robot-here", "walked", "here"} <= classes
    styled = set(re.findall(r"\.([a-z][a-z-]*)", style))
    assert classes - styled == {"notes"}
    shown = (".robot { display: none", ".here .robot { display: inline", ".edge.walked { stroke:")
    assert all(rule in style for rule in shown)
