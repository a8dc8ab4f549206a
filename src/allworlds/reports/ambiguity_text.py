"""The texts of ``twins`` and ``ambiguity``: the worlds drawn, and why they look alike."""

from __future__ import annotations

from collections.abc import Sequence
from textwrap import wrap

from allworlds.document import UNSET
from allworlds.maps import Quotient
from allworlds.reports.check_words import counted
from allworlds.reports.drawing.scene import scene_of
from allworlds.reports.drawing.text import draw
from allworlds.reports.text_layout import entry, interruption, table
from allworlds.studies.ambiguity import (
    AmbiguityCensus,
    AmbiguityClass,
    CensusRow,
    ComparedWorlds,
    projection_of,
)
from allworlds.words import number, plural
from allworlds.world import World

DRAWN = 4
"""Of a larger class so many worlds are drawn."""


def twins_text(comparison: ComparedWorlds, width: int) -> str:
    """The verdict, both worlds, and the quotient they share or the walk that separates them."""
    if comparison.distinguishable:
        return "\n".join(_told_apart(comparison, width))
    projections = [projection_of(world) for world in comparison.worlds]
    lines = entry(*twins_words(comparison), width)
    for name, world, (_, classes) in zip("AB", comparison.worlds, projections, strict=True):
        lines += ["", f"world {name}; under each dart its class", ""]
        lines += [_drawing(world, classes, width)]
    return "\n".join([*lines, "", *_quotient(projections[0].quotient, width)])


def twins_words(comparison: ComparedWorlds) -> tuple[str, str]:
    """The verdict, and why."""
    if comparison.motions is not UNSET:
        motions = ", ".join(map(str, comparison.motions)) or "none: the first percepts differ"
        count = plural(len(comparison.motions), "motion")
        return "TOLD APART", f"by {count}, and by no fewer: {motions}"
    word, what = {
        "same": ("SAME", "the two are one world, start included; "),
        "same-map": ("ALIKE", "one world, entered at two darts that look alike; "),
        "different": ("TWINS", "two different worlds; "),
    }[comparison.relation]
    return word, what + _why_alike([projection_of(world).quotient for world in comparison.worlds])


def class_text(found: AmbiguityClass, width: int) -> str:
    """The size of the class, some of its worlds, and the quotient they share."""
    lines = entry(*class_words(found), width)
    lines += entry(
        "poses", f"{number(found.poses)} (a world, and a dart where the robot is)", width
    )
    for i, world in enumerate(found.worlds[:DRAWN]):
        name = "the given world" if i == 0 else f"world {i + 1}"
        genus = f"genus {world.map.genus}; under each dart its class"
        lines += ["", f"{name}: {genus}", ""]
        lines += [_drawing(world, projection_of(world).classes, width)]
    if len(found.worlds) > DRAWN:
        lines += ["", f"and {number(len(found.worlds) - DRAWN)} more: see --json"]
    if found.notice:
        lines += ["", *entry("notice", found.notice, width)]
    return "\n".join([*lines, "", *_quotient(projection_of(found.world).quotient, width)])


def class_words(found: AmbiguityClass) -> tuple[str, str]:
    """The verdict, and why."""
    universe = f"in the class {found.map_class}"
    if found.size == 1:
        return "ALONE", f"no other world {universe} has its quotient: a robot can map it"
    text = f"{plural(found.size, 'world')} {universe}; " + _why_alike(
        [projection_of(found.world).quotient]
    )
    return "AMBIGUOUS", text


def census_text(census: AmbiguityCensus, width: int) -> str:
    """A line for each number of edges, and what the counts were compared with."""
    header = ["edges", "marked worlds", "ambiguous", "classes", "largest class"]
    rows = [
        [
            str(row.edges),
            number(row.marked_worlds),
            *_of_classes(row),
        ]
        for row in census.rows
    ]
    lines = table(header, rows, "rrrrr", width)
    text = (
        "maps with one marked vertex, up to isomorphism; ambiguous are those from which no "
        f"motion tells another world of the class {census.map_class}"
    )
    lines += ["", *interruption(complete=census.complete, width=width)]
    lines += entry("scope", text, width)
    if not census.whole:
        text = (
            f"of the shard {census.shard} alone, which may hold some members of a class and not "
            "others: classes and counts are told by the merge of all shards"
        )
        return "\n".join([*lines, *entry("shard", text, width)])
    if census.gate.agrees:
        text = f"no rooted map was forgotten: {counted(census.source)}"
        return "\n".join([*lines, *entry("gate", text, width)])
    for row in census.rows:
        if row.rooted != row.counted:
            text = (
                f"with {plural(row.edges, 'edge')} {plural(row.rooted, 'rooted map')} "
                f"{'was' if row.rooted == 1 else 'were'} met, but {census.source} counts "
                f"{row.counted}"
            )
            lines += entry("MISMATCH", text, width)
    return "\n".join(lines)


def _of_classes(row: CensusRow) -> list[str]:
    told = (row.ambiguous_worlds, row.classes, row.largest_class or None)
    return ["-" if count is None else number(count) for count in told]


def _told_apart(comparison: ComparedWorlds, width: int) -> list[str]:
    lines = entry(*twins_words(comparison), width)
    for name, world in zip("AB", comparison.worlds, strict=True):
        lines += ["", f"world {name}", "", draw(scene_of(world), width)]
    motions, percepts = comparison.motions or (), comparison.percepts or ()
    rows = [
        [str(i), str(motion), str(p), "=" if p == q else "≠", str(q)]
        for i, (motion, p, q) in enumerate(zip(("start", *motions), *percepts, strict=True))
    ]
    header = ["step", "motion", "sensed in A", "", "sensed in B"]
    return [*lines, "", *table(header, rows, "rr", width, keys=2)]


def _why_alike(quotients: Sequence[Quotient]) -> str:
    """The one sentence; ``quotients`` differ at most in their sheets."""
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


def _drawing(world: World, classes: Sequence[int], width: int) -> str:
    """The world; under each dart its class."""
    return draw(scene_of(world, labels=[str(q) for q in classes]), width)


def _quotient(quotient: Quotient, width: int) -> list[str]:
    header, rows = quotient_table(quotient)
    said = "the quotient (a→b: alpha takes class a to b; a↺: to itself, a semi-edge)"
    return [*wrap(said, width), "", *table(header, rows, "llr", width)]


def quotient_table(quotient: Quotient) -> tuple[list[str], list[list[str]]]:
    """A row a vertex: its classes clockwise with where alpha leads, and what lies over it."""
    rows = []
    for vertex, cone in zip(quotient.vertices, quotient.cone_indices, strict=True):
        around = " ".join(
            f"{q}→{quotient.alpha[q]}" if quotient.alpha[q] != q else f"{q}↺" for q in vertex
        )
        rows.append([around, str(quotient.labels[vertex[0]]), str(cone)])
    return ["classes clockwise", "sensed there", "times round"], rows
