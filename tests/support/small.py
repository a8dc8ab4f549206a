"""Small maps that many tests speak of, made by hand, and a strategy that draws others."""

import networkx as nx
import pytest
from hypothesis import assume, strategies as st

from allworlds.maps import CombinatorialMap, rooted_code, rooted_maps, unrooted_code
from allworlds.world import State

EDGE = CombinatorialMap((0, 1), (1, 0))
LOOP = CombinatorialMap((1, 0), (1, 0))
PATH = CombinatorialMap((0, 2, 1, 3), (1, 0, 3, 2))  # degrees 1, 2, 1
TRIANGLE = CombinatorialMap((1, 0, 3, 2, 5, 4), (2, 5, 0, 4, 3, 1))
# Vertex 0 of degree 1, vertex 1 of degree 3 with a loop.
LOLLIPOP = CombinatorialMap((0, 2, 3, 1), (1, 0, 3, 2))
# The same from its loop on: round vertex 0 loop, loop, edge.
LASSO = CombinatorialMap((1, 2, 0, 3), (1, 0, 3, 2))
# Around one vertex the edges a, b stand as aabb (plane) and as abab (torus).
PLANE = CombinatorialMap((1, 2, 3, 0), (1, 0, 3, 2))
TORUS = CombinatorialMap((1, 2, 3, 0), (2, 3, 0, 1))


def stepped(world, dart, action):
    """The dart after an action of a robot without markers, and what is sensed there."""
    state, percept = world.step(State(dart), action)
    return state.dart, percept


def is_least_rooting(map_):
    """Whether no other dart at the vertex of dart 0 has a smaller code: one of a marked map has."""
    codes = [rooted_code(map_.sigma, map_.alpha, dart) for dart in map_.vertices[0]]
    return min(codes) == rooted_code(map_.sigma, map_.alpha, 0)


def slow(*values):
    """Parameters of a test of a paper, which are tried with ``-m 'not slowest'``."""
    return pytest.param(*values, marks=pytest.mark.slow)


def slowest(*values):
    """Parameters that are left to ``nox -s full``."""
    return pytest.param(*values, marks=pytest.mark.slowest)


def every(step, values):
    """Parameters of which all but each ``step``-th are left to ``nox -s full``."""
    return [value if i % step == 0 else slowest(value) for i, value in enumerate(values)]


def all_maps(most):
    """Every rooted map with at most so many edges."""
    return [map_ for edges in range(1, most + 1) for map_ in rooted_maps(edges)]


def unrooted_maps(most):
    """Every map with at most so many edges, once whatever its root."""
    codes = {unrooted_code(map_) for map_ in all_maps(most)}
    return [CombinatorialMap(*code) for code in sorted(codes, key=lambda c: (len(c[0]), c))]


@st.composite
def labelled_pairs(draw, most=6):
    """A permutation and a pairing of the same darts, connected or not."""
    darts = range(2 * draw(st.integers(1, most)))
    sigma = draw(st.permutations(darts))
    paired = draw(st.permutations(darts))
    alpha = [0] * len(darts)
    for a, b in zip(paired[::2], paired[1::2], strict=True):
        alpha[a], alpha[b] = b, a
    return sigma, alpha


def joined(sigma, alpha):
    """The graph on the darts whose components the two permutations do not leave."""
    return nx.Graph([*enumerate(sigma), *enumerate(alpha)])


@st.composite
def maps(draw, most=6):
    """A map with at most so many edges whose darts have any names.

    ``allworlds.strategies.maps`` draws canonical numberings alone, by a way of the package's.
    """
    sigma, alpha = draw(labelled_pairs(most))
    assume(nx.is_connected(joined(sigma, alpha)))
    return CombinatorialMap(sigma, alpha)
