"""The one slip that makes a right answer a wrong one, where there is one.

``SLIPS`` is **the** table.  Each recogniser undoes its slip and compares what results with the
world, so what it says is true of the answer, whatever has led to it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TypeAlias

from allworlds.explaining.story import Belief
from allworlds.maps.canonical import Mismatch, isomorphism, rooted_isomorphism
from allworlds.maps.combinatorial import CombinatorialMap, Dart, InvalidMap
from allworlds.maps.surgery import contracted, deleted

LARGEST = 40
"""Edges above which slips are not looked for: there are quadratically many, each compared anew."""

Recogniser: TypeAlias = Callable[[Belief], str]
"""The slip as a sentence with the darts of the world; empty if it is another one, or none."""


def tell_slip(belief: Belief) -> list[str]:
    """The first slip of the table that makes all the difference, if one does."""
    if max(belief.answer.map.edge_count, belief.story.map.edge_count) > LARGEST:
        return []
    return [told for told in (recognise(belief) for recognise in SLIPS.values()) if told][:1]


def _mirrored(belief: Belief) -> str:
    """Every rotation is given anticlockwise."""
    answer, world, robot = belief.answer, belief.story.map, belief.story.walked[-1]
    mirrored = answer.map.mirrored()
    if rooted_isomorphism(mirrored, answer.here, world, robot):
        return (
            "The answer is a mirror image: with its rotations read anticlockwise it would be right."
        )
    if isomorphism(mirrored, world) and not isomorphism(answer.map, world):
        return (
            "The answer's map is the mirror image of the world's: its rotations are anticlockwise."
        )
    return ""


def _glued_crosswise(belief: Belief) -> str:
    """Two edges have one end each exchanged."""
    world, robot = belief.story.map, belief.story.walked[-1]
    if isomorphism(belief.answer.map, world):
        return ""
    of_map_alone = ""
    for mended, wrong in _reglued(belief.answer.map):
        names = rooted_isomorphism(mended, belief.answer.here, world, robot)
        if not isinstance(names, Mismatch):
            return _say_crosswise(belief, [(names[a], names[b]) for a, b in wrong])
        if not of_map_alone:
            names = isomorphism(mended, world)
            if not isinstance(names, Mismatch):
                of_map_alone = _say_crosswise(belief, [(names[a], names[b]) for a, b in wrong])
    return of_map_alone


def _reglued(
    map_: CombinatorialMap,
) -> Iterator[tuple[CombinatorialMap, tuple[tuple[Dart, Dart], tuple[Dart, Dart]]]]:
    """The maps with two edges glued otherwise, each with these two edges as they were."""
    for i, (a, b) in enumerate(map_.edges):
        for c, d in map_.edges[i + 1 :]:
            for pairs in (((a, c), (b, d)), ((a, d), (b, c))):
                alpha = [*map_.alpha]
                for x, y in pairs:
                    alpha[x], alpha[y] = y, x
                try:
                    yield CombinatorialMap(map_.sigma, alpha), ((a, b), (c, d))
                except InvalidMap:  # it falls apart
                    continue


def _say_crosswise(belief: Belief, wrong: list[tuple[Dart, Dart]]) -> str:
    world = belief.story.map
    (a, b), (c, d) = wrong
    for x, y in ((a, c), (a, d), (b, c), (b, d)):
        if world.alpha[x] != y and world.vertex_of[x] == world.vertex_of[y]:
            first, second = sorted((x, y))
            return (
                f"One slip makes all the difference: the answer has darts {first} and {second} of "
                f"{belief.story.vertex(x)} exchanged."
            )
    return (
        f"One slip makes all the difference: the answer joins {_pairs(wrong)}, where the world "
        f"joins {_pairs([(a, world.alpha[a]), (b, world.alpha[b])])}."
    )


def _pairs(edges: list[tuple[Dart, Dart]]) -> str:
    ordered = sorted((min(edge), max(edge)) for edge in edges)
    return " and ".join(f"dart {d} with {e}" for d, e in ordered)


def _edge_missing(belief: Belief) -> str:
    """One edge of the world is not in the answer, or is a vertex there."""
    world, answer = belief.story.map, belief.answer.map
    if answer.edge_count != world.edge_count - 1:
        return ""
    for d, e in world.edges:
        if _same(deleted(world, d), answer):
            return f"The answer lacks one edge of the world: that of darts {d} and {e}."
    for d, e in world.edges:
        if _same(contracted(world, d), answer):
            ends = f"{belief.story.vertex(d)} and {belief.story.vertex(e)}"
            return f"The answer takes {ends} for one vertex, and has no edge between them."
    return ""


def _edge_too_many(belief: Belief) -> str:
    """One edge of the answer is not in the world, or is a vertex there."""
    world, answer = belief.story.map, belief.answer.map
    if answer.edge_count != world.edge_count + 1:
        return ""
    if any(_same(deleted(answer, d), world) for d, _ in answer.edges):
        return "The answer has one edge too many: without it, it is the map of the world."
    if any(_same(contracted(answer, d), world) for d, _ in answer.edges):
        return "The answer takes one vertex for two, with an edge between them."
    return ""


def _same(a: CombinatorialMap | None, b: CombinatorialMap) -> bool:
    return a is not None and not isinstance(isomorphism(a, b), Mismatch)


SLIPS: dict[str, Recogniser] = {
    "mirrored": _mirrored,
    "glued crosswise": _glued_crosswise,
    "an edge missing": _edge_missing,
    "an edge too many": _edge_too_many,
}
"""The slips that are looked for, the commonest first."""
