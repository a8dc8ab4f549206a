"""A lighthouse of the user's own is tried in small worlds before it is used."""

import pytest

from allworlds.world import InvalidWorld
from allworlds.world.named import world_named
from allworlds.world.selection import tried_kind

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
