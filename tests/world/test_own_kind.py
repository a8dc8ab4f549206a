"""Lighthouses of the user's own: found by name, known by content, and checked."""

import copy
import importlib
import json
import pickle
from pathlib import Path

import pytest

from allworlds import check, replay
from allworlds.inputs.checks import InputError
from allworlds.protocol.actions import Drop, Percept
from allworlds.protocol.user_code import OtherText
from allworlds.world import InvalidWorld, Lighthouse, Position, World, worlds
from allworlds.world.lighthouses.kinds import kind_of, lighthouse_kind
from models import PARITY
from small import EDGE, PLANE, TORUS, all_maps

BAD = """
from dataclasses import dataclass

from allworlds import Lighthouse, Percept


class NoPlaces(Lighthouse):
    pass


class Base(Lighthouse):
    @classmethod
    def places(cls, map_, start):
        yield cls()


@dataclass
class Thawed(Base):
    size: int = 0


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


class Marks(Base):
    leaves_marks = True

    def refusal(self, action, lying, hand):
        return ""


class HoldsTwo(Marks):
    in_hand = 2


class HoldsText(Marks):
    in_hand = "two"


class ActsNot(Marks):
    def acted(self, map_, state, action):
        return 1 // 0


class ActsFive(Marks):
    def acted(self, map_, state, action):
        return 5


class Moves(Marks):
    def acted(self, map_, state, action):
        return type(state)(map_.alpha[state.dart])


class Half(Marks):
    def acted(self, map_, state, action):
        return type(state)(state.dart, written=((0, "a"),))


class Refuses(Base):
    leaves_marks = True

    def refusal(self, action, lying, hand):
        return None


class Leaves(Marks):
    def left_marks(self, map_, state):
        return "many"


class Holds(Base):
    @property
    def in_hand(self):
        return -1


class Tells(Base):
    def told(self, map_):
        return {"x": object()}


class TellsDarts(Base):
    def told(self, map_):
        return map_.alpha[0] + map_.sigma[0]


class Far(Base):
    def sensed(self, map_, here):
        return Percept(map_.degree_at[here], 0, map_.degree_at[here])


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
    kind = lighthouse_kind(name).as_class
    assert issubclass(kind, Lighthouse)
    assert kind is lighthouse_kind(name).as_class
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
    with pytest.raises(OtherText, match="has another text now"):
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

    with pytest.raises(InputError, match="put it into a file of its own"):
        lighthouse_kind(Local)
    assert lighthouse_kind(Position).name == "position"


def test_renaming_darts_renames_the_darts_of_a_place(folder):
    kind = lighthouse_kind("parity.py:Parity").as_class
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
        ("bad.py:Thawed", "is no frozen dataclass"),
        ("bad.py:absent", "'bad.py' has no 'absent'"),
        ("absent.py:Lamp", "there is no file 'absent.py'"),
        ("bad.py:Base:size=3", "has no option 'size'; it has none"),
        ("parity.py:Parity:modulus=two", "option modulus = 'two' is not an integer"),
        ("parity.py:Parity?modulus", "is not of the form key=value"),
        ("parity.py:parity?colour=2", "unexpected keyword argument 'colour'; legal is (modulus"),
        ("position+bad.py:Base", "both have marks"),
    ],
)
def test_what_is_no_lighthouse_is_refused_in_one_line(folder, name, said):
    with pytest.raises(InputError, match=said.replace("(", r"\(")) as error:
        lighthouse_kind(name)
    assert "\n" not in str(error.value)


def leave_a_mark(world):
    world.step(world.initial, Drop())


@pytest.mark.parametrize(
    ("kind", "said"),
    [
        ("Raises", "sensed raises ZeroDivisionError"),
        ("RaisesPlaces", "places raises KeyError: 'lamp'"),
        ("Foreign", "write yield cls"),
        ("Short", "percepts of the lighthouse .* for each dart"),
        ("Degree", "legal is Percept"),
        ("Negative", "legal is Percept"),
        ("Far", "bearing=1.* below the degree"),
        ("Texts", "gives .*'dark'.*; legal is Percept"),
        ("Exits", "sensed raises SystemExit"),
        ("ActsNot", "acted raises ZeroDivisionError"),
        ("ActsFive", "acted of the lighthouse .* gives 5; legal is a State"),
        ("Moves", "acted of the lighthouse .* legal is a State with the dart of the one before"),
        ("Half", "acted of the lighthouse .* legal is a State"),
        ("Refuses", "refusal of the lighthouse .* gives None; legal is a text"),
        ("Leaves", "left_marks of the lighthouse .* gives 'many'; legal is an integer"),
        ("Holds", "in_hand of the lighthouse .* gives -1; legal is an integer from 0 on"),
        ("HoldsText", "in_hand of the lighthouse .* gives 'two'; legal is an integer from 0 on"),
        ("Tells", "told of the lighthouse .* legal is an integer, a dict"),
        ("TellsDarts", "tells 1, asked again 1, and 5 with the darts"),
    ],
)
def test_an_error_in_a_lighthouse_is_bad_input_that_names_it(folder, kind, said):
    with pytest.raises(InvalidWorld, match=said) as error:
        leave_a_mark(next(worlds(edges=1, lighthouse=f"bad.py:{kind}")))
    assert f"bad.py:{kind}" in str(error.value)
    assert "object at 0x" not in str(error.value) or kind == "Tells"


NUMPY = """
from dataclasses import dataclass

import numpy as np
from allworlds import Lighthouse, Percept


@dataclass(frozen=True)
class Lamp(Lighthouse):
    dart: int
    size: int
    more: object = None

    @classmethod
    def places(cls, map_, start):
        yield cls(np.int64(start), np.uint8(7))

    def sensed(self, map_, here):
        return Percept(np.int64(map_.degree_at[here]), np.int64(here == self.dart))


class Half(Lamp):
    @classmethod
    def places(cls, map_, start):
        yield cls(np.int64(start), np.float32(0.5))


class Yes(Lamp):
    @classmethod
    def places(cls, map_, start):
        yield cls(np.int64(start), 7, np.bool_(True))


class List(Lamp):
    @classmethod
    def places(cls, map_, start):
        yield cls(np.int64(start), np.array(7), np.array([1]))


class Set(Lamp):
    @classmethod
    def places(cls, map_, start):
        yield cls(np.int64(start), 7, frozenset({5}))
"""


def test_an_integer_of_numpy_in_a_field_is_written_as_an_integer(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("of_numpy.py").write_text(NUMPY)
    report = check(gives_up, edges=2, lighthouse="of_numpy.py:Lamp")
    (finding,) = report.findings[:1]
    told = json.loads(finding.text)["world"]["lighthouse"]
    assert (told["dart"], told["size"]) == (finding.world.start, 7)
    assert replay(finding, gives_up).outcome == "reproduced"


@pytest.mark.parametrize(
    ("kind", "value"),
    [
        ("Half", r"np.float32\(0.5\)"),
        ("Yes", "np.True_"),
        ("List", "array"),
        ("Set", r"frozenset\(\{5\}\)"),
    ],
)
def test_a_field_that_no_document_can_hold_is_refused(kind, value, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("of_numpy.py").write_text(NUMPY)
    with pytest.raises(InputError, match=f"{value}.* has a field that no document can hold"):
        next(worlds(edges=1, lighthouse=f"of_numpy.py:{kind}"))


def gives_up(first):
    return None
    yield


def test_the_hand_may_be_a_number_in_the_class(folder):
    assert next(worlds(edges=1, lighthouse="bad.py:HoldsTwo")).initial.hand == 2


def test_a_field_with_a_default_is_an_option_and_one_without_is_none(folder):
    (folder / "mine.py").write_text(
        "from dataclasses import dataclass\nfrom typing import ClassVar\n"
        "from allworlds import Lighthouse, Percept\n"
        "@dataclass(frozen=True, slots=True)\nclass Lamp(Lighthouse):\n"
        "    darts: tuple[int, ...]\n    often: int = 1\n"
        "    name: str = 'a'\n    bright: float = 0.5\n    lit: bool = True\n"
        "    height: ClassVar[int] = 3\n"
        "    @classmethod\n    def places(cls, map_, start):\n        yield cls((start,))\n"
        "    def sensed(self, map_, here):\n"
        "        marks = self.often * self.lit * (self.name == 'b')\n"
        "        return Percept(map_.degree_at[here], marks)\n"
        "class Forgets(Lamp):\n"
        "    @classmethod\n    def places(cls, map_, start):\n        yield Lamp((start,))\n"
        "class Careless(Lamp):\n    often = 4\n"
    )
    (place,) = lighthouse_kind("mine.py:Lamp:often=3,name=b").as_class.places(EDGE, 0)
    assert (place.often, place.name, place.lit) == (3, "b", True)
    world = World(EDGE, place)
    assert world.first == Percept(1, 3)
    told = world.to_json()["lighthouse"]
    assert told["options"] == {"often": 3, "name": "b"}
    assert told["darts"] == [0]
    assert World.from_json(world.to_json()) == world == pickle.loads(pickle.dumps(world))
    assert str(kind_of(place)) == "mine.py:Lamp?often=3,name=b"
    assert (
        World(EDGE, next(lighthouse_kind("mine.py:Lamp").as_class.places(EDGE, 0))).first.marks == 0
    )
    for name, said in (
        ("mine.py:Lamp:height=4", "has no option 'height'; legal: often, name, lit"),
        ("mine.py:Lamp:bright=1", "no option 'bright'; legal: often, name, lit"),
        ("mine.py:Lamp:lit=3", "option lit = '3' is neither true nor false"),
        ("mine.py:Careless", "sets often = 4 without a type, and so the field keeps 1"),
        ("parity.py:forgets?modulus=5", "sets modulus = 5 without a type"),
    ):
        with pytest.raises(InvalidWorld, match=said):
            lighthouse_kind(name)
    with pytest.raises(InvalidWorld, match=r"write yield cls\(...\)"):
        [*lighthouse_kind("mine.py:Forgets").as_class.places(EDGE, 0)]


def test_options_stand_beside_the_name_of_a_kind_and_not_in_it(folder):
    own = World(EDGE, next(lighthouse_kind("parity.py:Parity").as_class.places(EDGE, 0))).to_json()
    for kind in ("doormarks:states=3", "parity.py:Parity?modulus=3", "compass+movable"):
        lighthouse = {**own["lighthouse"], "kind": kind}
        with pytest.raises(InvalidWorld, match="is more than a name"):
            World.from_json({**own, "lighthouse": lighthouse})
    written = World.from_json({**EDGE.to_json(), "lighthouse": {"kind": "doormarks", "states": 3}})
    assert str(kind_of(written.lighthouse)) == "doormarks:states=3"


def test_what_a_lighthouse_prints_gets_to_stderr(folder, capsys):
    (folder / "loud.py").write_text(
        PARITY.replace("        if map_", "        print('lit')\n        if map_", 1)
    )
    next(worlds(edges=1, lighthouse="loud.py:Parity"))
    heard = capsys.readouterr()
    assert (heard.out, heard.err[:4]) == ("", "lit\n")


def test_a_copy_of_ours_senses_what_ours_does(folder):
    theirs = worlds(edges=4, lighthouse="parity.py:Copy", places="all")
    ours = worlds(edges=4, lighthouse="position", places="all")
    assert [(w.map, w.percepts) for w in theirs] == [(w.map, w.percepts) for w in ours]


def test_places_sees_an_option_by_its_name_and_not_among_the_fields(folder):
    (folder / "seen.py").write_text(
        "from dataclasses import dataclass, fields\n\nfrom allworlds import Lighthouse\n\n\n"
        "@dataclass(frozen=True)\nclass Seen(Lighthouse):\n    dart: int\n    of: int = 2\n\n"
        "    @classmethod\n    def places(cls, map_, start):\n"
        "        assert cls.of == cls(start).of\n"
        "        assert fields(cls)[1].default == 2\n        yield cls(start)\n"
    )
    kind = lighthouse_kind("seen.py:Seen:of=5").as_class
    assert [place.of for place in kind.places(PLANE, 0)] == [5]


MODULE = """
from dataclasses import dataclass

from allworlds import Lighthouse, Percept


class Bare(Lighthouse):
    dart: int = 0

    @classmethod
    def places(cls, map_, start):
        yield cls(start)

    def sensed(self, map_, here):
        return Percept(map_.degree_at[here], int(here == self.dart))


@dataclass(frozen=True)
class Decorated(Bare):
    turned: int = 0

    @classmethod
    def places(cls, map_, start):
        yield Decorated(start)
"""


@pytest.mark.parametrize("name", ["Bare", "Decorated"])
def test_the_users_own_class_stays_as_it_was(tmp_path, monkeypatch, name):
    module = f"lamp_{name.lower()}"
    (tmp_path / f"{module}.py").write_text(MODULE)
    monkeypatch.syspath_prepend(tmp_path)
    theirs = getattr(importlib.import_module(module), name)
    before = dict(vars(theirs))
    own = lighthouse_kind(theirs).as_class
    (place,) = own.places(EDGE, 0)
    assert vars(theirs) == before
    assert type(place) is own is not theirs
    assert issubclass(own, theirs)
    assert own.__qualname__ == name
    assert pickle.loads(pickle.dumps(place)) == place
    assert lighthouse_kind(theirs) == lighthouse_kind(own) == kind_of(place)


def test_a_place_of_the_users_class_is_one_of_the_kind_that_was_made_from_it(tmp_path, monkeypatch):
    (tmp_path / "lamp_placed.py").write_text(MODULE)
    monkeypatch.syspath_prepend(tmp_path)
    theirs = importlib.import_module("lamp_placed").Decorated
    own = lighthouse_kind(theirs).as_class
    assert World(EDGE, theirs(0)) == World(EDGE, own(0))
