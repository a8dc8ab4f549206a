"""The lighthouses ``door`` and ``word:PATTERN``: one letter is sensed at v0, by the bearing."""

import pytest

from allworlds import ambiguity
from allworlds.world import Door, InvalidWorld, Position, Word, World
from allworlds.world.lighthouses.kinds import kind_of, lighthouse_from_json, lighthouse_kind
from allworlds.world.lighthouses.marked import word_of
from small import all_maps


@pytest.mark.parametrize(
    ("pattern", "words"),
    [
        ("1", ["1", "11", "111", "1111"]),
        ("12", ["1", "12", "121", "1212"]),
        ("10*", ["1", "10", "100", "1000"]),
        ("10*2", ["1", "12", "102", "1002"]),
        ("0*1", ["1", "01", "001", "0001"]),
        ("123", ["1", "12", "123", "1231"]),
    ],
)
def test_a_pattern_is_repeated_or_one_letter_of_it_is(pattern, words):
    assert ["".join(map(str, word_of(pattern, d + 1))) for d in range(4)] == words


def test_the_door_is_sensed_only_by_who_comes_in_by_it():
    for map_ in all_maps(3):
        places = [*Door.places(map_, 0)]
        assert [map_.offset(0, place.dart) for place in places] == [*range(map_.degree_at[0])]
        for place in places:
            marked = [d for d, seen in enumerate(place.percepts(map_)) if seen.marks]
            assert marked == [place.dart]
            assert {seen.bearing for seen in place.percepts(map_)} == {None}


def test_the_bearing_of_a_letter_is_the_offset_to_the_dart():
    word = lighthouse_kind("word:123*").as_class
    for map_ in all_maps(3):
        for place in word.places(map_, 0):
            for dart in map_.vertices[map_.vertex_of[0]]:
                bearing = map_.offset(dart, place.dart)
                assert place.percepts(map_)[dart].marks == min(bearing + 1, 3)


def test_position_and_door_are_words():
    for map_ in all_maps(3):
        for pattern, kind in (("1", Position), ("10*", Door)):
            for place in kind.places(map_, 0):
                assert Word(place.dart, pattern).percepts(map_) == place.percepts(map_)


def test_a_word_is_named_and_written_with_its_pattern():
    map_ = all_maps(2)[0]
    place = next(lighthouse_kind("word:10*").as_class.places(map_, 0))
    assert str(kind_of(place)) == "word:10*"
    assert place.to_json() == {"kind": "word", "dart": 0, "pattern": "10*"}
    assert lighthouse_from_json(place.to_json(), map_, 0) == place
    assert World.from_json(World(map_, place).to_json()).lighthouse == place


@pytest.mark.parametrize("pattern", ["", "x", "*", "1**", "1*2*", "pattern=12", "1,2", "٣", "1\n"])
def test_a_pattern_that_is_none_is_refused(pattern):
    with pytest.raises(InvalidWorld, match="is no pattern; legal are digits"):
        lighthouse_kind(f"word:{pattern}")
    with pytest.raises(InvalidWorld, match="is no pattern; legal are digits"):
        World(all_maps(1)[0], Word(0, pattern))


@pytest.mark.parametrize(
    ("kind", "first"),
    # The smallest degrees at which these words are proper powers: none; 4; 2; 6.
    [("door", 4), ("word:10*0", 4), ("word:12", 2), ("word:1", 2), ("word:110", 3)],
)
def test_worlds_look_alike_from_the_degree_on_at_which_a_word_is_a_power(kind, first):
    rows = ambiguity.census(edges=3, lighthouse=kind).rows
    assert [row.edges for row in rows if row.ambiguous_worlds] == [*range(first, 4)]
