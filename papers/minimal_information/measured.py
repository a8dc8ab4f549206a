"""Section VII: lattices and dense graphs with holes, and how far below the bound they stay."""

from __future__ import annotations

from allworlds import World
from allworlds.claims import Found, Means, truth
from allworlds.maps import family as map_of
from formulas import paper_bound
from passes import passes_of

HOLES = 0.1


def _worlds(families: list[str], seeds: int) -> list[tuple[str, World]]:
    return [
        (family, World(map_of(family, holes=HOLES, seed=seed), "directional"))
        for family in families
        for seed in range(seeds)
    ]


def below_bound(_: Means, *, families: list[str], seeds: int, share: float) -> Found:
    """The cost of each run as a share of (1)+(2)."""
    largest: dict[str, float] = {}
    runs = 0
    for family, world in _worlds(families, seeds):
        n, m = world.map.vertex_count, world.map.edge_count
        cost = sum(one.cost for one in passes_of(world))
        largest[family] = max(largest.get(family, 0.0), cost / paper_bound(n, m))
        runs += 1
    shares = [round(value, 4) for value in largest.values()]
    return Found(truth(max(shares) <= share), {"runs": runs}, {"largest shares": shares})


def transit_explains(_: Means, *, families: list[str], seeds: int, share: float) -> Found:
    """Share of the gap that comes from charging each walk to a known end with n_s."""
    explained: dict[str, float] = {}
    runs = 0
    for family, world in _worlds(families, seeds):
        n, m = world.map.vertex_count, world.map.edge_count
        passes = passes_of(world)
        gap = paper_bound(n, m) - sum(one.cost for one in passes)
        saved = sum(one.vertices - one.walk for one in passes)
        explained[family] = max(explained.get(family, 0.0), saved / gap)
        runs += 1
    shares = [round(value, 4) for value in explained.values()]
    return Found(truth(min(shares) >= share), {"runs": runs}, {"largest shares": shares})
