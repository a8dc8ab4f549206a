import itertools

import pytest

from allworlds.maps import CombinatorialMap, InvalidMap, rooted_code
from allworlds.reports.drawing.text import draw, rotation_table
from allworlds.reports.parts import Scene
from reports.test_text import parsed, parsed_table, without_numbers
from small import slowest


def all_maps(edges):
    """Every pair of permutations that is a map, by brute force."""
    involutions = [
        alpha
        for alpha in itertools.permutations(range(2 * edges))
        if all(alpha[d] != d and alpha[alpha[d]] == d for d in range(2 * edges))
    ]
    for sigma, alpha in itertools.product(itertools.permutations(range(2 * edges)), involutions):
        try:
            yield CombinatorialMap(sigma, alpha)
        except InvalidMap:
            continue


@pytest.mark.parametrize("edges", [1, 2, slowest(3)])
def test_the_drawing_and_the_table_are_exact_for_every_small_map(edges):
    for map_ in all_maps(edges):
        scene = Scene(map_, map_.sigma[0])
        assert parsed(draw(scene)) == (map_, [scene.start])
        assert parsed_table(rotation_table(scene)) == (map_, [scene.start])


@pytest.mark.slowest
def test_without_the_numbers_two_drawings_agree_exactly_for_the_same_rooted_map():
    # 10 + 74 rooted maps of 2 and 3 edges: Arques and Beraud, Discrete Math. 215 (2000).
    for edges, count in ((1, 2), (2, 10), (3, 74)):
        pictures = {}
        for map_ in all_maps(edges):
            code = rooted_code(map_.sigma, map_.alpha, 0)
            pictures.setdefault(code, set()).add(tuple(without_numbers(draw(Scene(map_)))))
        assert len(pictures) == count
        assert all(len(drawn) == 1 for drawn in pictures.values())
        assert len(set.union(*pictures.values())) == count
