"""The shortest walk along every edge, against a search through all walks."""

import pytest

from maps import test_postman as quick


@pytest.mark.parametrize("edges", [4])
def test_no_walk_along_every_edge_is_shorter_and_one_is_so_long(edges):
    quick.test_no_walk_along_every_edge_is_shorter_and_one_is_so_long(edges)
