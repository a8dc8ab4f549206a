"""Section II: the world, motions and percepts."""

from __future__ import annotations

from itertools import product

from allworlds import CombinatorialMap, World
from allworlds.claims import Found, Means, truth
from allworlds.maps import rooted_maps


def motions_undone(_: Means, *, edges: int, length: int) -> Found:
    """Every list of motions, walked and undone by ``0, -kr, ..., -k2`` and a turn by ``-k1``."""
    walks = kept = 0
    for m in range(1, edges + 1):
        for map_ in rooted_maps(m):
            degree = max(map_.degrees)
            for n in range(1, length + 1):
                for motions in product(range(degree), repeat=n):
                    walks += 1
                    there = walked(map_, 0, motions)
                    first, *later = motions
                    back = walked(map_, there, [0, *(-k for k in reversed(later))])
                    kept += map_.turn(back, -first) == 0
    return Found(truth(walks == kept), {"walks": walks})


def walked(map_: CombinatorialMap, dart: int, motions: object) -> int:
    """The dart that the motions lead to: each turns by sigma and then crosses the edge."""
    for k in motions:  # type: ignore[attr-defined]
        dart = map_.alpha[map_.turn(dart, k)]
    return dart


def orders_are_shifts(_: Means, *, edges: int) -> Found:
    """At each vertex, for each two darts of entry: the two orders of its edges."""
    pairs = shifts = 0
    for m in range(1, edges + 1):
        for map_ in rooted_maps(m):
            for around in map_.vertices:
                size = len(around)
                orders = [[map_.turn(dart, k) for k in range(size)] for dart in around]
                for one, other in product(orders, repeat=2):
                    pairs += 1
                    cyclic = (other[k:] + other[:k] for k in range(size))
                    shifts += sorted(one) == sorted(around) and one in cyclic
    return Found(truth(pairs == shifts), {"pairs": pairs})


def marker_tells_entry(_: Means, *, edges: int) -> Found:
    """The percepts at v0, by dart of entry: with a direction all different, without all equal."""
    told = entries = 0
    for m in range(1, edges + 1):
        for map_ in rooted_maps(m):
            at_v0 = map_.vertices[map_.vertex_of[0]]
            pointing = World(map_, "directional").percepts
            plain = World(map_, "position").percepts
            entries += len(at_v0)
            told += len({pointing[dart] for dart in at_v0})
            told -= len(at_v0) * (len({plain[dart] for dart in at_v0}) - 1)
    return Found(truth(told == entries), {"entries": entries})
