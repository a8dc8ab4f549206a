"""The mistakes of a user's model, each told with its method."""

from dataclasses import dataclass
from typing import Any

import pytest

from allworlds.protocol.actions import Move, Percept
from allworlds.robots.model import Model, ModelError
from allworlds.robots.single_search import search
from small import EDGE


@dataclass(frozen=True)
class Given(Model):
    """A model whose answers are given.

    Attributes:
        percept: of each robot.
        following: what ``step`` yields.
    """

    percept: Any = 0
    following: tuple = ((0, ""),)
    first: Any = 0

    def initial(self, map_, starts):
        yield self.first

    def sensed(self, map_, state, robot):
        return self.percept

    def step(self, map_, state, acts):
        yield from self.following


@pytest.mark.parametrize(
    ("model", "told"),
    [
        (Given(Percept(1, marks=True)), "not of integers, in its method sensed"),
        (Given({1, 2} | {object()}), "neither a Percept nor a value that JSON has"),
        (Given(following=()), "yields no state after"),
        (Given(following=(0,)), "which is not a pair of a state and words"),
        (Given(following=(([], ""),)), "yields a state that is not hashable, of the type list"),
        (Given(first={}), "not hashable, of the type dict"),
        (Given(following=1), "raises TypeError, line"),
    ],
)
def test_a_mistake_of_a_model_is_told_with_its_method(model, told):
    def move(first):
        yield Move(1)

    with pytest.raises(ModelError, match=told):
        search(EDGE, (0,), model, [move])
