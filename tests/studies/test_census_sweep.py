from itertools import permutations

import pytest

from allworlds.documents.document import replace
from allworlds.engines.units import units_of_level
from allworlds.inputs.checks import InputError
from allworlds.maps import rooted_maps
from allworlds.outcome import Disagreement, Stopped
from allworlds.reports.formats import brief
from allworlds.studies.ambiguity import census, census_sweep
from allworlds.studies.ambiguity.census_sweep import SensedParts
from allworlds.studies.ambiguity.members import least_rooting
from allworlds.world.lighthouses.kinds import lighthouse_kind
from listeners import Hears


def numbers(row):
    return tuple(row.to_json().values())


def test_the_smallest_ambiguous_worlds_have_two_edges():
    # One vertex with two loops, in the plane and on the torus.
    assert [numbers(row) for row in census(edges=2).rows] == [(1, 2, 0, 0, 0), (2, 7, 2, 1, 2)]


def test_the_smallest_simple_ambiguous_worlds_have_six_edges_and_three_classes():
    rows = census(edges=6, map_class="simple").rows
    assert [row.classes for row in rows] == [0, 0, 0, 0, 0, 3]
    assert rows[-1].ambiguous_worlds == 6


@pytest.mark.parametrize("edges", [6])
def test_no_planar_simple_world_with_fewer_than_eight_edges_is_ambiguous(edges):
    rows = census(edges=edges, map_class="planar-simple").rows
    assert [row.classes for row in rows] == [0] * edges


def test_marked_worlds_weighed_by_their_rootings_are_the_rooted_maps():
    # A marked map has deg(v0) / |Aut| rootings at v0; 2, 10, 74, 706 rooted maps (A000698).
    for row, rooted in zip(census(edges=4).rows, (2, 10, 74, 706), strict=True):
        found = [least_rooting(m, m.vertices[0]) for m in rooted_maps(row.edges)]
        marked = {root.code: root.times for root in found}
        degrees = {
            root.code: m.degree_at[0] for root, m in zip(found, rooted_maps(row.edges), strict=True)
        }
        weights = [degrees[code] // times for code, times in marked.items()]
        assert sum(weights) == row.rooted == row.counted == rooted
        assert len(marked) == row.marked_worlds


def test_a_bound_on_the_vertices_is_one_for_every_row():
    all_rows = census(edges=3).rows
    few = census(edges=3, vertices=2).rows
    assert few[0] == all_rows[0]
    assert few[2].marked_worlds < all_rows[2].marked_worlds
    assert census(vertices=3, map_class="simple").rows[-1].edges == 3


def test_the_document_has_the_promised_parts():
    found = census(edges=2)
    document = found.to_json()
    assert document["rows"][1] == {
        "edges": 2,
        "marked_worlds": 7,
        "ambiguous_worlds": 2,
        "classes": 1,
        "largest_class": 2,
    }
    assert document["gate"]["agrees"] is True
    scope = document["scope"]
    assert (scope["class"], scope["edges"], scope["vertices"]) == ("maps", 2, None)
    assert found.exit_code == 0


def test_the_listener_hears_every_rooted_map():
    listener = Hears()
    census(edges=3, listener=listener)
    # 2, 10, 74 rooted maps (A000698).
    assert listener.heard == [(1, 2, 2), (2, 10, 10), (3, 74, 74)]
    assert listener.notices == []


def test_a_class_without_worlds_is_vacuous(monkeypatch):
    monkeypatch.setattr("allworlds.engines.units.rooted_maps", lambda *_: iter(()))
    found = census(edges=1)
    assert not found.gate.agrees
    assert found.exit_code == 70
    rows = tuple(replace(row, counted=0) for row in found.rows)
    assert replace(found, rows=rows).exit_code == 4


def test_a_forgotten_world_is_noticed(monkeypatch):
    def plane(*scope):
        return (map_ for map_ in rooted_maps(*scope) if map_.is_planar)

    monkeypatch.setattr("allworlds.engines.units.rooted_maps", plane)
    with pytest.raises(Disagreement, match="1 worlds were met of a class of 2"):
        census(edges=2)


@pytest.mark.parametrize(
    ("options", "named"),
    [
        ({"edges": 0}, "edges = 0"),
        ({}, "needs a bound"),
        ({"vertices": 3}, "vertices = 3 alone"),
        ({"edges": 2, "map_class": "round"}, "'round' is not one of maps"),
    ],
)
def test_bad_options_are_named(options, named):
    with pytest.raises(InputError, match=named):
        census(**options)


def test_the_two_smallest_worlds_of_a_look_are_a_pair_in_whatever_order_they_come():
    sizes = {"large": (4, 1), "small": (2, 1), "middle": (3, 1)}
    for order in permutations(sizes):
        met = SensedParts(0, sizes)
        for name in order:
            met.add(SensedParts(0, looks={"look": name}))
        assert met.smallest_pair() == ("small", "middle")
        assert [sorted(found) for found in met.classes()] == [sorted(sizes)]


def test_why_rows_are_missing_is_told():
    found = replace(census(edges=1), ending=Stopped("the time is up"))
    assert found.to_json()["stopped"] == "the time is up"


def test_the_worlds_of_all_sizes_are_added_up_in_the_headline():
    assert brief(census(edges=2), 100).startswith("AMBIGUOUS: 2 of 9 marked worlds")
    assert brief(census(edges=1), 100).startswith("TOLD APART: no two of 2 marked worlds")


@pytest.mark.parametrize(
    ("batch", "sizes"), [(2000, [10]), (11, [10]), (10, [10, 0]), (4, [4, 4, 2]), (5, [5, 5, 0])]
)
def test_worlds_come_in_batches_and_each_once(batch, sizes, monkeypatch):
    kind = lighthouse_kind("position")
    extent = census_sweep.CensusRequest(lighthouse=kind, edges=3).extent
    unit = next(iter(units_of_level(extent, 3)))
    ((_, every),) = census_sweep.batches(unit, extent, kind)
    monkeypatch.setattr(census_sweep, "BATCH", batch)
    made = [*census_sweep.batches(unit, extent, kind)]
    assert [(maps, len(worlds)) for maps, worlds in made] == [(size, size) for size in sizes]
    assert [each for _, worlds in made for each in worlds] == every
