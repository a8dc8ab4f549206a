"""The sense in which an explorer writes rotations, if the world of its finding cannot tell."""

from __future__ import annotations

from collections.abc import Iterator

from allworlds.judging.explanations.slips import mirror_image
from allworlds.judging.explanations.story import Belief, Story
from allworlds.judging.findings.finding import Chirality, Finding
from allworlds.maps import CombinatorialMap, MapClass, isomorphism, rooted_maps
from allworlds.words import size
from allworlds.world import World

LARGEST = 5
"""The largest number of edges of the chiral worlds: each class has some."""

NARROWEST = (MapClass.PLANAR_SIMPLE, MapClass.SIMPLE, MapClass.PLANAR, MapClass.MAPS)
"""The classes, each before those that hold it: an explorer may be made for one of them alone."""


def needs_a_chiral_world(finding: Finding) -> bool:
    """Whether the answer is wrong as a mirror image would be, in a world that cannot tell."""
    return finding.law == "pose" and bool(mirror_image(Belief(Story(finding))))


def chiral_worlds(finding: Finding) -> Iterator[World]:
    """Worlds like the finding's that are not their own mirror image, small ones first.

    They have its lighthouse, and are simple or planar where its world is.
    """
    for edges in range(1, LARGEST + 1):
        for map_ in rooted_maps(edges, narrowest_class(finding)):
            place = next(iter(finding.rules.kind.places(map_, 0)), None)
            if place and not isomorphism(map_, map_.mirrored()):
                yield World(map_, place, 0)


def narrowest_class(finding: Finding) -> MapClass:
    """The narrowest of the usual classes that holds the finding's world."""
    return next(each for each in NARROWEST if each.includes(finding.world.map))


def chirality_in(world: World, answer: CombinatorialMap) -> Chirality | None:
    """The sense that an answer in a chiral world shows; None if it is neither map nor image."""
    edges = size(world.map.edge_count, world.map.vertex_count)
    where = f"a world with {edges}, which is not its own mirror image"
    if isomorphism(answer, world.map):
        return Chirality("clockwise", where)
    if isomorphism(answer.mirrored(), world.map):
        return Chirality("anticlockwise", where)
    return None
