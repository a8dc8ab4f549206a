"""Another world that agrees with the log: it is another one, and it does agree."""

import pytest

from judging import test_another_world as quick
from small import long


@pytest.mark.parametrize("map_class", [long("maps")])
def test_in_every_small_world_and_for_every_short_walk_it_is_another_and_senses_the_same(map_class):
    quick.test_in_every_small_world_and_for_every_short_walk_it_is_another_and_senses_the_same(
        map_class
    )
