"""Symmetric starts of two robots, one of which begins d rounds later: feasible iff d >= Shrink.

Source: Pelc and Yadav, Using Time to Break Symmetry, 2018, for port numbers.  For rotations: with
the words of ``shrink.py`` the later robot is where, in the other copy, the earlier one was d rounds
ago, so they are s - d apart at least.  With d >= s the earlier one walks to where the later comes.
Dispersion: Augustine and Moses, Dispersion of Mobile Robots, ICDCN 2018; of anonymous robots Das,
Bose, Sau, arXiv 2008.00701.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from allworlds import Automaton, CombinatorialMap, Move, Percept
from allworlds.claims import Found, Means, truth
from allworlds.robots import search
from check import common_words, never_together
from shrink import Pair, by_word, distance, shrink_by_walk, words_from
from small_automata import two_states
from worlds import EDGE, PATH_3, named, ring, simple_worlds, starts_apart


def ahead(map_: CombinatorialMap, pair: Pair, delay: int) -> Automaton:
    """The program that leads both near each other, and then over to the other's place."""
    words = words_from(map_, pair) or {}
    near = min(words, key=lambda each: (distance(map_, *each), len(words[each])))
    over = path_between(map_, *near)
    return by_word([*words[near], *over, *[None] * (delay - len(over))])


def path_between(map_: CombinatorialMap, one: int, other: int) -> list[int]:
    """The turns of a shortest walk from a dart to the vertex of another."""
    turns = []
    while left := distance(map_, one, other):
        around = range(map_.degree_at[one])
        turns.append(next(k for k in around if distance(map_, map_.move(one, k), other) < left))
        one = map_.move(one, turns[-1])
    return turns


def meet_late(map_: CombinatorialMap, pair: Pair, program: Automaton, delay: int) -> bool:
    """Whether two of a program meet, the first of which is so many rounds ahead."""
    memory, (dart, other) = program.start, pair
    for _ in range(delay):
        memory, action = program.step(memory, Percept(map_.degree_at[dart]))
        dart = map_.move(dart, action.k) if isinstance(action, Move) else dart
        if map_.vertex_of[dart] == map_.vertex_of[other]:
            return True
    team = [Automaton(memory, program.step), program]
    return search(map_, (dart, other), named("meeting"), team, "fsync").holds


def delays(_: Means, *, rings: list[int], most: int) -> Found:
    """Search the program for each delay from Shrink on, and all automata of two states below it."""
    yes = no = wrong = searched = 0
    least: list[int] = []
    for map_ in (EDGE, *map(ring, rings)):
        automata = [*two_states([map_.degree_at[0]])]
        shrinks = {pair: shrink_by_walk(map_, pair) or 0 for pair in starts_apart(map_)}
        least.append(max(shrinks.values()))
        for pair, shrink in shrinks.items():
            for delay in range(shrink):
                no, searched = no + 1, searched + len(automata)
                wrong += not never_together(map_.sigma, map_.alpha, *pair, delay)
                wrong += any(meet_late(map_, pair, each, delay) for each in automata)
            for delay in range(shrink, most + 1):
                yes += 1
                wrong += not meet_late(map_, pair, ahead(map_, pair, delay), delay)
    witnesses = {"feasible": yes, "infeasible": no, "automata": searched}
    return Found(truth(not wrong), witnesses, {"least delay for all": least})


@dataclass(frozen=True)
class Dispersion(type(named("meeting"))):  # type: ignore[misc]  # the model of that name
    """Robots that shall be at different vertices."""

    def over(self, map_: CombinatorialMap, state: Any) -> bool:
        """Whether they are."""
        return len({map_.vertex_of[dart] for dart in state.darts}) == len(state.darts)


go = Automaton(None, lambda memory, _percept: (memory, Move(0)))
"""The robot that leaves by its own dart."""


def dispersion(_: Means, *, edges: int) -> Found:
    """On one dart they stay together whatever they do; else each goes by its own dart."""
    together = parted = wrong = searched = 0
    for map_ in simple_worlds(edges):
        pairs = common_words(map_.sigma, map_.alpha, 0, 0) or {(0, 1)}
        together += 1
        wrong += any(one != other for one, other in pairs)
        for dart in map_.vertices[map_.vertex_of[0]][1:]:
            parted += 1
            wrong += not search(map_, (0, dart), Dispersion(), [go] * 2, "fsync").holds
    for map_, degrees in ((EDGE, [1]), (ring(3), [2]), (PATH_3, [1, 2])):
        for program in two_states(degrees):
            searched += 1
            found = search(map_, (0, 0), Dispersion(), [program] * 2, "fsync")
            wrong += found.law != "progress"
    witnesses = {"worlds with both on one dart": together, "starts on two darts": parted}
    return Found(truth(not wrong), {**witnesses, "automata": searched})
