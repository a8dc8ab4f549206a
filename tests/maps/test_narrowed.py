"""Sources of the numbers of maps under a condition, compared with enumeration and literature."""

from math import comb, factorial, prod

import pytest

from allworlds.maps.counting import (
    NARROWED,
    catalan,
    rooted_of_genus_by_contraction,
)

NAMES = [
    *("cubic", "regular:2", "regular:4", "eulerian", "trees", "girth:1", "girth:2", "girth:3"),
    *("girth:4", "genus:0", "genus:1", "genus:2", "triangulation", "quadrangulation"),
]


def source_under(map_class, name):
    kind, _, number = name.partition(":")
    return NARROWED[kind](map_class, int(number or 0))


def total(map_class, name, edges):
    return sum(source_under(map_class, name).cells(edges).values())


@pytest.mark.parametrize(("name", "legal"), [("cubic", {3}), ("eulerian", {*range(2, 99, 2)})])
def test_maps_of_these_degrees_are_as_many_by_contraction(name, legal):
    for m in range(1, 7):
        each = [
            rooted_of_genus_by_contraction(m, genus, frozenset(legal))
            for genus in range(m // 2 + 1)
        ]
        assert sum(sum(cells.values()) for cells in each) == total("maps", name, m)


def test_cubic_maps_are_those_of_the_literature():
    # OEIS A062980; planar ones: W. T. Tutte 1962, 2^(2k+1) (3k)!! / ((k+2)! k!!), 2k vertices.
    assert [total("maps", "cubic", 3 * k) for k in (1, 2, 3, 4)] == [5, 60, 1105, 27120]
    for k in (1, 2, 3, 4):
        planar, rest = divmod(2 ** (2 * k + 1) * odd(3 * k), factorial(k + 2) * odd(k))
        assert rest == 0
        assert total("planar", "cubic", 3 * k) == planar
        assert total("planar", "triangulation", 3 * k) == planar


def odd(n):
    """The double factorial."""
    return prod(range(n, 0, -2))


def test_planar_maps_of_even_degrees_and_with_faces_of_four_darts_are_those_of_the_literature():
    # W. T. Tutte 1963: 3 2^(m-1) C(2m,m) / ((m+1)(m+2)) Eulerian ones; quadrangulations with f
    # faces are as many as planar maps with f edges, 2 3^f C(2f,f) / ((f+1)(f+2)).
    for m in (1, 2, 3, 4, 5, 6):
        eulerian = 3 * 2 ** (m - 1) * comb(2 * m, m) // ((m + 1) * (m + 2))
        assert total("planar", "eulerian", m) == eulerian
        faces = 2 * 3**m * comb(2 * m, m) // ((m + 1) * (m + 2))
        assert total("planar", "quadrangulation", 2 * m) == faces


def test_simple_planar_triangulations_are_those_of_the_literature():
    assert [total("planar-simple", "triangulation", 3 * k) for k in (1, 2, 3, 4)] == [1, 1, 3, 13]
    assert total("planar-simple", "triangulation", 4) == 0


def test_maps_with_loops_alone_are_as_many_as_of_degree_2m():
    for m in (1, 2, 3, 4):
        assert total("maps", f"regular:{2 * m}", m) == prod(range(1, 2 * m, 2))
        assert total("planar", f"regular:{2 * m}", m) == catalan(m)


def test_no_condition_passes_for_another():
    cells = {}
    for name in NAMES:
        if source := source_under("maps", name):
            cells[name] = [source.cells(m) for m in range(1, 7)]
    assert len(cells) == len(NAMES) - 2  # girth:2, girth:4
    for name, told in cells.items():
        assert [other for other, same in cells.items() if same == told] == [name]
