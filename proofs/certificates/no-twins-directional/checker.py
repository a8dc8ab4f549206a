"""No two worlds look alike with a directional lighthouse, up to 5 edges.  See README.md."""

from __future__ import annotations

from pathlib import Path

from lrat import Refused
from lrat_claims import refuted
from maps import World, rooted_maps, rooted_world, twins_among
from world_clauses import Asked, size_of

ASKED = Asked("directional", "maps")
EDGES = 5
ROOTED = [2, 10, 74, 706, 8162]
"""Rooted maps with 1, 2, ... edges: A000698 of the OEIS, shifted."""


def check(folder: Path) -> list[str]:
    """Check the claim, and return in sentences what holds."""
    said = []
    worlds: list[World] = []
    for edges in range(1, EDGES + 1):
        size = size_of(ASKED, edges)
        assert size is not None
        files = folder / f"m{edges}.cnf.xz", folder / f"m{edges}.lrat.xz"
        derived = refuted(*files, ASKED, (size, size))
        said.append(f"m = {edges}: the formula is the one meant; LRAT, {derived:,} clauses")
        # Turning is free: the start is the pointed dart.
        level = [rooted_world(map_, "directional") for map_ in rooted_maps(edges)]
        if len(level) != ROOTED[edges - 1]:
            raise Refused(f"{len(level)} rooted maps with {edges} edges, not {ROOTED[edges - 1]}")
        worlds += level
    count, twins = twins_among(iter(worlds))
    if twins:
        raise Refused(f"these look alike: {twins}")
    return [*said, f"m <= {EDGES}: {count:,} worlds enumerated, no two look alike"]
