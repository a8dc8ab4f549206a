"""A lighthouse of the user's own is tried in small worlds before it is used."""

from itertools import islice

import pytest

from allworlds.inputs.checks import InputError
from allworlds.world import InvalidWorld, World, worlds
from allworlds.world.named import world_named
from allworlds.world.selection import OwnCondition, a_condition, tried_kind
from small import EDGE, PATH

MINE = """
from dataclasses import dataclass

from allworlds import Lighthouse, Percept


@dataclass(frozen=True)
class Honest(Lighthouse):
    dart: int

    @classmethod
    def places(cls, map_, start):
        yield cls(start)

    def sensed(self, map_, here):
        return Percept(map_.degree_at[here], int(map_.vertex_of[here] == map_.vertex_of[self.dart]))


class OfNames(Honest):
    def sensed(self, map_, here):
        return Percept(map_.degree_at[here], int(here == 0))


class AtNames(Honest):
    @classmethod
    def places(cls, map_, start):
        yield cls(min(map_.vertices[map_.vertex_of[start]]))


class Nowhere(Honest):
    @classmethod
    def places(cls, map_, start):
        return iter(())


class Large(Honest):
    @classmethod
    def places(cls, map_, start):
        if map_.edge_count > 3:
            yield cls(start)
"""


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    (tmp_path / "mine.py").write_text(MINE)
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize(
    ("kind", "said"),
    [
        ("OfNames", "'degree 1, marked' at dart 0, and 'degree 1' with the darts renamed to"),
        (
            "AtNames",
            "with the darts renamed to .* it has the places .*; legal are .* in this order",
        ),
        ("Nowhere", "has no place in any map with at most 4 edges"),
    ],
)
def test_a_lighthouse_that_is_no_function_of_the_world_or_has_no_place_is_refused(kind, said):
    with pytest.raises(InvalidWorld, match=f"lighthouse mine.py:{kind} .*{said}") as error:
        tried_kind(f"mine.py:{kind}")
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("kind", ["Honest", "Large"])
def test_one_that_is_a_function_of_the_world_is_taken_also_if_its_places_are_in_large_maps(kind):
    assert tried_kind(f"mine.py:{kind}").name == f"mine.py:{kind}"


def test_the_lighthouse_that_a_world_names_itself_is_tried_too():
    world = '{"sigma":[0,1],"alpha":[1,0],"start":0,"lighthouse":{"kind":"mine.py:OfNames"}}'
    with pytest.raises(InvalidWorld, match="with the darts renamed to"):
        world_named(world)


def test_a_place_is_one_of_its_kind_in_the_map():
    world_named('{"sigma":[0,1],"alpha":[1,0],"lighthouse":{"kind":"mine.py:Honest","dart":0}}')
    with pytest.raises(InvalidWorld) as refused:
        world_named('{"sigma":[0,1],"alpha":[1,0],"lighthouse":{"kind":"mine.py:Honest","dart":1}}')
    assert "the lighthouse mine.py:Honest cannot stand at " in str(refused.value)
    assert " in this map with start 0: it is none of its places there" in str(refused.value)


@pytest.mark.parametrize("options", [None, 5, [1], "a=1"])
def test_options_of_a_lighthouse_of_ones_own_are_an_object(options):
    lighthouse = {"kind": "mine.py:Honest", "options": options, "dart": 0}
    with pytest.raises(InvalidWorld, match=r"lighthouse.options = .* is no object"):
        World.from_json({"sigma": [0, 1], "alpha": [1, 0], "lighthouse": lighthouse})


def test_without_a_bound_all_worlds_are_those_of_a_check():
    every = worlds()
    assert {world.map.edge_count for world in islice(every, 800)} == {1, 2, 3, 4, 5}
    # 2 + 10 + 74 + 706 + 8162 rooted maps (A000698)
    assert 800 + sum(1 for _ in every) == 8954
    assert {world.map.edge_count for world in worlds(vertices=2, map_class="simple")} == {1}
    assert {world.map.edge_count for world in worlds(edges=2)} == {1, 2}


def test_places_of_all_worlds_are_all_or_the_first():
    assert [sum(1 for _ in worlds(edges=1, places=which)) for which in ("first", "all")] == [2, 3]
    with pytest.raises(InputError, match="places 'some' is not one of all, first"):
        next(worlds(edges=1, places="some"))


def test_a_predicate_that_has_a_name_of_its_own_is_a_predicate_all_the_same():
    class Even:
        name = "even"

        def __call__(self, map_):
            return map_.edge_count % 2 == 0

    condition = a_condition(Even(), local=True)
    assert type(condition) is OwnCondition
    assert [condition.holds(map_) for map_ in (EDGE, PATH)] == [False, True]
