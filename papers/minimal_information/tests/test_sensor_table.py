"""The page on sensors has what the program finds, and what is proved."""

import json
import subprocess
from collections import Counter

import numpy as np
import pytest

import sensor_table
from allworlds import CombinatorialMap
from allworlds.studies.ambiguity import coarsenings, sensed_classes
from allworlds.world.lighthouses.kinds import lighthouse_kind
from sensors import Features

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


def behind(away, neighbour, behind, door, next_, other):
    """Whether the dart behind the door shows its letter alone."""
    return behind not in (away, neighbour, door, next_, other)


def edge(away, neighbour, behind, door, next_, other):
    """Whether the door's letter is at v0 alone, that of the dart behind neither there nor near."""
    return door not in (away, neighbour, behind) and behind not in (neighbour, next_, other)


def apart(away, neighbour, behind, door, next_, other):
    """Whether none of ten sets of equal letters is complete."""
    return not (
        (door == next_ == other)
        or (door == behind == other)
        or (door == behind and next_ == other)
        or (door == behind and next_ == neighbour)
        or (door == other and next_ == behind)
        or (door == neighbour and next_ == behind)
        or (door == next_ and behind == neighbour)
        or (door == away and behind == neighbour)
        or (door == next_ == behind == away)
        or (door == next_ == neighbour and other == behind)
    )


REASONS = {"behind": behind, "edge": edge, "apart": apart}


def test_the_page_names_the_reasons_that_hold():
    rows = TEXT.partition("| letters | reasons |")[2].partition("\n\n")[0].splitlines()[2:]
    named = [row.split(" | ")[1].removesuffix(" |").split("; ") for row in rows]
    hold = [[name for name, holds in REASONS.items() if holds(*one)] for one in proved()]
    assert named == hold


def renamed(letters):
    """The same letters, numbered in the order in which they come."""
    number = {letter: i for i, letter in enumerate(dict.fromkeys(letters))}
    return tuple(number[letter] for letter in letters)


EVERY = coarsenings.partitions(len(FEATURES))
ENOUGH = {one for one in EVERY if any(holds(*one) for holds in REASONS.values())}


def test_a_reason_holds_for_131_of_203_and_the_page_has_the_minimal_ones():
    assert (len(EVERY), len(ENOUGH)) == (203, 131)
    least = {one for one in ENOUGH if not {*coarsenings.lower(one)} & ENOUGH}
    assert least == {renamed(one) for one in proved()}


# ---- The table of the proof ----

PROGRAM = sensor_table.HERE.parents[1] / "proofs" / "coq" / "weakest"
needs_program = pytest.mark.skipif(
    not PROGRAM.exists(), reason="not built: make -C proofs/coq explorer"
)


@pytest.fixture(scope="module")
def rows():
    """The table that the kernel writes down, a row for each coarsening."""
    told = subprocess.run([PROGRAM, "--write"], capture_output=True, text=True, check=True)
    return [json.loads(line) for line in told.stdout.splitlines()]


def checked(rows):
    """What the extracted checker says of a table, and its exit code."""
    text = "".join(f"{json.dumps(row)}\n" for row in rows)
    told = subprocess.run([PROGRAM], input=text, capture_output=True, text=True, check=False)
    return told.stdout, told.returncode


def shown(twin):
    """The map of a twin, and what is sensed of the features of its darts; dart 0 is the door."""
    map_ = CombinatorialMap(twin["sigma"], twin["alpha"])
    return map_, [Features(0).sensed(map_, dart) for dart in map_.darts]


def alike(letters, twins):
    """Whether no motion tells two worlds apart."""
    (map_, sensed), (other, of_other) = map(shown, twins)
    pairs = [tuple(twin["root"] for twin in twins)]
    for one, two in pairs:
        here, there = sensed[one], of_other[two]
        if here.degree != there.degree or letters[here.marks] != letters[there.marks]:
            return False
        after = (map_.sigma[one], other.sigma[two]), (map_.alpha[one], other.alpha[two])
        pairs += [pair for pair in after if pair not in pairs]
    return True


@needs_program
def test_the_table_of_the_proof_is_about_the_sensors_of_this_page(rows):
    assert checked(rows) == ("131 of 203 suffice\n", 0)
    assert {renamed(row["letters"]) for row in rows} == {*EVERY}
    assert {renamed(row["letters"]) for row in rows if not row["twins"]} == ENOUGH
    for row in rows:
        if row["twins"]:
            assert alike(row["letters"], row["twins"])


@needs_program
def test_a_table_with_a_wrong_row_is_refused(rows):
    first, *others = rows
    assert first["twins"]
    for wrong in (
        {"twins": []},
        {"letters": [0, 1, 2, 3, 4, 5]},
        {"twins": first["twins"][:1] * 2},
    ):
        assert checked([first | wrong, *rows]) == ("REFUSED\n", 1)
    assert checked(others) == ("REFUSED\n", 1)
    assert checked([first | {"letters": [0, -1, 0, 0, 0, 0]}, *others])[1] == 2
