"""No two worlds look alike with a directional lighthouse, up to 5 edges.  See README.md."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from lrat import Refused
from lrat_claims import refuted

from maps import World, code, quotient_code, rooted_maps

EDGES = 5
BY_ENUMERATION = 5
ROOTED = [2, 10, 74, 706, 8162]
"""Rooted maps with 1, 2, ... edges: A000698 of the OEIS, shifted."""


def check(folder: Path) -> list[str]:
    """What has been checked, sentence by sentence."""
    said = []
    for edges in range(1, EDGES + 1):
        maps = list(rooted_maps(edges))
        if len(maps) != ROOTED[edges - 1]:
            raise Refused(f"{len(maps)} rooted maps with {edges} edges, not {ROOTED[edges - 1]}")
        derived = refuted(folder, f"m{edges}", maps, "directional")
        said.append(f"m = {edges}: LRAT proof, {derived:,} clauses")
    seen: dict[object, object] = {}
    worlds = 0
    for world in _worlds():
        worlds += 1
        mine = code(world["sigma"], world["alpha"], world["start"])
        if seen.setdefault(quotient_code(world), mine) != mine:
            raise Refused(f"{world} looks like another world")
    return [*said, f"m <= {BY_ENUMERATION}: {worlds:,} worlds enumerated, no two look alike"]


def _worlds() -> Iterator[World]:
    """Every world whose start is the pointed dart; turning is free."""
    for edges in range(1, BY_ENUMERATION + 1):
        for sigma, alpha in rooted_maps(edges):
            lighthouse = {"kind": "directional", "dart": 0}
            yield {"sigma": sigma, "alpha": alpha, "start": 0, "lighthouse": lighthouse}
