"""The two candidates for Fig. 1 of the paper.  See README.md."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from documents import members, pair_of, read_json
from lrat import Refused
from lrat_claims import refuted
from maps import (
    World,
    is_planar,
    is_simple,
    orbit,
    quotient_code,
    replay,
    require_bisimulation,
    rooted_maps,
    rooted_world,
    vertex_count,
    world_code,
)
from world_clauses import Asked, size_of

MOTIONS = [1, 1, 2, 2, 1]
PERCEPTS = [(3, False)] * 4 + [(4, True)]
WALK = tuple((motion, *sensed) for motion, sensed in zip(MOTIONS, PERCEPTS, strict=True))
CAPTION = Asked("position", "planar-simple", marked=4, others=3, walk=WALK)
SIZES = {"planar-simple": (14, 9), "wheel": (8, 5)}
IN_THE_PLANE = {"planar-simple": [True, True], "wheel": [True, False]}
SMALLER = [(8, 5), (11, 7)]
"""Edges and vertices that one vertex of degree 4 and others of degree 3 can have below 14, 9."""


def check(folder: Path) -> list[str]:
    """Check the claim, and return in sentences what holds."""
    codes = require_pairs(read_json(folder / "pairs.json"))
    said = [
        f"{name}: n = {vertices}, m = {edges}; caption holds from all 4 starts"
        for name, (edges, vertices) in SIZES.items()
    ]
    size = size_of(CAPTION, SMALLER[0][0], SMALLER[0][1])
    assert size is not None
    files = folder / "search-m8.cnf.xz", folder / "search-m8.lrat.xz"
    derived = refuted(*files, CAPTION, (size, size))
    said.append(f"no planar simple pair with m = 8 has the caption: LRAT, {derived:,} clauses")
    counts, found = _look_alike([*SMALLER, SIZES["planar-simple"]])
    for (edges, vertices), count in zip(SMALLER, counts, strict=False):
        said.append(f"nor any with m = {edges}, n = {vertices}: {count} rooted maps enumerated")
    if found != [codes["planar-simple"]]:
        raise Refused("planar-simple: not the only worlds up to this size that look alike")
    said.append("and with m = 14, n = 9 this pair is the only one: enumerated")
    return said


def _look_alike(sizes: list[tuple[int, int]]) -> tuple[list[int], list[set[Any]]]:
    """The number of planar maps of each size with these degrees; those that look like others."""
    counts = []
    groups: dict[Any, set[Any]] = {}
    for edges, vertices in sizes:
        maps = rooted_maps(edges, simple=True, most=vertices, degrees=(4, 3))
        worlds = [rooted_world(map_, "position") for map_ in maps if is_planar(map_)]
        counts.append(len(worlds))
        for world in worlds:
            groups.setdefault(quotient_code(world), set()).add(world_code(world))
    return counts, [worlds for worlds in groups.values() if len(worlds) > 1]


def require_pairs(document: Any) -> dict[str, set[Any]]:
    """The codes of the two worlds of each pair, if they are as README.md says.

    Raises:
        Refused: saying what is amiss.
    """
    codes = {}
    for name, entry in members(document, set(SIZES), "pairs.json").items():
        pair, classes = pair_of(entry, "position")
        require_bisimulation(pair, classes)
        for world in pair:
            if (len(world.sigma) // 2, vertex_count(world.map)) != SIZES[name]:
                raise Refused(f"{name}: a world has another size")
            _require_caption(world, name)
        codes[name] = {world_code(world) for world in pair}
        if len(codes[name]) == 1:
            raise Refused(f"{name}: the two worlds are the same")
        if [is_planar(world.map) for world in pair] != IN_THE_PLANE[name]:
            raise Refused(f"{name}: not {IN_THE_PLANE[name]}: whether the worlds are in the plane")
    return codes


def _require_caption(world: World, name: str) -> None:
    sigma, home = world.sigma, orbit(world.sigma, world.start)
    if not is_simple(world.map):
        raise Refused(f"{name}: a world is not simple")
    degrees = [len(orbit(sigma, d)) for d in range(len(sigma)) if d not in home]
    if len(home) != 4 or set(degrees) != {3}:
        raise Refused(f"{name}: degrees other than 4 at the marker and 3 elsewhere")
    for start in home:
        if replay(world, start, MOTIONS) != PERCEPTS:
            raise Refused(f"{name}: from dart {start} the caption's walk senses something else")
