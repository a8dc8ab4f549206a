"""Walks that show worlds: along given motions, or along every edge."""

from __future__ import annotations

from collections.abc import Sequence

from allworlds.maps import CombinatorialMap, Dart
from allworlds.protocol import Move, Transcript
from allworlds.world import World


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
