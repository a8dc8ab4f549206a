"""Pictures side by side, and the walk along which keys step in all of them."""

from __future__ import annotations

from collections.abc import Sequence
from xml.etree import ElementTree as ET

from allworlds.reports.drawing.layout import Layout
from allworlds.reports.drawing.scene import Scene
from allworlds.reports.drawing.svg import picture
from allworlds.reports.rendering import tag

KEYS = (
    "Left and right arrow, Home and End step along the walk, the space bar plays it, "
    "plus and minus zoom."
)

SPEEDS = {"slow": 1600, "medium": 800, "fast": 250}
"""Milliseconds from step to step."""


def viewer(
    figures: Sequence[ET.Element], steps: ET.Element, title: str, *about: ET.Element
) -> ET.Element:
    """Pictures with the walk along which keys step in all of them.

    What is told about them stands before the pictures, and on a phone behind them.
    """
    return tag(
        "div",
        *about,
        tag("div", class_="tabs", role="group", aria_label="Picture", hidden="hidden"),
        tag("div", *figures, class_="pictures"),
        _controls(),
        tag("p", KEYS, class_="keys", hidden="hidden"),
        steps,
        class_="viewer",
        role="group",
        tabindex="0",
        aria_label=f"{title} {KEYS}",
    )


def _controls() -> ET.Element:
    """Buttons, a slider, and the position in the walk. Without a script there are none."""
    go = {"first": "|◀", "back": "◀", "next": "▶", "last": "▶|"}
    step = [
        tag("button", sign, type="button", data_go=where, aria_label=where.capitalize())
        for where, sign in go.items()
    ]
    play = tag("button", "Play", type="button", class_="play")
    speed = tag(
        "select",
        *(
            tag("option", name, value=time, selected="selected" if name == "medium" else None)
            for name, time in SPEEDS.items()
        ),
        class_="speed",
        aria_label="Speed",
    )
    slider = tag("input", type="range", class_="slider", min=0, value=0, aria_label="Step")
    zoom = [
        tag("button", sign, type="button", data_zoom=way, aria_label=said)
        for sign, way, said in (("\N{MINUS SIGN}", "out", "Zoom out"), ("+", "in", "Zoom in"))
    ]
    return tag(
        "div",
        tag("div", *step[:2], play, *step[2:], speed, class_="buttons"),
        slider,
        tag("div", *zoom, class_="buttons"),
        tag("p", "", class_="now", role="status"),
        class_="controls",
        hidden="hidden",
    )


def figure(
    title: str,
    scene: Scene,
    name: str,
    follows: str,
    drawn: Layout | None = None,
    *,
    moves: bool = True,
) -> ET.Element:
    """A picture with its caption and its legend.

    The robot in it is that of ``follows``; where that is empty there is none.  It ``moves``, unless
    its walk has no motion.
    """
    legend = [tag("span", "clockwise: the order of darts", class_="key turn-key")]
    if follows:
        legend += [
            tag("span", "robot, at the dart by which it came", class_="key robot-key"),
        ]
    if follows and moves:
        legend += [
            tag("span", "walked", class_="key walked-key"),
            tag("span", "walked just before", class_="key trail-key", hidden="hidden"),
            tag("span", "walked just now, with its step", class_="key last-key", hidden="hidden"),
        ]
    if scene.marks:
        legend.append(tag("span", "marked", class_="key marked-key"))
    if scene.pointed:
        legend.append(tag("span", "pointed along", class_="key pointed-key"))
    legend.append(tag("span", "faced at the start", class_="key start-key"))
    if scene.ringed is not None:
        legend.append(tag("span", "the first difference", class_="key ring-key"))
    genus = scene.map.genus
    about = f"genus {genus}" + ("; edges that cross do not meet" if genus else "")
    return tag(
        "figure",
        tag("figcaption", tag("b", title), f", {about}"),
        _frame(picture(scene, name, title, drawn), title, follows),
        tag("p", *legend, class_="legend"),
        data_title=title,
    )


def _frame(drawing: ET.Element, title: str, follows: str) -> ET.Element:
    return tag(
        "div",
        drawing,
        class_="frame",
        data_follows=follows,
        role="group",
        tabindex="0",
        aria_label=f"{title}, which can be scrolled",
    )
