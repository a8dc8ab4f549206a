"""The telling of worlds that look alike, with the tours that show it."""

from __future__ import annotations

from collections.abc import Sequence
from string import ascii_lowercase

from msgspec import UNSET

from allworlds.judging.explanations.story import Walked
from allworlds.judging.findings.walks import true_trail
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.maps.quotient import Quotient
from allworlds.protocol.actions import Move
from allworlds.protocol.transcript import Transcript
from allworlds.reports.drawing.scene import Scene, scene_of
from allworlds.reports.rows import CsvRows
from allworlds.reports.telling import (
    Block,
    Cell,
    Elsewhere,
    Headline,
    Section,
    ToldResult,
    ToldTable,
    ToldWalk,
    View,
    Words,
    fact,
)
from allworlds.studies.ambiguity.members import AmbiguityClass, projection_of
from allworlds.studies.ambiguity.telling_apart import ComparedWorlds
from allworlds.words import number, plural
from allworlds.world.world import World


def walk_along(world: World, motions: Sequence[int]) -> Transcript:
    """The log of these motions from the start."""
    state, steps = world.initial, []
    for k in motions:
        state, percept = world.step(state, Move(k))
        steps.append((Move(k), percept))
    return Transcript(world.first, tuple(steps))


def tour(worlds: Sequence[World]) -> Transcript:
    """A walk in the first of these worlds that goes along every edge of each of them.

    No motion must tell the worlds apart.  It takes the nearest edge that is new in the world at
    hand, among equals the first clockwise, and goes on in the next world where none is left.

    Cost: the edges of all worlds, times the darts of one.
    """
    motions: list[int] = []
    for world in worlds:
        map_, dart, left = world.map, world.start, set(world.map.darts)
        for k in motions:
            dart = _along(map_, dart, k)
            left -= {dart, map_.alpha[dart]}
        while left:
            for k in _nearest(map_, dart, left):
                dart = _along(map_, dart, k)
                left -= {dart, map_.alpha[dart]}
                motions.append(k)
    return walk_along(worlds[0], motions)


def _along(map_: CombinatorialMap, dart: Dart, k: int) -> Dart:
    return map_.alpha[map_.turn(dart, k)]


def _nearest(map_: CombinatorialMap, start: Dart, left: set[Dart]) -> list[int]:
    """The shortest motions that end with one of these darts."""
    ways: dict[Dart, list[int]] = {start: []}
    queue = [start]
    for dart in queue:
        for k in range(map_.degree_at[dart]):
            reached = _along(map_, dart, k)
            if reached in left:
                return [*ways[dart], k]
            if reached not in ways:
                ways[reached] = [*ways[dart], k]
                queue.append(reached)
    raise AssertionError("the map is connected")


DRAWN = 6
"""The number of worlds of a larger class that are drawn."""

ALIKE = (
    "Darts of one letter are not to be told apart: the same is sensed at each, and every motion "
    "leads from them to darts that are of one letter again."
)
TOURED = (
    "So this walk, which goes along every edge of each world, senses the same in all of them, as "
    "any other does."
)


def twins_telling(comparison: ComparedWorlds) -> ToldResult:
    """The walk that tells two worlds apart, or the quotient that they share."""
    worlds = comparison.worlds
    blocks: list[Block]
    if comparison.bisimulation is UNSET:
        title, blocks = "The shortest walk that tells them apart", [_apart(comparison)]
    else:
        title = "Darts of one letter look alike"
        quotient = _quotient(projection_of(worlds[0]).quotient)
        blocks = [alike("AB", worlds, comparison.bisimulation), *quotient]
    return ToldResult(
        "allworlds ambiguity twins",
        "A and B",
        comparison,
        _told(comparison),
        [Section("walk-1", title, blocks)],
        rows=None
        if comparison.bisimulation is UNSET
        else lambda: _rows(worlds, comparison.bisimulation or ()),
    )


def _rows(worlds: Sequence[World], classes: Sequence[Sequence[int]]) -> CsvRows:
    """A row for each dart of each world: darts of one class are not to be told apart."""
    rows = [
        [number, dart, world.map.vertex_of[dart], of_world[dart]]
        for number, (world, of_world) in enumerate(zip(worlds, classes, strict=True), 1)
        for dart in world.map.darts
    ]
    return CsvRows({"world": int, "dart": int, "vertex": int, "class": int}, rows)


def _told(comparison: ComparedWorlds) -> Headline:
    if comparison.motions is not UNSET:
        if comparison.told is not UNSET:
            one, other = comparison.told
            said = f"by 0 motions: before the start {one} is told in A, and {other} in B"
            return Headline("TOLD APART", said, "holds")
        motions = ", ".join(map(str, comparison.motions)) or "none: the first percepts differ"
        count = plural(len(comparison.motions), "motion")
        return Headline("TOLD APART", f"by {count}, and by no fewer: {motions}", "holds")
    word, what = {
        "same": ("SAME", "the two are one world, start included; "),
        "same-map": ("ALIKE", "one world, entered at two darts that look alike; "),
        "different": ("TWINS", "two different worlds; "),
    }[comparison.relation]
    why = _why_alike([projection_of(world).quotient for world in comparison.worlds])
    return Headline(word, what + why, "vacuous")


def class_telling(found: AmbiguityClass) -> ToldResult:
    """The size of the class, some of its worlds, and the quotient they share."""
    worlds = found.worlds[:DRAWN]
    names = ["The given world", *(f"World {i}" for i in range(2, len(worlds) + 1))]
    classes = [projection_of(world).classes for world in worlds]
    quotient = _quotient(projection_of(found.world).quotient)
    blocks: list[Block] = [alike(names, worlds, classes)]
    if len(found.worlds) > DRAWN:
        left = number(len(found.worlds) - DRAWN)
        blocks.append(Words(f"{left} more worlds: --json lists them."))
    if found.notice:
        blocks.append(Words(f"{found.notice}."))
    poses = f"{number(found.poses)} (a world, and a dart where the robot is)"
    return ToldResult(
        "allworlds ambiguity class",
        "one world",
        found,
        _size(found),
        [Section("walk-1", "Worlds that look alike", [*blocks, fact("poses", poses), *quotient])],
        rows=lambda: _rows(found.worlds, [projection_of(world).classes for world in found.worlds]),
    )


def _size(found: AmbiguityClass) -> Headline:
    universe = f"in the class {found.map_class}"
    if found.size == 1:
        text = f"no other world {universe} has its quotient: a robot can map it"
        return Headline("ALONE", text, "holds")
    why = _why_alike([projection_of(found.world).quotient])
    text = f"{plural(found.size, 'world')} {universe}; {why}"
    return Headline("AMBIGUOUS", text, "vacuous")


def alike(
    names: Sequence[str], worlds: Sequence[World], classes: Sequence[Sequence[int]]
) -> ToldWalk:
    """Worlds that no motion tells apart, with a walk along every edge of each."""
    scenes = [
        scene_of(world, labels=[letters(q) for q in of_world])
        for world, of_world in zip(worlds, classes, strict=True)
    ]
    sentences = [ALIKE, TOURED] if len(worlds) > 1 else ["The walk goes along every edge."]
    return _walk(names, worlds, scenes, tour(worlds), sentences)


def _apart(comparison: ComparedWorlds) -> ToldWalk:
    worlds = comparison.worlds
    scenes = [scene_of(world) for world in worlds]
    transcript = walk_along(worlds[0], comparison.motions or ())
    sentence = "The last percepts of this walk differ."
    if comparison.told is not UNSET:
        sentence = "The robot knows which world it is in before it moves."
    return _walk("AB", worlds, scenes, transcript, [sentence])


def _walk(
    names: Sequence[str],
    worlds: Sequence[World],
    scenes: Sequence[Scene],
    transcript: Transcript,
    sentences: Sequence[str],
) -> ToldWalk:
    """One walk in each of the worlds."""
    motions = [action.k for action in transcript.actions if type(action) is Move]
    logs = [walk_along(world, motions) for world in worlds]
    views = [
        View(
            letters(i),
            f"World {name}" if len(name) == 1 else name,
            scene,
            true_trail(world, log),
            f"genus {world.map.genus}",
        )
        for i, (name, world, scene, log) in enumerate(zip(names, worlds, scenes, logs, strict=True))
    ]
    apart = [log.percepts for log in logs if log.percepts != transcript.percepts]
    elsewhere = Elsewhere("sensed in B", apart[0]) if apart else None
    walked = Walked(worlds[0], transcript)
    return ToldWalk("One walk", walked, views, sentences, elsewhere, tour=not apart)


def _why_alike(quotients: Sequence[Quotient]) -> str:
    """The sentence that gives the reason.

    The ``quotients`` differ only in their sheets, if at all.
    """
    sheets = [quotient.sheets for quotient in quotients]
    if len(sheets) == 1:
        who = f"all are covers, with {plural(sheets[0], 'sheet')},"
    elif sheets[0] == sheets[1]:
        who = f"both are covers, with {plural(sheets[0], 'sheet')},"
    else:
        who = f"A is a cover with {plural(sheets[0], 'sheet')}, B one with {sheets[1]},"
    size = plural(len(quotients[0].sigma), "class", "classes")
    return (
        f"{who} of one quotient of {size} of darts, and as darts of one class sense the same and "
        "lead to darts of one class, no motion tells the worlds apart"
    )


def _quotient(quotient: Quotient) -> tuple[Words, ToldTable]:
    """A row a vertex: its classes clockwise with where alpha leads, and what lies over it."""
    rows: list[list[Cell]] = []
    for vertex, cone in zip(quotient.vertices, quotient.cone_indices, strict=True):
        around = " ".join(
            f"{letters(q)}→{letters(quotient.alpha[q])}"
            if quotient.alpha[q] != q
            else f"{letters(q)}↺"
            for q in vertex
        )
        rows.append([around, str(quotient.labels[vertex[0]]), cone])
    header = ["classes clockwise", "sensed there", "times round"]
    said = "The quotient (a→b: alpha takes class a to class b; a↺: to itself, a semi-edge)."
    return Words(said), ToldTable(header, rows)


def letters(number: int) -> str:
    """``a`` to ``z``, then ``aa``, ``ab``, and so on."""
    rest, last = divmod(number, len(ascii_lowercase))
    return (letters(rest - 1) if rest else "") + ascii_lowercase[last]
