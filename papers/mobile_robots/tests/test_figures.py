"""The picture of the collision is the one that the program draws."""

import importlib
from xml.etree import ElementTree as ET

import pytest

from paper_claims import PAPER


@pytest.fixture
def drawing(monkeypatch):
    """The module that draws it."""
    monkeypatch.syspath_prepend(PAPER / "figures")
    return importlib.import_module("collision")


def test_the_picture_that_is_kept_is_drawn_again(drawing):
    text = ET.tostring(drawing.figure(), "unicode") + "\n"
    assert drawing.FILE.read_text(encoding="utf-8") == text


def test_every_look_is_a_circle_and_every_late_move_a_dotted_line(drawing):
    parts = [*drawing.figure().iter()]
    looks = [part for part in parts if part.tag == "circle" and "end" not in part.get("class", "")]
    late = [part for part in parts if part.get("class") == "due"]
    assert (len(looks), len(late)) == (8, 8)
    assert sum(part.get("class") == "end" for part in parts) == 1
