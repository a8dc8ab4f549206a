"""``folding``: the log does not determine the map."""

from __future__ import annotations

from allworlds.explaining.open_darts import tell_open_darts
from allworlds.explaining.story import Story
from allworlds.explaining.telling import Telling


def tell_folding(story: Story) -> Telling:
    """What the log leaves open."""
    guessed = "The log does not determine the map, so the answer, right or not, was guessed."
    return Telling([guessed, *tell_open_darts(story)])
