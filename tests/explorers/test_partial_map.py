import networkx as nx
import pytest
from hypothesis import given, strategies as st

from allworlds.explorers.builtin.algorithm1 import PartialMap
from allworlds.maps import CombinatorialMap, rooted_code
from allworlds.protocol.actions import Checkpoint, Percept
from small import maps


def sensed(world, dart, pointed):
    """The percept at a dart of a world with a directional lighthouse."""
    if world.vertex_of[dart] != world.vertex_of[pointed]:
        return Percept(world.degree_at[dart])
    return Percept(world.degree_at[dart], 1, world.offset(dart, pointed))


class Growth:
    """A partial map that someone who sees the world builds without any mistake."""

    def __init__(self, world, root, bearing):
        self.world, self.pointed = world, world.turn(root, bearing)
        self.s = PartialMap(sensed(world, root, self.pointed))
        self.true = [world.turn(root, d) for d in range(world.degree_at[root])]

    def explore(self, dart):
        beyond = self.world.alpha[self.true[dart]]
        if beyond in self.true:
            self.s.add_loop(dart, self.true.index(beyond))
            return
        entry = self.s.add_vertex(dart, sensed(self.world, beyond, self.pointed))
        assert entry == len(self.true)
        self.true += [self.world.turn(beyond, k) for k in range(self.world.degree_at[beyond])]


@st.composite
def growths(draw, most=6):
    """A world, and a part of it that has been explored in some order."""
    world = draw(maps(most))
    root = draw(st.sampled_from(world.darts))
    growth = Growth(world, root, draw(st.integers(0, world.degree_at[root] - 1)))
    for _ in range(draw(st.integers(0, world.edge_count))):
        growth.explore(draw(st.sampled_from(growth.s.unexplored)))
    return growth


def graph(s):
    """The explored part of S."""
    explored = nx.MultiGraph()
    explored.add_nodes_from(s.vertex)
    explored.add_edges_from((s.vertex[d], s.vertex[e]) for d, e in enumerate(s.alpha) if d < e)
    return explored


# ---------------------------------------------------------------- the start


@pytest.mark.parametrize("bearing", [0, 1, 2])
def test_at_the_start_the_darts_of_v0_are_known_open_and_tell_the_bearing(bearing):
    s = PartialMap(Percept(3, 1, bearing))
    assert (s.sigma, s.alpha, s.vertex, s.first) == ([1, 2, 0], [0, 1, 2], [0, 0, 0], [0])
    assert s.unexplored == [0, 1, 2]
    assert [p.bearing for p in s.expected] == [(bearing - d) % 3 for d in range(3)]
    assert {(p.degree, p.marks) for p in s.expected} == {(3, 1)}


def test_without_a_bearing_every_dart_of_v0_is_expected_to_look_the_same():
    assert PartialMap(Percept(2, 1)).expected == [Percept(2, 1)] * 2


# ---------------------------------------------------------------- growing


@given(growths())
def test_every_dart_of_s_is_a_dart_of_the_world(growth):
    s, world, true = growth.s, growth.world, growth.true
    assert len(set(true)) == len(true) == len(s.sigma)
    for d, dart in enumerate(true):
        assert true[s.sigma[d]] == world.sigma[dart]
        assert s.alpha[d] == d or true[s.alpha[d]] == world.alpha[dart]
        assert s.expected[d] == sensed(world, dart, growth.pointed)
        assert s.sigma[d] in range(s.first[s.vertex[d]], len(true))


@given(growths())
def test_u_holds_the_open_darts_in_the_order_in_which_they_came(growth):
    s = growth.s
    assert s.unexplored == [d for d, e in enumerate(s.alpha) if d == e]
    assert all(s.alpha[s.alpha[d]] == d for d in range(len(s.alpha)))


@given(growths())
def test_explored_to_the_end_s_is_the_world(growth):
    while growth.s.unexplored:
        growth.explore(growth.s.unexplored[-1])
    s, world = growth.s, growth.world
    whole = CombinatorialMap(s.sigma, s.alpha)
    assert rooted_code(*map(tuple, (s.sigma, s.alpha)), 0) == rooted_code(
        world.sigma, world.alpha, growth.true[0]
    )
    assert [vertex[0] for vertex in whole.vertices] == s.first


@given(growths(), st.data())
def test_turning_and_offset_are_those_of_the_world(growth, data):
    s, world, true = growth.s, growth.world, growth.true
    d = data.draw(st.sampled_from(range(len(true))))
    k = data.draw(st.integers(-20, 20))
    e = s.turn(d, k)
    assert true[e] == world.turn(true[d], k)
    assert s.offset(d, e) == world.offset(true[d], true[e]) == k % world.degree_at[true[d]]


# ---------------------------------------------------------------- walking in S


@given(growths())
def test_the_ways_of_a_vertex_are_its_explored_darts_clockwise(growth):
    s, world = growth.s, growth.world
    for vertex, first in enumerate(s.first):
        around = [s.turn(first, k) for k in range(world.degree_at[growth.true[first]])]
        explored = [(d, s.vertex[s.alpha[d]]) for d in around if s.alpha[d] != d]
        assert list(s.ways(vertex)) == explored


@given(growths(), st.data())
def test_distances_are_those_of_the_explored_graph(growth, data):
    s = growth.s
    goal = data.draw(st.sampled_from(s.vertex))
    assert s.distances(goal) == nx.single_source_shortest_path_length(graph(s), goal)


@given(growths(), st.data())
def test_distances_avoid_the_vertices_that_are_to_be_avoided(growth, data):
    s = growth.s
    goal = data.draw(st.sampled_from(s.vertex))
    avoiding = data.draw(st.sets(st.sampled_from(s.vertex))) - {goal}
    rest = graph(s)
    rest.remove_nodes_from(avoiding)
    expected = nx.single_source_shortest_path_length(rest, goal)
    assert s.distances(goal, sorted(avoiding)) == expected


def test_a_checkpoint_is_a_value_that_does_not_grow_with_s():
    s = PartialMap(Percept(2, 1, 0))
    before = s.checkpoint(1)
    entry = s.add_vertex(0, Percept(1))
    assert before == Checkpoint((1, 0), (0, 1), 1)
    assert s.checkpoint(entry) == Checkpoint((1, 0, 2), (2, 1, 0), 2)
