"""The story of a run: names of vertices and darts, the walk in a wrong answer, and slips.

A slip is the one mistake by which a wrong answer differs from the world.  The walk in the answer is
a walk in the answer's map, with the actions of the robot's walk in the world; the two walks diverge
at the first step at which the answer and the world contradict each other.
"""

import math
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from typing import TypeAlias

from msgspec import Struct

from allworlds.inputs.checks import InputError, show
from allworlds.judging.belief import believed_walk, trail_to
from allworlds.judging.findings.finding import Finding
from allworlds.judging.walk import Walk
from allworlds.maps.build import contracted, deleted
from allworlds.maps.combinatorial import (
    CombinatorialMap,
    Dart,
    InvalidMap,
    isomorphism,
    rooted_isomorphism,
)
from allworlds.protocol.actions import Estimate, Move, Percept
from allworlds.world.world import World


class Walked:
    """A walk in a world, and the names of the vertices and darts on it.

    Attributes:
        walk: the walk.
        world: the world of the walk.
        map: the map of the world.
        sensed: the percepts at the start and after each step.
    """

    def __init__(self, walk: Walk) -> None:
        self.walk = walk
        self.world = walk.world
        self.map = walk.world.map
        self.sensed = walk.percepts

    @property
    def discoveries(self) -> dict[Dart, int]:
        """For each walked edge, named by its smaller dart, the step that first walked along it.

        The steps are numbered from 1 on.
        """
        return {edge: before + 1 for edge, before in self.walk.crossed.items()}

    def in_words(self, percept: Percept) -> str:
        """The percept in words: marks are called labels if the lighthouse labels vertices."""
        return percept.in_words(labels=self.world.lighthouse.labels_vertices)

    def vertex(self, dart: Dart) -> str:
        """The name of a dart's vertex: its label, such as ``hall``, or ``v1`` without a label."""
        return self.world.labels.vertex(self.map.vertex_of[dart])

    def spot(self, dart: Dart) -> str:
        """The name of a dart together with that of its vertex: ``v1, dart 3``."""
        return f"{self.vertex(dart)}, dart {dart}"

    @property
    def unwalked(self) -> list[str]:
        """The edges that the robot never walked along, in words."""
        walked = self.walk.crossed
        return [
            f"the edge from dart {a} of {self.vertex(a)} to dart {b} of {self.vertex(b)}"
            for a, b in self.map.edges
            if a not in walked
        ]

    def arrival(self, step: int) -> str:
        """The vertex and dart of the robot after a step, such as ``v1, dart 3``.

        The steps are numbered from 1 on; 0 stands for the start.  After a motion in a world with
        labelled vertices the text names both vertices: ``hall -> F, dart 3``.
        """
        spot = self.spot(self.walk.darts[step])
        moved = step and type(self.walk.actions[step - 1]) is Move
        if moved and self.world.labels.vertices:
            return f"{self.vertex(self.walk.darts[step - 1])} -> {spot}"
        return spot


class Story(Walked):
    """A finding with the walk that its log describes.

    Attributes:
        finding: the finding that is explained.
        checkpoint: the number of steps that the robot had walked when the explorer showed a wrong
            checkpoint; None if no wrong checkpoint is known.  If the broken law is about
            checkpoints, this is the checkpoint that breaks the law.  If the run ended without an
            answer, for example in a crash, this is the first checkpoint that breaks
            ``invariant-1`` or ``invariant-2``; it is known only if the law ``invariant-1`` is
            checked.

    Raises:
        InputError: if the finding's transcript is impossible in its world, or ends before this
            checkpoint.
    """

    def __init__(self, finding: Finding) -> None:
        super().__init__(Walk.recorded(finding.world, finding.transcript))
        self.finding = finding
        self.checkpoint = finding.step
        if finding.step is not None and finding.step >= len(self.walk.darts):
            raise InputError(
                f"step = {show(finding.step)} is behind the walk, which has "
                f"{len(self.walk.darts) - 1} steps"
            )

    def last_left(self, dart: Dart, step: int) -> str:
        """A clause that says when, before ``step``, the robot last left the vertex of ``dart``.

        The clause is ``which it had just left``, or ``which it had left at step 3``.
        """
        vertex = self.vertex(dart)
        last = max(i for i in range(step) if self.vertex(self.walk.darts[i]) == vertex)
        just = last == step - 1
        return "which it had just left" if just else f"which it had left at step {last + 1}"


class Belief:
    """The robot's belief: the wrong answer of a finding, and the walk in this answer.

    Attributes:
        story: the finding with its walk in the world.
        answer: the wrong answer.
        walk: the walk in the answer.

    Raises:
        InputError: if the finding's ``seen`` is no map with ``here``, so that its law cannot be one
            about the answer.
    """

    def __init__(self, story: Story) -> None:
        seen = story.finding.seen
        if not isinstance(seen, Estimate):
            raise InputError(
                f"seen = {show(seen)} is no rooted map, but the law is about the answer"
            )
        self.story, self.answer = story, seen
        self.walk = believed_walk(story.walk, self.answer)

    @property
    def step(self) -> int | None:
        """The first step at which the walks in the answer and the world diverge; None if never."""
        parting = self.walk.parting
        return parting.step if parting else None


class Telling(Struct, frozen=True):
    """The explanation of a run that breaks a law.

    Attributes:
        sentences: the sentences of the explanation.
        step: the step at which a mistake first shows: for a wrong answer the first step at which
            the walks in the answer and in the world diverge; else the attribute ``checkpoint`` of
            the :class:`Story`; None if there is no such step.
        answer: the wrong answer; None if the law is not about the answer.
        other: another world that agrees with the log; None if the law is not about such worlds.
        slip: the name of the slip that makes the answer wrong; empty if none is known.
    """

    sentences: list[str]
    step: int | None = None
    answer: Estimate | None = None
    other: World | None = None
    slip: str = ""


Teller: TypeAlias = Callable[[Story], Telling]
"""A function that explains the finding of a story, which breaks a certain law; it may raise
InputError."""


LARGEST = 40
"""The largest number of edges for which slips are searched; the cost grows with its square."""


class Slip(Struct, frozen=True):
    """The one mistake by which an answer differs from the world.

    Attributes:
        name: the name of the slip, in a word or two.
        sentence: a description with the darts of the world.
        mended, truth: two equal maps, which prove the slip.  ``mended`` is the answer's map after
            the correction of the slip, and ``truth`` is the world's map.  If one edge is missing or
            misplaced in the answer, both maps are without this edge.  If the slip is in the reading
            of percepts, ``mended`` is None: then the answer fits the percepts if they are read
            wrongly in this way, and that proves the slip.
        here: the robot's dart in ``mended``; None if the answer's ``here`` is also wrong, or if the
            dart is unknown.
    """

    name: str
    sentence: str
    mended: CombinatorialMap | None
    truth: CombinatorialMap
    here: Dart | None = None


MIRROR_IMAGE, BEARINGS = "mirror image", "bearings anticlockwise"

Recogniser: TypeAlias = Callable[[Belief], Slip | None]
"""The function that recognises one kind of slip; it returns None for any other answer."""


def the_slip(belief: Belief) -> Slip | None:
    """The first kind of slip in :data:`SLIPS` that alone makes the answer differ from the world.

    The result is None if no single slip does, or if one of the two maps has more than
    :data:`LARGEST` edges.
    """
    if max(belief.answer.map.edge_count, belief.story.map.edge_count) > LARGEST:
        return None
    return next((slip for recognise in SLIPS if (slip := recognise(belief))), None)


def mirror_image(belief: Belief) -> Slip | None:
    """Recognise an answer that lists the darts of each vertex anticlockwise."""
    answer, world, robot = belief.answer, belief.story.map, belief.story.walk.darts[-1]
    mirrored = answer.map.mirrored()
    if rooted_isomorphism(mirrored, answer.here, world, robot):
        sentence = "The answer is a mirror image: with sigma reversed it would be right."
        return Slip(MIRROR_IMAGE, sentence, mirrored, world, answer.here)
    if isomorphism(mirrored, world) and not isomorphism(answer.map, world):
        sentence = "The answer's map is the world's mirror image: its sigma goes anticlockwise."
        return Slip(MIRROR_IMAGE, sentence, mirrored, world)
    return None


def bearings_anticlockwise(belief: Belief) -> Slip | None:
    """Recognise an answer that fits the percepts only if bearings are counted anticlockwise.

    The percepts are compared along the walk in the answer that ends at ``here``.  Only the percepts
    at the start and after the first walk along each edge must fit, because an explorer need not
    look at the percepts on a way back.  But if the answer's map equals the world's map, only
    ``here`` is wrong, which usually has another cause; so this slip is then recognised only if all
    percepts of the walk fit.
    """
    map_, walk = belief.answer.map, belief.story.walk
    trail = trail_to(map_, belief.answer.here, walk)
    is_right = bool(isomorphism(map_, belief.story.map))
    sensed, taken = [(trail[0], walk.first)], set()
    for dart, percept in zip(trail[1:], walk.percepts[1:], strict=True):
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
    """Whether the percepts ``sensed`` are possible in ``map_``.

    Each percept must show the degree of its vertex in ``map_``.  All percepts at one vertex must
    have the same marks, and their bearings must all lead to the same dart.

    Args:
        map_: a map.
        sensed: pairs of the robot's dart in ``map_`` and the percept there.
        way: 1 if bearings count darts clockwise, -1 if anticlockwise.
    """
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
    """Recognise an answer that is right but for two edges, which have exchanged one end."""
    answer, world, robot = belief.answer, belief.story.map, belief.story.walk.darts[-1]
    if isomorphism(answer.map, world):
        return None
    with_wrong_place = None
    for mended, wrong in _reglued(answer.map):
        here: Dart | None = answer.here
        names = rooted_isomorphism(mended, answer.here, world, robot)
        if not names and with_wrong_place is None:
            here, names = None, isomorphism(mended, world)
        if names is None:
            continue
        sentence = _say_crosswise(belief, [(names[a], names[b]) for a, b in wrong])
        slip = Slip("edges crossed", sentence, mended, world, here)
        if here is not None:
            return slip
        with_wrong_place = slip
    return with_wrong_place


def _reglued(
    map_: CombinatorialMap,
) -> Iterator[tuple[CombinatorialMap, tuple[tuple[Dart, Dart], tuple[Dart, Dart]]]]:
    """The maps that arise from ``map_`` if two of its edges exchange an end.

    Each map comes with these two edges, each as its two darts in ``map_``.  Results that are not
    connected are left out.
    """
    for i, (a, b) in enumerate(map_.edges):
        for c, d in map_.edges[i + 1 :]:
            for pairs in (((a, c), (b, d)), ((a, d), (b, c))):
                alpha = [*map_.alpha]
                for x, y in pairs:
                    alpha[x], alpha[y] = y, x
                with suppress(InvalidMap):  # it is not connected
                    yield CombinatorialMap(map_.sigma, alpha), ((a, b), (c, d))


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
        f"The answer differs from the world only in this: it joins {_pairs(wrong)}, but the world "
        f"joins {_pairs([(a, world.alpha[a]), (b, world.alpha[b])])}."
    )


def _pairs(edges: list[tuple[Dart, Dart]]) -> str:
    ordered = sorted((min(edge), max(edge)) for edge in edges)
    return " and ".join(f"dart {d} with {e}" for d, e in ordered)


def _edge_misplaced(belief: Belief) -> Slip | None:
    """Recognise an answer that is right but for one edge, which has a wrong end, or two."""
    world, answer = belief.story.map, belief.answer.map
    if answer.edge_count != world.edge_count or isomorphism(answer, world):
        return None
    left = [(edge, less) for edge in world.edges if (less := deleted(world, edge[0]))]
    for d, _ in answer.edges:
        fewer = deleted(answer, d)
        for (a, b), less in left:
            if fewer and isomorphism(fewer, less):
                sentence = (
                    f"Only one edge is wrong: the edge of darts {a} and {b} of the world is "
                    "elsewhere in the answer."
                )
                return Slip("edge misplaced", sentence, fewer, less)
    return None


def _edge_missing(belief: Belief) -> Slip | None:
    """Recognise an answer that lacks one edge, and perhaps takes its two ends for one vertex.

    There may be several edges whose removal makes the world's map equal to the answer's map.  Then
    the slip names an edge that the robot never walked along.  If the robot walked along all of
    them, the slip names the one that it discovered last, because the explorer most likely knew the
    edges that were discovered earlier.
    """
    story, answer = belief.story, belief.answer.map
    alpha, crossed = story.map.alpha, story.walk.crossed

    def last(edges: Iterator[tuple[Dart, CombinatorialMap]]) -> list[tuple[Dart, CombinatorialMap]]:
        return sorted(edges, key=lambda edge: -crossed.get(edge[0], math.inf))[:1]

    for d, less in last(_without_an_edge(deleted, story.map, answer)):
        sentence = f"The answer lacks one edge of the world: the edge of darts {d} and {alpha[d]}."
        return Slip("edge missing", sentence, answer, less)
    for d, less in last(_without_an_edge(contracted, story.map, answer)):
        ends = f"{story.vertex(d)} and {story.vertex(alpha[d])}"
        sentence = f"The answer takes {ends} for one vertex, and lacks an edge between them."
        return Slip("one vertex for two", sentence, answer, less)
    return None


def _edge_too_many(belief: Belief) -> Slip | None:
    """Recognise an answer with one edge too many.

    Without this edge, or after its contraction to a vertex, the answer's map is the world's map.
    """
    world, answer = belief.story.map, belief.answer.map
    for _, less in _without_an_edge(deleted, answer, world):
        sentence = "The answer has one edge too many; without this edge it is the world's map."
        return Slip("edge too many", sentence, less, world)
    for _, less in _without_an_edge(contracted, answer, world):
        sentence = "The answer takes one vertex for two, with an edge between them."
        return Slip("two vertices for one", sentence, less, world)
    return None


def _without_an_edge(
    taking: Callable[[CombinatorialMap, Dart], CombinatorialMap | None],
    larger: CombinatorialMap,
    smaller: CombinatorialMap,
) -> Iterator[tuple[Dart, CombinatorialMap]]:
    """The edges of ``larger`` whose removal makes this map equal to ``smaller``.

    ``taking`` is the function that removes the edge of a dart from a map: ``deleted`` or
    ``contracted``.  It returns None if the removal is impossible.  Each edge is given by its
    smaller dart, together with the map without the edge.
    """
    if larger.edge_count == smaller.edge_count + 1:
        for d, _ in larger.edges:
            less = taking(larger, d)
            if less is not None and isomorphism(less, smaller):
                yield d, less


SLIPS: tuple[Recogniser, ...] = (
    mirror_image,
    bearings_anticlockwise,
    _glued_crosswise,
    _edge_misplaced,
    _edge_missing,
    _edge_too_many,
)
"""The functions that each recognise one kind of slip, the commonest kind first."""
