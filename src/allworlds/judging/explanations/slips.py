"""Slips that are looked for, and that have words of their own."""

from __future__ import annotations

import re
from collections.abc import Callable, Hashable, Iterable, Iterator, Sequence
from typing import TypeAlias, TypeGuard

from msgspec import Struct

from allworlds.judging.explanations.story import Belief, Walked
from allworlds.judging.findings.walks import trail_to
from allworlds.maps.canonical import Mismatch, isomorphism, rooted_isomorphism
from allworlds.maps.combinatorial import CombinatorialMap, Dart, InvalidMap
from allworlds.maps.surgery import contracted, deleted
from allworlds.protocol.actions import Move, Percept
from allworlds.words import plural

PYTHON = "Traceback (most recent call last):"

TELLING = re.compile(
    r"""(\b\w*(Error|Exception)\b.*:)  # Node, Java, Ruby, C#
    |(^panic:)                         # Go
    |(\bpanicked\ at\b)                # Rust
    |(^\s*what\(\):)                   # C++
    |(\bAssertion\b.*\bfailed\b)        # C
    |(^(fatal|Segmentation\ fault|Aborted|Killed)\b)
    """,
    re.VERBOSE | re.IGNORECASE,
)
"""The words at the beginning of that line, or in it."""

FRAME = re.compile(r"^\s+at\s|^\s*File \"|^note: ")
"""The words in a line about the place of an error, not about the error."""


def telling_line(text: str) -> str:
    """The line of a traceback, or of a text on stderr, that names the error.

    Python writes this line last, other languages first, followed by places, or a version.  If no
    line looks like one, it is the last line; empty if there is none.
    """
    lines = [line for line in text.split("\n") if line.strip()]
    if not lines:
        return ""
    if any(line.startswith(PYTHON) for line in lines):
        return next((line for line in reversed(lines) if line[0] != " "), lines[-1]).strip()
    for i in reversed(range(len(lines))):
        if TELLING.search(lines[i]) and not FRAME.search(lines[i]):
            # Rust tells where on this line, and what on the next.
            after = lines[i + 1 : i + 2] if lines[i].endswith(":") else []
            return " ".join(line.strip() for line in [lines[i], *after])
    return lines[-1].strip()


LONGEST = 200
"""The number of steps of the longest round that is looked for."""

TIMES = 3
"""The least number of times that a round is gone."""

WAY_BACK = (
    "motions a, b, c are undone by 0, -c, -b, and then the robot stands at the dart by which it "
    "left, a darts clockwise of the one where it stood before"
)
"""The rule of ways back: a wrong one is a likely cause of a walk without an end."""


class Round(Struct, frozen=True):
    """The steps that a walk repeats until its end.

    Attributes:
        first: the first step of the first round.
        length: steps of a round.
        times: the number of times, the last one perhaps in part.
    """

    first: int
    length: int
    times: int


def round_at_the_end(steps: Sequence[Hashable]) -> Round | None:
    """The shortest round with which the steps end; steps are numbered from 1.  Cost: O(n LONGEST).

    None if it is gone less than :data:`TIMES` times, or is not the greater part of the steps: a
    wandering robot goes round by chance, for a while.
    """
    for length in range(1, min(LONGEST, len(steps) // TIMES) + 1):
        first = len(steps) - length
        while first > 0 and steps[first - 1] == steps[first - 1 + length]:
            first -= 1
        if len(steps) - first >= max(TIMES * length, len(steps) / 2):
            return Round(first + 1, length, -(-(len(steps) - first) // length))
    return None


def tell_rounds(story: Walked) -> list[str]:
    """Tell that the robot went round, or since when no edge was new; skip short walks."""
    actions = story.transcript.actions
    found = round_at_the_end([*zip(actions, story.walked[1:], strict=True)])
    if found:
        steps = plural(found.length, "step")
        told = f"From step {found.first} on it repeated {steps} {found.times} times"
        return [f"{told}, until the end.", *_tell_ways_back(story, found.first + found.length - 1)]
    found_at = story.discoveries
    if not found_at:
        return []
    left = story.map.edge_count - len(found_at)
    step = f"After step {found_at[-1]}"
    if left:
        told = f"{step} it met no new edge; {plural(left, 'edge')} it never met."
        return [told, *_tell_ways_back(story, len(actions))]
    why = (
        "Either it takes a vertex or an edge that it knows for a new one, or the robot is not "
        "where the explorer believes."
    )
    return [
        f"{step} it had walked every edge of the world, and yet it went on.",
        why,
        f"Look at its ways back: {WAY_BACK}.",
    ]


def _tell_ways_back(story: Walked, end: int) -> list[str]:
    """Tell how a way back is walked, where one may begin before that step."""
    actions, turns = story.transcript.actions[:end], story.sensed
    back = (i for i, action in enumerate(actions) if i and action == Move(0))
    may_begin = any(turns[i].degree > 1 for i in back)
    if not may_begin or all(action == Move(0) for action in actions):
        return []
    return [f"Look at its ways back: {WAY_BACK}."]


LARGEST = 40
"""Edges above which slips are not looked for: there are quadratically many, each compared anew."""


class Slip(Struct, frozen=True):
    """The one difference between an answer and the world.

    Attributes:
        name: in the table.
        sentence: a description with the darts of the world.
        mended: the map without the slip; None if the slip is in the reading of percepts.
        truth: the map that the mended one equals: the world's, or that without the edge of the
            slip.
        here: the robot's dart in the mended map; None if that is wrong, too, or unknown.
    """

    name: str
    sentence: str
    mended: CombinatorialMap | None
    truth: CombinatorialMap
    here: Dart | None = None


MIRROR_IMAGE, BEARINGS = "mirror image", "bearings anticlockwise"

Recogniser: TypeAlias = Callable[[Belief], Slip | None]
"""A recogniser: the slip, or None if it is another one, or none."""


def the_slip(belief: Belief) -> Slip | None:
    """The first slip of the table that accounts for all of the difference; None if none does."""
    if max(belief.answer.map.edge_count, belief.story.map.edge_count) > LARGEST:
        return None
    return next((slip for recognise in SLIPS.values() if (slip := recognise(belief))), None)


def mirror_image(belief: Belief) -> Slip | None:
    """Recognise an answer in which every rotation is given anticlockwise."""
    answer, world, robot = belief.answer, belief.story.map, belief.story.walked[-1]
    mirrored = answer.map.mirrored()
    if rooted_isomorphism(mirrored, answer.here, world, robot):
        sentence = (
            "The answer is a mirror image: with its rotations read anticlockwise it would be right."
        )
        return Slip(MIRROR_IMAGE, sentence, mirrored, world, answer.here)
    if isomorphism(mirrored, world) and not isomorphism(answer.map, world):
        sentence = (
            "The answer's map is the mirror image of the world's: its rotations are anticlockwise."
        )
        return Slip(MIRROR_IMAGE, sentence, mirrored, world)
    return None


def bearings_anticlockwise(belief: Belief) -> Slip | None:
    """Recognise an answer whose edges end as sensed if bearings are counted anticlockwise.

    The walk that ends at ``here`` is followed in the answer.  Percepts count at the start and
    where the walk takes an edge for the first time: on its way back a robot need not look.  Where
    the map is right, all percepts count: there a wrong ``here`` alone is likelier.
    """
    map_, transcript = belief.answer.map, belief.story.transcript
    trail = trail_to(map_, belief.answer.here, transcript)
    is_right = bool(isomorphism(map_, belief.story.map))
    sensed, taken = [(trail[0], transcript.first)], set()
    for dart, percept in zip(trail[1:], transcript.percepts[1:], strict=True):
        edge = min(dart, map_.alpha[dart])
        if is_right or edge not in taken:
            sensed.append((dart, percept))
        taken.add(edge)
    if _fits(map_, sensed, 1) or not _fits(map_, sensed, -1):
        return None
    sentence = (
        "The explorer seems to count bearings anticlockwise: read so, the percepts show all edges "
        "as the answer has them. A bearing counts the darts clockwise, from the dart by which the "
        "robot arrives to the pointed dart."
    )
    return Slip(BEARINGS, sentence, None, belief.story.map)


def _fits(map_: CombinatorialMap, sensed: Iterable[tuple[Dart, Percept]], way: int) -> bool:
    """Whether each vertex has one degree, one number of marks and one pointed dart."""
    found: dict[int, tuple[int, Dart | None]] = {}
    for dart, percept in sensed:
        if map_.degree_at[dart] != percept.degree:
            return False
        pointed = None if percept.bearing is None else map_.turn(dart, way * percept.bearing)
        here = (percept.marks, pointed)
        if found.setdefault(map_.vertex_of[dart], here) != here:
            return False
    return True


def _glued_crosswise(belief: Belief) -> Slip | None:
    """Recognise an answer in which two edges have one end each exchanged."""
    world, robot = belief.story.map, belief.story.walked[-1]
    if isomorphism(belief.answer.map, world):
        return None
    of_map_alone = None
    for mended, wrong in _reglued(belief.answer.map):
        names = rooted_isomorphism(mended, belief.answer.here, world, robot)
        if not isinstance(names, Mismatch):
            sentence = _say_crosswise(belief, [(names[a], names[b]) for a, b in wrong])
            return Slip("edges crossed", sentence, mended, world, belief.answer.here)
        if of_map_alone is None:
            names = isomorphism(mended, world)
            if not isinstance(names, Mismatch):
                sentence = _say_crosswise(belief, [(names[a], names[b]) for a, b in wrong])
                of_map_alone = Slip("edges crossed", sentence, mended, world)
    return of_map_alone


def _reglued(
    map_: CombinatorialMap,
) -> Iterator[tuple[CombinatorialMap, tuple[tuple[Dart, Dart], tuple[Dart, Dart]]]]:
    """The maps with two edges glued otherwise, each with the two original edges."""
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
                f"The answer differs from the world only in this: darts {first} and {second} of "
                f"{belief.story.vertex(x)} are exchanged."
            )
    return (
        f"The answer differs from the world only in this: it joins {_pairs(wrong)}, the world "
        f"joins {_pairs([(a, world.alpha[a]), (b, world.alpha[b])])}."
    )


def _pairs(edges: list[tuple[Dart, Dart]]) -> str:
    ordered = sorted((min(edge), max(edge)) for edge in edges)
    return " and ".join(f"dart {d} with {e}" for d, e in ordered)


def _edge_misplaced(belief: Belief) -> Slip | None:
    """Recognise an answer in which one edge has an end, or both, in another place."""
    world, answer = belief.story.map, belief.answer.map
    if answer.edge_count != world.edge_count or isomorphism(answer, world):
        return None
    left = [(edge, less) for edge in world.edges if (less := deleted(world, edge[0]))]
    for d, _ in answer.edges:
        fewer = deleted(answer, d)
        for (a, b), less in left:
            if fewer and isomorphism(fewer, less):
                sentence = (
                    f"All but one edge is right: that of darts {a} and {b} of the world is "
                    "elsewhere in the answer."
                )
                return Slip("edge misplaced", sentence, fewer, less)
    return None


def _edge_missing(belief: Belief) -> Slip | None:
    """Recognise an answer that lacks one edge of the world, or has a vertex in its place."""
    world, answer = belief.story.map, belief.answer.map
    if answer.edge_count != world.edge_count - 1:
        return None
    for d, e in world.edges:
        if _same(less := deleted(world, d), answer):
            sentence = f"The answer lacks one edge of the world: that of darts {d} and {e}."
            return Slip("edge missing", sentence, answer, less)
    for d, e in world.edges:
        if _same(less := contracted(world, d), answer):
            ends = f"{belief.story.vertex(d)} and {belief.story.vertex(e)}"
            sentence = f"The answer takes {ends} for one vertex, and has no edge between them."
            return Slip("one vertex for two", sentence, answer, less)
    return None


def _edge_too_many(belief: Belief) -> Slip | None:
    """Recognise an answer with one edge that is not in the world, or is a vertex there."""
    world, answer = belief.story.map, belief.answer.map
    if answer.edge_count != world.edge_count + 1:
        return None
    for d, _ in answer.edges:
        if _same(less := deleted(answer, d), world):
            sentence = "The answer has one edge too many: without it, it is the map of the world."
            return Slip("edge too many", sentence, less, world)
    for d, _ in answer.edges:
        if _same(less := contracted(answer, d), world):
            sentence = "The answer takes one vertex for two, with an edge between them."
            return Slip("two vertices for one", sentence, less, world)
    return None


def _same(a: CombinatorialMap | None, b: CombinatorialMap) -> TypeGuard[CombinatorialMap]:
    return a is not None and bool(isomorphism(a, b))


SLIPS: dict[str, Recogniser] = {
    "mirrored": mirror_image,
    "bearings read anticlockwise": bearings_anticlockwise,
    "glued crosswise": _glued_crosswise,
    "an edge misplaced": _edge_misplaced,
    "an edge missing": _edge_missing,
    "an edge too many": _edge_too_many,
}
"""The slips that are looked for, the commonest first."""
