"""Two worlds with a natural lighthouse that look alike, and that none are smaller."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from documents import pair_of, read_json
from lrat import Refused
from maps import (
    World,
    is_planar,
    orbit,
    require_bisimulation,
    rooted_maps,
    rooted_world,
    twins_among,
    vertex_count,
    world_code,
)

EDGES, VERTICES = 4, 2
DEGREES = (2, 6)
"""Of v0 and of v1."""


def check(folder: Path) -> list[str]:
    """Check the claim, and return in sentences what holds."""
    require_pairs(read_json(folder / "pair.json"))
    count, twins = twins_among(_worlds(EDGES - 1))
    if twins:
        raise Refused(f"a smaller pair: {twins}")
    return [
        "a pair with n = 2, m = 4: plane and torus, degrees 2 and 6, the same is told",
        f"no smaller one: {count} worlds with m <= {EDGES - 1} enumerated",
    ]


def require_pairs(document: Any) -> None:
    """Raise Refused unless the pair is as README.md says.

    Raises:
        Refused: saying what is wrong.
    """
    pair, classes = pair_of(document, "natural")
    require_bisimulation(pair, classes)
    for world in pair:
        size = len(world.sigma) // 2, vertex_count(world.map)
        if size != (EDGES, VERTICES):
            raise Refused(f"a world has {size} edges and vertices")
        v0, v1 = world.start, world.alpha[world.darts[0]]
        degrees = len(orbit(world.sigma, v0)), len(orbit(world.sigma, v1))
        # The robot is told v1's degree: in both worlds the same.
        if degrees != DEGREES or DEGREES[1] not in _unique_neighbours(world):
            raise Refused(f"v0 and the v1 that is named have degrees {degrees}, not {DEGREES}")
    if world_code(pair[0]) == world_code(pair[1]):
        raise Refused("the two worlds are the same")
    if [is_planar(world.map) for world in pair] != [True, False]:
        raise Refused("they are not one in the plane and one on the torus")


def _worlds(most: int) -> Iterator[World]:
    for edges in range(1, most + 1):
        for map_ in rooted_maps(edges):
            world = rooted_world(map_, "natural")
            if _unique_neighbours(world):
                yield world


def _unique_neighbours(world: World) -> set[int]:
    """Degrees of neighbours of v0 that no other vertex has; empty unless v0's is so too."""
    sigma, alpha = world.map
    home = orbit(sigma, world.start)
    vertices = {min(orbit(sigma, d)): len(orbit(sigma, d)) for d in range(len(sigma))}
    degrees = list(vertices.values())
    if degrees.count(len(home)) > 1:
        return set()
    around = {len(orbit(sigma, alpha[d])) for d in home if alpha[d] not in home}
    return {degree for degree in around if degrees.count(degree) == 1}
