"""Section VII: lattices and dense graphs with holes, and how far below the bound they stay."""

from __future__ import annotations

import csv
from pathlib import Path
from statistics import mean

from allworlds import World
from allworlds.claims import Found, Means, truth
from allworlds.maps import family as map_of
from formulas import paper_bound
from passes import PassWalked, passes_of

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


PARTS = "tests never made", "order of passes", "shorter tests", "walks to ends"


def parts_of_gap(world: World, passes: list[PassWalked]) -> tuple[int, ...]:
    """The parts of (1)+(2) that a run does not need, as ``PARTS``; with its cost they add up to it.

    A pass is charged with n_s traversals to the end, and with 2(n_s - 1) for each dart of U; in the
    bound all passes that find a vertex come first.
    """
    m = world.map.edge_count
    darts = [2 * (m - one.explored) for one in passes]
    tests = [2 * (one.vertices - 1) for one in passes]
    never = sum(
        each * (most - len(one.tests)) for one, most, each in zip(passes, darts, tests, strict=True)
    )
    shorter = sum(
        each * len(one.tests) - sum(one.tests) for one, each in zip(passes, tests, strict=True)
    )
    charged = sum(
        one.vertices + each * most for one, most, each in zip(passes, darts, tests, strict=True)
    )
    order = paper_bound(world.map.vertex_count, m) - charged
    return never, order, shorter, sum(one.vertices - one.walk for one in passes)


def gap_parts(_: Means, *, families: list[str], seeds: int, percent: dict[str, list[int]]) -> Found:
    """By family the shares of the four parts of all gaps, each within its limits in percent."""
    sums: dict[str, list[int]] = {}
    runs = exact = 0
    for family, world in _worlds(families, seeds):
        passes = passes_of(world)
        cost = sum(one.cost for one in passes)
        gap = paper_bound(world.map.vertex_count, world.map.edge_count) - cost
        parts = parts_of_gap(world, passes)
        exact += sum(parts) == gap and min(parts) >= 0
        known = sums.setdefault(family, [0] * len(PARTS))
        sums[family] = [a + b for a, b in zip(known, parts, strict=True)]
        runs += 1
    shares = {
        name: [round(each[i] / sum(each), 4) for each in sums.values()]
        for i, name in enumerate(PARTS)
    }
    limits = [(100 * min(shares[name]), 100 * max(shares[name]), *percent[name]) for name in PARTS]
    within = all(low <= least and most <= high for least, most, low, high in limits)
    witnesses = {"runs": runs, "runs whose parts add up": exact}
    return Found(truth(exact == runs and within), witnesses, shares)


FIGURE_3 = Path(__file__).parent / "figures" / "figure-3-means.csv"
"""The means of Fig. 3, as ``figures/means.py`` has written them."""


def means_above_2m(
    _: Means, *, families: list[str], seeds: int, policies: list[str], times: int
) -> Found:
    """Compare the mean of each family and policy with times * m, and those of Fig. 3 on file."""
    drawn: dict[tuple[str, str], list[float]] = {}
    for family, world in _worlds(families, seeds):
        for policy in policies:
            cost = sum(one.cost for one in passes_of(world, policy))
            drawn.setdefault((family, policy), []).append(cost / world.map.edge_count)
    ours = [mean(shares) for shares in drawn.values()]
    with FIGURE_3.open(encoding="utf-8", newline="") as file:
        kept = [float(row["mean"]) / int(row["edges"]) for row in csv.DictReader(file)]
    witnesses = {"means": len(ours), "means of Fig. 3": len(kept)}
    figures = {
        "least mean / m": round(min(ours), 2),
        "least mean / m of Fig. 3": round(min(kept), 2),
    }
    return Found(truth(min(*ours, *kept) > times), witnesses, figures)
