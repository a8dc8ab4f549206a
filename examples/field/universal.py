"""Universal traversal: a word of offsets that visits every vertex, whatever the map and the start.

Source: R. Aleliunas, R. Karp, R. Lipton, L. Lovász, C. Rackoff, Random walks, universal traversal
sequences, and the complexity of maze problems (1979); in this form, where an offset counts from
the dart of arrival, the exploration sequences of M. Koucký (2002).

Lighthouse: ``none``.  Task: ``cover``.  Expected: the word that this file finds HOLDS in the cubic
maps it was found for; without its last offset it is REFUTED there by the law ``task``::

    allworlds check 'universal.py:follows?word=WORD' --lighthouse none --task cover --where cubic

As a program this file finds a shortest word for the cubic maps with at most that many edges:
``python3 universal.py 6`` (for 6 edges some seconds).
"""

import sys
from itertools import count

from allworlds import Move, worlds


def follows(word):
    """The explorer that leaves by these offsets, one after the other, and stops."""

    def explore(first):
        for offset in str(word):
            yield Move(int(offset))

    return explore


def shortest_word(edges: int) -> str:
    """The least shortest word for all cubic maps with at most so many edges.

    The first offset is 1: every start is tried, so another one changes nothing.
    """
    maps = [world.map for world in worlds(edges=edges, lighthouse="none", where="cubic")]
    robots = [(map_, 0, frozenset(range(map_.vertex_count)) - {map_.vertex_of[0]}) for map_ in maps]
    for length in count(1):
        if word := completed(moved(robots, 1), length - 1, "1"):
            return word
    raise AssertionError  # there is a word: the search comes to it


def completed(robots: list, left: int, word: str) -> str:
    """The least word with this beginning and so many offsets more; empty if there is none.

    A robot is a map, the dart by which it has come, and the vertices that are left.
    """
    if not robots:
        return word
    if max(len(unvisited) for *_, unvisited in robots) > left:
        return ""
    longer = (completed(moved(robots, k), left - 1, f"{word}{k}") for k in range(3))
    return next(filter(None, longer), "")


def moved(robots: list, offset: int) -> list:
    """The robots after a motion, without those that are done."""
    after = []
    for map_, dart, unvisited in robots:
        arrived = map_.alpha[map_.turn(dart, offset)]
        if left := unvisited - {map_.vertex_of[arrived]}:
            after.append((map_, arrived, left))
    return after


if __name__ == "__main__":
    word = shortest_word(int(sys.argv[1]))
    print(len(word), word)
