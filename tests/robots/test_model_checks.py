"""A model that answers otherwise when it is asked again, or that tells names of darts apart."""

from itertools import count
from types import SimpleNamespace

import pytest

from allworlds.inputs.checks import InputError
from allworlds.robots import model_checks
from allworlds.robots.model import ModelError
from studies.test_team import team


class Searched(SimpleNamespace):
    """A search of two configurations, between which there is one step."""

    def __init__(self, sensed=7, follows="there"):
        super().__init__(
            world=SimpleNamespace(name="own", sensed=lambda *_: sensed),
            states=["here", "there"],
            program_of=(0, 0),
            full=True,
            sensed_first=lambda number, robot: 7 if (number, robot) == (0, 1) else None,
            state_number=int,
            graph=SimpleNamespace(
                transitions=lambda number: [5] if number == 0 else [],
                target=lambda step: 1 if step == 5 else 0,
                transition=lambda number, step: (number, step, follows),
            ),
        )

    def __len__(self):
        return len(self.states)


@pytest.fixture(autouse=True)
def events(monkeypatch):
    event = lambda _, step: SimpleNamespace(state=step[2])  # noqa: E731  # short
    monkeypatch.setattr(model_checks, "event_of", event)


def test_a_model_that_answers_the_same_again_is_one():
    model_checks.ensure_same_model(Searched())


def test_what_is_sensed_otherwise_the_second_time_is_a_fault():
    with pytest.raises(ModelError, match="'own' is not the same twice: robot 1 senses something"):
        model_checks.ensure_same_model(Searched(sensed=8))


def test_another_state_that_follows_is_a_fault():
    with pytest.raises(ModelError, match="another state follows 'here' after the same actions"):
        model_checks.ensure_same_model(Searched(follows="elsewhere"))


def test_the_darts_are_turned_and_reversed():
    assert model_checks._other_names(4) == [[1, 2, 3, 0], [3, 2, 1, 0]]


def test_a_model_that_tells_names_of_darts_apart_is_a_fault(monkeypatch):
    monkeypatch.undo()
    events = count()
    monkeypatch.setattr(model_checks, "_verdict", lambda _: ("progress", next(events)))
    with pytest.raises(InputError, match="tells renumbered darts apart: progress is broken in the"):
        team("waits", "searches", edges=1)


@pytest.mark.parametrize(
    ("found", "verdict"),
    [
        (None, ("", 2)),
        (SimpleNamespace(law="deadlock", cycle=(), at=3), ("deadlock", 4)),
        (SimpleNamespace(law="progress", cycle=(1,), at=3), ("progress", 0)),
    ],
)
def test_a_verdict_is_the_law_and_the_least_number_of_events(found, verdict):
    search = Searched()
    search.broken, search.way = found, lambda at: [*range(at + 1)]
    assert model_checks._verdict(search) == verdict
