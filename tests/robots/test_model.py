"""The mistakes of a user's model, each told with its method."""

from dataclasses import dataclass
from typing import Any

import pytest

from allworlds.protocol.actions import Move, Percept
from allworlds.robots.model import Liveness, Model, ModelError, ModelInMap
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
    begins: Any = ((0,),)
    reason: Any = ""

    def starts(self, map_, robots):
        return self.begins

    def initial(self, map_, starts):
        yield self.first

    def sensed(self, map_, state, robot):
        return self.percept

    def step(self, map_, state, acts):
        yield from self.following

    def bad(self, map_, state):
        return self.reason

    def told(self, map_, robot):
        if robot:
            raise ValueError("only one")

    def progress(self, map_):
        yield Liveness("lit", forever=False, holds=lambda state: state.lit)


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


EVERY = [
    lambda model: model.initial(EDGE, (0,)),
    lambda model: model.sensed(EDGE, 0, 0),
    lambda model: model.step(EDGE, 0, {}),
]


@pytest.mark.parametrize("call", EVERY)
def test_a_model_has_a_start_percepts_and_steps_of_its_own(call):
    with pytest.raises(NotImplementedError):
        call(Model())


@pytest.mark.parametrize(
    ("begins", "shown"),
    [
        (((0, 2),), "(0, 2)"),
        (((-1, 0),), "(-1, 0)"),
        (((0,),), "(0,)"),
        (((0, 0), (0, 0, 0)), "(0, 0, 0)"),
        (([0, 1],), "[0, 1]"),
    ],
)
def test_a_start_of_a_model_is_a_dart_for_each_robot(begins, shown):
    assert ModelInMap(Given(begins=((0, 1),)), EDGE, "own").starts(2) == [(0, 1)]
    legal = "a tuple of 2 darts, each from 0 to 1"
    with pytest.raises(ModelError) as refused:
        ModelInMap(Given(begins=begins), EDGE, "own").starts(2)
    assert f"'own' yields {shown}, which is not {legal}, in its method st" in str(refused.value)
    assert str(refused.value).endswith("; sigma=[0, 1] alpha=[1, 0]")


def test_a_reason_why_a_state_is_bad_is_a_text():
    assert ModelInMap(Given(reason="dark"), EDGE, "own").bad(0) == "dark"
    with pytest.raises(ModelError, match="returns True, which is not a text, in its method bad"):
        ModelInMap(Given(reason=True), EDGE, "own").bad(0)


def test_an_error_in_a_condition_or_in_an_answer_is_told_with_its_method():
    world = ModelInMap(Given(), EDGE, "own")
    (condition,) = world.progress()
    with pytest.raises(ModelError, match=r"raises AttributeError, .*, in its method progress"):
        world.holds(condition, 0)
    assert world.told(0) is None
    with pytest.raises(ModelError, match=r"raises ValueError, line .*: only one, in its method"):
        world.told(1)
