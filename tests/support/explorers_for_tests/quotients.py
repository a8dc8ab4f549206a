"""Explorers that answer without a map, rightly in worlds of one vertex with two loops."""

from allworlds import Ambiguous, CombinatorialMap, Estimate


def two_loops(first):
    return Ambiguous([0], [0], [first.degree], [first.marks], 0)
    yield


def the_plane(first):
    return Estimate(CombinatorialMap((1, 2, 3, 0), (1, 0, 3, 2)), 0)
    yield


def short_degrees(first):
    return Ambiguous([0], [0], [], [1], 0)
    yield


def here_beyond(first):
    return Ambiguous([0], [0], [4], [1], 1)
    yield


def no_permutation(first):
    return Ambiguous([1], [0], [4], [1], 0)
    yield


def no_involution(first):
    return Ambiguous([1, 2, 0], [1, 2, 0], [4] * 3, [1] * 3, 0)
    yield


def apart(first):
    return Ambiguous([0, 1], [0, 1], [4, 4], [1, 1], 0)
    yield


def no_integers(first):
    return Ambiguous(["0"], [0], [4], [1], 0)
    yield
