"""The page on sensors has what the program finds."""

from collections import Counter

import numpy as np
import pytest

import sensor_table
from allworlds.studies.ambiguity import coarsenings, sensed_classes
from allworlds.world.lighthouses.kinds import lighthouse_kind

TEXT = sensor_table.PAGE.read_text(encoding="utf-8")
FEATURES = ("away", "neighbour", "behind", "door", "next", "other")


def test_rows_of_the_table_are_what_the_command_finds():
    report = sensor_table.found(("door", "word:1", "word:01*"))
    rows = sensor_table.table(report).splitlines()[2:]
    assert len(rows) == 3
    assert all(f"{row}\n" in TEXT for row in rows)
    other = sensor_table.table(sensor_table.found(("word:1",), edges=1))
    assert other.splitlines()[-1] not in TEXT


@pytest.mark.slowest
def test_the_table_and_the_pictures_are_those_that_are_written_anew():
    found = sensor_table.found()
    again = sensor_table.written(TEXT, "table", sensor_table.table(found))
    assert sensor_table.written(again, "twins", sensor_table.pictures(found)) == TEXT


def proved():
    """The coarsenings that the page says to be minimal and to suffice for all m."""
    rows = TEXT.partition("| letters | reasons |")[2].partition("\n\n")[0].splitlines()[2:]
    blocks = [[block.split() for block in row.split(" | ")[0][2:].split(" / ")] for row in rows]
    number = [{f: i for i, block in enumerate(one) for f in block} for one in blocks]
    return [tuple(letters[f] for f in FEATURES) for letters in number]


def several_sheets(letters, edges):
    """How many worlds of each size are not their own quotients, for each of these coarsenings."""
    finest = f"{sensor_table.HERE}/sensors.py:Features"
    request, kind = coarsenings.WeakestRequest(finest, edges=edges), lighthouse_kind(finest)
    found = {one: Counter() for one in letters}
    for level in coarsenings._levels(request, kind, len(FEATURES)):
        for one, counts in found.items():
            sensed = np.array(one)[level.features] << sensed_classes.BITS | level.arrays.sensed
            of = sensed_classes.classes(level.arrays._replace(sensed=sensed))
            counts[of.shape[1] // 2] += int(((of == 0).sum(axis=1) > 1).sum())
    return {one: dict(+counts) for one, counts in found.items()}


def test_no_sensor_that_is_proved_is_finer_than_another():
    letters = proved()
    assert len(letters) == len({*letters}) == 24
    for one in letters:
        below = coarsenings.lower(one)
        for coarser in below:
            below += coarsenings.lower(coarser)
        numbered = ({f: i for i, f in enumerate(dict.fromkeys(each))} for each in letters)
        names = {tuple(n[f] for f in each) for n, each in zip(numbered, letters, strict=True)}
        assert not names & {*below}


@pytest.mark.parametrize("edges", [3, pytest.param(5, marks=pytest.mark.slowest)])
def test_worlds_under_sensors_that_are_proved_are_their_own_quotients(edges):
    found = several_sheets(proved(), edges)
    # An edge; a loop, with the door at either dart; a path, from both starts.
    assert Counter(str(counts) for counts in found.values()) == {"{}": 18, "{1: 3}": 5, "{3: 2}": 1}


def test_a_sensor_with_twins_has_worlds_that_cover_others():
    refuted = (0, 1, 0, 1, 1, 0)  # neighbour door next: alike in twins with m = 6
    assert several_sheets([refuted], 3) == {refuted: {3: 5}}
