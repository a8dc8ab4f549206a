"""Start pairs of two robots by Shrink: the least distance to which one word of moves leads both.

Symmetric starts, from which all walks look alike, keep all that two equal programs do the same.
Let S be the set of pairs of darts to which words of moves lead from (a, b), and s the least
distance in S.  *Two deterministic anonymous robots that start at the same time from symmetric
a and b, with s > 0, never meet.*  Proof: before any round let both have sensed the same, and let
their darts be a pair in S.  Then they do the same, Move(k) for one k or nothing, so their darts are
again a pair in S.  They are at two vertices, for s > 0, and sense the same: the degrees are equal,
for the starts are symmetric, and neither sees the other.  By induction it is so for ever.  With
s = 0 the word that leads both to one vertex is a program, so a rotation system is no port
numbering: there symmetric starts are infeasible.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import combinations, product
from typing import Any

from allworlds import Automaton, CombinatorialMap, Move, Wait
from allworlds.claims import Found, Means, truth
from allworlds.maps import distances, project
from allworlds.robots import search
from check import never_together
from small_automata import two_states
from worlds import EDGE, PATH_3, PATH_4, STAR_3, named, ring, simple_worlds, starts_apart

NAMED = {"edge": EDGE, "path of 3": PATH_3, "path of 4": PATH_4, "star": STAR_3}
NAMED |= {"triangle": ring(3), "square": ring(4)}

Pair = tuple[int, int]


def distance(map_: CombinatorialMap, one: int, other: int) -> int:
    """The distance of the vertices of two darts."""
    return distances(map_, map_.vertex_of[one])[map_.vertex_of[other]]


def words_from(map_: CombinatorialMap, pair: Pair) -> dict[Pair, tuple[int, ...]] | None:
    """A shortest word of moves to each pair that is reached; None if the views differ."""
    words: dict[Pair, tuple[int, ...]] = {pair: ()}
    queue = [pair]
    for one, other in queue:
        if map_.degree_at[one] != map_.degree_at[other]:
            return None
        for k in range(map_.degree_at[one]):
            after = map_.move(one, k), map_.move(other, k)
            if after not in words:
                words[after] = (*words[one, other], k)
                queue.append(after)
    return words


def shrink_by_walk(map_: CombinatorialMap, pair: Pair) -> int | None:
    """Shrink by a walk over pairs of darts; None if the starts are not symmetric."""
    words = words_from(map_, pair)
    return None if words is None else min(distance(map_, *each) for each in words)


def shrink_by_classes(map_: CombinatorialMap) -> dict[Pair, int]:
    """Shrink of all symmetric pairs: the bisimulation of the darts, then distances that relax."""
    classes = project((map_, map_.degree_at, 0)).classes
    alike = [pair for pair in product(map_.darts, repeat=2) if len({classes[d] for d in pair}) == 1]
    least = {pair: distance(map_, *pair) for pair in alike}
    changed = True
    while changed:
        changed = False
        for one, other in alike:
            for k in range(map_.degree_at[one]):
                after = least[map_.move(one, k), map_.move(other, k)]
                if after < least[one, other]:
                    least[one, other], changed = after, True
    return least


def counted(map_: CombinatorialMap, pairs: Sequence[Pair]) -> tuple[Counter[int | None], bool]:
    """The number of these pairs by Shrink, and whether both ways agree on each."""
    least, found, agree = shrink_by_classes(map_), Counter[int | None](), True
    for pair in pairs:
        shrink = shrink_by_walk(map_, pair)
        agree = agree and shrink == least.get(pair)
        found[shrink] += 1
    return found, agree


def shrink_named(_: Means) -> Found:
    """Count the pairs of darts at two vertices of some worlds: not symmetric, Shrink 0, 1, 2."""
    figures, right, total = {}, True, 0
    for name, map_ in NAMED.items():
        at = map_.vertex_of
        pairs = [(a, b) for a, b in combinations(map_.darts, 2) if at[a] != at[b]]
        found, agree = counted(map_, pairs)
        right, total = right and agree, total + len(pairs)
        figures[name] = [found[key] for key in (None, 0, 1, 2)]
    return Found(truth(right), {"pairs": total}, figures)


def shrink_worlds(_: Means, *, edges: int) -> Found:
    """Count the pairs of all simple worlds by Shrink in two ways."""
    found, right = Counter[int | None](), True
    for map_ in simple_worlds(edges):
        here, agree = counted(map_, [*starts_apart(map_)])
        right = right and agree
        found += here
    largest = max(shrink for shrink in found if shrink is not None)
    table = [found[shrink] for shrink in range(largest + 1)]
    figures = {"not symmetric": found[None], "by Shrink": table}
    rarer = table == sorted(table, reverse=True) and 2 * found[None] > found.total()
    return Found(truth(right and rarer), {"pairs": found.total()}, figures)


def by_word(word: Sequence[int | None]) -> Automaton:
    """The program that makes these moves, waits where there is None, and then for ever."""

    def step(place: int, _percept: Any) -> tuple[int, Any]:
        turn = word[place] if place < len(word) else None
        return min(place + 1, len(word)), Wait() if turn is None else Move(turn)

    return Automaton(0, step)


def shrink_zero(_: Means, *, edges: int) -> Found:
    """Let both robots follow the word that leads them to one vertex, in each symmetric start."""
    pairs, missed, longest, model = 0, 0, 0, named("meeting")
    for map_ in simple_worlds(edges):
        for pair in starts_apart(map_):
            words = words_from(map_, pair) or {}
            together = [word for each, word in words.items() if distance(map_, *each) == 0]
            if together:
                word = min(together, key=len)
                found = search(map_, pair, model, [by_word(word)] * 2, "fsync")
                pairs, missed = pairs + 1, missed + (not found.holds)
                longest = max(longest, len(word))
    return Found(truth(not missed), {"pairs": pairs}, {"longest word": longest})


def shrink_positive(_: Means, *, rings: list[int], edges: int) -> Found:
    """Check the proof's set of pairs by a program of its own; search all automata of two states."""
    pairs = automata = met = unproved = 0
    for map_ in simple_worlds(edges):
        for pair in starts_apart(map_):
            if shrink_by_walk(map_, pair):
                pairs += 1
                unproved += not never_together(map_.sigma, map_.alpha, *pair)
    model = named("meeting")
    for map_, degrees in ((EDGE, [1]), (PATH_4, [1, 2]), *((ring(n), [2]) for n in rings)):
        every = [*two_states(degrees)]
        for pair in starts_apart(map_):
            if shrink_by_walk(map_, pair):
                automata += len(every)
                for program in every:
                    met += search(map_, pair, model, [program] * 2, "fsync").law != "progress"
    return Found(truth(not met and not unproved), {"pairs": pairs, "searches": automata})
