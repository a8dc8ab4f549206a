"""The text of ``search``: the two worlds drawn, and why no motion tells them apart."""

from __future__ import annotations

from allworlds.reports.drawing.scene import scene_of
from allworlds.reports.drawing.text import draw
from allworlds.reports.text_layout import entry, table
from allworlds.studies.ambiguity import SearchResult
from allworlds.words import plural


def search_text(result: SearchResult, width: int) -> str:
    """The answer, the sizes it rests on, and where the certificate is."""
    first, *others = search_words(result)
    lines = entry(*first, width) + _drawn(result, width)
    for name, text in others:
        lines += entry(name, text, width)
    header, rows = search_table(result)
    if rows:
        lines += ["", *table(header, rows, "llr", width), ""]
    lines += entry("files", str(result.directory), width)
    return "\n".join(lines)


def search_table(result: SearchResult) -> tuple[list[str], list[list[str]]]:
    """The header and the rows of what was decided."""
    rows = [
        [
            searched.sizes.name,
            searched.status,
            f"{searched.seconds:.2f}",
            searched.formula.name,
            "-" if searched.proof is None else searched.proof.name,
        ]
        for searched in result.levels
    ]
    return ["sizes", "status", "seconds", "formula", "proof"], rows


def search_words(result: SearchResult) -> list[tuple[str, str]]:
    """The answer, and what it rests on, as names and texts."""
    asked = result.question.describes
    if result.status == "unknown":
        return [("UNKNOWN", f"{asked}: undecided.")]
    if result.vacuous:
        return [("VACUOUS", f"{asked}: there is no world at all.")]
    if result.status == "sat":
        pair = [] if result.certificate is None else [("pair", str(result.certificate))]
        return [("FOUND", f"{asked}."), ("why", _why(result)), *pair]
    proof = "no certificate for all sizes; the notices say why"
    if result.certificate is not None:
        proof = (
            f"{result.certificate}: a formula and an LRAT proof for all sizes, each proof checked "
            "by a program that is no solver"
        )
    return [("NONE", f"{asked}: there are none."), ("proof", proof)]


def _why(result: SearchResult) -> str:
    assert result.pair is not None
    assert result.bisimulation is not None
    home = result.bisimulation[0][result.pair[0].start]
    return (
        f"the two starts are in class c{home}, sigma and alpha take every class to one class, and "
        "the darts of a class sense the same: so whatever the motions, both robots stand at darts "
        "of one class. No start makes the two worlds the same."
    )


def _drawn(result: SearchResult, width: int) -> list[str]:
    """The two worlds, if there are."""
    lines: list[str] = []
    if result.pair is None or result.bisimulation is None:
        return lines
    for name, world, classes in zip("AB", result.pair, result.bisimulation, strict=True):
        size = (
            f"{plural(world.map.edge_count, 'edge')}, "
            f"{plural(world.map.vertex_count, 'vertex', 'vertices')}, genus {world.map.genus}"
        )
        lines += ["", f"world {name} ({size}); under each dart its class", ""]
        scene = scene_of(world, labels=[f"c{k}" for k in classes])
        lines.append(draw(scene, width))
    return [*lines, ""]
