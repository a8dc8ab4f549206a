"""The page of play: self-contained, and the world is in it without being seen."""

import hashlib
import json
import re
from base64 import b64encode

import pytest

from allworlds.playing import play
from allworlds.reports import page_of, text
from allworlds.reports.play.page import world_data
from allworlds.world import LIGHTHOUSES
from small import LOLLIPOP


@pytest.mark.parametrize("kind", LIGHTHOUSES)
def test_the_page_holds_the_world_under_every_lighthouse(kind):
    made = play(json.dumps(LOLLIPOP.to_json()), lighthouse=kind)
    page = page_of("play", made)
    (held,) = re.findall(
        r'<script type="application/json" id="play-json">(.*?)</script>', page, re.DOTALL
    )
    assert json.loads(held) == json.loads(json.dumps(world_data(made.world)))
    assert f"A {kind} lighthouse." in page
    assert ("You are told: " in page) == (made.world.told is not None)


def test_the_page_allows_its_own_script_and_style_alone():
    page = page_of("play", play("theta"))
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
    page = page_of("play", play("theta"))
    (script,) = re.findall(r"<script>(.*?)</script>", page, re.DOTALL)
    asked = {*re.findall(r'\bat\("([a-z-]+)"\)', script)}
    asked |= {
        *re.findall(r"^  ([a-z]+)(?:: |,$)", script.partition("const BUTTONS")[2], re.MULTILINE)
    }
    assert {"uncover", "claim", "notes", "sensed", "world"} < asked
    assert asked <= {*re.findall(r'\bid="([a-z-]+)"', page)}


def test_nothing_is_seen_of_the_world_before_it_is_uncovered():
    made = play("theta-torus")
    page = page_of("play", made)
    (game,) = re.findall(r'<div id="game"([^>]*)>', page)
    assert "hidden" in game
    title = re.findall(r"<title>(.*?)</title>|<h1>(.*?)</h1>", page)
    assert "theta" not in str(title)
    assert "theta" not in text("play", play("theta-torus"), 80).partition("the walk")[2]
