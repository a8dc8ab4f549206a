"""Cost by size: members that their names give back, runs that single runs confirm."""

import pytest

from allworlds import compare, run
from allworlds.world import Directional, World
from allworlds.world.named import map_of_family
from studies import test_growth as quick

report = quick.report


@pytest.mark.slowest
def test_every_cost_is_that_of_a_single_run_at_the_place_of_that_number(report):
    for row in report.rows:
        for one in row.members:
            map_ = one.map()
            assert (map_.edge_count, map_.vertex_count) == (row.edges, row.vertices)
            text, seed = one.name.split(" --seed ")
            assert map_of_family(text, None, int(seed)) == map_
            places = [*Directional.places(map_, 0)]
            assert len(places) == one.places
            for place, cost in zip(one.ran, one.costs, strict=True):
                world = World(map_, places[place])
                assert run(row.explorer, world).outcome.cost == cost


@pytest.mark.slowest
def test_rows_stand_by_family_size_and_explorer_whoever_was_faster(report):
    names = [(row.family, row.edges, row.explorer) for row in report.rows]
    order = {"lattice": 0, "cubic": 1, "algorithm1": 0, "folding-oldest": 1}
    assert names == sorted(names, key=lambda key: (order[key[0]], key[1], order[key[2]]))
    again = compare(
        "algorithm1", "folding-oldest", family=["lattice", "cubic"], to=30, draws=2, workers=2
    )
    assert again.rows == report.rows
