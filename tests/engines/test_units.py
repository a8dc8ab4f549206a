"""The units of which a job is made, and the shards to which they are dealt."""

import pytest

from allworlds.engines import units
from allworlds.engines.units import Sample
from allworlds.inputs.checks import InputError
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.studies.check.exhaustive import check
from allworlds.studies.merge import status


def test_the_unit_is_dealt_to_the_first_shard_and_to_the_last_small_levels():
    def levels(edges, shard=units.WHOLE):
        extent = Extent(MapClass.MAPS, edges)
        return [m for m in extent.levels if [*units.across_level(extent, m, shard)]]

    assert [levels(edges) for edges in (1, 2, 3, 4, 7)] == [[1], [2], [3], [3, 4], [3, 4]]
    assert levels(4, units.Shard(1, 2)) == []


def test_a_built_in_explorer_has_no_such_unit(tmp_path):
    check("algorithm1", edges=1, engine="python", run=tmp_path / "run")
    assert status(tmp_path / "run").units.all == len(
        [*units.units_of_level(Extent(MapClass.MAPS, 1), 1)]
    )


@pytest.mark.parametrize(
    ("shard", "legal"),
    [((0, 1), True), ((1, 2), True), ((2, 2), False), ((-1, 2), False), ((0, 0), False)],
)
def test_shards_are_counted_from_0(shard, legal):
    if legal:
        assert str(units.Shard(*shard)) == f"{shard[0]}/{shard[1]}"
    else:
        with pytest.raises(InputError, match=r"is out of range; K/N needs 0 <= K < N, counted"):
            units.Shard(*shard)


def test_numbers_of_a_shard_have_nine_digits_at_most():
    assert units.shard_numbers("0/999999999") == (0, 999_999_999)
    assert units.shard_numbers("999999999/1") == (999_999_999, 1)
    for wrong in ("0/1000000000", "1000000000/1", "0", "/2", "0/", "0/1/2", "a/b"):
        with pytest.raises(InputError, match=r"is not of the form K/N, .*; N is at most 999999999"):
            units.shard_numbers(wrong)


@pytest.mark.parametrize(
    ("name", "legal", "wrong", "told"),
    [
        ("runs", 1, 0, "runs = 0 is not positive"),
        ("runs", 10**12, 10**12 + 1, "= 1000000000001 is too big; at most 1,000,000,000,000 is"),
        ("seed", 0, -1, "seed = -1, but seeds are 0, 1, 2, ..."),
        ("min_edges", 1, 0, "min-edges = 0 is not positive"),
    ],
)
def test_numbers_of_a_sample_have_limits(name, legal, wrong, told):
    assert getattr(units.Sample(**{"runs": 5, name: legal}), name) == legal
    with pytest.raises(InputError) as refused:
        units.Sample(**{"runs": 5, name: wrong})
    assert told in str(refused.value)


def test_a_seed_is_0_or_more():
    assert Sample(1, seed=0).seed == 0
    with pytest.raises(InputError, match=r"^seed = -1, but seeds are 0, 1, 2, \.\.\.$"):
        Sample(1, seed=-1)
