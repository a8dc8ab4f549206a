import pytest

import allworlds
from allworlds.maps import MapClass, contracted, deleted
from allworlds.studies.fuzz.sample_sweep import fuzz
from small import slowest
from studies import test_shrinking as quick
from studies.test_shrinking import smallest

large = quick.large


@pytest.mark.parametrize(("edges", "degree"), [(5, 4), slowest(9, 6)])
def test_shrinking_stays_in_its_class(planted, edges, degree):
    # The smallest plane simple maps with so many edges and a vertex of that degree: a wheel's
    # hub with all of its spokes, and some edges of its rim.
    report = fuzz(planted(edges, degree), edges=edges + 5, runs=100, map_class="planar-simple")
    (finding,) = report.findings
    map_ = finding.world.map
    assert MapClass.PLANAR_SIMPLE.includes(map_)
    assert (map_.edge_count, map_.vertex_count) == (edges, degree + 1)


@pytest.mark.parametrize(
    "condition",
    [
        lambda map_: map_.is_simple and max(map_.degrees) >= 3,
        lambda map_: len(map_.faces) >= 3 and map_.vertex_count >= 3,
        lambda map_: map_.genus == 0 and sorted(map_.degrees)[-2:] == [3, 3],
    ],
)
def test_no_single_deletion_or_contraction_of_the_last_step_refutes(large, condition):
    steps, _ = smallest(large, lambda world: condition(world.map))
    map_ = steps[-1].world.map
    assert condition(map_)
    neighbours = [change(map_, dart) for dart in map_.darts for change in (deleted, contracted)]
    assert not any(condition(other) for other in neighbours if other)


def test_where_every_world_refutes_one_loop_is_left(large):
    steps, _ = smallest(large, lambda world: True)
    assert steps[-1].world.map == allworlds.CombinatorialMap((1, 0), (1, 0))
