"""Costs beside the player's: those of runs, of the best strategy, and of the shortest walk."""

import pytest

from allworlds.studies.run import LARGEST, play
from studies.test_costs import costs


@pytest.mark.long
def test_in_large_worlds_algorithm1_is_not_compared():
    made = play(f"cycle:{LARGEST}")
    assert costs(made.world)["algorithm1"] > costs(made.world)["every-edge"] == LARGEST
    assert costs(play("cycle:201").world) == {"every-edge": 201}
