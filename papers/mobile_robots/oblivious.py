"""Oblivious robots on rings that see the whole ring, and shall gather for ever.

Source: Klasing, Markou, Pelc, Gathering Asynchronous Oblivious Mobile Robots in a Ring, TCS 390
(2008), read as Research Report RR-1422-07 of LaBRI: an odd number of robots gathers by Algorithm
Odd-Gathering from all starts but periodic ones.  Two robots never do (Proposition 2.1).  Millet,
Potop-Butucaru, Sznajder, Tixeuil, On the Synthesis of Mobile Robots Algorithms, SSS 2014: rules for
three in rounds.  Both are in ``examples/robots/gathering_three.py``.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import gathering_three
from allworlds import Automaton
from allworlds.claims import Found, Means, truth
from allworlds.robots import search
from check import gathers, turned_onto_itself
from gathering import by_rules, every_rule_set, pairs, to_the_tower
from worlds import (
    SCHEDULERS,
    arrangements,
    is_periodic,
    named,
    placements,
    places_of,
    ring,
    steps_by,
)


def gather_from(start: Sequence[int], vertices: int, program: Automaton, scheduler: Any) -> bool:
    """Whether the robots of this program gather from a start, in every schedule."""
    team = [program] * len(start)
    return search(ring(vertices), start, named("snapshot"), team, scheduler).holds


def gather_as_checked(
    start: Sequence[int], vertices: int, program: Automaton, scheduler: str
) -> bool:
    """The same by the program that shares nothing with the search."""
    return gathers(places_of(start), vertices, steps_by(program), scheduler)


def lcm_counts(_: Means, *, least: int, most: int) -> Found:
    """Arrangements of three robots, and those from which two programs gather in async.

    The others are turned onto themselves.
    """
    classes, gathered, periodic, wrong = [], [], 0, 0
    programs = gathering_three.odd, gathering_three.three
    for n in range(least, most + 1):
        starts, right = arrangements(n, 3), 0
        for start in starts:
            still = is_periodic(start, n)
            periodic += still
            wrong += still != turned_onto_itself(places_of(start), n)
            found = [gather_from(start, n, program, "async") for program in programs]
            found += [gather_as_checked(start, n, program, "async") for program in programs]
            wrong += still in found
            right += all(found)
        classes.append(len(starts))
        gathered.append(right)
    witnesses = {"arrangements": sum(classes), "periodic": periodic}
    return Found(truth(not wrong), witnesses, {"arrangements": classes, "gathered": gathered})


Said = Callable[[int, int, str], bool | None]
"""Whether the naive rule fails: vertices, distance of robots 0 and 1, scheduler; None: unsaid."""


def naive(robots: int, vertices: int, said: Said) -> Found:
    """The arrangements from which the naive rule has a run without gathering, by scheduler."""
    figures: dict[str, list[str]] = {scheduler: [] for scheduler in SCHEDULERS}
    starts_in_all = wrong = 0
    for n in range(3, vertices + 1):
        starts = arrangements(n, robots)
        starts_in_all += len(starts)
        for scheduler in SCHEDULERS:
            failing = 0
            for start in starts:
                fails = not gather_from(start, n, gathering_three.naive, scheduler)
                failing += fails
                wrong += fails == gather_as_checked(start, n, gathering_three.naive, scheduler)
                wrong += said(n, start[1] // 2, scheduler) not in (None, fails)
            figures[scheduler].append(f"{failing}/{len(starts)}")
    return Found(truth(not wrong), {"arrangements": starts_in_all}, figures)


def naive_two(_: Means, *, vertices: int) -> Found:
    """Two robots: in central they fail if opposite, in fsync also at odd distances, else always."""

    def said(n: int, distance: int, scheduler: str) -> bool:
        near = min(distance, n - distance)
        opposite = 2 * near == n
        by_scheduler = {"central": opposite, "fsync": opposite or near % 2 == 1}
        return by_scheduler.get(scheduler, True)

    return naive(2, vertices, said)


def naive_three(_: Means, *, vertices: int) -> Found:
    """Three robots: they fail always, but in fsync."""
    return naive(3, vertices, lambda _n, _distance, name: None if name == "fsync" else True)


def rule_sets(_: Means, *, vertices: int, towers: bool) -> Found:
    """Count the rule sets that gather from all starts, by scheduler, each decided in two ways.

    With ``towers`` the rules where two are at one vertex are all tried; else the third goes there.
    """
    seen, starts = pairs(vertices, (1, 1, 1)), placements(vertices, 3)
    if towers:
        left = [*every_rule_set(seen + pairs(vertices, (1, 2)))]
    else:
        tower = to_the_tower(vertices)
        left = [{**rules, **tower} for rules in every_rule_set(seen)]
    numbers, differ = [len(left)], 0
    for scheduler in ("fsync", "ssync", "async"):
        right = []
        for rules in left:
            program = by_rules(rules)
            holds = all(gather_from(start, vertices, program, scheduler) for start in starts)
            checked = (gather_as_checked(start, vertices, program, scheduler) for start in starts)
            differ += holds != all(checked)
            if holds:
                right.append(rules)
        left = right
        numbers.append(len(left))
    witnesses = {"rule sets": numbers[0], "right ones": numbers[-1]}
    return Found(truth(not differ), witnesses, {"left": numbers})


rule_sets_five = rule_sets_all = rule_sets
