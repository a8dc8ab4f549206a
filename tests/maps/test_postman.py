"""The shortest walk along every edge, against a search through all walks."""

import pytest

from allworlds.maps import covering_walk, named_map, rooted_maps


def searched(map_, start):
    """The fewest traversals, by a search through all vertices with the edges walked so far."""
    begin = (map_.vertex_of[start], frozenset())
    queue, cost = [begin], {begin: 0}
    for state in queue:
        vertex, walked = state
        if len(walked) == map_.edge_count:
            return cost[state]
        for dart in map_.vertices[vertex]:
            far = map_.alpha[dart]
            after = (map_.vertex_of[far], walked | {min(dart, far)})
            if after not in cost:
                cost[after] = cost[state] + 1
                queue.append(after)
    raise AssertionError("the map is connected")


@pytest.mark.parametrize("edges", [1, 2, 3])
def test_no_walk_along_every_edge_is_shorter_and_one_is_so_long(edges):
    for map_ in rooted_maps(edges):
        assert covering_walk(map_, 0) == searched(map_, 0)


@pytest.mark.parametrize(
    ("name", "start", "cost"),
    # A star has all edges but the last one twice; an even graph has a closed walk.
    [("star-3", 0, 5), ("star-3", 5, 4), ("cycle-5", 0, 5), ("theta", 0, 3), ("k4", 0, 7)],
)
def test_the_walks_of_known_maps(name, start, cost):
    map_ = named_map(name)
    assert covering_walk(map_, start) == cost
