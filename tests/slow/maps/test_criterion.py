from collections import Counter

import pytest
from test_criterion import marked_maps, quotient_of

from allworlds.maps import CombinatorialMap, class_size, is_ambiguous
from allworlds.studies.ambiguity import projection_of
from allworlds.studies.ambiguity.members import lifts
from allworlds.world import Position, World
from small import slowest


def moore(colour, *permutations_):
    """Refinement until it is stable, by counting signatures: knows nothing of Hopcroft."""
    while True:
        signs = list(zip(colour, *([colour[y] for y in p] for p in permutations_), strict=True))
        number = {sign: i for i, sign in enumerate(dict.fromkeys(signs))}
        if len(number) == len(set(colour)):
            return colour
        colour = [number[sign] for sign in signs]


def groups(maps):
    """Marked maps that no motion tells apart: all of them refined together, naively."""
    colour, sigma, alpha, starts = [], [], [], []
    for map_ in maps:
        shift = len(sigma)
        starts.append((shift, map_.degree_at[0]))
        colour += [
            (degree, v == map_.vertex_of[0])
            for degree, v in zip(map_.degree_at, map_.vertex_of, strict=True)
        ]
        sigma += [d + shift for d in map_.sigma]
        alpha += [d + shift for d in map_.alpha]
    final = moore(colour, sigma, alpha)
    found = []
    for start, degree in starts:
        seen, dart = set(), start
        for _ in range(degree):
            seen.add(final[dart])
            dart = sigma[dart]
        found.append(frozenset(seen))
    return found


@pytest.mark.parametrize("edges", [1, 2, 3, 4, 5, slowest(6)])
def test_the_criterion_and_burnsides_count_are_right_for_every_marked_map(edges):
    maps = marked_maps(edges)
    found = groups(maps)
    size = Counter(found)
    for map_, group in zip(maps, found, strict=True):
        quotient = quotient_of(map_)
        assert is_ambiguous(quotient) == (size[group] > 1), map_
        assert class_size(quotient) == size[group], map_


@pytest.mark.parametrize("edges", [1, 2, 3, 4])
def test_every_lift_is_a_map_with_the_same_rooted_quotient(edges):
    for map_ in marked_maps(edges)[::3]:
        quotient = quotient_of(map_)
        for lift in lifts(quotient):
            assert lift == CombinatorialMap(lift.sigma, lift.alpha)
            for sheet in range(quotient.sheets):
                assert projection_of(World(lift, Position(sheet), sheet)).quotient == quotient
