from collections import Counter
from random import Random

import pytest

from allworlds.inputs.checks import InputError
from allworlds.maps import families, family, random_map, rooted_code
from allworlds.maps.build import lattice
from allworlds.maps.families import FAMILIES, edges_of


@pytest.mark.parametrize(
    ("text", "size"),
    [
        ("lattice:3x4", (17, 12)),
        ("strip:5", (13, 10)),
        ("dense:5", (10, 5)),
        ("cycle:7", (7, 7)),
        ("torus:3x4", (24, 12)),
        ("torus:1x2", (4, 2)),
        ("cubic:8", (12, 8)),
        ("regular:4x5", (10, 5)),
        ("random:6", (6, None)),
        ("random:5x9", (9, 5)),
        ("random:1x3", (3, 1)),
        ("bouquet:6", (7, 2)),
        ("lollipop:4x3", (13, 7)),
        ("prism:4", (12, 8)),
        ("thick:6x4", (14, 5)),
        ("thick:2x3", (3, 4)),
        ("cover:4", (20, 12)),
        ("corridor:1", (28, 4)),
        ("corridor:3", (190, 10)),
        ("corridor:1x14", (22, 4)),
        ("corridor:2x14", (71, 11)),
        ("corridor:2x40", (121, 7)),
    ],
)
def test_the_sizes_of_the_families(text, size):
    map_ = family(text)
    assert map_.edge_count == size[0]
    assert edges_of(text) == size[0]
    assert size[1] in (None, map_.vertex_count)


def test_a_seed_makes_the_same_map_again():
    for text, holes in (("random:9", 0), ("lattice:4x4", 0.2), ("dense:6", 0.3)):
        maps = [family(text, holes=holes, seed=seed) for seed in (1, 1, 2, 3, 4)]
        assert maps[0] == maps[1]
        assert len(set(maps)) > 1


@pytest.mark.parametrize(
    ("text", "degrees"),
    [
        ("torus:4x5", {4: 20}),
        ("cubic:12", {3: 12}),
        ("regular:6x7", {6: 7}),
        ("bouquet:5", {1: 1, 11: 1}),
        ("lollipop:6x4", {1: 1, 6: 7, 7: 1}),
        ("prism:5", {3: 10}),
        ("thick:6x5", {5: 2, 6: 4}),
        ("corridor:2", {2: 1, 30: 6}),
        ("corridor:2x14", {2: 1, 14: 10}),
    ],
)
@pytest.mark.parametrize("seed", [0, 1, 2])
def test_the_degrees_of_the_families(text, degrees, seed):
    assert Counter(family(text, seed=seed).degrees) == degrees


def test_a_torus_has_genus_1_and_square_faces():
    map_ = family("torus:4x5", seed=3)
    assert map_.genus == 1
    assert {len(face) for face in map_.faces} == {4}


def test_a_cover_of_k_sheets_covers_its_base():
    degrees = Counter(family("cover:6", seed=1).degrees)
    assert all(times % 6 == 0 for times in degrees.values())


def test_a_seed_draws_the_start_in_a_lattice_and_another_map_elsewhere():
    starts = {family("lattice:3x3", seed=seed).degree_at[0] for seed in range(12)}
    assert starts == {2, 3, 4}
    assert family("lattice:3x3") == lattice(3, 3)
    for text in (
        "torus:3x3",
        "prism:6",
        "cover:3",
        "thick:6x4",
        "random:5x9",
        "strip:4",
        "corridor:1",
        "corridor:1x14",
    ):
        assert len({family(text, seed=seed) for seed in range(1, 9)}) > 1


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
        "cubic:3",
        "regular:2x4",
        "random:5x3",
        "random:0x0",
        "lollipop:5x2",
        "lollipop:4x0",
        "thick:3x3",
        "prism:2",
        "cover:0",
        "corridor:0",
        "corridor:2x12",
        "corridor:2x15",
        "torus:0x3",
        "torus:400x400",
    ],
)
def test_a_text_that_is_no_family_is_refused(text):
    with pytest.raises(InputError):
        family(text)


def test_holes_are_for_lattices_and_dense_maps():
    known = ["lattice:RxC", "strip:C", "dense:N"]
    assert [kind.form for kind in FAMILIES if kind.has_holes] == known
    with pytest.raises(InputError, match="cycle:5"):
        family("cycle:5", holes=0.1)


@pytest.mark.parametrize(
    ("legal", "wrong", "told"),
    [
        ("torus:1x1", "torus:0x1", "R and C are at least 1"),
        ("torus:1x1", "torus:1x0", "R and C are at least 1"),
        ("regular:3x2", "regular:2x2", "D is at least 3, and D times N is even"),
        ("regular:4x1", "regular:4x0", "D is at least 3, and D times N is even"),
        ("regular:3x2", "regular:3x1", "D is at least 3, and D times N is even"),
        ("cubic:2", "cubic:0", "N is even, and at least 2"),
        ("cubic:4", "cubic:3", "N is even, and at least 2"),
        ("random:1x1", "random:0x1", "N vertices need N - 1 edges at least, and a map has 1"),
        ("random:2x1", "random:3x1", "N vertices need N - 1 edges at least, and a map has 1"),
        ("random:1x1", "random:1x0", "N vertices need N - 1 edges at least, and a map has 1"),
        ("random:1", "random:0", "a map has at least 1 edge"),
        ("lollipop:4x1", "lollipop:2x1", "D is even and at least 4, L at least 1"),
        ("lollipop:6x1", "lollipop:5x1", "D is even and at least 4, L at least 1"),
        ("lollipop:4x1", "lollipop:4x0", "D is even and at least 4, L at least 1"),
        ("thick:2x1", "thick:0x1", "D is even and at least 2, L at least 1"),
        ("thick:4x1", "thick:3x1", "D is even and at least 2, L at least 1"),
        ("thick:2x1", "thick:2x0", "D is even and at least 2, L at least 1"),
        ("prism:3", "prism:2", "N is at least 3"),
        ("cover:1", "cover:0", "K is at least 1"),
        ("corridor:1x14", "corridor:0x14", "F is at least 1, R even and at least 14"),
        ("corridor:1x14", "corridor:1x12", "F is at least 1, R even and at least 14"),
        ("corridor:1x16", "corridor:1x15", "F is at least 1, R even and at least 14"),
        ("cycle:1", "cycle:0", "n = 0 is too small; it must be at least 1"),
        ("dense:2", "dense:1", "vertices = 1 is too small; it must be at least 2"),
    ],
)
def test_the_numbers_of_a_family_have_a_least_value(legal, wrong, told):
    assert family(legal).edge_count == edges_of(legal) >= 1
    with pytest.raises(InputError) as refused:
        family(wrong)
    assert str(refused.value) == f"family {wrong}: {told}"


def test_no_map_of_a_family_has_more_than_100000_edges(monkeypatch):
    monkeypatch.setattr(families, "cycle", lambda vertices: vertices)
    assert edges_of("cycle:100000") == family("cycle:100000") == 100_000
    for large in ("cycle:100001", "strip:33335", "dense:448"):
        with pytest.raises(InputError, match=f"family '{large}' has more than 100,000 edges"):
            family(large)


@pytest.mark.parametrize("seed", range(3))
def test_in_a_corridor_only_far_hubs_have_edges_to_others_than_the_next(seed):
    map_, shape = family("corridor:2x14", seed=seed), families.CorridorShape(2, 14)
    away = {abs(map_.vertex_of[dart] - map_.vertex_of[map_.alpha[dart]]) for dart in map_.darts}
    near = [dart for dart in map_.darts if map_.vertex_of[dart] <= shape.near]
    assert {map_.vertex_of[map_.alpha[dart]] - map_.vertex_of[dart] for dart in near} == {-1, 0, 1}
    assert away == {0, 1}
