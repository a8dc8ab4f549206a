"""The census of any lighthouse."""

import pytest

from studies import test_sensed_worlds as quick

folder = quick.folder


@pytest.mark.long
@pytest.mark.parametrize(
    ("kind", "edges"),
    [("natural", 4), ("heard.py:Words", 4), ("heard.py:Neighbour", 4)],
)
def test_parts_are_those_that_comparing_every_two_worlds_gives(folder, kind, edges):
    quick.test_parts_are_those_that_comparing_every_two_worlds_gives(folder, kind, edges)


@pytest.mark.parametrize(("kind", "told"), [("natural", quick.degrees_of_natural)])
def test_what_is_told_is_a_part_of_a_world_with_four_edges(folder, kind, told):
    quick.test_what_is_told_is_a_part_of_a_world(folder, kind, told, edges=4)
