"""The frame of every page, and pictures with the walk along which keys step in all of them."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Mapping, Sequence
from hashlib import sha256
from importlib.resources import files
from typing import Any
from xml.etree import ElementTree as ET

from allworlds.reports.drawing.layout import Layout
from allworlds.reports.drawing.positions import laid_out
from allworlds.reports.drawing.scene import Scene
from allworlds.reports.drawing.svg import SHORT, picture
from allworlds.reports.markup import document, raw, record, tag
from allworlds.version import __version__

LARGEST = 1_000_000
"""Bytes of a page.  A document with which it would be larger is left out, and the page says so."""


def framed(
    title: tuple[str, str],
    verdict: tuple[str, str, str] | None,
    sections: Sequence[ET.Element],
    data: Mapping[str, Any],
    style: str = "",
    script: str = "",
) -> str:
    """A page as an HTML document that refers to no other file.

    Its own style and script are allowed by their hashes, and nothing else is.

    Args:
        title: what was done, and to whom.
        verdict: in a word, in a sentence, and as its name, by which it has its colour; None
            without one.
        sections: the page.
        data: the document of the report, which the page holds too.
        style: what this page adds to the style of all.
        script: what this page has in place of the script by which keys step along its walks.
    """
    style, script = read("style.css") + style, read("fit.js") + (script or read("script.js"))
    word, said, name = verdict or ("", "", "")
    policy = (
        f"default-src 'none'; style-src {_hash(style)}; script-src {_hash(script)}; "
        "base-uri 'none'; form-action 'none'"
    )
    head = tag(
        "head",
        tag("meta", charset="utf-8"),
        tag("meta", http_equiv="Content-Security-Policy", content=policy),
        tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
        tag("meta", name="color-scheme", content="light dark"),
        tag("meta", name="referrer", content="no-referrer"),
        tag("title", f"{title[0]}: {f'{word}, ' if word else ''}{title[1]}"),
        raw("style", style),
    )
    header = [tag("h1", title[0], ": ", tag("bdi", title[1]))]
    if verdict:
        header.append(tag("p", tag("b", word), " ", tag("span", said), class_=f"verdict {name}"))
    whole = [record(data, class_="report", id="report-json")]
    without = "is too large to hold its report: --json prints it"
    for held, records in (("holds its data as JSON", whole), (without, [])):
        foot = f"Made by allworlds {__version__}. This page needs no network, and {held}."
        body = tag(
            "body",
            tag("header", *header),
            tag("main", *sections),
            tag("footer", tag("p", foot)),
            *records,
            raw("script", script),
        )
        page = document(tag("html", head, body, lang="en"))
        if len(page.encode()) <= LARGEST:
            break
    return page


def read(name: str) -> str:
    """The text of a style or a script that stands beside this module."""
    return (files("allworlds.reports.web") / name).read_text(encoding="utf-8")


def _hash(text: str) -> str:
    return f"'sha256-{b64encode(sha256(text.encode()).digest()).decode()}'"


KEYS = (
    "Left and right arrow, Home and End step along the walk, the space bar plays it, "
    "plus and minus zoom."
)


def viewer(
    figures: Sequence[ET.Element], steps: ET.Element, title: str, *about: ET.Element
) -> ET.Element:
    """Pictures with the walk along which keys step in all of them.

    What is said about them stands before the pictures, and on a phone behind them.
    """
    return tag(
        "div",
        *about,
        tag("div", class_="tabs", role="group", aria_label="Picture", hidden="hidden"),
        tag("div", *figures, class_="pictures"),
        ET.fromstring(read("controls.html")),  # noqa: S314  # our own file
        tag("p", KEYS, class_="keys", hidden="hidden"),
        steps,
        class_="viewer",
        role="group",
        tabindex="0",
        aria_label=f"{title} {KEYS}",
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
    walks, genus = bool(follows) and moves, scene.map.genus
    keys = (
        ("turn", "clockwise: the order of darts", True),
        ("robot", "robot, at the dart by which it came", bool(follows)),
        ("walked", "walked", walks),
        ("trail", "walked just before", walks),
        ("last", "walked just now, with its step", walks),
        ("marked", "marked", bool(scene.marks)),
        ("pointed", "pointed along", bool(scene.pointed)),
        ("start", "faced at the start", True),
        ("ring", "the first difference", scene.ringed is not None),
    )
    by_script = {"trail", "last"}
    legend = (
        tag("span", said, class_=f"key {key}-key", hidden="hidden" if key in by_script else None)
        for key, said, there in keys
        if there
    )
    frame = tag(
        "div",
        picture(scene, name, title, drawn),
        class_="frame",
        data_follows=follows,
        role="group",
        tabindex="0",
        aria_label=f"{title}, which can be scrolled",
    )
    cut, lettered = scene.cut_names(SHORT), (drawn or laid_out(scene)).letters
    known = "edges go on at the same letter" if lettered else "edges that cross do not meet"
    about = f", genus {genus}" + (f"; {known}" if genus else "")
    return tag(
        "figure",
        tag("figcaption", tag("b", title), about),
        frame,
        *([tag("p", f"{'; '.join(cut)}.", class_="legend")] if cut else []),
        tag("p", *legend, class_="legend"),
        data_title=title,
    )
