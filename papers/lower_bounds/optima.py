"""Claims about the best worst case of any explorer, and about explorers that never forget."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from functools import partial

import explorers
from allworlds import World, check, worlds
from allworlds.claims import Found, Means, Picture, Unfinished, of_check, truth
from bouquets import bound_of_information, bouquets, cautious_cost, told_apart
from in_every_world import most_expensive
from minimax import ToldApart, minimax
from playing import named, played, run_here


def fewest_traversals(given: Iterable[World], told_apart: ToldApart | None = None) -> int:
    """The fewest traversals that suffice in all these worlds.

    Raises:
        Unfinished: if the strategy that is found, followed in each of them, is wrong or needs
            another number.
    """
    known = [*given]
    solved = minimax(((w.map, w.start, w.lighthouse.dart) for w in known), told_apart)
    if most_expensive(solved.strategy, known) != solved.traversals:
        raise Unfinished(f"the strategy does not need {solved.traversals} traversals")
    return solved.traversals


def optimum(_: Means, *, edges: int) -> Found:
    """Find the optimum by minimax over all worlds with m known."""
    best, runs = list[int](), 0
    every = [*worlds(edges=edges, places="all")]
    for m in range(1, edges + 1):
        given = [world for world in every if world.map.edge_count == m]
        best.append(fewest_traversals(given))
        runs += len(given)
    squares = best == [(m - 1) ** 2 for m in range(1, edges + 1)]
    return Found(truth(squares), {"runs": runs}, {"optimum": best})


def bouquet_minimax(_: Means, *, loops: int) -> Found:
    """Find the optimum in bouquets by minimax, beside what counting and caution say."""
    given = [[*bouquets(c)] for c in range(1, loops + 1)]
    best = [fewest_traversals(some, told_apart) for some in given]
    information = [bound_of_information(len(some)) for some in given]
    cautious = [cautious_cost(c) for c in range(1, loops + 1)]
    between = all(a <= b <= c for a, b, c in zip(information, best, cautious, strict=True))
    squares = best[1:] == [c * c for c in range(2, loops + 1)]
    figures = {"optimum": best, "counting gives": information}
    return Found(truth(between and squares), {"worlds": sum(map(len, given))}, figures)


def run_by_run(_: Means, *, edges: int, one: str, other: str) -> Found:
    """Compare two explorers, first in, first out, in every run: the one never walks more."""
    runs = less = more = 0
    most_expensive_world = None
    for world in worlds(edges=edges, places="all"):
        costs = []
        for name in (one, other):
            told = run_here(name, world)
            if told.finding:
                raise Unfinished(f"{name} breaks a law in {world}")
            costs.append(told.cost)
        runs += 1
        less += costs[0] < costs[1]
        more += costs[0] > costs[1]
        if costs[0] > costs[1] and most_expensive_world is None:
            most_expensive_world = world
    seen = {"runs": runs, "less": less}
    if most_expensive_world is None:
        return Found(truth(more == 0), seen)
    map_ = most_expensive_world.map
    figures = {"runs with more": more, "edges": map_.edge_count, "vertices": map_.vertex_count}
    return Found("refuted", seen, figures, (Picture(f"{one} walks more", most_expensive_world),))


remembering_never_more = greedy_never_more = run_by_run


def never_forgetting_in_bound(means: Means, *, edges: int, explorers: list[str]) -> Found:
    """Check explorers that never forget under all laws, including the bound (1)+(2)."""
    seen: Counter[str] = Counter()
    holds = True
    for name in explorers:
        found = of_check(check(named(name), edges=edges, bound="paper", workers=means.workers))
        holds = holds and found.verdict == "holds"
        seen.update(found.witnesses)
        events = _events(name, edges)
        seen.update({case: events[case] for case in ("case-1", "case-2")})
    return Found(truth(holds), seen)


def _events(name: str, edges: int) -> Counter[str]:
    """How often each thing happens to an explorer, in all its runs."""
    met: Counter[str] = Counter()
    explore = partial(getattr(explorers, name), notice=lambda event: met.update([event]))
    for world in worlds(edges=edges, places="all"):
        played(explore, world)
    return met
