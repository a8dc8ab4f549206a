import pytest
from test_counting import CLASSES, SECOND, labelled

from allworlds.maps.counting import (
    SOURCES,
    rooted_planar_simple_by_substitution,
    rooted_simple_by_degrees,
)
from graph_atlas import rooted_planar_simple, rooted_simple

# Tutte, A census of planar triangulations (1962): 2 (4n+1)! / ((n+1)! (3n+2)!), n = 0, 1, ...
# rooted simple triangulations with n + 3 vertices.
TRIANGULATIONS = [1, 1, 3, 13, 68, 399]


@pytest.mark.parametrize("map_class", CLASSES)
def test_the_sources_of_a_class_agree_on_every_cell_that_two_of_them_know(map_class):
    for m in range(1, 10):
        cells = SOURCES[map_class].cells(m)
        for other in SECOND[map_class]:
            known = other(m)
            assert len(known) >= min(m, 3)
            assert known == {n: cells[n] for n in known}, m


def test_labelling_vertices_and_rooting_count_the_same_simple_maps():
    for n in range(2, 7):
        assert labelled(n, rooted_simple) == labelled(n, rooted_simple_by_degrees)


def test_simple_planar_maps_with_the_most_edges_are_tuttes_triangulations():
    most = [rooted_planar_simple_by_substitution(3 * n - 6)[n] for n in range(3, 9)]
    assert most == TRIANGULATIONS
    assert [rooted_planar_simple(3 * n - 6)[n] for n in range(3, 6)] == TRIANGULATIONS[:3]


def test_simple_planar_maps_never_have_more_than_3n_minus_6_edges():
    for m in range(2, 16):
        for known in (rooted_planar_simple(m), rooted_planar_simple_by_substitution(m)):
            assert all(not known[n] for n in known if 3 * n - 6 < m and n >= 3)
