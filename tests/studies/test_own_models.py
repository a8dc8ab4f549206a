"""A lighthouse, a task and a class of the user's own at once, in every way to run a check."""

import pytest

import allworlds
from models import PARITY

EXPLORER = """
from allworlds import Move


def walks(first):
    for _ in range(2):
        yield Move(1)
    return "done"
"""

MODELS = f"""{PARITY}

def says(word):
    return lambda world, transcript, answer: None if answer == word else f"{{answer}} is said"


def small(degree):
    return lambda map_: max(map_.degrees) <= degree
"""

ASKED = {
    "edges": 3,
    "lighthouse": "models.py:Parity",
    "task": "models.py:says?word=done",
    "where": "models.py:small?degree=3",
}
WRONG = {**ASKED, "task": "models.py:says?word=home"}


@pytest.fixture
def folder(tmp_path, monkeypatch):
    (tmp_path / "models.py").write_text(MODELS)
    (tmp_path / "mine.py").write_text(EXPLORER)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_what_no_motion_tells_apart_under_it_is_told_of(folder):
    where = "models.py:small?degree=4"
    census = allworlds.ambiguity.census(edges=3, lighthouse=ASKED["lighthouse"], where=where)
    one, other = census.pair
    assert all(max(world.map.degrees) <= 4 for world in census.pair)
    twins = allworlds.twins(one, other)
    assert not twins.distinguishable
    assert twins.bisimulation
