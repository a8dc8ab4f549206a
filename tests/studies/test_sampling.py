from collections import Counter
from random import Random

import pytest

from allworlds.engines.units import Sample, Shard
from allworlds.inputs.checks import InputError
from allworlds.maps import CombinatorialMap, MapClass, random_map, rooted_code, rooted_maps
from allworlds.maps.classes import Extent
from allworlds.maps.mixture import PARTS, glued, rerooted
from allworlds.studies.check.covered import telling_apart
from allworlds.studies.fuzz.sample_sweep import fuzz
from allworlds.studies.fuzz.sampling import batches, waves
from allworlds.world import Directional

CLASSES = pytest.mark.parametrize("map_class", list(MapClass))


def code(map_):
    return rooted_code(map_.sigma, map_.alpha, 0)


def drawn(map_class, edges, runs, seed=0):
    extent = Extent(map_class, edges)
    parts = batches(Sample(runs, seed))
    return [placed for batch in parts for placed in batch.placed(extent, Directional)]


@pytest.mark.parametrize(("runs", "count"), [(60, 3), (1000, 7), (2, 3), (64, 1)])
def test_shards_share_the_pieces_evenly_and_join_to_the_whole(runs, count):
    parts = [[*batches(Sample(runs, portion=Shard(k, count)))] for k in range(count)]
    sizes = [len(part) for part in parts]
    assert max(sizes) - min(sizes) <= 1
    every = sorted((batch for part in parts for batch in part), key=lambda batch: batch.first)
    assert every == [*batches(Sample(runs))]
    numbers = [run for batch in every for run in range(batch.first, batch.last)]
    assert numbers == [*range(runs)]


@pytest.mark.parametrize(
    ("runs", "told"),
    [(1, [(0, 1)]), (300, [(0, 16), (16, 64), (64, 256), (256, 300)]), (64, [(0, 16), (16, 64)])],
)
def test_each_wave_of_draws_is_four_times_as_large_as_all_before(runs, told):
    assert [*waves(runs)] == told


def test_a_longer_sample_begins_with_the_shorter():
    assert drawn(MapClass.MAPS, 10, 150)[:70] == drawn(MapClass.MAPS, 10, 70)


@CLASSES
@pytest.mark.parametrize("least", [7])
def test_no_world_of_a_sample_is_smaller_than_it_is_to_be(map_class, least):
    # No lattice has 14 edges of which none is taken away: other maps take its place.
    first, *_ = batches(Sample(30, min_edges=least))
    sizes = [map_.edge_count for map_, _ in first.placed(Extent(map_class, 14), Directional)]
    assert len(sizes) == 8
    assert min(sizes) >= least
    assert max(sizes) <= 14


@CLASSES
def test_every_number_of_edges_and_every_bearing_comes(map_class):
    sample = drawn(map_class, 6, 300)
    assert {map_.edge_count for map_, _ in sample} == set(range(1, 7))
    assert {places[0][0] for map_, places in sample if map_.degree_at[0] == 3} == {0, 1, 2}


def test_a_sample_of_plain_maps_has_loops_handles_and_planes():
    sample = [map_ for map_, _ in drawn(MapClass.MAPS, 10, 200)]
    for has in ("loop_count", "parallel_count", "genus", "is_planar", "is_simple"):
        assert any(getattr(map_, has) for map_ in sample)


def test_random_maps_are_uniform_among_all_rooted_maps_with_two_edges():
    random = Random(2026)
    draws = 5000
    counted = Counter(code(random_map(2, random)) for _ in range(draws))
    assert set(counted) == {code(map_) for map_ in rooted_maps(2)}
    assert len(counted) == 10  # OEIS A000698
    # 500 each; 100 are more than four and a half standard deviations.
    assert all(abs(count - draws / 10) < 100 for count in counted.values())


def test_gluing_at_random_is_not_uniform():
    random = Random(2026)
    glue = glued(MapClass.PLANAR)
    counted = Counter(code(glue(2, random)) for _ in range(5000))
    assert len(counted) == 9  # in the plane; OEIS A000168
    assert not all(abs(count - 5000 / 9) < 100 for count in counted.values())


def test_random_maps_with_one_edge_are_the_loop_and_the_link():
    random = Random(0)
    counted = Counter(random_map(1, random).vertex_count for _ in range(1000))
    assert abs(counted[1] - 500) < 80
    assert counted[1] + counted[2] == 1000


@pytest.mark.parametrize(("runs", "message"), [(0, "runs = 0"), (-1, "runs = -1")])
def test_a_sample_of_nothing_is_refused(runs, message):
    with pytest.raises(InputError, match=f"{message} is not positive"):
        Sample(runs)


# ---------------------------------------------------------------- the mixture


def counts(part, edges, draws):
    """How often each rooted map is drawn."""
    random = Random(2026)
    return Counter(code(rerooted(PARTS[part](edges, random), random)) for _ in range(draws))


@pytest.mark.parametrize("edges", [2, 3])
def test_random_planar_maps_are_uniform_among_all_of_genus_0(edges):
    (count,) = ({2: 9, 3: 54}[edges],)  # OEIS A000168
    counted = counts("planar", edges, 60 * count)
    assert set(counted) == {code(map_) for map_ in rooted_maps(edges, MapClass.PLANAR)}
    assert len(counted) == count
    # 60 each; the sum of the squares of what each is off, over 60, is about their number.
    assert sum((n - 60) ** 2 / 60 for n in counted.values()) < count + 5 * (2 * count) ** 0.5


def test_cubic_ones_with_3_edges_are_every_cubic_rooted_map():
    cubic = {code(map_) for map_ in rooted_maps(3) if set(map_.degrees) == {3}}
    found = {
        each for each in counts("regular", 3, 400) if set(CombinatorialMap(*each).degrees) == {3}
    }
    assert found == cubic


@pytest.mark.parametrize("part", PARTS)
def test_every_part_has_maps_of_every_size_that_is_asked_or_less(part):
    random = Random(1)
    for edges in (*range(1, 12), 40):
        for _ in range(5):
            map_ = PARTS[part](edges, random)
            assert CombinatorialMap(map_.sigma, map_.alpha) == map_
            assert (edges / 3 if edges > 4 else 1) <= map_.edge_count <= edges


@pytest.mark.parametrize("part", ["cover", "ring"])
def test_coverings_look_alike_from_every_sheet_but_for_a_defect(part):
    random = Random(7)
    sheets = [telling_apart(PARTS[part](30, random))[0] for _ in range(40)]
    whole = [each for each in sheets if each >= 5]
    assert len(whole) >= 5  # those without a defect
    assert len(whole) < 35


def test_a_part_draws_its_worlds_whatever_else_is_in_the_mixture():
    mixed = [*placed(mix=("uniform", "ring", "cover"), runs=30)]
    assert mixed[1::3] == [*placed(mix=("ring",), runs=10)]
    assert mixed[1::3] != [*placed(mix=("ring",), runs=10, seed=1)]


def placed(mix, runs, seed=0):
    for batch in batches(Sample(runs, seed, mix=mix)):
        yield from batch.placed(Extent(MapClass.MAPS, 20), Directional)


@pytest.mark.parametrize(
    ("mix", "message"), [("rings", "'rings' is not one of"), (["ring", "ring"], "'ring' stands")]
)
def test_what_is_no_part_or_comes_twice_is_refused(mix, message):
    with pytest.raises(InputError, match=message):
        fuzz(edges=4, mix=mix)
