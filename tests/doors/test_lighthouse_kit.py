"""The conformance kit of lighthouses: ours pass, and wrong ones do not."""

import pytest

from allworlds.inputs.checks import InputError
from allworlds.testing import assert_lighthouse
from allworlds.world import LIGHTHOUSES
from models import PARITY

WRONG = """
import itertools

from allworlds import Drop, Lighthouse, Percept


class Base(Lighthouse):
    @classmethod
    def places(cls, map_, start):
        yield cls()


class CountsItsCalls(Base):
    calls = itertools.count()

    def sensed(self, map_, here):
        return Percept(map_.degree_at[here], next(self.calls))


class LooksAtNames(Base):
    def sensed(self, map_, here):
        return Percept(map_.degree_at[here], int(here == 0))


class Twice(Base):
    @classmethod
    def places(cls, map_, start):
        yield cls()
        yield cls()


class Hides(Base):
    gives_marks = False

    def sensed(self, map_, here):
        return Percept(map_.degree_at[here], 1)


class Points(Base):
    gives_bearings = False

    def sensed(self, map_, here):
        return Percept(map_.degree_at[here], 0, 0)


class AtFirstName(Lighthouse):
    dart: int

    @classmethod
    def places(cls, map_, start):
        yield cls(min(map_.darts))


class Changes(Base):
    turn = itertools.count()

    @classmethod
    def places(cls, map_, start):
        for _ in range(next(cls.turn) % 2):
            yield cls()


class Nowhere(Base):
    @classmethod
    def places(cls, map_, start):
        yield from ()


class TellsNames(Base):
    def told(self, map_):
        return map_.alpha[0]


class TellsTurns(Base):
    turn = itertools.count()

    def told(self, map_):
        return next(self.turn)


class Marks(Base):
    leaves_marks = True

    def refusal(self, action, lying, hand):
        return "" if type(action) is Drop else "a Move or Drop"

    def acted(self, map_, state, action):
        return state.with_number(map_.vertex_of[state.dart], 1)

    def left_marks(self, map_, state):
        return state.number_at(map_.vertex_of[state.dart])


class SaysNothing(Marks):
    leaves_marks = False
"""


@pytest.mark.parametrize("kind", [*LIGHTHOUSES, "cluster:single=true", "compass+movable"])
def test_every_lighthouse_of_ours_passes(kind):
    assert_lighthouse(kind, edges=2)


def test_lighthouses_of_ones_own_pass(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "parity.py").write_text(PARITY)
    assert_lighthouse("parity.py:Parity")
    assert_lighthouse("parity.py:Copy+told:n")
    (tmp_path / "wrong.py").write_text(WRONG)
    assert_lighthouse("wrong.py:Marks")


@pytest.mark.parametrize(
    ("kind", "said"),
    [
        ("CountsItsCalls", "asked twice"),
        ("LooksAtNames", "with the darts renamed"),
        ("AtFirstName", "with the darts renamed"),
        ("Twice", "is there twice"),
        ("Hides", "gives_marks is False"),
        ("Points", "gives_bearings is False"),
        ("Changes", "asked twice"),
        ("Nowhere", "has no place in any map with at most 4 edges"),
        ("TellsNames", r"tells \d, asked again \d, and \d with the darts"),
        ("TellsTurns", "tells 0, asked again 1"),
    ],
)
def test_what_is_no_function_of_the_world_is_found(tmp_path, monkeypatch, kind, said):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "wrong.py").write_text(WRONG)
    with pytest.raises(AssertionError, match=said):
        assert_lighthouse(f"wrong.py:{kind}")


def test_a_lighthouse_that_lets_the_robot_leave_marks_says_so(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "wrong.py").write_text(WRONG)
    with pytest.raises(InputError, match="has a method refusal, but leaves_marks is False"):
        assert_lighthouse("wrong.py:SaysNothing")
