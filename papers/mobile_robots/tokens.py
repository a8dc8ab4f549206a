"""Robots with a token each that stays where it is laid down, on rings: where they can meet.

Source: Kranakis, Krizanc, Santoro, Sawchuk, Mobile Agent Rendezvous in a Ring, ICDCS 2003, for one
orientation; for any number Gasieniec, Kranakis, Krizanc, Zhang, SOFSEM 2006.  Facing: ours.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from allworlds import Automaton
from allworlds.claims import Found, Means, truth
from allworlds.robots import search
from check import kept_apart
from tokens_on_rings import onward, round_once
from worlds import arrangements, is_periodic, named, ring


def is_right(vertices: int, starts: Sequence[int], program: Automaton, *, feasible: bool) -> bool:
    """Whether the robots meet if that is said to be feasible, and else are kept apart for ever."""
    model, map_ = named("tokens:movable=false"), ring(vertices)
    met = search(map_, starts, model, [program] * len(starts), "fsync").holds
    return met == feasible != kept_apart(map_.sigma, map_.alpha, starts)


def by_distance(
    vertices: int, turned: int, program: Automaton, feasible: Callable[[int, int], bool]
) -> Found:
    """Two robots at each distance on each ring, one of them turned or not."""
    wrong, counts = 0, [0, 0]
    for n in range(3, vertices + 1):
        for distance in range(1, n):
            can = feasible(n, distance)
            counts[can] += 1
            wrong += not is_right(n, (0, 2 * distance + turned), program, feasible=can)
    return Found(truth(not wrong), {"feasible": counts[True], "infeasible": counts[False]})


def tokens_one_way(_: Means, *, vertices: int) -> Found:
    """Two robots with one orientation."""
    return by_distance(vertices, 0, round_once(2), lambda n, distance: 2 * distance != n)


def tokens_facing(_: Means, *, vertices: int) -> Found:
    """Two robots that face each other."""
    return by_distance(vertices, 1, onward, lambda n, distance: n % 2 == 1 or distance % 2 == 0)


def tokens_more(_: Means, *, vertices: int, robots: int) -> Found:
    """More robots with one orientation, in each arrangement on each ring."""
    wrong, periodic, counts = 0, 0, list[int]()
    for k in range(3, robots + 1):
        program = round_once(k)
        for n in range(k, vertices + 1):
            starts = arrangements(n, k)
            counts.append(len(starts))
            for start in starts:
                still = is_periodic(start, n)
                periodic += still
                wrong += not is_right(n, start, program, feasible=not still)
    witnesses = {"arrangements": sum(counts), "periodic": periodic}
    return Found(truth(not wrong), witnesses, {"arrangements by ring": counts})
