from collections import Counter
from random import Random

import pytest

from allworlds.inputs import InputError
from allworlds.maps.canonical import rooted_code
from allworlds.maps.families import family, random_map


@pytest.mark.parametrize(
    ("text", "size"),
    [("lattice:3x4", (17, 12)), ("dense:5", (10, 5)), ("cycle:7", (7, 7)), ("random:6", (6, None))],
)
def test_the_sizes_of_the_families(text, size):
    map_ = family(text)
    assert map_.edge_count == size[0]
    assert size[1] in (None, map_.vertex_count)


def test_a_seed_makes_the_same_map_again():
    for text, holes in (("random:9", 0), ("lattice:4x4", 0.2), ("dense:6", 0.3)):
        maps = [family(text, holes=holes, seed=seed) for seed in (1, 1, 2, 3, 4)]
        assert maps[0] == maps[1]
        assert len(set(maps)) > 1


def test_a_random_map_is_uniform_among_the_rooted_ones():
    random, draws = Random(5), 4000
    seen = Counter()
    for _ in range(draws):
        map_ = random_map(2, random)
        seen[rooted_code(map_.sigma, map_.alpha, 0)] += 1
    assert len(seen) == 10  # A000698
    assert sum((n - draws / 10) ** 2 / (draws / 10) for n in seen.values()) < 27.9  # 99.9 %


@pytest.mark.parametrize(
    "text",
    [
        "",
        "lattice",
        "lattice:3",
        "lattice:3x",
        "dense:-1",
        "cycle:0",
        "random:0",
        "dense:1",
        "lattice:1x1",
        "lattice:0x3",
        "cycle:\N{ARABIC-INDIC DIGIT THREE}",
        "random:1 ",
    ],
)
def test_a_text_that_is_no_family_is_refused(text):
    with pytest.raises(InputError):
        family(text)


def test_holes_are_for_lattices_and_dense_maps():
    with pytest.raises(InputError, match="cycle:5"):
        family("cycle:5", holes=0.1)
