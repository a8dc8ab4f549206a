"""Explorers for the recorded commands: each wrong in a way of its own, none by the clock."""

from allworlds import Automaton, CombinatorialMap, Estimate, Move, Watch


def stays(first):
    """Answers without a step, as if every world were one edge."""
    return Estimate(CombinatorialMap([0, 1], [1, 0]), 0)
    yield


def first_edge(first):
    """Walks one edge, and takes the world for it: right in the smallest world alone."""
    yield Move(0)
    return Estimate(CombinatorialMap([0, 1], [1, 0]), 1)


def crashes(first):
    """Raises at the second vertex of degree 2."""
    p = yield Move(0)
    while p.degree != 2:
        p = yield Move(1)
    raise ValueError("degree 2 is too much")


def says_nonsense(first):
    """Yields what is no action."""
    yield "north"


def walks_for_ever(first):
    """Never answers."""
    while True:
        yield Move(1)


def chooses(first, *, choices):
    """Walks where a choice leads it, and answers with one edge."""
    yield Move(choices.pick([0, 1], of="edge"))
    return Estimate(CombinatorialMap([0, 1], [1, 0]), 1)


def waits(first):
    """Waits until somebody comes."""
    while True:
        yield Watch()


other_end = Automaton(None, lambda memory, percept: (None, Move(0)))
"""Goes to and fro."""
