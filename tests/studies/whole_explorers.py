"""Explorers of the studies in ``whole_studies.py``; reports name their lines."""

from allworlds import Estimate, Move
from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.maps import named_map


def stays(first):
    return Estimate(named_map("edge"), 0)
    yield


def wrong_from(edges, degree=1):
    """Algorithm 1, but its pose is wrong from so many edges on, if a vertex has that degree."""

    def explore(first, *, choices):
        right = yield from algorithm1(first, choices=choices)
        map_ = right.map
        if map_.edge_count >= edges and max(map_.degrees) >= degree:
            return Estimate(map_, map_.sigma[right.here])
        return right

    return explore


def loop_at_once(first):
    return Estimate(named_map("loop"), 0)
    yield


def walks_for_ever(first):
    while True:
        yield Move(1)
