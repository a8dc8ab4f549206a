import pytest

from allworlds.studies.ambiguity.formulas import forbid_other_start, pair_formula
from searches import question
from small import slowest
from studies import test_encoder as quick
from studies.test_encoder import solved


@pytest.mark.slowest
def test_a_pair_that_is_one_world_started_twice_is_excluded_by_its_other_start(tmp_path):
    # Planar simple, 6 edges: one map has two starts that look alike; nothing else does.
    asked = question("position", "planar-simple", 6, 6)
    sizes = list(asked.sizes())[-1]
    formula, pair = pair_formula(asked, sizes)
    assert solved(tmp_path / "f.cnf", formula) == "sat"
    for start in range(1, 12):
        forbid_other_start(formula, pair, start)
    assert solved(tmp_path / "f.cnf", formula) == "unsat"


@pytest.mark.slowest
@pytest.mark.parametrize(
    ("map_class", "edges", "count"),
    [slowest("maps", 4, 706), ("planar", 4, 378)],
)
def test_the_models_of_one_world_are_the_rooted_maps_of_the_class(
    tmp_path, map_class, edges, count
):
    quick.test_the_models_of_one_world_are_the_rooted_maps_of_the_class(
        tmp_path, map_class, edges, count
    )


@pytest.mark.parametrize("map_class", ["maps", "planar"])
@pytest.mark.parametrize(("fewest", "most"), [(2, 3), (4, 4)])
def test_bounds_on_the_vertices_leave_exactly_the_maps_within_them(
    tmp_path, map_class, fewest, most
):
    quick.test_bounds_on_the_vertices_leave_exactly_the_maps_within_them(
        tmp_path, map_class, fewest, most
    )
