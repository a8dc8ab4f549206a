"""The units of which a job is made, and the shards to which they are dealt."""

from allworlds.engines import units
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
