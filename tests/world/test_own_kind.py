"""Lighthouses of the user's own: found by name, known by content, and watched."""

import copy
import pickle

import pytest

from allworlds.inputs import InputError
from allworlds.protocol import Percept
from allworlds.world import (
    InvalidWorld,
    Lighthouse,
    Position,
    World,
    kind_of,
    lighthouse_kind,
    lighthouse_named,
    worlds,
)
from models import PARITY
from small import PLANE, TORUS, all_maps

BAD = """
from allworlds import Lighthouse, Percept


class NoPlaces(Lighthouse):
    pass


class Base(Lighthouse):
    @classmethod
    def places(cls, map_, start):
        yield cls()


class Raises(Base):
    def sensed(self, map_, here):
        return 1 // 0


class RaisesPlaces(Base):
    @classmethod
    def places(cls, map_, start):
        yield cls()
        raise KeyError("lamp")


class Foreign(Base):
    @classmethod
    def places(cls, map_, start):
        yield Base()


class Short(Base):
    def percepts(self, map_):
        return [Percept(1)]


class Degree(Base):
    def sensed(self, map_, here):
        return Percept(7)


class Negative(Base):
    def sensed(self, map_, here):
        return Percept(map_.degree_at[here], 0, -1)


class Texts(Base):
    def sensed(self, map_, here):
        return "dark"


class Exits(Base):
    def sensed(self, map_, here):
        raise SystemExit(0)


def nothing():
    return 3
"""


@pytest.fixture
def folder(tmp_path, monkeypatch):
    (tmp_path / "parity.py").write_text(PARITY)
    (tmp_path / "bad.py").write_text(BAD)
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize(
    ("name", "modulus"),
    [
        ("parity.py:Parity", 2),
        ("parity.py:Parity:modulus=3", 3),
        ("parity.py:Parity?modulus=3", 3),
        ("parity.py:parity?modulus=5", 5),
    ],
)
def test_a_class_of_a_file_is_a_kind_of_lighthouse_with_its_options(folder, name, modulus):
    kind = lighthouse_named(name)
    assert issubclass(kind, Lighthouse)
    assert kind is lighthouse_named(name)
    for map_ in all_maps(2):
        places = [*kind.places(map_, 0)]
        assert len(places) == map_.degree_at[0]
        for bearing, place in enumerate(places):
            sensed = World(map_, place).percepts[0]
            assert sensed == Percept(map_.degree_at[0], 1, bearing % modulus)


def test_it_is_written_with_its_options_and_its_digest_and_read_again(folder):
    world = next(worlds(edges=2, lighthouse="parity.py:Parity:modulus=3"))
    document = world.to_json()["lighthouse"]
    assert document["kind"] == "parity.py:Parity"
    assert document["options"] == {"modulus": 3}
    assert World.from_json(world.to_json()) == world
    (folder / "parity.py").write_text(PARITY + "\n")
    with pytest.raises(InvalidWorld, match="has another text now"):
        World.from_json(world.to_json())


def test_a_place_goes_to_other_processes_with_the_text_of_its_class(folder):
    kind = lighthouse_kind("parity.py:Parity:modulus=3")
    place = next(kind.as_class.places(PLANE, 0))
    (folder / "parity.py").unlink()
    again = pickle.loads(pickle.dumps((kind, place)))
    assert again == (kind, place)
    assert kind_of(again[1]) == kind
    assert copy.deepcopy(place) == place


def test_a_class_in_python_is_found_by_its_module(folder, monkeypatch):
    monkeypatch.syspath_prepend(folder)
    from parity import Parity

    kind = lighthouse_kind(Parity)
    assert str(kind) == "parity:Parity"
    assert [world.percepts[0] for world in worlds(edges=1, lighthouse=Parity)]

    class Local(Parity):
        pass

    with pytest.raises(InvalidWorld, match="put it into a file of its own"):
        lighthouse_kind(Local)
    assert lighthouse_kind(Position).name == "position"


def test_renaming_darts_renames_the_darts_of_a_place(folder):
    kind = lighthouse_named("parity.py:Parity")
    names = [2, 3, 0, 1]
    for map_ in (PLANE, TORUS):
        for place in kind.places(map_, 0):
            world = World(map_, place)
            other = world.relabelled(names)
            for dart in map_.darts:
                assert other.percepts[names[dart]] == world.percepts[dart]


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("bad.py:NoPlaces", "is no lighthouse"),
        ("bad.py:nothing", "is no lighthouse"),
        ("bad.py:absent", "'bad.py' has no 'absent'"),
        ("absent.py:Lamp", "there is no file 'absent.py'"),
        ("bad.py:Base:size=3", "has no option 'size'; legal are none"),
        ("parity.py:Parity:modulus=two", "is of the type str, not int"),
        ("parity.py:Parity?modulus", "is not of the form key=value"),
        ("parity.py:parity?colour=2", "unexpected keyword argument"),
        ("position+bad.py:Base", "both have marks"),
    ],
)
def test_what_is_no_lighthouse_is_refused_in_one_line(folder, name, said):
    with pytest.raises(InputError, match=said.replace("(", r"\(")) as error:
        lighthouse_kind(name)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(
    ("kind", "said"),
    [
        ("Raises", "sensed raises ZeroDivisionError"),
        ("RaisesPlaces", "places raises KeyError: 'lamp'"),
        ("Foreign", "write yield cls"),
        ("Short", "has 1 percepts for 2 darts"),
        ("Degree", "legal is Percept"),
        ("Negative", "legal is Percept"),
        ("Texts", "senses 'dark'"),
        ("Exits", "sensed raises SystemExit"),
    ],
)
def test_an_error_in_a_lighthouse_is_bad_input_that_names_it(folder, kind, said):
    with pytest.raises(InvalidWorld, match=said) as error:
        [world.percepts for world in worlds(edges=1, lighthouse=f"bad.py:{kind}", places="all")]
    assert f"bad.py:{kind}" in str(error.value)


def test_a_copy_of_ours_senses_what_ours_does(folder):
    theirs = worlds(edges=4, lighthouse="parity.py:Copy", places="all")
    ours = worlds(edges=4, lighthouse="position", places="all")
    assert [(w.map, w.percepts) for w in theirs] == [(w.map, w.percepts) for w in ours]
