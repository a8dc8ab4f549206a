"""The form of a log: what is written is read again, and what is none is refused."""

import pytest
from hypothesis import given
from hypothesis.strategies import booleans, integers, lists, one_of, sampled_from, text, tuples

from allworlds import log
from allworlds.log import Log

NUMBERS = one_of(integers(0, 300), integers(-(1 << 80), 1 << 80))
SMALL = lists(integers(0, 255), min_size=1, max_size=64)
ANY = lists(NUMBERS, max_size=80)
MAPS = one_of(
    SMALL.flatmap(lambda s: tuples(sampled_from([s]), sampled_from([s[::-1]]), integers(0, 255))),
    tuples(ANY, ANY, NUMBERS),
)
ENTRIES = one_of(
    integers(0, 1 << 70).map(lambda k: (log.motion(k), "action", k)),
    sampled_from(
        [
            (bytes((log.DROP,)), "action", log.DROPPED),
            (bytes((log.PICK,)), "action", log.PICKED),
        ]
    ),
    integers(0, 1 << 70).map(lambda k: (log.written(k), "action", log.WROTE - k)),
    tuples(integers(0, 1 << 20), integers(0, 1 << 20)).map(
        lambda pair: (log.choice(*pair), "choice", pair)
    ),
    MAPS.map(lambda m: (log.shown(*m), "shown", (tuple(m[0]), tuple(m[1]), m[2]))),
)
WORDS = text(max_size=20)
ENDS = one_of(
    MAPS.map(lambda m: (log.answer(*m), (tuple(m[0]), tuple(m[1]), m[2]))),
    tuples(ANY, ANY, ANY, ANY, NUMBERS).map(
        lambda q: (log.quotient(q[:4], q[4]), (*map(tuple, q[:4]), q[4]))
    ),
    WORDS.map(lambda told: (log.value(told), (told,))),
    tuples(sampled_from(log.LAWS), WORDS, WORDS, WORDS, booleans()).map(
        lambda f: (log.fault(*f[:4], machine=f[4]), f)
    ),
    sampled_from(sorted(log.ENDS)).map(lambda code: (bytes((code,)), ())),
)


@given(lists(ENTRIES, max_size=6), ENDS)
def test_what_is_written_is_read(entries, end):
    bytes_, parts = end
    read = Log(b"".join(entry for entry, _, _ in entries) + bytes_)
    assert read.actions == [what for _, kind, what in entries if kind == "action"]
    pairs = [what for _, kind, what in entries if kind == "choice"]
    assert [*zip(read.choices, read.widths, strict=True)] == pairs
    assert [tuple(shown[1:]) for shown in read.checkpoints] == [
        what for _, kind, what in entries if kind == "shown"
    ]
    before = 0
    counted = iter(read.checkpoints)
    for _, kind, _ in entries:
        before += kind == "action"
        if kind == "shown":
            assert next(counted)[0] == before
    assert read.ending[1:] == parts


@given(lists(ENTRIES, max_size=3), ENDS)
def test_a_log_that_is_cut_off_has_no_end(entries, end):
    whole = b"".join(entry for entry, _, _ in entries) + end[0]
    begun = len(whole) - len(end[0])
    for length in range(begun, len(whole) - 1):
        cut = whole[:length]
        if end[0][0] == log.FAULT and length == begun + 1:
            continue  # a fault of compiled code has no words
        with pytest.raises(ValueError, match=r"no end|no entry|behind its end"):
            Log(cut)


@pytest.mark.parametrize(
    "wrong",
    [
        bytes((0, log.OVER, 0)),
        bytes((log.REFUSED + 1,)),
        bytes((255,)),
        bytes((log.FAULT, 9, 0)) + bytes(12),
    ],
)
def test_what_is_no_log_is_refused(wrong):
    with pytest.raises(ValueError, match=r"behind its end|begins no entry|no law"):
        Log(wrong)


def test_a_motion_is_one_byte_as_far_as_there_are_bytes_for_it():
    lengths = [len(log.motion(k)) for k in (0, log.LARGEST_MOTION, log.LARGEST_MOTION + 1)]
    assert lengths[:2] == [1, 1]
    assert lengths[2] > 1


@pytest.mark.parametrize("code", [log.SHOWN, log.ANSWERED])
def test_a_map_that_is_cut_off_is_no_entry(code):
    with pytest.raises(ValueError, match="the log has no end"):
        Log(bytes((code, 2, 0, 0, 1, 1)))


def test_a_fault_of_compiled_code_has_no_words():
    read = Log(bytes((3, log.FAULT)))
    assert (read.actions, read.ending) == ([3], (log.FAULT, "illegal-action", "", "", "", False))
