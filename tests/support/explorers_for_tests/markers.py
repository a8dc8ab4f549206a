"""Explorers that drop and pick up markers, rightly and wrongly."""

from allworlds import CombinatorialMap, Drop, Estimate, Move, Pick
from allworlds.explorers.builtin.algorithm1 import algorithm1_cluster

EDGE = CombinatorialMap((0, 1), (1, 0))


def lays_a_cluster(first):
    """One marker at v0, two at a neighbour: then as where the cluster stands from the beginning."""
    percept = yield Drop()
    for _ in range(first.degree):
        seen = yield Move(1)
        if seen.marks == 0:
            yield Drop()
            yield Drop()
            percept = yield Move(0)
            break
        percept = yield Move(0)
    return (yield from algorithm1_cluster(percept))


def marks_its_start(first):
    """Drops its only marker, and answers with the map of one edge."""
    yield Drop()
    yield Move(0)
    return Estimate(EDGE, 1)


def drops_and_takes(first):
    """Drops, walks on, comes back, takes up again; then answers with the map of one edge."""
    yield Drop()
    yield Move(0)
    yield Move(0)
    yield Pick()
    return Estimate(EDGE, 0)


def drops_two(first):
    yield Drop()
    yield Drop()
    return Estimate(EDGE, 0)


def takes_where_none_lies(first):
    yield Drop()
    yield Move(0)
    yield Pick()
    return Estimate(EDGE, 0)


def takes_at_once(first):
    yield Pick()
    return Estimate(EDGE, 0)


def plays_with_its_marker(first):
    """Never ends, and never moves."""
    while True:
        yield Drop()
        yield Pick()


def drops_a_class(first):
    """Yields the type in place of a value."""
    yield Drop
    return Estimate(EDGE, 0)


class Heavy(Drop):
    """Looks like a Drop, and is none."""


def drops_something_else(first):
    yield Heavy()
    return Estimate(EDGE, 0)


RUNS = []


def drops_now_and_then(first):
    """Keeps from run to run whether it has dropped."""
    RUNS.append(first)
    if len(RUNS) % 2:
        yield Drop()
    return Estimate(EDGE, 0)
    yield


def in_a_cluster(first):
    """A cluster that stands from the beginning."""
    return (yield from algorithm1_cluster(first))
