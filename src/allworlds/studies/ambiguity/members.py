"""The complete ambiguity class of a world: all worlds that no motion tells from it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from allworlds.inputs import InputError, an_integer, show
from allworlds.maps import (
    Code,
    CombinatorialMap,
    Disagreement,
    Labelled,
    MapClass,
    Projection,
    Quotient,
    class_size,
    is_ambiguous,
    pose_count,
    project,
    rooted_code,
)
from allworlds.outcome import SCHEMA, Exit
from allworlds.protocol import Percept
from allworlds.studies.ambiguity.lifting import lifts
from allworlds.studies.ambiguity.marked_code import LeastRooting, least_rooting
from allworlds.world import Directional, Position, World

if TYPE_CHECKING:
    from allworlds import documents

DEFAULT_LIMIT = 1000
"""The largest class whose members are all made, unless another limit is named."""


@dataclass(frozen=True)
class AmbiguityClass:
    """All worlds that no motion tells from a given one.

    Attributes:
        world: the given one.
        universe: the class of maps that the members belong to.
        quotient: what a robot can know; rooted at the start.
        size: the exact number of members, the given world included.
        poses: the exact number of pose hypotheses: (member, dart where the robot can be), up
            to automorphisms.
        worlds: the given world first, then the others by their codes; with start 0 in
            canonical numbering, where the robot could be, facing as it does.
    """

    world: World
    universe: MapClass
    quotient: Quotient
    size: int
    poses: int
    worlds: tuple[World, ...]

    @property
    def notice(self) -> str | None:
        """What has been left out, if anything."""
        if len(self.worlds) == self.size:
            return None
        return (
            f"{len(self.worlds)} of {self.size} worlds are listed, as --limit says; "
            "size and poses are exact (Burnside's count)"
        )

    @property
    def exit_code(self) -> Exit:
        """The exit code of the command: a question was answered."""
        return Exit.ANSWERED

    def to_json(self) -> documents.AmbiguityClassDocument:
        """The document of ``ambiguity class --json``."""
        return {
            "schema": SCHEMA,
            "world": self.world.to_json(),
            "class": self.universe.value,
            "ambiguous": self.size > 1,
            "size": self.size,
            "poses": self.poses,
            "sheets": self.quotient.sheets,
            "listed": len(self.worlds),
            "notice": self.notice,
            "worlds": [world.to_json() for world in self.worlds],
            "quotient": quotient_to_json(self.quotient),
        }


def quotient_to_json(quotient: Quotient) -> documents.QuotientDocument:
    """``{"sigma", "alpha", "degree", "marks"}``; ``alpha[q] == q`` is a semi-edge."""
    marks = []
    for label in quotient.labels:
        assert isinstance(label, Percept)
        marks.append(label.marks)
    return {
        "sigma": list(quotient.sigma),
        "alpha": list(quotient.alpha),
        "degree": list(quotient.degree),
        "marks": marks,
    }


def projection_of(world: World) -> Projection:
    """The world onto its quotient, rooted at the start: what is sensed are the labels."""
    return project(Labelled(world.map, world.percepts, world.start))


def class_of(
    world: World, *, limit: int = DEFAULT_LIMIT, map_class: str = MapClass.MAPS.value
) -> AmbiguityClass:
    """The complete ambiguity class of a world.

    Args:
        world: with a position lighthouse, or a directional one (then it is alone).
        limit: the largest number of members that are made; of a larger class only so many
            are listed, with its exact size.
        map_class: the universe; only members that belong to it count.

    Raises:
        InputError: for another lighthouse, under which a class can be infinite; for a world
            outside the universe; for a limit below 1, or one that is too small where all
            members must be made to see which belong to the universe.

    Cost: O(k m) for each of the at most k ``limit`` lifts.
    """
    universe = _checked(world, limit, map_class)
    quotient, classes = projection_of(world)
    size = class_size(quotient)
    if (size > 1) != is_ambiguous(quotient):
        raise Disagreement(f"the criterion and Burnside's count {size} differ on {quotient}")
    if size > limit and universe is not MapClass.MAPS:
        raise InputError(
            f"limit {show(limit)} is too small: {size} worlds must be made to see which of them "
            f"are {universe}"
        )
    own = least_rooting(world.map, [d for d, q in enumerate(classes) if q == 0])
    found = _members(quotient, limit, own)
    poses = pose_count(quotient)
    if size <= limit:
        _check_complete(quotient, found, own)
        inside = {
            code: rooting
            for code, rooting in found.items()
            if universe.includes(CombinatorialMap.trusted(*code))
        }
        size, poses = len(inside), _poses(quotient, inside)
        found = inside
    others = sorted(code for code in found if code != own.code)
    listed = tuple(_placed(world, code) for code in (own.code, *others))
    return AmbiguityClass(world, universe, quotient, size, poses, listed)


def _checked(world: World, limit: int, map_class: str) -> MapClass:
    if not isinstance(world, World):
        raise InputError(f"world = {show(world)} is no World; World.from_json makes one")
    if not isinstance(world.lighthouse, Position | Directional):
        raise InputError(
            f"under the lighthouse {world.lighthouse.kind} no class is made, which without a mark "
            "at one vertex can be infinite; legal are the lighthouses position and directional"
        )
    if an_integer("limit", limit) < 1:
        raise InputError(f"limit {show(limit)} is too small; at least the world itself is listed")
    universe = MapClass.named(map_class)
    if not universe.includes(world.map):
        raise InputError(f"the world itself is not {universe}, so its class there is empty")
    return universe


def _members(quotient: Quotient, limit: int, own: LeastRooting) -> dict[Code, LeastRooting]:
    """The members by code; of more than the limit the given one and the first others."""
    alike = range(quotient.sheets)  # the darts of a lift that lie over class 0
    found: dict[Code, LeastRooting] = {}
    for lift in lifts(quotient):
        rooting = least_rooting(lift, alike)
        # One place is kept for the given world until it is met.
        if len(found) < limit - (own.code not in found) or rooting.code == own.code:
            found[rooting.code] = rooting
        elif rooting.code not in found:
            found[own.code] = own
            break
    return found


def _check_complete(quotient: Quotient, found: dict[Code, LeastRooting], own: LeastRooting) -> None:
    """Nothing, if three counts of the class agree and the world is in it."""
    size, poses, weighed = class_size(quotient), pose_count(quotient), _poses(quotient, found)
    if len(found) != size or poses != weighed or own.code not in found:
        raise Disagreement(
            f"{len(found)} worlds have been made and {size} counted, with {weighed} and {poses} "
            f"poses, for the quotient {quotient}"
        )


def _poses(quotient: Quotient, found: dict[Code, LeastRooting]) -> int:
    """The mass formula: the sum of k / |Aut(world, v0)|."""
    return sum(quotient.sheets // rooting.times for rooting in found.values())


def _placed(world: World, code: Code) -> World:
    """The member with that code, with the lighthouse of the given world."""
    map_ = CombinatorialMap.trusted(*code)
    if isinstance(world.lighthouse, Position):
        return World(map_, Position(0), 0)
    # A directional marker makes all darts different: the member is the world itself.
    bearing = world.first.bearing
    assert bearing is not None
    assert code == rooted_code(world.map.sigma, world.map.alpha, world.start)
    return World(map_, Directional(map_.turn(0, bearing)), 0)
