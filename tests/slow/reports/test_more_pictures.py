"""The pictures of the other maps with three edges."""

import pytest

from reports import test_svg as quick

pytestmark = pytest.mark.parametrize("map_", quick.REST, ids=str)


def test_every_dart_and_every_vertex_is_named_once(map_):
    quick.test_every_dart_and_every_vertex_is_named_once(map_)


def test_a_darts_number_stands_beside_its_vertex_in_the_darts_direction(map_):
    quick.test_a_darts_number_stands_beside_its_vertex_in_the_darts_direction(map_)
