"""The smallest pairs that look alike when only the position is marked.  See README.md."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from documents import members, pair_of, read_json
from lrat import Refused
from lrat_claims import refuted
from maps import (
    Map,
    is_planar,
    is_simple,
    require_bisimulation,
    rooted_maps,
    rooted_world,
    twins_among,
    vertex_count,
    world_code,
)
from world_clauses import Asked, size_of

SIMPLE = {"maps": False, "simple": True, "planar-simple": True}
BELOW: dict[str, list[tuple[int, int | None]]] = {
    "maps": [(1, None)],
    "simple": [(m, None) for m in range(1, 6)],
    "planar-simple": [*[(m, None) for m in range(1, 8)], (8, 6)],
}
"""For each class the edges, and the largest number of vertices, where there is no pair."""

PAIR = {"maps": (2, 1), "simple": (6, 4), "planar-simple": (8, 7)}
"""Edges and vertices of the pairs."""


def check(folder: Path) -> list[str]:
    """Check the claim, and return in sentences what holds."""
    said = []
    require_pairs(read_json(folder / "pairs.json"))
    for name, levels in BELOW.items():
        said.append(f"{name}: a pair with m = {PAIR[name][0]}, n = {PAIR[name][1]}")
        for edges, most in levels:
            if most is None:
                _refute(folder, name, edges)
        maps = (map_ for edges, most in levels for map_ in _members(name, edges, most))
        worlds, twins = twins_among(rooted_world(map_, "position") for map_ in maps)
        if twins:
            raise Refused(f"{name}: a smaller pair: {twins}")
        proofs = [edges for edges, most in levels if most is None]
        said.append(f"{name}: no smaller one: LRAT for m = {proofs[0]}..{proofs[-1]}")
        edges, most = levels[-1]
        beyond = f" and for m = {edges}, n <= {most}" if most else ""
        said.append(f"{name}: {worlds:,} rooted maps enumerated up to there{beyond}")
    return said


def _refute(folder: Path, name: str, edges: int) -> None:
    asked = Asked("position", name)
    size = size_of(asked, edges)
    assert size is not None
    files = folder / f"{name}-m{edges}.cnf.xz", folder / f"{name}-m{edges}.lrat.xz"
    refuted(*files, asked, (size, size))


def _members(name: str, edges: int, most: int | None) -> Iterator[Map]:
    for map_ in rooted_maps(edges, simple=SIMPLE[name], most=most):
        if name != "planar-simple" or is_planar(map_):
            yield map_


def require_pairs(document: Any) -> None:
    """Raise Refused unless the pairs are as README.md says.

    Raises:
        Refused: saying what is wrong.
    """
    for name, entry in members(document, set(BELOW), "pairs.json").items():
        pair, classes = pair_of(entry, "position")
        require_bisimulation(pair, classes)
        for world in pair:
            if (len(world.sigma) // 2, vertex_count(world.map)) != PAIR[name]:
                raise Refused(f"{name}: the pair has not the size that is claimed")
            if SIMPLE[name] and not is_simple(world.map):
                raise Refused(f"{name}: a world is not simple")
            if name == "planar-simple" and not is_planar(world.map):
                raise Refused(f"{name}: a world is not planar")
        if world_code(pair[0]) == world_code(pair[1]):
            raise Refused(f"{name}: the two worlds are the same")
