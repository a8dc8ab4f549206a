import json

import pytest
from hypothesis import given, strategies as st

from allworlds.inputs.checks import InputError
from allworlds.protocol.actions import (
    Drop,
    ExplorerFault,
    Move,
    Percept,
    Pick,
    Transcript,
    action_from_json,
)

FIRST = {"degree": 2, "marks": 1, "bearing": 0}
percepts = st.integers(1, 9).flatmap(
    lambda degree: st.builds(
        Percept,
        st.just(degree),
        st.integers(0, 3),
        st.none() | st.integers(0, degree - 1),
    )
)
actions = st.builds(Move, st.integers(0, 9)) | st.just(Drop()) | st.just(Pick())
transcripts = st.builds(
    Transcript, percepts, st.lists(st.tuples(actions, percepts), max_size=9).map(tuple)
)


# ---------------------------------------------------------------- percepts


@pytest.mark.parametrize(
    ("percept", "words"),
    [
        (Percept(3), "degree 3"),
        (Percept(3, 1), "degree 3, marked"),
        (Percept(3, 2), "degree 3, marks 2"),
        (Percept(3, 1, 2), "degree 3, marked, bearing 2"),
        (Percept(1, 0, 0), "degree 1, bearing 0"),
    ],
)
def test_a_percept_reads_as_what_is_sensed(percept, words):
    assert str(percept) == words


def test_a_percept_cannot_be_changed_and_is_equal_by_what_is_sensed():
    with pytest.raises(AttributeError):
        Percept(3).degree = 2
    assert len({Percept(3), Percept(3, 0, None), Percept(3, 1), Percept(3, 1, 0)}) == 3


@given(percepts)
def test_a_percept_survives_json(percept):
    document = json.loads(json.dumps(percept.to_json()))
    assert document == {
        "degree": percept.degree,
        "marks": percept.marks,
        "bearing": percept.bearing,
    }
    assert Transcript.from_json([{"percept": document}]).first == percept


def test_marks_and_bearing_may_be_missing_and_other_keys_are_ignored():
    for document in ({"degree": 3}, {"degree": 3, "colour": "red"}):
        assert Transcript.from_json([{"percept": document, "step": 0}]).first == Percept(3)


@pytest.mark.parametrize("value", [None, 3, "degree", [3], [["degree", 3]]])
def test_what_is_no_object_is_no_percept(value):
    with pytest.raises(InputError, match=r"percept = .*: expected object") as refusal:
        Transcript.from_json([{"percept": value}])
    assert repr(value) in str(refusal.value)


@pytest.mark.parametrize(
    "value",
    [
        {},
        {"marks": 1},
        {"degree": None},
        {"degree": True},
        {"degree": 3.0},
        {"degree": "3"},
        {"degree": 3, "marks": None},
        {"degree": 3, "marks": False},
        {"degree": 3, "bearing": "0"},
        {"degree": 3, "bearing": True},
    ],
)
def test_a_percept_of_anything_but_integers_is_refused_and_shown(value):
    with pytest.raises(InputError, match=r"transcript\[1\].percept"):
        Transcript.from_json([{"percept": FIRST}, {"move": 0, "percept": value}])


# ---------------------------------------------------------------- actions


@pytest.mark.parametrize(
    ("action", "document"),
    [
        (Move(0), {"move": 0}),
        (Move(3), {"move": 3}),
        (Move(-1), {"move": -1}),
        (Drop(), {"drop": True}),
        (Pick(), {"pick": True}),
    ],
)
def test_an_action_has_one_document_and_comes_back_from_it(action, document):
    percept = Percept(1)
    told = Transcript(percept, ((action, percept),)).to_json()
    assert told[1] == {**document, "percept": percept.to_json()}
    assert action_from_json(document) == action
    assert action_from_json({**document, "percept": {"degree": 1}}) == action


@pytest.mark.parametrize(
    "row",
    [
        {},
        {"move": True},
        {"move": False},
        {"move": 1.0},
        {"move": "1"},
        {"move": None},
        {"drop": False},
        {"drop": 1},
        {"pick": "true"},
        {"percept": {"degree": 1}},
        [],
        None,
        "move",
        1,
    ],
)
def test_what_holds_no_action_is_none(row):
    assert action_from_json(row) is None


# ---------------------------------------------------------------- transcripts


@given(transcripts)
def test_a_transcript_survives_json(transcript):
    rows = json.loads(json.dumps(transcript.to_json()))
    assert len(rows) == 1 + len(transcript.steps)
    assert Transcript.from_json(rows) == transcript


def test_the_rows_are_the_first_percept_and_then_action_and_percept_together():
    transcript = Transcript(Percept(2, 1, 0), ((Move(1), Percept(3)), (Drop(), Percept(3, 1))))
    assert transcript.to_json() == [
        {"percept": FIRST},
        {"move": 1, "percept": {"degree": 3, "marks": 0, "bearing": None}},
        {"drop": True, "percept": {"degree": 3, "marks": 1, "bearing": None}},
    ]


@given(transcripts)
def test_the_cost_is_the_number_of_moves_and_markers_are_free(transcript):
    moves = [action for action, _ in transcript.steps if isinstance(action, Move)]
    assert transcript.cost == len(moves)


def test_a_transcript_without_steps_costs_nothing():
    assert Transcript(Percept(1)).cost == 0
    assert Transcript(Percept(1)).steps == ()


@pytest.mark.parametrize("rows", [None, [], {}, "rows", 7])
def test_what_is_no_list_of_rows_is_no_transcript(rows):
    with pytest.raises(InputError, match="transcript"):
        Transcript.from_json(rows)


@pytest.mark.parametrize(
    ("rows", "message"),
    [
        ([7], r"transcript\[0\] = 7: expected object"),
        ([{}], r"transcript\[0\] = \{\}: object missing required field percept"),
        ([{"percept": {"degree": "x"}}], r"transcript\[0\].percept.degree = 'x': expected int"),
        ([{"percept": FIRST}, {"percept": FIRST}], r"\{'percept'.* has no move, .* or write"),
        ([{"percept": FIRST}, 5], r"transcript\[1\] = 5"),
        ([{"percept": FIRST}, {"move": 1}], r"transcript\[1\] = \{'move': 1\}"),
        ([{"percept": FIRST}, {"pick": True, "percept": []}], r"transcript\[1\].percept = \[\]"),
    ],
)
def test_a_row_that_is_none_is_named(rows, message):
    with pytest.raises(InputError, match=message):
        Transcript.from_json(rows)


def test_a_fault_of_a_foreign_explorer_carries_its_law_and_what_was_seen():
    fault = ExplorerFault("timeout", "no line within 10 s")
    assert (fault.law, fault.seen, fault.detail) == ("timeout", "no line within 10 s", "")
    assert str(fault) == fault.seen
