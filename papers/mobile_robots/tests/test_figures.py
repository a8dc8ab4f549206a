"""The pictures are those that the programs draw, and show what the claims find."""

import importlib

import pytest

from check import gathers
from claims import shrink_named, shrink_worlds
from paper_claims import PAPER
from worlds import placements, places_of, steps_by

SLOW = pytest.mark.slow
NAMES = [
    "collision",
    "start_pairs",
    *(pytest.param(n, marks=SLOW) for n in ("configurations", "rule_sets")),
]


@pytest.fixture
def drawing(monkeypatch):
    """The module that draws a picture."""
    monkeypatch.syspath_prepend(PAPER / "figures")
    return importlib.import_module


def test_every_picture_has_a_program_that_is_tried_here():
    tried = {name if isinstance(name, str) else name.values[0] for name in NAMES}
    assert {file.stem for file in (PAPER / "figures").glob("*.svg")} == tried


@pytest.mark.parametrize("name", NAMES)
def test_the_picture_that_is_kept_is_drawn_again(drawing, name):
    text = drawing("strokes").written(drawing(name).figure())
    assert (PAPER / "figures" / f"{name}.svg").read_text(encoding="utf-8") == text


def test_every_look_is_a_circle_and_every_late_move_a_dotted_line(drawing):
    parts = [*drawing("collision").figure().iter()]
    looks = [part for part in parts if part.tag == "circle" and "end" not in part.get("class", "")]
    late = [part for part in parts if part.get("class") == "due"]
    assert (len(looks), len(late)) == (8, 8)
    assert sum(part.get("class") == "end" for part in parts) == 1


def test_there_is_a_square_for_each_pair_in_both_orders_and_a_bar_for_each_number(drawing):
    pairs = drawing("start_pairs")
    parts = [part for part in pairs.figure().iter("rect") if part.get("fill")]
    side, legend = str(pairs.CELL - 1), len(pairs.NAMES)
    squares = [part for part in parts if part.get("width") == side == part.get("height")]
    named = sum(sum(numbers) for numbers in shrink_named(None).figures.values())
    assert len(squares) == 2 * named + legend
    bars = sum(1 + len(shrink_worlds(None, edges=m).figures["by Shrink"]) for m in range(2, 7))
    assert len(parts) == len(squares) + bars


def test_the_last_number_of_configurations_is_that_of_the_claim(drawing):
    _, configurations = drawing("configurations").counts("async")
    kept = (PAPER / "figures" / "configurations.svg").read_text(encoding="utf-8")
    assert f">{configurations[-1]} configurations in ASYNC" in kept


def test_each_rule_set_that_is_drawn_is_right_as_far_as_it_is_said(drawing):
    for number, program in enumerate(drawing("rule_sets").one_of_each(5), 1):
        for place, scheduler in enumerate(("fsync", "ssync", "async")):
            starts = [places_of(start) for start in placements(5, 3)]
            right = all(gathers(start, 5, steps_by(program), scheduler) for start in starts)
            assert right == (place < number)
