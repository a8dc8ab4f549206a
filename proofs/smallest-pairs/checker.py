"""The smallest pairs that look alike when only the position is marked.  See README.md."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from lrat import Refused, read
from lrat_claims import refuted

from maps import (
    Map,
    is_planar,
    is_simple,
    marked_code,
    positioned,
    require_bisimulation,
    rooted_maps,
    twins_among,
    vertex_count,
)

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
    """What has been checked, sentence by sentence."""
    said = []
    pairs = json.loads(read(folder / "pairs.json"))
    for name, levels in BELOW.items():
        _require_pair(pairs[name], name)
        said.append(f"{name}: a pair with m = {PAIR[name][0]}, n = {PAIR[name][1]}")
        proofs, worlds = [], 0
        for edges, most in levels:
            maps = list(_members(name, edges, most))
            count, twins = twins_among(positioned(map_) for map_ in maps)
            worlds += count
            if twins:
                raise Refused(f"{name}: a smaller pair: {twins}")
            if (folder / f"{name}-m{edges}.cnf.xz").exists() and most is None:
                refuted(folder, f"{name}-m{edges}", maps, "position")
                proofs.append(edges)
        if proofs != [edges for edges, most in levels if most is None]:
            raise Refused(f"{name}: LRAT proofs for m in {proofs} only")
        said.append(f"{name}: no smaller one: LRAT for m = {proofs[0]}..{proofs[-1]}")
        last = levels[-1]
        beyond = f" and for m = {last[0]}, n <= {last[1]}" if last[1] else ""
        said.append(f"{name}: {worlds:,} rooted maps enumerated up to there{beyond}")
    return said


def _members(name: str, edges: int, most: int | None) -> Iterator[Map]:
    for map_ in rooted_maps(edges, simple=SIMPLE[name], most=most):
        if name != "planar-simple" or is_planar(map_):
            yield map_


def _require_pair(entry: dict[str, Any], name: str) -> None:
    pair = entry["pair"]
    require_bisimulation(pair, entry["bisimulation"])
    for world in pair:
        map_ = (world["sigma"], world["alpha"])
        if world["lighthouse"]["kind"] != "position":
            raise Refused(f"{name}: the lighthouse is not 'position'")
        if (len(map_[0]) // 2, vertex_count(map_)) != PAIR[name]:
            raise Refused(f"{name}: the pair has not the size that is claimed")
        if SIMPLE[name] and not is_simple(map_):
            raise Refused(f"{name}: a world is not simple")
        if name == "planar-simple" and not is_planar(map_):
            raise Refused(f"{name}: a world is not planar")
    if marked_code(pair[0]) == marked_code(pair[1]):
        raise Refused(f"{name}: the two worlds are the same")
