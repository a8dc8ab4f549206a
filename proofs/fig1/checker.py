"""The two candidates for Fig. 1 of the paper.  See README.md."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from lrat import Refused, read
from lrat_claims import refuted

from maps import (
    World,
    is_planar,
    is_simple,
    marked_code,
    orbit,
    positioned,
    quotient_code,
    replay,
    require_bisimulation,
    rooted_maps,
    twins_among,
    vertex_count,
)

MOTIONS = [1, 1, 2, 2, 1]
PERCEPTS = [(3, False)] * 4 + [(4, True)]
SIZES = {"planar-simple": (14, 9), "wheel": (8, 5)}
SMALLER = [(8, 5), (11, 7)]
"""Edges and vertices that one vertex of degree 4 and others of degree 3 can have below 14, 9."""


def check(folder: Path) -> list[str]:
    """What has been checked, sentence by sentence."""
    said = []
    pairs = json.loads(read(folder / "pairs.json"))
    for name, (edges, vertices) in SIZES.items():
        pair = pairs[name]["pair"]
        require_bisimulation(pair, pairs[name]["bisimulation"])
        for world in pair:
            if (len(world["sigma"]) // 2, vertex_count(_map(world))) != (edges, vertices):
                raise Refused(f"{name}: a world has another size")
            _require_caption(world, name)
        if marked_code(pair[0]) == marked_code(pair[1]):
            raise Refused(f"{name}: the two worlds are the same")
        said.append(f"{name}: n = {vertices}, m = {edges}; caption holds from all 4 starts")
    if not all(map(is_planar, map(_map, pairs["planar-simple"]["pair"]))):
        raise Refused("planar-simple: a world is not planar")
    derived = refuted(folder, "search-m8", [], "position")
    said.append(f"no planar simple pair with m = 8 has the caption: LRAT, {derived:,} clauses")
    for edges, vertices in SMALLER:
        maps = rooted_maps(edges, simple=True, most=vertices, degrees=(4, 3))
        count, twins = twins_among(positioned(map_) for map_ in maps if is_planar(map_))
        if twins:
            raise Refused(f"a smaller planar simple pair: {twins}")
        said.append(f"nor any with m = {edges}, n = {vertices}: {count} rooted maps enumerated")
    found = _look_alike(*SIZES["planar-simple"])
    if found != [{marked_code(world) for world in pairs["planar-simple"]["pair"]}]:
        raise Refused("planar-simple: not the only worlds of this size that look alike")
    said.append("and with m = 14, n = 9 this pair is the only one: enumerated")
    return said


def _look_alike(edges: int, vertices: int) -> list[set[Any]]:
    """The worlds of this size and these degrees that look like others, by what they look like."""
    groups: dict[Any, set[Any]] = {}
    for map_ in rooted_maps(edges, simple=True, most=vertices, degrees=(4, 3)):
        if is_planar(map_):
            world = positioned(map_)
            groups.setdefault(quotient_code(world), set()).add(marked_code(world))
    return [worlds for worlds in groups.values() if len(worlds) > 1]


def _map(world: World) -> tuple[list[int], list[int]]:
    return world["sigma"], world["alpha"]


def _require_caption(world: World, name: str) -> None:
    sigma, home = world["sigma"], orbit(world["sigma"], world["start"])
    if world["lighthouse"]["kind"] != "position" or not is_simple(_map(world)):
        raise Refused(f"{name}: not a simple world with its position marked")
    degrees = [len(orbit(sigma, d)) for d in range(len(sigma)) if d not in home]
    if len(home) != 4 or set(degrees) != {3}:
        raise Refused(f"{name}: degrees other than 4 at the marker and 3 elsewhere")
    for start in home:
        if replay(world, start, MOTIONS) != PERCEPTS:
            raise Refused(f"{name}: from dart {start} the caption's walk senses something else")
