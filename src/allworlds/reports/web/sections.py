"""The sections of a page."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import groupby
from xml.etree import ElementTree as ET

from allworlds.document.struct import replace
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol.actions import Move
from allworlds.reports.drawing.alike import extended, layout_like, mirror_of, names_like
from allworlds.reports.drawing.layout import Layout, layout
from allworlds.reports.plain_text import cost_picture
from allworlds.reports.rendering import record, tag
from allworlds.reports.telling import (
    Block,
    Costs,
    Curve,
    Quote,
    Section,
    ShownMap,
    SizeCost,
    ToldFacts,
    ToldPicture,
    ToldRecord,
    ToldTable,
    ToldWalk,
    View,
    Words,
)
from allworlds.reports.web.viewer import figure, viewer
from allworlds.words import number, plural, size


def drawn_beside(
    first: View, other: View, drawn: Layout, agreement: int
) -> tuple[View, View, Layout]:
    """Both views with their first difference ringed, the other in the numbers of the first.

    Args:
        first: what is to be seen in one map, and the trail there.
        other: the same of the other one.
        drawn: how the first is laid out.
        agreement: the number of steps, the start included, in which both go along alike.
    """
    world, answer = first.scene, other.scene
    ties: dict[Dart, Dart] = {}
    for robot, belief in zip(first.trail[:agreement], other.trail[:agreement], strict=True):
        for k in range(world.map.degree_at[robot]):
            ties[answer.map.turn(belief, k)] = world.map.turn(robot, k)
    ties = mirror_of(answer.map, world.map) or extended(ties, answer.map, world.map)
    beside = layout_like(ties, answer.map, answer.start, world.map, drawn)
    if agreement < len(first.trail):
        world = replace(world, ringed=first.trail[agreement])
        answer = replace(answer, ringed=other.trail[agreement])
    answer = replace(answer, names=names_like(ties, answer.map, world.map))
    return replace(first, scene=world), replace(other, scene=answer), beside


NEVER = 10**9
"""Stands for the step at which something is known that never is."""


def let_grow(drawn: ET.Element, map_: CombinatorialMap, seen: ShownMap) -> None:
    """Add to a figure the step at which each part appears, and a legend of the styles."""
    for part in drawn.iter():
        if (darts := part.get("data-darts")) is not None:
            part.set("data-since", str(seen.edges.get(int(darts.split()[0]), NEVER)))
        elif (vertex := part.get("data-vertex")) is not None:
            first = map_.vertices[int(vertex)][0]
            part.set("data-since", str(seen.darts.get(first, NEVER)))
        elif (stub := part.get("data-stub")) is not None:
            explored = seen.edges.get(int(stub))
            part.set("class", "stub open" if explored is None else "stub open gone")
            part.set("data-since", str(seen.darts.get(int(stub), NEVER)))
            part.set("data-until", str(NEVER if explored is None else explored))
    legend = drawn[-1]
    legend.append(tag("span", "open: not explored yet", class_="key known-key"))


COLUMN, BAR, HEIGHT, LEFT, TOP, FOOT = 30, 18, 180, 56, 24, 52
"""In pixels: from column to column, the width of a bar, and the room that the bars have."""


def plot(cells: Sequence[SizeCost], name: str) -> ET.Element:
    """The largest cost of each size as a bar, and its bound as a line above; ``name`` is its id."""
    top = max((max(cell.cost, cell.bound or 0) for cell in cells), default=0) or 1
    width = LEFT + COLUMN * len(cells) + 8

    def y(value: float) -> str:
        return f"{TOP + HEIGHT * (1 - value / top):.1f}"

    parts: list[ET.Element] = []
    for value in _ticks(top):
        parts.append(tag("path", class_="grid", d=f"M{LEFT - 4} {y(value)} H{width}"))
        parts.append(tag("text", number(value), class_="tick", x=LEFT - 8, y=y(value)))
    for i, cell in enumerate(cells):
        parts += _column(cell, LEFT + COLUMN * i + COLUMN // 2, y)
    at = LEFT
    for edges, group in groupby(cells, key=lambda cell: cell.edges):
        wide = COLUMN * len([*group])
        middle = at + wide // 2
        parts.append(tag("path", class_="brace", d=f"M{at + 4} {TOP + HEIGHT + 24} h{wide - 8}"))
        parts.append(tag("text", str(edges), x=middle, y=TOP + HEIGHT + 38))
        at += wide
    parts.append(tag("text", "vertices", class_="axis", x=LEFT - 6, y=TOP + HEIGHT + 14))
    parts.append(tag("text", "edges", class_="axis", x=LEFT - 6, y=TOP + HEIGHT + 38))
    return tag(
        "svg",
        tag("title", "The largest cost of each size against its bound", id=f"{name}-title"),
        tag("desc", " ".join(map(_in_words, cells)), id=f"{name}-desc"),
        *parts,
        id=name,
        class_="plot",
        role="img",
        aria_labelledby=f"{name}-title {name}-desc",
        viewBox=f"0 0 {width} {TOP + HEIGHT + FOOT}",
        width=width,
        height=TOP + HEIGHT + FOOT,
        xmlns="http://www.w3.org/2000/svg",
    )


def _column(cell: SizeCost, middle: int, y: Callable[[float], str]) -> list[ET.Element]:
    left, foot = middle - BAR // 2, TOP + HEIGHT
    parts = [
        tag("path", class_="cost", d=f"M{left} {foot} V{y(cell.cost)} h{BAR} V{foot} Z"),
        tag("text", str(cell.vertices), x=middle, y=foot + 14),
    ]
    if cell.bound is not None:
        parts.append(tag("path", class_="bound", d=f"M{left - 4} {y(cell.bound)} h{BAR + 8}"))
    return parts


def _ticks(top: int) -> list[int]:
    """Round numbers from 0 to the top, four or so."""
    step = 1
    while top / step > 5:
        step *= 5 if str(step).startswith("2") or (step == 1 and top > 10) else 2
    return [*range(0, top + 1, step)]


def _in_words(cell: SizeCost) -> str:
    most = "" if cell.bound is None else f" of at most {number(cell.bound)}"
    return f"{size(cell.edges, cell.vertices)}: {plural(cell.cost, 'traversal')}{most}."


LONGEST = 1500
"""The number of steps of a longer walk that are told."""


def steps_of(
    walk: ToldWalk, views: Sequence[View], name: str, follows: Sequence[str]
) -> ET.Element:
    """The list of the first :data:`LONGEST` steps.

    Args:
        walk: which one.
        views: the pictures in which it is followed.
        name: of the walk, with which the names of its steps begin.
        follows: a name for each view, by which its picture finds the robot in a step.
    """
    items = [_step(walk, i, f"{name}-step-{i}") for i in range(len(walk.walked.walked[:LONGEST]))]
    for followed, view in zip(follows, views, strict=True):
        for item, dart in zip(items, view.trail, strict=False):
            item.set(f"data-{followed}", str(dart))
    return tag(
        "ol",
        *items,
        class_="walk compared" if walk.elsewhere else "walk",
        start="0",
        role="list",
        aria_label="The walk, step by step",
    )


def _step(walk: ToldWalk, i: int, name: str) -> ET.Element:
    walked, parts = walk.walked, i == walk.parting
    action = walked.transcript.steps[i - 1][0] if i else None
    item = tag(
        "li",
        tag("a", str(i), href=f"#{name}", class_="step", aria_label=f"step {i}"),
        tag("span", str(action) if action else "start", class_="motion"),
        tag("span", f"at {walked.place(walked.walked[i])}", class_="place"),
        tag("span", f"sensed: {walked.sensed[i]}", class_="sensed"),
        id=name,
        class_="parting" if parts else None,
        data_moved="" if type(action) is Move else None,
    )
    if walk.elsewhere and i < len(walk.elsewhere.percepts):
        other = walk.elsewhere.percepts[i]
        sign, kind = ("=", "fits") if other == walked.sensed[i] else ("≠", "misfits")
        item.append(tag("span", f"{sign} {walk.elsewhere.where}: {other}", class_=kind))
    if parts:
        item.append(tag("b", "belief and truth diverge here", class_="note"))
    return item


ROOM = 700_000
"""The characters of a page for walks that are opened one at a time; if they need more, the first
are left out."""

LONGEST_WORDS = 30
"""A cell with a longer text may be broken into lines."""


def element(section: Section) -> ET.Element:
    """A section with its title."""
    shows = any(isinstance(block, ToldWalk | ToldPicture) for block in section.blocks)
    tells = any(isinstance(block, ToldFacts) for block in section.blocks)
    title = section.title or ("The walk" if shows else "The numbers")
    return tag(
        "section",
        tag("h2", tag("bdi", title), id=f"{section.name}-title"),
        *_parts(section),
        *_runs(section.runs),
        id=section.name,
        class_="finding" if shows else "scope" if tells else None,
        aria_labelledby=f"{section.name}-title",
    )


def _parts(section: Section) -> Iterator[ET.Element]:
    pictures = [block for block in section.blocks if isinstance(block, ToldPicture)]
    for block in section.blocks:
        if not isinstance(block, ToldPicture):
            yield from _block(block, section.name)
        elif block is pictures[0]:
            drawn = [
                figure(picture.title, picture.scene, f"{section.name}-{i}", "")
                for i, picture in enumerate(pictures, 1)
            ]
            yield tag("div", *drawn, class_="pictures")


def _block(block: Block, name: str) -> Iterator[ET.Element]:
    match block:
        case Words():
            yield tag("p", tag("bdi", block.text), class_="story")
        case ToldFacts():
            yield tag("dl", *_facts(block.entries))
        case ToldTable():
            yield from _scrolled(_table(block), block.caption or "Counts") if block.rows else ()
        case ToldWalk():
            yield from _walk(block, name)
        case Costs():
            yield from _scrolled(plot(block.cells, f"{name}-plot"), "Cost against bound")
            keys = [tag("span", "the largest cost", class_="key cost-key")]
            if any(cell.bound is not None for cell in block.cells):
                keys.append(tag("span", "the largest bound", class_="key bound-key"))
            yield tag("p", *keys, class_="legend")
        case Curve():
            yield cost_picture(block.spent, f"{name}-cost")
        case Quote():
            yield from [tag("h3", block.title.capitalize())] if block.title else []
            yield _lines(block.text, f"{name}-{block.name}")
            if block.command:
                yield _copier("Copy the command", f"{name}-{block.name}")
        case ToldRecord():
            summary = tag("summary", "The transcript, as it was recorded")
            yield tag("details", summary, _lines(block.log, f"{name}-transcript"))
            yield _copier(block.title, f"{name}-json")
            yield record(block.document, class_="finding", id=f"{name}-json")


def _facts(entries: Iterable[tuple[str, str]]) -> Iterator[ET.Element]:
    for name, text in entries:
        if name:
            yield tag("dt", name)
        yield tag("dd", tag("bdi", text))


def _scrolled(inner: ET.Element, label: str) -> Iterator[ET.Element]:
    """A wide element inside a box that scrolls."""
    yield tag("div", inner, class_="frame", tabindex="0", role="group", aria_label=label)


def _table(table: ToldTable) -> ET.Element:
    columns = ([row[i] for row in table.texts] for i in range(len(table.header)))
    kinds = [
        None if side == "r" else _kind(cells)
        for side, cells in zip(table.right, columns, strict=True)
    ]
    return tag(
        "table",
        *([tag("caption", table.caption)] if table.caption else []),
        tag("thead", _row("th", table.header, kinds, scope="col")),
        tag("tbody", *(_row("td", row, kinds) for row in table.texts)),
    )


def _row(
    name: str, cells: Sequence[str], kinds: Sequence[str | None], **attributes: str
) -> ET.Element:
    told = zip(cells, kinds, strict=True)
    return tag("tr", *(tag(name, cell, class_=kind, **attributes) for cell, kind in told))


def _kind(cells: Sequence[str]) -> str:
    """The CSS class of a column of texts: of words, or of sentences, which may break."""
    return "sentence" if max(map(len, cells)) > LONGEST_WORDS else "words"


def _lines(text: str, name: str) -> ET.Element:
    return tag("pre", tag("bdi", text, id=name), tabindex="0")


def _copier(label: str, of: str) -> ET.Element:
    return tag("p", tag("button", label, type="button", data_copy=of, hidden="hidden"))


def _walk(walk: ToldWalk, name: str) -> Iterator[ET.Element]:
    """The pictures of a walk, and its steps, along which keys step in all of them."""
    if walk.walked.world.told is not None:
        yield tag("p", f"Told before the start: {walk.walked.world.told}.")
    steps = len(walk.walked.transcript.steps)
    if steps >= LONGEST:
        yield tag("p", f"The first {number(LONGEST - 1)} of {number(steps)} steps are told.")
    follows = ["robot", *(view.name for view in _views(walk)[1:])]
    said = tag(
        "p", *(part for s in walk.sentences for part in (tag("bdi", s), " ")), class_="story"
    )
    yield viewer(
        [*_figures(walk, name, follows)],
        steps_of(walk, _views(walk), name, follows),
        f"{walk.title}.",
        *([said] if walk.sentences else []),
    )


def _views(walk: ToldWalk) -> list[View]:
    """The views of a walk that have motion to show."""
    return [view for view in walk.views if not view.still]


def _figures(walk: ToldWalk, name: str, follows: Sequence[str]) -> Iterator[ET.Element]:
    views = _views(walk)
    moves = walk.walked.transcript.cost > 0
    first = layout(views[0].scene.map, views[0].scene.start)
    drawn = {views[0].name: first}
    if walk.agreement is not None and not views[1].known:
        views[0], views[1], beside = drawn_beside(views[0], views[1], first, walk.agreement)
        drawn[views[1].name] = beside
    for view, followed in zip(views, follows, strict=True):
        shown = drawn.get(view.name, first if view.known else None)
        made = figure(view.title, view.scene, f"{name}-{view.name}", followed, shown, moves=moves)
        if view.known:
            let_grow(made, view.scene.map, view.known)
        yield made


def _runs(runs: Sequence[Section]) -> Iterator[ET.Element]:
    """The last of the runs, as many as fit; the very last, the largest, is open."""
    room, kept = ROOM, list[ET.Element]()
    for run in reversed(runs):
        made = _run(run)
        room -= len(ET.tostring(made, "unicode", method="html"))
        if room < 0:
            break
        kept.append(made)
    if kept:
        kept[0].set("open", "open")
    if left := len(runs) - len(kept):
        yield tag("p", f"{plural(left, 'smaller size')} left out to keep the page small.")
    yield from reversed(kept)


def _run(run: Section) -> ET.Element:
    return tag(
        "details",
        tag("summary", tag("h3", run.title, id=f"{run.name}-title")),
        *_parts(replace(run, runs=())),
        class_="run",
        id=run.name,
    )
