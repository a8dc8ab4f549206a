"""The text of ``search``: the two worlds drawn, and why no motion tells them apart."""

from __future__ import annotations

from allworlds.drawing import draw, scene_of
from allworlds.reports.layout import entry, table
from allworlds.smt import SearchResult
from allworlds.words import plural


def search_text(result: SearchResult, width: int) -> str:
    """The answer, the sizes it rests on, and where the certificate is."""
    lines = {"sat": _found, "unsat": _none, "unknown": _undecided}[result.status](result, width)
    rows = [
        [
            searched.sizes.name,
            searched.status,
            f"{searched.seconds:.2f}",
            searched.formula.name,
            "-" if searched.proof is None else searched.proof.name,
        ]
        for searched in result.searched
    ]
    if rows:
        lines += ["", *table(["sizes", "status", "seconds", "formula", "proof"], rows, "llr"), ""]
    lines += entry("files", str(result.directory), width)
    return "\n".join(lines)


def _found(result: SearchResult, width: int) -> list[str]:
    assert result.pair is not None
    assert result.classes is not None
    lines = entry("FOUND", f"{result.question.describes}.", width)
    for name, world, classes in zip("AB", result.pair, result.classes, strict=True):
        size = (
            f"{plural(world.map.edge_count, 'edge')}, "
            f"{plural(world.map.vertex_count, 'vertex', 'vertices')}, genus {world.map.genus}"
        )
        lines += ["", f"world {name} ({size}); under each dart its class", ""]
        scene = scene_of(world, labels=[f"c{k}" for k in classes])
        lines.append(draw(scene, width))
    home = result.classes[0][result.pair[0].start]
    why = (
        f"the two starts are in class c{home}, sigma and alpha take every class to one class, and "
        "the darts of a class sense the same: so whatever the motions, both robots stand at darts "
        "of one class. No start makes the two worlds the same."
    )
    lines += ["", *entry("why", why, width)]
    if result.certificate is not None:
        lines += entry("pair", str(result.certificate), width)
    return lines


def _none(result: SearchResult, width: int) -> list[str]:
    if result.vacuous:
        return entry("VACUOUS", f"{result.question.describes}: there is no world at all.", width)
    lines = entry("NONE", f"{result.question.describes}: there are none.", width)
    if result.certificate is None:
        return lines + entry("proof", "no certificate for all sizes; the notices say why", width)
    text = (
        f"{result.certificate}: a formula and an LRAT proof for all sizes, each proof checked "
        "by a program that is no solver"
    )
    return lines + entry("proof", text, width)


def _undecided(result: SearchResult, width: int) -> list[str]:
    return entry("UNKNOWN", f"{result.question.describes}: undecided.", width)
