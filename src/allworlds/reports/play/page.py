"""The page of ``play``, in which the reader is the robot."""

from __future__ import annotations

from collections.abc import Sequence
from importlib.resources import files
from typing import Any
from xml.etree import ElementTree as ET

from allworlds.inputs.checks import InputError
from allworlds.judging.laws.bounds import bound_named
from allworlds.protocol.actions import Pick
from allworlds.reports.drawing.scene import scene_of
from allworlds.reports.rendering import record, tag
from allworlds.reports.tellings.played import LEAST, NAMES
from allworlds.reports.web.frame import Own, Page, framed
from allworlds.reports.web.viewer import figure
from allworlds.studies.play import Play
from allworlds.world.lighthouses.kinds import parts_of
from allworlds.world.lighthouses.placeless import Movable, Whiteboard
from allworlds.world.world import World

HOW = (
    "Click a number, or press its key, to leave by that edge: 0 is the way back, the others "
    "follow clockwise. At the start 0 is the edge that you face. All that you are told is what "
    "you sense where you arrive."
)
CONCLUDE = (
    "Every arrival is drawn as a place of its own, as it might be one. Do you know better? "
    "Click two darts to say that they are one and the same."
)


def game(play: Play) -> str:
    """The page of the game, which hides the world at first."""
    world = play.world
    lighthouse = f"{world.lighthouse.kind} lighthouse"
    told = "" if world.told is None else f" You are told: {world.told}."
    page = Page(
        "allworlds play",
        "you are the robot",
        ("EXPLORE", f"Which world is this, and where in it are you? A {lighthouse}.{told}", "open"),
        [
            tag("noscript", tag("p", "This page needs JavaScript: it is played.")),
            _board(play),
        ],
        play.to_json(),
        Own(
            _read("play.css"), "".join(_read(name) for name in ("robot.js", "spots.js", "view.js"))
        ),
    )
    return framed(page)


def world_data(world: World) -> dict[str, Any]:
    """Data of the world for the script, whatever the lighthouse; see ``robot.js``.

    Raises:
        InputError: for a lighthouse of the user's under which the robot leaves marks.
    """
    map_ = world.map
    marking = next((part for part in parts_of(world.lighthouse) if part.leaves_marks), None)
    if marking is not None and marking.code is not None:
        raise InputError(
            f"under the lighthouse {world.lighthouse.written} the robot leaves marks in a way of "
            "your own, which a page cannot do; leave -o out to play in the terminal"
        )
    written = marking if isinstance(marking, Whiteboard) else None
    spots: list[int] | None = None
    if written:
        spots = [written.place_of_number(map_, dart) for dart in map_.darts]
    elif isinstance(marking, Movable) and marking.distinct:
        spots = list(map_.vertex_of)
    return {
        "sigma": list(map_.sigma),
        "alpha": list(map_.alpha),
        "vertex": list(map_.vertex_of),
        "percepts": [percept.to_json() for percept in world.percepts],
        "start": world.start,
        "hand": world.lighthouse.in_hand,
        "pick": not world.lighthouse.refusal(Pick(), 1, 0),
        "states": written.states if written else 0,
        "spots": spots,
        "bound": bound_named(world.lighthouse.default_bound).of(map_, world.start),
    }


def costs_data(play: Play) -> dict[str, Any]:
    """The costs of others for the script, and what is to be said of them."""
    return {
        "others": [[NAMES[one.who], one.cost] for one in play.costs],
        "said": f"{LEAST} {play.not_compared}".rstrip(),
    }


def _board(play: Play) -> ET.Element:
    world = play.world
    return tag(
        "div",
        tag("div", _senses(), _notes(), class_="game"),
        tag("p", "", id="outcome", class_="outcome", role="status"),
        _costs(),
        tag("section", tag("h2", "The walk"), tag("ol", id="log", start="0"), class_="log"),
        tag(
            "section",
            tag("h2", "The world"),
            _buttons(("uncover", "Uncover the world"), ("restart", "Begin again")),
            tag("div", figure("The world", scene_of(world), "played", "robot"), id="world"),
        ),
        record(
            {**world_data(world), "costs": costs_data(play)},
            id="play-json",
        ),
        id="game",
        hidden="hidden",
    )


def _costs() -> ET.Element:
    """The place of the table of costs, which the script shows at the end."""
    return tag(
        "section",
        tag("h2", "Costs"),
        tag("table", tag("tbody", id="cost-rows"), class_="costs"),
        tag("p", "", id="costs-words", class_="legend"),
        id="costs",
        hidden="hidden",
    )


def _senses() -> ET.Element:
    return tag(
        "figure",
        tag("figcaption", tag("b", "What you sense")),
        tag("div", id="sensed", class_="frame"),
        tag("p", "", id="sensed-words", role="status"),
        tag("p", tag("span", "", id="cost"), " ", tag("span", "", id="hand")),
        _buttons(("drop", "Drop a marker"), ("pick", "Take a marker up")),
        _buttons(("write", "Write"), before=[_number()]),
        tag("p", HOW, class_="legend"),
    )


def _notes() -> ET.Element:
    return tag(
        "figure",
        tag("figcaption", tag("b", "Your notes")),
        tag("div", id="notes", class_="frame"),
        tag("p", "", id="notes-words", role="status"),
        _buttons(("undo", "Take back a conclusion"), ("claim", "This is the world")),
        tag("p", CONCLUDE, class_="legend"),
    )


def _number() -> ET.Element:
    told = {"min": "0", "value": "0", "step": "1", "aria_label": "The number to write"}
    return tag("input", type="number", id="number", **told)


def _buttons(*buttons: tuple[str, str], before: Sequence[ET.Element] = ()) -> ET.Element:
    made = (tag("button", label, type="button", id=name) for name, label in buttons)
    return tag("p", *before, *made, class_="rows")


def _read(name: str) -> str:
    return (files("allworlds.reports.play") / name).read_text(encoding="utf-8")
