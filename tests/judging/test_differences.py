"""Which of two plays that differ is told, and in which words."""

import pytest

from allworlds import log as entries
from allworlds.judging.differences import (
    SHOWN_AFTER,
    SHOWN_BEFORE,
    _may_be_overruled,
    difference_of,
    in_words,
    side_by_side,
)
from allworlds.judging.laws.law_table import Violation
from allworlds.log import Log

MAP = entries.answer((0, 1), (1, 0), 1)
OTHER = entries.answer((0, 1), (1, 0), 0)
CRASH = entries.fault("crash", "an action", "ValueError: no")
ILLEGAL = entries.fault("illegal-action", "an action", "a 5")


def log(*actions, end=MAP):
    return Log(b"".join([*map(entries.motion, actions), end]))


def said(first, second, **more):
    found = difference_of(first, second, **more)
    return found and found.seen


@pytest.mark.parametrize(
    ("first", "second", "words"),
    [
        (log(0, 1), log(0, 1), None),
        (log(0, 1), log(0, 2), "the second walk differs at step 2"),
        (log(0, 1), log(0), "the second walk differs in its length"),
        (log(0), log(0, end=OTHER), "the second answer differs"),
        (
            *(log(0), log(0, 1, end=bytes((entries.BEYOND,)))),
            "the second walk goes on where the first one ended",
        ),
        (
            *(log(0), log(0, 1, 1, end=bytes((entries.BEYOND,)))),
            "the second walk differs in its length",
        ),
        (
            *(log(0, end=CRASH), log(0)),
            "the second answer differs; the first ended with crash: ValueError: no",
        ),
        (
            *(log(0), log(1, end=CRASH)),
            "the second walk differs at step 1; the second ended with crash: ValueError: no",
        ),
        (log(0), log(1, end=ILLEGAL), "the second walk differs at step 1"),
        (
            *(log(0), log(0, end=ILLEGAL)),
            "the second answer differs; the second ended with illegal-action: a 5",
        ),
        (log(0, end=CRASH), log(0, end=CRASH), None),
        (log(0, end=bytes((entries.BEYOND,))), log(0, end=bytes((entries.REFUSED,))), None),
    ],
)
def test_the_first_difference_is_told(first, second, words):
    assert said(first, second) == words


def test_choices_are_compared_where_every_schedule_is_tried():
    first, second = (Log(entries.choice(index, 2) + MAP) for index in (0, 1))
    assert said(first, second) is None
    assert said(first, second, choices=True) == "the choices of the second play differ"
    wider = Log(entries.choice(0, 3) + MAP)
    assert said(first, wider, choices=True) == "the choices of the second play differ"
    assert said(first, first, choices=True) is None


@pytest.mark.parametrize(
    ("law", "second", "may"),
    [
        (None, log(0), True),
        ("crash", log(0, end=CRASH), True),
        ("illegal-action", log(0, end=ILLEGAL), False),
        ("illegal-action", log(0, end=CRASH), True),
        ("illegal-action", log(0), True),
    ],
)
def test_a_law_that_both_plays_break_is_told_before_that_they_differ(law, second, may):
    violation = law and Violation(law, "this", "that")
    assert _may_be_overruled(violation, second) is may


def test_both_plays_are_shown_around_the_first_action_that_differs():
    first = [*map(str, range(20))]
    second = [*first[:12], "other", *first[13:16]]
    lines = side_by_side((first, "all was done"), (second, "crash")).splitlines()
    before, after = SHOWN_BEFORE, SHOWN_AFTER
    shown = ", ".join(first[12 - before : 12 + after])
    assert lines[0] == f"first play, from step 5 on: {shown}, and 4 more"
    assert lines[1] == f"second play, from step 5 on: {shown.replace('12', 'other')}, crash"
    short = side_by_side((first[:2], "crash"), (first[:2], "all was done")).splitlines()
    assert short[0] == "first play, from step 1 on: 0, 1, crash"


def test_the_ending_of_a_play_is_told_in_a_word():
    moves, ending = in_words(log(0, 2))
    assert moves == ["move 0", "move 2"]
    assert ending.startswith("the answer Estimate(map=")
    assert in_words(log(end=CRASH)) == ([], "crash")
    assert in_words(log(end=bytes((entries.OVER,)))) == ([], "all was done")
