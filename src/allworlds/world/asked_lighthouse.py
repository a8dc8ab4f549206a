"""The lighthouse of a request; one of the user's is tried in small worlds before it is used."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache
from random import Random
from typing import Annotated

from allworlds.document.struct import Text, about
from allworlds.inputs.checks import one_of
from allworlds.inputs.requests import SCOPE, Option, Request, Taken
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.enumeration import rooted_maps
from allworlds.protocol.actions import Action, Drop, Move, Pick, Write
from allworlds.protocol.faults import IllegalAction
from allworlds.world.lighthouses.base import Lighthouse
from allworlds.world.lighthouses.kinds import (
    LIGHTHOUSES,
    OWN,
    GivenLighthouse,
    LighthouseKind,
    lighthouse_kind,
)
from allworlds.world.lighthouses.options import InvalidWorld
from allworlds.world.world import World

TRIED_EDGES = 3
"""In all maps with so many edges a lighthouse of the user's must be a function of the world."""

PLACED_EDGES = 4
"""In one of the maps with so many edges it must have a place."""

STEPS = 12
"""The length of a walk on which the robot leaves marks."""


def tried_kind(given: object) -> LighthouseKind:
    """The kind of a name, or of a class; one of the user's is tried in all small maps.

    Raises:
        InvalidWorld: naming the legal kinds, or the map in which it is no function of the world.
    """
    kind = lighthouse_kind(given)
    if any(not code.recorded for code in kind.codes):
        _try(kind)
    return kind


@cache
def _try(kind: LighthouseKind) -> None:
    for wrong in flaws_of(kind, TRIED_EDGES):
        raise InvalidWorld(wrong)
    maps = (map_ for level in range(1, PLACED_EDGES + 1) for map_ in rooted_maps(level))
    if not any(True for map_ in maps for _ in kind.as_class.places(map_, 0)):
        raise InvalidWorld(
            f"the lighthouse {kind} has no place in any map with at most {PLACED_EDGES} edges"
        )


def flaws_of(kind: LighthouseKind, edges: int) -> Iterator[str]:
    """Why a lighthouse is no function of the world, for each small map where it is none.

    Each place is there once. Asked twice it senses and tells the same. Under other names of the
    darts there are the same places in the same order, the same is sensed and told there, and the
    robot may do the same with marks. It gives marks and bearings, and lets the robot leave some,
    only if it says so. It is read again as it was written.
    """
    names = Random(edges)  # noqa: S311  # any names
    for level in range(1, edges + 1):
        for map_ in rooted_maps(level):
            other = [*map_.darts]
            names.shuffle(other)
            if wrong := _flaw(kind.as_class, map_, other):
                yield f"the lighthouse {kind} in {map_}: {wrong}"


def _flaw(kind: type[Lighthouse], map_: CombinatorialMap, other: Sequence[int]) -> str:
    places = [*kind.places(map_, 0)]
    for number, place in enumerate(places):
        if place in places[:number]:
            return f"the place {place} is there twice"
    if places != [*kind.places(map_, 0)]:
        return "asked twice, it has other places"
    renamed = [*kind.places(map_.relabelled(other), other[0])]
    if renamed != [place.relabelled(other) for place in places]:
        return f"with the darts renamed to {[*other]}, it has the places {renamed}"
    found = (_flaw_at(World(map_, place), other) for place in places)
    return next((wrong for wrong in found if wrong), "")


def _flaw_at(world: World, other: Sequence[int]) -> str:
    place, sensed, renamed = world.lighthouse, world.percepts, world.relabelled(other)
    named = f"with the darts renamed to {[*other]}"
    if sensed != place.percepts(world.map):
        return f"asked twice, {place} senses something else"
    for dart in world.map.darts:
        if (there := renamed.percepts[other[dart]]) != sensed[dart]:
            return f"{place} senses '{sensed[dart]}' at dart {dart}, and '{there}' {named}"
    if world.told != world.told:
        return f"asked twice, {place} tells something else"
    if world.told != renamed.told:
        return f"{place} tells {world.told}, and {renamed.told} {named}"
    if not place.as_kind.gives_marks and any(percept.marks for percept in sensed):
        return f"{place} gives marks, but gives_marks is False"
    if not place.as_kind.gives_bearings and any(percept.bearing is not None for percept in sensed):
        return f"{place} gives bearings, but gives_bearings is False"
    if World.from_json(world.to_json()) != world:
        return f"{place} is read otherwise than it is written"
    return _flaw_on_a_walk(world, renamed, named)


def _flaw_on_a_walk(world: World, renamed: World, named: str) -> str:
    """Why the marks that the robot leaves are no function of what it does; empty if they are."""
    kind, state, there = world.lighthouse.as_kind, world.initial, renamed.initial
    if state.hand != there.hand:
        return f"in_hand is {state.hand}, and {there.hand} {named}"
    random, done = Random(len(world.map.darts)), ""  # noqa: S311  # any walk
    for _ in range(STEPS if kind.leaves_marks else 1):
        moves = [Move(k) for k in range(world.percepts[state.dart].degree)]
        free = [a for a in (Drop(), Pick(), Write(0), Write(1)) if not refused(world, state, a)]
        if free and not kind.leaves_marks:
            return f"the robot may {free[0]}, but leaves_marks is False"
        action = random.choice([*moves, *free * len(moves)])
        done += f"{', ' if done else ''}{action}"
        if refused(renamed, there, action):
            return f"'{action}' is legal after '{done}', and not so {named}"
        after = world.step(state, action)
        if world.step(state, action) != after:
            return f"done twice, '{done}' leads to something else"
        state, (there, sensed) = after[0], renamed.step(there, action)
        if sensed != after[1]:
            return f"after '{done}' it senses '{after[1]}', and '{sensed}' {named}"
    return ""


def refused(world: World, state: object, action: Action) -> str:
    """The reason why an action is illegal in a state; empty if it is legal."""
    try:
        world.step(state, action)  # type: ignore[arg-type]
    except IllegalAction as error:
        return str(error)
    return ""


def _lighthouse(given: object) -> LighthouseKind | None:
    return None if given is None else tried_kind(given)


class LighthouseOptions(Request):
    """The part of a request that names the kind of lighthouse."""

    lighthouse: Annotated[
        Taken[GivenLighthouse | None, LighthouseKind | None],
        Option(
            SCOPE,
            "KIND",
            f"KIND[:key=value,...]: {one_of(LIGHTHOUSES)}, {OWN}, or several with + between them "
            "[default: directional, or the one that a built-in explorer is written for].",
            told=Annotated[Text, about("`KIND[:key=value,...]`")],
        ),
    ] = Taken(_lighthouse, None)
