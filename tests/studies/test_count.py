import pytest

from allworlds.engines.units import LevelUnit
from allworlds.inputs.checks import InputError
from allworlds.maps import MapClass, rooted_maps, unrooted_code
from allworlds.maps.classes import Extent
from allworlds.studies.count import count, count_one_by_one
from bruteforce import unrooted_maps


@pytest.mark.parametrize(
    ("map_class", "rooted"),
    [
        ("maps", [2, 10, 74, 706]),  # A000698
        ("planar", [2, 9, 54, 378]),  # Tutte
    ],
)
def test_rooted_maps_by_edges(map_class, rooted):
    census = count(edges=4, map_class=map_class)
    assert [row.rooted for row in census.rows] == rooted
    assert census.exit_code == 0
    for row in census.rows:
        assert sum(row.by_vertices.values()) == sum(row.by_genus.values()) == row.rooted


def test_unrooted_maps_by_edges():
    assert [row.unrooted for row in count(edges=4).rows] == [2, 5, 20, 107]


def test_simple_maps_by_vertices():
    census = count(map_class="simple", vertices=4)
    rooted, labelled = {}, {}
    for row in census.rows:
        for n in row.by_vertices:
            rooted[n] = rooted.get(n, 0) + row.by_vertices[n]
            labelled[n] = labelled.get(n, 0) + row.labelled[n]
    assert (rooted, labelled) == ({2: 1, 3: 3, 4: 32}, {2: 1, 3: 4, 4: 87})
    assert census.exit_code == 0


def test_no_edge_count_with_such_few_vertices_is_an_empty_row():
    census = count(edges=5, vertices=2, map_class="simple")
    assert [row.rooted for row in census.rows] == [1, 0, 0, 0, 0]
    assert census.exit_code == 0


@pytest.mark.parametrize("options", [{}, {"edges": 0}, {"vertices": 3}, {"map_class": "x"}])
def test_bad_bounds_are_refused(options):
    with pytest.raises(InputError):
        count(**options)


def test_the_rows_for_programs_count_by_vertices_and_genus_rooted_and_not():
    report = count(edges=4)
    rows = report.records()
    for row in report.rows:
        here = [one for one in rows if one["edges"] == row.edges]
        assert sum(one["rooted"] for one in here) == row.rooted
        assert sum(one["unrooted"] for one in here) == row.unrooted
        for key, told in (("vertices", row.by_vertices), ("genus", row.by_genus)):
            for value, maps in told.items():
                assert sum(one["rooted"] for one in here if one[key] == value) == maps
    # Of one map there are 2m / |Aut| rootings: each is one of these, up to isomorphism.
    found = {}
    for map_ in rooted_maps(4):
        code = unrooted_code(map_)
        found.setdefault((map_.vertex_count, map_.genus), set()).add(code)
    told = {(one["vertices"], one["genus"]): one["unrooted"] for one in rows if one["edges"] == 4}
    assert told == {cell: len(codes) for cell, codes in found.items()}


@pytest.mark.parametrize("map_class", ["maps", "planar", "simple"])
def test_maps_up_to_reflection_and_self_dual_ones_are_those_of_least_codes(map_class):
    """The maps of another enumeration, told apart by their least codes."""
    for row in count(edges=4, map_class=map_class).rows:
        unrooted = unrooted_maps(row.edges, map_class)
        codes = [(unrooted_code(m), unrooted_code(m.mirrored())) for m in unrooted]
        assert row.unrooted == len(codes)
        assert row.up_to_reflection == len({min(pair) for pair in codes})
        assert row.chiral == sum(own != mirror for own, mirror in codes)
        assert row.self_dual == sum(unrooted_code(m) == unrooted_code(m.dual()) for m in unrooted)


def test_a_condition_of_ones_own_may_hold_of_a_map_and_not_of_its_mirror_image(tmp_path):
    path = tmp_path / "first.py"
    path.write_text(
        "from allworlds.maps import unrooted_code\n"
        "def first(map_):\n"
        "    return unrooted_code(map_) <= unrooted_code(map_.mirrored())\n"
    )
    row = count(edges=4, where=f"{path}:first").rows[-1]
    assert (row.unrooted, row.chiral, row.up_to_reflection) == (96, 11, None)


def test_a_long_count_is_told_from_time_to_time(monkeypatch):
    monkeypatch.setattr("allworlds.studies.count.TOLD_EVERY", 4)
    told = count_one_by_one(Extent(MapClass.MAPS, 2), LevelUnit(2, ()))
    assert [sum(each.cells.values()) for each in told] == [4, 4, 2]
