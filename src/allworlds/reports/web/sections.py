"""Sections of a telling as elements of a page."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from xml.etree import ElementTree as ET

from allworlds.document import replace
from allworlds.reports.cost_curve import cost_picture
from allworlds.reports.drawing.layout import layout
from allworlds.reports.markup import record, tag
from allworlds.reports.telling import (
    Block,
    Costs,
    Curve,
    Quote,
    Section,
    ToldFacts,
    ToldPicture,
    ToldRecord,
    ToldTable,
    ToldWalk,
    View,
    Words,
)
from allworlds.reports.web.beside import drawn_beside
from allworlds.reports.web.cost_plot import plot
from allworlds.reports.web.known import let_grow
from allworlds.reports.web.viewer import figure, viewer
from allworlds.reports.web.walk import LONGEST, steps_of
from allworlds.words import number, plural

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
            let_grow(made, view.scene.map, view.known, tested=bool(walk.tests))
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
