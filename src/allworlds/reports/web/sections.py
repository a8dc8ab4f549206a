"""The sections of a page, the frame of every page, and pictures with a walk.

The reader's keys step along a walk, in all pictures of this walk at the same time.
"""

import json
from base64 import b64encode
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict
from hashlib import sha256
from importlib.resources import files
from typing import Any
from xml.etree import ElementTree as ET

from allworlds.judging.explanations.story import Walked
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.protocol.actions import Move, Pick
from allworlds.reports.drawing.layout import Layout, drawn_beside
from allworlds.reports.drawing.plot import plot
from allworlds.reports.drawing.positions import laid_out
from allworlds.reports.drawing.svg import document, picture, raw, record, tag
from allworlds.reports.parts import (
    Block,
    Curve,
    DataRecord,
    FactList,
    MapPictures,
    Paragraph,
    Quote,
    RunRow,
    Scene,
    Section,
    ShownMap,
    ShownRun,
    ShownWalk,
    Table,
    View,
)
from allworlds.version import __version__
from allworlds.words import number
from allworlds.world.lighthouses import composed, kinds
from allworlds.world.world import World

LARGEST = 1_000_000
"""The largest number of bytes of a page; a larger page leaves out its document, and says so."""


def framed(
    title: tuple[str, str],
    verdict: tuple[str, str, str] | None,
    sections: Sequence[ET.Element],
    data: Mapping[str, Any],
    style: str = "",
    script: str = "",
) -> str:
    """A page as an HTML document that refers to no other file.

    It tells the browser the hashes of its style and scripts, so that no other script is ever run.

    Args:
        title: the command and its subject.
        verdict: the verdict as a word, as a sentence, and as the name that decides its colour; None
            without a verdict.
        sections: the elements of the page.
        data: the JSON document of the report. The page holds it, too, unless the page would then be
            larger than :data:`LARGEST`.
        style: a style in addition to that of all pages.
        script: a script in place of the usual script, by which keys step along walks.
    """
    style, script = (
        read("style.css") + style,
        read("fit.js") + (script or read("world.js") + read("script.js")),
    )
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
    for held, embedded in (("holds its data as JSON", whole), (without, [])):
        foot = f"Made by allworlds {__version__}. This page needs no network, and {held}."
        body = tag(
            "body",
            tag("header", *header),
            tag("main", *sections),
            tag("footer", tag("p", foot)),
            *embedded,
            raw("script", script),
        )
        page = document(tag("html", head, body, lang="en"))
        if len(page.encode()) <= LARGEST:
            break
    return page


def read(name: str) -> str:
    """The text of a style or a script in the folder of this module."""
    return (files("allworlds.reports.web") / name).read_text(encoding="utf-8")


def _hash(text: str) -> str:
    return f"'sha256-{b64encode(sha256(text.encode()).digest()).decode()}'"


KEYS = (
    "Left and right arrow, Home and End step along the walk, the space bar plays it, "
    "plus and minus zoom."
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

    Args:
        title: the caption.
        scene: the content of the picture.
        name: the id of the picture's element, unique in the page.
        follows: the word W for the robot in the picture; empty if no robot moves in the picture.
            Each step of the walk has an attribute ``data-W`` with the dart of the robot, and the
            page's script moves the robot to this dart.
        drawn: the layout; by default that of :func:`laid_out`.
        moves: whether the walk has motions, so that the legend explains the signs of walked edges.
    """
    walks, genus = bool(follows) and moves, scene.map.genus
    keys = (
        ("turn", "clockwise: the order of darts", True),
        ("robot", "robot, at the dart by which it came", bool(follows) or scene.robot is not None),
        ("walked", "walked", walks),
        ("trail", "walked just before", walks),
        ("last", "walked just now, with its step", walks),
        ("marked", "marked", bool(scene.marks)),
        ("pointed", "pointed along", bool(scene.pointed)),
        ("start", "faced at the start", scene.start is not None),
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
    lettered = (drawn or laid_out(scene)).letters
    known = "edges go on at the same letter" if lettered else "edges that cross do not meet"
    about = f", genus {genus}" + (f"; {known}" if genus else "")
    return tag(
        "figure",
        tag("figcaption", tag("b", title), about),
        frame,
        tag("p", *legend, class_="legend"),
        data_title=title,
    )


NEVER = 10**9
"""A number larger than every step: the step of a part that never becomes known."""


def let_grow(drawn: ET.Element, map_: CombinatorialMap, seen: ShownMap) -> None:
    """Add to the figure ``drawn`` the step at which each part of its map ``map_`` appears.

    The steps are those of ``seen``.  The legend of the figure gets the sign of an open dart.
    """
    for part in drawn.iter():
        if (darts := part.get("data-darts", part.get("data-cut"))) is not None:
            part.set("data-since", str(seen.edges.get(int(darts.split()[0]), NEVER)))
        elif (vertex := part.get("data-vertex")) is not None:
            first = map_.vertices[int(vertex)][0]
            part.set("data-since", str(seen.darts.get(first, NEVER)))
        elif (stub := part.get("data-stub")) is not None:
            explored = seen.edges.get(int(stub))
            part.set("class", "stub open" if explored is None else "stub open gone")
            part.set("data-since", str(seen.darts.get(int(stub), NEVER)))
            part.set("data-until", str(NEVER if explored is None else explored))
    drawn[-1].append(tag("span", "open: not explored yet", class_="key known-key"))


LONGEST = 1500
"""The largest number of steps of a walk that are shown."""


def _steps(walk: ShownWalk, name: str, views: Mapping[str, View]) -> ET.Element:
    """The list of the first :data:`LONGEST` steps.

    Args:
        walk: the walk.
        name: the beginning of the id of each step's element.
        views: the pictures, by name.  The element of each step has an attribute for each picture:
            its name is ``data-`` and the picture's name, its value the robot's dart in this
            picture.
    """
    items = [
        _step(walk, i, f"{name}-step-{i}") for i in range(len(walk.walked.walk.darts[:LONGEST]))
    ]
    for follows, view in views.items():
        for item, dart in zip(items, view.trail, strict=False):
            item.set(f"data-{follows}", str(dart))
    return tag(
        "ol",
        *items,
        class_="walk compared" if walk.elsewhere else "walk",
        start="0",
        role="list",
        aria_label="The walk, step by step",
    )


def _at(walked: Walked) -> str:
    """The word before the name of the robot's vertex, as in ``at v1``.

    It is empty if the user's file gives names to the vertices, such as ``kitchen``: a name alone
    can be read.
    """
    return "" if walked.world.labels.vertices else "at "


def _step(walk: ShownWalk, i: int, name: str) -> ET.Element:
    walked, parts = walk.walked, i == walk.parting
    action = walked.walk.steps[i - 1][0] if i else None
    line = [tag("small", f" ({source})") for source in ["", *walk.lines][i : i + 1] if source]
    item = tag(
        "li",
        tag("a", str(i), href=f"#{name}", class_="step", aria_label=f"step {i}"),
        tag("span", str(action) if action else "start", class_="motion"),
        tag("span", f"{_at(walked)}{walked.arrival(i)}", class_="place"),
        tag("span", f"sensed: {walked.in_words(walked.sensed[i])}", *line, class_="sensed"),
        id=name,
        class_="parting" if parts else None,
        data_moved="" if type(action) is Move else None,
    )
    if walk.elsewhere and i < len(walk.elsewhere.percepts):
        other = walk.elsewhere.percepts[i]
        sign, kind = ("=", "fits") if other == walked.sensed[i] else ("≠", "misfits")
        item.append(
            tag("span", f"{sign} {walk.elsewhere.where}: {walked.in_words(other)}", class_=kind)
        )
    if parts:
        item.append(tag("b", "belief and truth diverge here", class_="note"))
    return item


LONGEST_WORDS = 30
"""The largest number of characters of a cell that is never broken into lines."""


def element(section: Section) -> ET.Element:
    """A section of a page, with its title."""
    shown = ShownWalk | ShownRun | MapPictures
    shows = any(isinstance(block, shown) for block in section.blocks)
    tells = any(isinstance(block, FactList) for block in section.blocks)
    title = section.title or ("The walk" if shows else "The numbers")
    return tag(
        "section",
        tag("h2", tag("bdi", title), id=f"{section.name}-title"),
        *(part for block in section.blocks for part in _block(block, section.name)),
        id=section.name,
        class_="finding" if shows else "scope" if tells else None,
        aria_labelledby=f"{section.name}-title",
    )


def _block(block: Block, name: str) -> Iterator[ET.Element]:
    match block:
        case Paragraph():
            yield tag("p", tag("bdi", block.text), class_="story")
        case FactList():
            yield tag("dl", *_facts(block.entries))
        case Table():
            if block.rows:  # in a box that scrolls
                said = block.caption or "Counts"
                shown = table_element(block)
                yield tag("div", shown, class_="frame", tabindex="0", role="group", aria_label=said)
        case Curve():
            yield tag("figure", tag("figcaption", tag("b", block.title)), plot(block))
        case MapPictures():
            entries = enumerate(block.entries)
            drawn = (figure(title, scene, f"{name}-{i}", "") for i, (title, scene) in entries)
            yield tag("div", *drawn, class_="pictures")
        case ShownWalk():
            yield from _walk(block, name)
        case ShownRun():
            yield _run(block, name)
        case Quote():
            yield from [tag("h3", block.title.capitalize())] if block.title else []
            yield _lines(block.text, f"{name}-{block.name}")
            if block.command:
                yield _copier("Copy the command", f"{name}-{block.name}")
        case DataRecord():
            yield _copier(block.title, f"{name}-json")
            yield record(block.document, class_="finding", id=f"{name}-json")


def _facts(entries: Iterable[tuple[str, str]]) -> Iterator[ET.Element]:
    for name, text in entries:
        if name:
            yield tag("dt", name)
        yield tag("dd", tag("bdi", text))


def table_element(table: Table) -> ET.Element:
    """A table as an element of a page."""

    def row(name: str, cells: Sequence[str], **attributes: str) -> ET.Element:
        kinds = ["sentence" if len(cell) > LONGEST_WORDS else "words" for cell in cells]
        shown = zip(cells, kinds, table.right, strict=True)
        return tag(
            "tr",
            *(
                tag(name, cell, class_=None if side == "r" else kind, **attributes)
                for cell, kind, side in shown
            ),
        )

    return tag(
        "table",
        *([tag("caption", table.caption)] if table.caption else []),
        tag("thead", row("th", table.header, scope="col")),
        tag("tbody", *(row("td", cells) for cells in table.texts)),
    )


def _lines(text: str, name: str) -> ET.Element:
    return tag("pre", tag("bdi", text, id=name), tabindex="0")


def _copier(label: str, of: str) -> ET.Element:
    return tag("p", tag("button", label, type="button", data_copy=of, hidden="hidden"))


def _walk(walk: ShownWalk, name: str) -> Iterator[ET.Element]:
    """The pictures of a walk, and its steps; keys step along the walk in all pictures.

    ``name`` is the name of the section, with which the ids of the elements begin.
    """
    if walk.walked.world.told is not None:
        yield tag("p", f"Told before the start: {walk.walked.world.told}.")
    steps = len(walk.walked.walk.steps)
    if steps >= LONGEST:
        yield tag("p", f"The first {number(LONGEST - 1)} of {number(steps)} steps are shown.")
    moving = [view for view in walk.views if not view.still]
    views = {view.name if i else "robot": view for i, view in enumerate(moving)}
    walked, data = walk.walked, world_data(walk.walked.world)
    places = [f"{_at(walked)}{walked.spot(dart)}" for dart in walked.map.darts]
    states = [asdict(state) for state in walked.walk.states[:LONGEST]]
    said = [part for sentence in walk.sentences for part in (tag("bdi", sentence), " ")]
    # What is said about the pictures stands before them, and on a phone behind them.
    yield tag(
        "div",
        *([tag("p", *said, class_="story")] if said else []),
        tag("div", class_="tabs", role="group", aria_label="Picture", hidden="hidden"),
        tag("div", *_figures(walk, name, views), class_="pictures"),
        ET.fromstring(read("controls.html")),  # noqa: S314  # our own file
        tag("p", KEYS, class_="keys", hidden="hidden"),
        _steps(walk, name, views),
        *([record({**data, "places": places, "walk": states}, class_="ways")] if data else []),
        class_="viewer",
        role="group",
        tabindex="0",
        aria_label=f"{walk.title}. {KEYS}",
    )


def _run(run: ShownRun, name: str) -> ET.Element:
    """The picture of a run of several robots, and its events.

    The user steps through the events by keys of the keyboard.  ``name`` is the beginning of the ids
    of the elements.
    """
    shown = run.rows[:LONGEST]
    items = [_event(row, i, f"{name}-step-{i}") for i, row in enumerate(shown)]
    label = "The run, event by event"
    picture_of_run = figure(run.title, run.scene, f"{name}-run", "robots")
    return tag(
        "div",
        tag("div", class_="tabs", role="group", aria_label="Picture", hidden="hidden"),
        tag("div", picture_of_run, class_="pictures"),
        ET.fromstring(read("controls.html")),  # noqa: S314  # our own file
        tag("p", KEYS, class_="keys", hidden="hidden"),
        tag("ol", *items, class_="walk", start="0", role="list", aria_label=label),
        class_="viewer",
        role="group",
        tabindex="0",
        aria_label=f"{run.title}. {KEYS}",
    )


def _event(row: RunRow, i: int, name: str) -> ET.Element:
    """An event of a run as an element, with the data that the picture shows after the event.

    These data are the robots' darts, and texts at vertices and edges.  ``i`` is the index of the
    event in the run, 0 for the start; ``name`` is the id of the element.
    """
    item = tag(
        "li",
        tag("a", f"{i}*" if row.repeats else str(i), href=f"#{name}", class_="step"),
        tag("span", row.name or "start", class_="motion"),
        tag("span", row.world, class_="place"),
        tag("span", "; ".join(row.robots), class_="sensed"),
        id=name,
        data_robots=" ".join("-" if dart is None else str(dart) for dart in row.darts),
        data_moved=" ".join(map(str, row.moved)) if row.moved else None,
    )
    for key, words in (("vertices", row.vertices), ("edges", row.edges)):
        if words:
            item.set(f"data-{key}", json.dumps({str(at): said for at, said in words.items()}))
    return item


def world_data(world: World) -> dict[str, Any] | None:
    """The data of a world for the script ``world.js``.

    Return None for a user's lighthouse under which the robot leaves marks: the script cannot make
    these marks.
    """
    map_ = world.map
    marking = next((part for part in kinds.parts_of(world.lighthouse) if part.leaves_marks), None)
    if marking is not None and marking.code is not None:
        return None
    written = marking if isinstance(marking, composed.Whiteboard) else None
    spots = None
    if written:
        spots = [written.place_of_number(map_, dart) for dart in map_.darts]
    elif isinstance(marking, composed.Movable) and marking.distinct:
        spots = list(map_.vertex_of)
    return {
        "sigma": list(map_.sigma),
        "alpha": list(map_.alpha),
        "vertex": list(map_.vertex_of),
        "percepts": [percept.to_json() for percept in world.percepts],
        "start": world.start,
        "labels": world.lighthouse.labels_vertices,
        "hand": world.lighthouse.in_hand,
        "pick": not world.lighthouse.refusal(Pick(), 1, 0),
        "states": written.states if written else 0,
        "spots": spots,
    }


def _figures(walk: ShownWalk, name: str, views: Mapping[str, View]) -> Iterator[ET.Element]:
    (robot, world), *others = views.items()
    first = laid_out(world.scene)
    shown = [(robot, world, first), *((each, view, None) for each, view in others)]
    if walk.agreement is not None and not others[0][1].known:
        world, other, beside = drawn_beside(world, others[0][1], first, walk.agreement)
        shown[:2] = [(robot, world, first), (others[0][0], other, beside)]
    moves = walk.walked.walk.cost > 0
    for follows, view, drawn in shown:
        like = first if view.known else drawn
        made = figure(view.title, view.scene, f"{name}-{view.name}", follows, like, moves=moves)
        if view.known:
            let_grow(made, view.scene.map, view.known)
        yield made
