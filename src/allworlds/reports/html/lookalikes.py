"""Pages of worlds that look alike: corresponding darts in one colour, one walk in all of them."""

from __future__ import annotations

from collections.abc import Sequence
from string import ascii_lowercase
from xml.etree import ElementTree as ET

from allworlds.document import UNSET
from allworlds.judging import Walked, true_trail
from allworlds.protocol import Move, Transcript
from allworlds.reports.ambiguity_text import class_words, twins_words
from allworlds.reports.drawing.scene import Scene, scene_of
from allworlds.reports.html.frame import Page, counts
from allworlds.reports.html.viewer import figure, viewer
from allworlds.reports.html.walk import walk
from allworlds.reports.markup import tag
from allworlds.reports.search_text import search_table, search_words
from allworlds.reports.tours import tour, walk_along
from allworlds.studies.ambiguity import (
    AmbiguityClass,
    ComparedWorlds,
    SearchResult,
    projection_of,
)
from allworlds.words import number
from allworlds.world import World

DRAWN = 6
"""Of a larger class so many worlds are drawn."""


def twins_page(comparison: ComparedWorlds) -> Page:
    """Both worlds, and the walk that tells them apart or a walk along all their edges."""
    word, text = twins_words(comparison)
    section = (
        _told_apart(comparison.worlds, comparison.motions or ())
        if comparison.bisimulation is UNSET
        else _twins(comparison.worlds, comparison.bisimulation)
    )
    return Page(
        "allworlds ambiguity twins",
        "A and B",
        (word, text, "holds" if comparison.distinguishable else "vacuous"),
        [section],
        comparison.to_json(),
    )


def class_page(found: AmbiguityClass) -> Page:
    """Some worlds of the class, and what they have in common."""
    word, text = class_words(found)
    worlds = found.worlds[:DRAWN]
    names = ["The given world", *(f"World {i}" for i in range(2, len(worlds) + 1))]
    sections = [_alike(names, worlds, [projection_of(world).classes for world in worlds])]
    left = len(found.worlds) - len(worlds)
    if left:
        sections.append(tag("p", f"And {number(left)} more worlds: --json lists them."))
    document = {**found.to_json(), "worlds": [world.to_json() for world in worlds]}
    verdict = (word, text, "holds" if found.size == 1 else "vacuous")
    return Page("allworlds ambiguity class", "one world", verdict, sections, document)


def search_page(result: SearchResult) -> Page:
    """The twins that were found, if any, and where they were looked for."""
    (word, text), *words = search_words(result)
    entries = [p for name, said in words for p in (tag("dt", name), tag("dd", tag("bdi", said)))]
    searched = tag(
        "section",
        tag("h2", "What was searched", id="seen"),
        tag("dl", *entries),
        *counts(*search_table(result), "Sizes, as they were decided"),
        aria_labelledby="seen",
        class_="scope",
    )
    pair = [_twins(result.pair, result.bisimulation)] if result.pair and result.bisimulation else []
    subject = f"{result.lighthouse} lighthouse, class {result.map_class.value}"
    verdict = (word, text, "holds" if word == "NONE" else "vacuous")
    return Page("allworlds ambiguity search", subject, verdict, [*pair, searched], result.to_json())


def _twins(worlds: Sequence[World], classes: Sequence[Sequence[int]]) -> ET.Element:
    return _alike([f"World {name}" for name in "AB"], worlds, classes)


def _alike(
    names: Sequence[str], worlds: Sequence[World], classes: Sequence[Sequence[int]]
) -> ET.Element:
    """Worlds that no motion tells apart, with a walk along every edge of each."""
    scenes = [
        scene_of(world, robot=world.start, labels=[letters(q) for q in of_world])
        for world, of_world in zip(worlds, classes, strict=True)
    ]
    about = "The walk goes along every edge."
    if len(worlds) > 1:
        about = (
            "Darts of one colour and letter are not to be told apart: the same is sensed at each, "
            "and every motion leads from them to darts that are of one letter again. So this walk, "
            "which goes along every edge of each world, senses the same in all of them, as any "
            "other does."
        )
    return _section(about, [*zip(names, scenes, strict=True)], worlds, tour(worlds))


def _told_apart(worlds: Sequence[World], motions: Sequence[int]) -> ET.Element:
    scenes = [(f"World {n}", scene_of(w, robot=w.start)) for n, w in zip("AB", worlds, strict=True)]
    about = "This is the shortest walk that tells them apart: its last percepts differ."
    return _section(about, scenes, worlds, walk_along(worlds[0], motions))


def _section(
    about: str,
    scenes: Sequence[tuple[str, Scene]],
    worlds: Sequence[World],
    transcript: Transcript,
) -> ET.Element:
    """The worlds side by side, and one walk in all of them."""
    follows = ["robot", *(f"in-{i}" for i in range(1, len(worlds)))]
    figures = [
        figure(title, scene, f"world-{i}", followed)
        for i, ((title, scene), followed) in enumerate(zip(scenes, follows, strict=True))
    ]
    first, *others = worlds
    motions = [action.k for action in transcript.actions if type(action) is Move]
    trails, differing = {}, None
    for followed, world in zip(follows[1:], others, strict=True):
        other = walk_along(world, motions)
        trails[followed] = true_trail(world, other)
        if other.percepts != transcript.percepts:
            differing = other.percepts
    steps = walk(Walked(first, transcript), "walk-1", others=trails, instead=differing)
    return tag(
        "section",
        tag("h2", "One walk in each" if others else "A walk", id="walk-1-title"),
        viewer(figures, steps, "One walk.", tag("p", about, class_="story")),
        class_="finding",
        id="walk-1",
        aria_labelledby="walk-1-title",
    )


def letters(number: int) -> str:
    """``a`` to ``z``, then ``aa``, ``ab``, and so on."""
    rest, last = divmod(number, len(ascii_lowercase))
    return (letters(rest - 1) if rest else "") + ascii_lowercase[last]
