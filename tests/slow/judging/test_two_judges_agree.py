"""The judge's own comparison against the second opinion, which shares no code with it.

The second opinion takes its time, so four edges, and all pairs of maps with three, are left to
``-m slowest`` but for a few; there they are cut into parts that can be done side by side.
"""

import pytest

from judging import test_two_judges_agree as quick
from judging.test_two_judges_agree import PARTS
from small import slowest


@pytest.mark.parametrize(
    ("most", "parts", "k"),
    [(3, PARTS, 0), *(slowest(3, PARTS, k) for k in range(1, PARTS))],
)
def test_on_every_pair_of_small_maps_and_every_pose(most, parts, k):
    quick.test_on_every_pair_of_small_maps_and_every_pose(most, parts, k)


@pytest.mark.parametrize("m", [slowest(3)])
def test_a_rooted_map_is_right_for_itself_alone(m):
    quick.test_a_rooted_map_is_right_for_itself_alone(m)


@pytest.mark.slowest
@pytest.mark.parametrize(("pairs", "k"), [(60, 0), *(slowest(60, k) for k in range(1, PARTS))])
def test_on_pairs_of_maps_of_four_edges_with_the_same_degrees(pairs, k):
    quick.test_on_pairs_of_maps_of_four_edges_with_the_same_degrees(pairs, k)


@pytest.mark.slowest
@pytest.mark.parametrize(("pairs", "k"), [(40, 0), *(slowest(40, k) for k in range(1, PARTS))])
def test_on_a_map_whose_edge_has_been_reglued(pairs, k):
    quick.test_on_a_map_whose_edge_has_been_reglued(pairs, k)
