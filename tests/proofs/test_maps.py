"""The checkers' enumeration lists what the package's does, code by code."""

import pytest

from allworlds.maps import MapClass, rooted_maps


@pytest.mark.parametrize(
    ("map_class", "edges", "most", "count"),
    [
        ("maps", 4, None, 706),
        ("simple", 5, None, 108),
        ("simple", 6, None, None),
        ("planar-simple", 7, None, None),
    ],
)
def test_two_enumerations_list_the_same_rooted_maps(checkers, map_class, edges, most, count):
    maps = checkers("maps")
    listed = maps.rooted_maps(edges, simple="simple" in map_class, most=most)
    mine = [maps.code(*m, 0) for m in listed if "planar" not in map_class or maps.is_planar(m)]
    assert len(mine) == len(set(mine))
    theirs = rooted_maps(edges, MapClass(map_class), most)
    assert sorted(mine) == sorted(maps.code(m.sigma, m.alpha, 0) for m in theirs)
    assert count in {None, len(mine)}


def test_worlds_of_which_all_degrees_are_fixed_are_those_that_have_them(checkers):
    maps = checkers("maps")
    asked = list(maps.rooted_maps(8, simple=True, most=5, degrees=(4, 3)))
    wanted = [
        m
        for m in rooted_maps(8, MapClass("simple"), 5)
        if m.vertex_count == 5 and m.degree_at[0] == 4 and sorted(m.degrees) == [3, 3, 3, 3, 4]
    ]
    assert sorted(maps.code(*m, 0) for m in asked) == sorted(
        maps.code(m.sigma, m.alpha, 0) for m in wanted
    )
    assert len(asked) > 10
