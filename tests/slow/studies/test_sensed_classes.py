"""The census of any lighthouse."""

import pytest

from allworlds.ambiguity import census
from allworlds.studies.ambiguity import sensed_classes
from studies import test_sensed_classes as quick

folder = quick.folder


@pytest.mark.slowest
@pytest.mark.parametrize(
    ("kind", "edges"),
    [("natural", 4), ("heard.py:Words", 4), ("heard.py:Neighbour", 4)],
)
def test_parts_are_those_that_comparing_every_two_worlds_gives(folder, kind, edges):
    quick.test_parts_are_those_that_comparing_every_two_worlds_gives(folder, kind, edges)


@pytest.mark.parametrize(("kind", "told"), [("natural", quick.degrees_of_natural)])
def test_what_is_told_is_a_part_of_a_world_with_four_edges(folder, kind, told):
    quick.test_what_is_told_is_a_part_of_a_world(folder, kind, told, edges=4)


@pytest.mark.slowest
@pytest.mark.parametrize(
    ("kind", "last"),
    [
        ("none", (870, 175, 23, 105)),
        ("position", (2286, 153, 22, 105)),
        ("door", (8162, 0, 0, 0)),
        ("natural", (1333, 20, 10, 2)),
        ("cluster", (2993, 28, 11, 8)),
        ("compass", (6332, 32, 13, 4)),
        ("labels", (8162, 0, 0, 0)),
        ("word:12", (5882, 68, 21, 28)),
    ],
)
def test_a_census_by_compiled_code_is_the_one_without(monkeypatch, kind, last):
    # The numbers are those of the census that compared one world after the other.
    compiled = census(edges=5, lighthouse=kind)
    monkeypatch.setattr(sensed_classes, "compiled_name", lambda *_: "")
    assert compiled.to_json() == census(edges=5, lighthouse=kind).to_json()
    row = compiled.rows[-1]
    found = row.marked_worlds, row.ambiguous_worlds, row.classes, row.largest_class
    assert found == last
