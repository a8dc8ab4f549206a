"""Two worlds with a natural lighthouse that look alike, and that none are smaller."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

from lrat import Refused, read

from maps import (
    World,
    is_planar,
    marked_code,
    orbit,
    positioned,
    require_bisimulation,
    rooted_maps,
    twins_among,
    vertex_count,
)

EDGES, VERTICES = 4, 2


def check(folder: Path) -> list[str]:
    """What has been checked, sentence by sentence."""
    entry = json.loads(read(folder / "pair.json"))
    pair = entry["pair"]
    require_bisimulation(pair, entry["bisimulation"])
    for world in pair:
        if not _has_natural_lighthouse(world):
            raise Refused("v0 or its neighbour v1 has no degree of its own")
        size = len(world["sigma"]) // 2, vertex_count((world["sigma"], world["alpha"]))
        if size != (EDGES, VERTICES):
            raise Refused(f"a world has {size} edges and vertices")
    if _told(pair[0]) != _told(pair[1]):
        raise Refused("the two robots are told different degrees of v1")
    if marked_code(pair[0]) == marked_code(pair[1]):
        raise Refused("the two worlds are the same")
    if [is_planar((w["sigma"], w["alpha"])) for w in pair] != [True, False]:
        raise Refused("they are not one in the plane and one on the torus")
    count, twins = twins_among(_worlds(EDGES - 1))
    if twins:
        raise Refused(f"a smaller pair: {twins}")
    return [
        "a pair with n = 2, m = 4: plane and torus, degrees 2 and 6, the same is told",
        f"no smaller one: {count} worlds with m <= {EDGES - 1} enumerated",
    ]


def _worlds(most: int) -> Iterator[World]:
    for edges in range(1, most + 1):
        for map_ in rooted_maps(edges):
            world = positioned(map_, "natural")
            if _has_natural_lighthouse(world):
                yield world


def _told(world: World) -> int:
    """The degree of v1, where there is exactly one candidate; the largest where there are more."""
    return max(_unique_neighbours(world))


def _has_natural_lighthouse(world: World) -> bool:
    return bool(_unique_neighbours(world))


def _unique_neighbours(world: World) -> set[int]:
    """Degrees of neighbours of v0 that no other vertex has; empty unless v0's is so too."""
    sigma, alpha = world["sigma"], world["alpha"]
    home = orbit(sigma, world["start"])
    vertices = {min(orbit(sigma, d)): len(orbit(sigma, d)) for d in range(len(sigma))}
    degrees = list(vertices.values())
    if degrees.count(len(home)) > 1:
        return set()
    around = {len(orbit(sigma, alpha[d])) for d in home if alpha[d] not in home}
    return {degree for degree in around if degrees.count(degree) == 1}
