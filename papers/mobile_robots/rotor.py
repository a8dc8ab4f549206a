"""The rotor-router: worst lock-in and worst cover of all small simple graphs.

Known: after 2mD steps at most the walk goes round and round an Euler tour of all darts (Yanovski,
Wagner, Bruckstein 2003, as Bampas and others 2009 quote it for all graphs).  The worst numbers
themselves are ours.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import NamedTuple

from allworlds import CombinatorialMap
from allworlds.claims import Found, Means, truth
from allworlds.maps import distances
from allworlds.robots import search
from rotor_router import RotorRouter, go, goes, pointed_way
from worlds import simple_worlds


class Walked(NamedTuple):
    """A walk: steps before those that repeat, their number, steps to cross all, states met."""

    before: int
    period: int
    cover: int
    states: frozenset[object]


def walked(map_: CombinatorialMap, pointers: Sequence[int]) -> Walked:
    """Walk from the root until the state is one that has been."""
    here, times = map_.vertex_of[0], dict[object, int]()
    crossed, cover = set[int](), 0
    while (state := (here, pointers)) not in times:
        times[state] = len(times)
        dart, pointers = pointed_way(map_, here, pointers)
        here = map_.vertex_of[dart]
        edge = min(dart, map_.alpha[dart])
        if edge not in crossed:
            crossed.add(edge)
            cover = len(times)
    return Walked(times[state], len(times) - times[state], cover, frozenset(times))


def rotor_worst(_: Means, *, edges: int) -> Found:
    """Walk from every start with all pointers; the worst of each size, and those on paths."""
    lock_in, cover, walks, wrong, on_paths = [0] * edges, [0] * edges, 0, 0, 0
    for map_ in simple_worlds(edges):
        m = map_.edge_count
        diameter = max(max(distances(map_, v).values()) for v in range(map_.vertex_count))
        path = diameter == m
        for pointers in product(*map_.vertices):
            walk = walked(map_, pointers)
            walks += 1
            wrong += walk.before > 2 * m * diameter or walk.period != 2 * m
            lock_in[m - 1] = max(lock_in[m - 1], walk.before)
            cover[m - 1] = max(cover[m - 1], walk.cover)
            on_paths += path and (walk.before, walk.cover) == ((m - 1) ** 2, m**2)
    squares = [size**2 for size in range(edges + 1)]
    right = not wrong and lock_in == squares[:-1] and cover == squares[1:]
    figures = {"worst lock-in": lock_in, "worst cover": cover}
    return Found(truth(right), {"walks": walks, "worst ones on paths": on_paths}, figures)


def rotor_model(_: Means, *, edges: int) -> Found:
    """Compare the search of the model with the walks, in each world with all pointers at once."""
    worlds = wrong = configurations = 0
    for map_ in simple_worlds(edges):
        walks = [walked(map_, pointers) for pointers in product(*map_.vertices)]
        found = search(map_, [0], RotorRouter(cover=True), [goes])
        wrong += not found.holds or found.longest != max(walk.cover for walk in walks)
        found = search(map_, [0], RotorRouter(), [go])
        states = frozenset[object]().union(*(walk.states for walk in walks))
        wrong += not found.holds or found.configurations != len(states)
        worlds, configurations = worlds + 1, configurations + found.configurations
    return Found(truth(not wrong), {"worlds": worlds, "configurations": configurations})
