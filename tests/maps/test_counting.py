import ast
import sys
from fractions import Fraction
from itertools import combinations
from math import comb, factorial, prod
from pathlib import Path

import pytest

import graph_atlas
from allworlds.maps import counting
from allworlds.maps.counting import (
    NARROWED,
    SOURCES,
    catalan,
    rooted_maps,
    rooted_of_genus,
    rooted_of_genus_by_contraction,
    rooted_planar_simple_by_substitution,
    rooted_simple_by_degrees,
)
from graph_atlas import ROTATIONS_LIMIT, rooted_planar_simple, rooted_simple


def of_all_genera(of_genus):
    def cells(m):
        each = [of_genus(m, genus) for genus in range(m // 2 + 1)]
        return {n: sum(one[n] for one in each) for n in range(1, m + 2)}

    return cells


# By the class of maps: what counts them besides the source of the gate, as far as it knows.
SECOND = {
    "maps": [of_all_genera(rooted_of_genus), of_all_genera(rooted_of_genus_by_contraction)],
    "planar": [lambda m: rooted_of_genus_by_contraction(m, 0)],
    "simple": [rooted_simple],
    "planar-simple": [rooted_planar_simple],
}
CLASSES = [*SECOND]

# OEIS A000698, from its third term: rooted maps of any orientable genus by edges.
ROOTED = [2, 10, 74, 706, 8162, 110410, 1708394, 29752066, 576037442]
# OEIS A000168: rooted planar maps.  A006295, A006296: those of genus 1 and 2.
GENUS_0 = [2, 9, 54, 378, 2916, 24057, 208494]
GENUS_1 = [0, 1, 20, 307, 4280, 56914, 736568]
GENUS_2 = [0, 0, 0, 21, 966, 27954, 650076]
# OEIS A022558, from its second term: Bona's numbers, of permutations that avoid 1342; they
# also count rooted simple planar maps.
SIMPLE_PLANAR = [1, 2, 6, 23, 103, 512, 2740, 15485, 91245, 555662]
# OEIS A000108.
CATALAN = [1, 1, 2, 5, 14, 42, 132, 429, 1430]


def test_rooted_maps_by_edges_are_the_published_numbers():
    assert [sum(rooted_maps(m).values()) for m in range(1, 10)] == ROOTED


def test_rooted_planar_maps_by_edges_are_the_published_numbers():
    assert [sum(rooted_of_genus(m, 0).values()) for m in range(1, 8)] == GENUS_0


def test_rooted_maps_by_genus_are_the_published_numbers():
    for m in range(1, 8):
        published = {0: GENUS_0[m - 1], 1: GENUS_1[m - 1], 2: GENUS_2[m - 1]}
        computed = {g: sum(rooted_of_genus(m, g).values()) for g in range(m // 2 + 1)}
        assert set(rooted_of_genus(m, m // 2 + 1).values()) == {0}
        assert {g: computed.get(g, 0) for g in published} == published
        assert sum(computed.values()) == ROOTED[m - 1]


def test_trees_are_counted_by_catalan_numbers_in_every_class():
    assert [catalan(n) for n in range(9)] == CATALAN
    for map_class in CLASSES:
        for cells in (SOURCES[map_class].cells, *SECOND[map_class]):
            assert [cells(m)[m + 1] for m in range(1, 8)] == CATALAN[1:8], map_class


def test_maps_with_one_vertex_are_the_pairings_of_its_darts():
    for m in range(1, 10):
        assert rooted_maps(m)[1] == prod(range(1, 2 * m, 2))


@pytest.mark.parametrize("map_class", CLASSES)
def test_the_gate_of_a_class_knows_every_cell(map_class):
    source = SOURCES[map_class]
    for m in range(1, 11):
        assert list(source.cells(m)) == list(range(1, m + 2))


@pytest.mark.parametrize("map_class", ["simple", "planar"])
def test_a_class_that_is_confused_with_another_does_not_pass(map_class):
    for other in CLASSES:
        same = all(SOURCES[other].cells(m) == SOURCES[map_class].cells(m) for m in range(1, 6))
        assert same == (other == map_class)


# The log-series


def pairs_of_permutations(m, sign):
    """``[z^m] sum_k (2k-1)!! x(x+sign)... z^k/(2k)!`` times 2m: disconnected pairs as well."""
    polynomial = [Fraction(1)]
    for i in range(2 * m):
        shifted = [Fraction(0), *polynomial]
        scaled = [sign * i * c for c in polynomial] + [Fraction(0)]
        polynomial = [a + b for a, b in zip(shifted, scaled, strict=True)]
    weight = Fraction(2 * m * prod(range(1, 2 * m, 2)), factorial(2 * m))
    return {n: weight * c for n, c in enumerate(polynomial) if c}


def test_without_the_logarithm_the_pairs_of_permutations_are_too_many():
    assert pairs_of_permutations(1, 1) == rooted_maps(1)
    assert all(pairs_of_permutations(2, 1)[n] >= rooted_maps(2)[n] for n in rooted_maps(2))
    assert pairs_of_permutations(2, 1) != rooted_maps(2)


def test_with_falling_factorials_the_pairs_of_permutations_are_wrong():
    assert pairs_of_permutations(1, -1) != rooted_maps(1)


# The recurrence of Carrell and Chapuy


def planar_totals(up_to, coefficient):
    """The recurrence at genus 0 and x = 1, with ``coefficient(n) / 3`` before Q^(n-1)."""
    q = [Fraction(1)]
    for n in range(1, up_to + 1):
        pairs = sum((2 * k - 1) * (2 * (n - k) - 1) * q[k - 1] * q[n - k - 1] for k in range(1, n))
        q.append((Fraction(coefficient(n), 3) * q[n - 1] + pairs / 2) * Fraction(6, n + 1))
    return q[1:]


def tutte(m):
    """Rooted planar maps with m edges: W. T. Tutte, A census of planar maps (1963)."""
    return 2 * 3**m * comb(2 * m, m) // ((m + 1) * (m + 2))


def test_planar_totals_are_tuttes_closed_form():
    for m in range(1, 30):
        assert sum(rooted_of_genus(m, 0).values()) == tutte(m)


def test_a_recurrence_with_a_wrong_coefficient_does_not_reproduce_tutte():
    closed = [tutte(m) for m in range(1, 8)]
    assert planar_totals(7, lambda n: 2 * (2 * n - 1)) == closed
    assert planar_totals(7, lambda n: 2 * (2 * n + 1)) != closed
    assert planar_totals(7, lambda n: 2 * n - 1) != closed


def test_exchanging_vertices_and_faces_keeps_the_counts_of_a_genus():
    for m in range(1, 10):
        for g in range(m // 2 + 1):
            cells = rooted_of_genus(m, g)
            ends = m + 2 - 2 * g  # vertices and faces together
            for n in range(1, m + 2):
                assert cells[n] == (cells[ends - n] if n < ends else 0)


def test_exchanging_vertices_and_faces_mixes_the_genera():
    # With 2 edges: 3 maps with one vertex, of which 1 is on the torus; 2 with three vertices.
    cells = rooted_maps(2)
    assert (cells[1], cells[3]) == (3, 2)


def test_there_are_no_maps_of_a_genus_with_fewer_than_2g_edges():
    assert set(rooted_of_genus(3, 2).values()) == {0}
    assert set(rooted_of_genus_by_contraction(3, 2).values()) == {0}
    # Euler: one vertex and one face.  OEIS A035319: 1, 1, 21, 1485.
    assert [rooted_of_genus(2 * g, g)[1] for g in (1, 2, 3)] == [1, 21, 1485]


def test_both_recurrences_agree_for_every_genus_and_number_of_vertices():
    for m in range(1, 9):
        for g in range(m // 2 + 1):
            assert rooted_of_genus(m, g) == rooted_of_genus_by_contraction(m, g)


# Simple maps


def connected_graphs(n):
    """The degrees of each connected graph on n labelled vertices."""
    for bits in range(1 << comb(n, 2)):
        edges = [e for i, e in enumerate(combinations(range(n), 2)) if bits >> i & 1]
        component = list(range(n))
        for u, v in edges:
            kept, lost = component[u], component[v]
            component = [kept if c == lost else c for c in component]
        if len(set(component)) == 1:
            yield [sum(v in e for e in edges) for v in range(n)]


def labelled(n, rooted):
    """Rotation systems on n labelled vertices: n! / 2m for each rooted simple map."""
    edges = range(n - 1, comb(n, 2) + 1)
    return sum(Fraction(factorial(n), 2 * m) * rooted(m)[n] for m in edges)


def test_labelled_rotation_systems_are_those_of_all_graphs_one_by_one():
    for n in range(2, 6):
        by_hand = sum(prod(factorial(d - 1) for d in ds) for ds in connected_graphs(n))
        assert labelled(n, rooted_simple_by_degrees) == by_hand
    # Each graph one by one, as above, in another program.
    numbers = [labelled(n, rooted_simple_by_degrees) for n in range(2, 6)]
    assert numbers == [1, 4, 87, 27868]


def test_all_rotations_of_a_vertex_instead_of_the_cyclic_ones_are_too_many():
    too_many = sum(prod(map(factorial, ds)) for ds in connected_graphs(4))
    assert too_many > labelled(4, rooted_simple_by_degrees)


@pytest.mark.parametrize("rooted", [rooted_simple, rooted_simple_by_degrees])
def test_simple_rooted_maps_by_vertices_are_the_known_numbers(rooted):
    # All simple maps with up to 5 vertices, enumerated by another program.
    totals = [sum(rooted(m)[n] for m in range(n - 1, comb(n, 2) + 1)) for n in range(2, 6)]
    assert totals == [1, 3, 32, 3965]


def test_simple_maps_by_degrees_agree_with_the_atlas_on_all_its_graphs():
    for m in range(1, 12):
        known, degrees = rooted_simple(m), rooted_simple_by_degrees(m)
        assert known == {n: degrees[n] for n in known}
        assert set(known) == {*range(1, min(m + 1, 7) + 1), m + 1}


def graph(n, edges):
    both = [*edges, *((v, u) for u, v in edges)]
    return tuple(frozenset(w for u, w in both if u == v) for v in range(n))


def test_automorphisms_of_known_graphs():
    # Permutations of the leaves, of all vertices, the dihedral group, the two ends.
    assert graph_atlas._automorphisms(graph(7, [(0, v) for v in range(1, 7)])) == 720
    assert graph_atlas._automorphisms(graph(7, list(combinations(range(7), 2)))) == 5040
    assert graph_atlas._automorphisms(graph(6, [(v, (v + 1) % 6) for v in range(6)])) == 12
    assert graph_atlas._automorphisms(graph(4, [(0, 1), (1, 2), (2, 3)])) == 2


def test_weighing_no_graph_by_its_automorphisms_is_too_many():
    stars_and_paths = graph_atlas._atlas(4, 3)
    unweighed = sum(map(graph_atlas._rotation_count, stars_and_paths)) * 2 * 3
    assert unweighed > rooted_simple(3)[4] == catalan(3)


# Simple planar maps


def test_simple_planar_maps_by_edges_are_the_published_numbers():
    totals = [sum(rooted_planar_simple_by_substitution(m).values()) for m in range(1, 11)]
    assert totals == SIMPLE_PLANAR


def test_rotations_of_genus_0_of_known_graphs():
    # K4 is 3-connected: one rotation system and its mirror image, of 2^4.  K5 has none.
    four, five = (graph(n, list(combinations(range(n), 2))) for n in (4, 5))
    assert graph_atlas._spherical_rotations(four) == 2 < graph_atlas._rotation_count(four) == 16
    assert graph_atlas._spherical_rotations(five) == 0 < graph_atlas._rotation_count(five)
    # All rotation systems of a tree are plane.
    star = graph(5, [(0, v) for v in range(1, 5)])
    assert graph_atlas._spherical_rotations(star) == graph_atlas._rotation_count(star) == 6


def test_simple_planar_is_less_than_simple_from_five_edges_on():
    # K4 without an edge has 4 rotation systems, 2 of them on the torus.
    assert rooted_planar_simple(4) == rooted_simple(4)
    assert rooted_planar_simple(5)[4] == 5 < rooted_simple(5)[4] == 10


def test_a_cell_without_a_source_is_absent_and_an_impossible_cell_is_0():
    assert 8 not in rooted_simple(8)
    assert rooted_simple(8)[4] == rooted_simple_by_degrees(8)[4] == 0
    assert sum(map(graph_atlas._rotation_count, graph_atlas._atlas(6, 12))) > ROTATIONS_LIMIT
    assert 6 not in rooted_planar_simple(12)
    assert rooted_planar_simple(12)[5] == 0


def test_the_cells_that_the_atlas_leaves_out_are_these_and_no_others(monkeypatch):
    monkeypatch.setattr(graph_atlas, "_rooted", lambda _weighed, _edges: 1)  # takes its time
    cells = {(m, n) for m in range(1, 22) for n in range(1, min(m + 1, 7) + 1)}
    known = {(m, n) for m in range(1, 22) for n in rooted_planar_simple(m)}
    of_seven = {(m, 7) for m in range(10, 16)}
    assert cells - known == of_seven | {(11, 6), (12, 6)}


# The gate


@pytest.mark.parametrize(
    "count",
    [
        rooted_maps,
        lambda m: rooted_of_genus(m, 0),
        rooted_simple,
        rooted_simple_by_degrees,
        rooted_planar_simple,
        rooted_planar_simple_by_substitution,
    ],
)
def test_no_edge_is_no_map(count):
    with pytest.raises(ValueError, match="at least 1 edge, not 0"):
        count(0)


def test_what_should_be_a_count_but_is_a_fraction_is_an_error():
    with pytest.raises(ArithmeticError, match="7 / 2 should be a count"):
        counting.exactly(7, 2)


def test_the_gate_shares_no_code_with_the_enumerator():
    imported = set()
    for node in ast.walk(ast.parse(Path(counting.__file__).read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom):
            imported.add(node.module)
        elif isinstance(node, ast.Import):
            imported.update(alias.name for alias in node.names)
    outside = {name for name in imported if name.split(".")[0] not in sys.stdlib_module_names}
    assert not outside


def test_maps_whose_faces_have_four_darts_are_counted_down_to_one_vertex():
    # With two edges and one face: two rooted trees, and the torus with one vertex.
    assert counting.rooted_with_faces(2, 4, (0, 1)) == {1: 1, 2: 0, 3: 2}


@pytest.mark.parametrize(
    ("map_class", "source"),
    [("maps", "Carrell-Chapuy recurrence"), ("simple", "substitution into planar maps")],
)
def test_maps_of_genus_0_of_a_class_are_the_planar_ones(map_class, source):
    of_genus_0 = NARROWED["genus"](map_class, 0)
    assert of_genus_0.name == source
    planar = {"maps": "planar", "simple": "planar-simple"}[map_class]
    for m in range(1, 6):
        assert of_genus_0.count(m) == SOURCES[planar].count(m)
    for same in ("planar", "planar-simple"):
        assert NARROWED["genus"](same, 0) == SOURCES[same]
        assert NARROWED["genus"](same, 1) is None
