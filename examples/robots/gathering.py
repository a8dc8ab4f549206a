"""Gathering of three oblivious robots on a ring, by tables of rules; in ``snapshot``.

A view of a robot is how far the others are in one direction; of both directions the lesser view
comes first.  A rule says for such a pair: stay, go toward the first, or toward the second one.
"""

from itertools import combinations, product

from allworlds import Automaton, Do, Wait

STAY, FIRST, SECOND = range(3)
"""The motions of a rule."""


def seen(robots):
    """The number of robots here, and the distances of others, each with their number."""
    others = [(place, robots[place]) for place in range(1, len(robots)) if robots[place]]
    return robots[0], tuple(others)


def by_rules(rules):
    """The robot of these rules, by pairs of views; where there is none it stays."""

    def step(memory, views):
        rule = rules.get(tuple(seen(view[0]) for view in views), STAY)
        return memory, Wait() if rule == STAY else Do("first" if rule == FIRST else "second")

    return Automaton(None, step)


def pair(places, numbers, robot, ring):
    """Both views of a robot, the lesser one first, where robots are at some vertices."""
    at = [0] * ring
    for place, number in zip(places, numbers, strict=True):
        at[place] = number
    ahead = [at[(places[robot] + step) % ring] for step in range(ring)]
    back = [at[(places[robot] - step) % ring] for step in range(ring)]
    return tuple(seen(robots) for robots in sorted((ahead, back)))


def pairs(ring, numbers):
    """Every pair of views where these numbers of robots are at different vertices."""
    others = combinations(range(1, ring), len(numbers) - 1)
    every = [(0, *rest) for rest in others]
    return sorted(
        {pair(each, numbers, robot, ring) for each in every for robot in range(len(numbers))}
    )


def every_rule_set(each):
    """All rules for these pairs; where both views are equal, toward either side is one choice."""
    for chosen in product(*(range(2 if one == other else 3) for one, other in each)):
        yield dict(zip(each, chosen, strict=True))


def to_the_tower(ring):
    """The rules of the third robot where two are at one vertex: it walks to them; they stay."""
    rules = {}
    for distance in range(1, ring):
        one, other = pair((0, distance), (1, 2), 0, ring)
        rules[one, other] = FIRST if one == other else SECOND  # robots near by make a view greater
    return rules


RING = 5
IN_A_ROW = (1, ((3, 1), (4, 1))), (1, ((1, 1), (2, 1)))  # at an end of three side by side
OPPOSITE = ((1, ((2, 1), (3, 1))),) * 2  # two side by side, as far as can be

explore = by_rules({IN_A_ROW: SECOND, OPPOSITE: FIRST, **to_the_tower(RING)})
