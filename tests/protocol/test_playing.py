"""A run is played: each action is an entry of the log."""

import pytest

from allworlds import log
from allworlds.protocol.actions import Drop, Move, Percept, Write
from allworlds.protocol.choices import Choices
from allworlds.protocol.playing import play_run


class Around:
    """Surroundings with a degree, in which everything is legal."""

    told, over = None, False

    def __init__(self, degree=1):
        self.first = Percept(degree)
        self.done = []

    def move(self, k):
        self.done.append(k)
        return self.first

    def act(self, action):
        self.done.append(action)
        return self.first


def played(around, *messages, budget=3):
    def explore(first, choices, told):
        for message in messages:  # noqa: UP028  # what is sent is no matter
            yield message

    return log.Log(play_run(around, explore, Choices(), budget, [0, 0], any_answer=True))


@pytest.mark.parametrize("k", [0, log.LARGEST_MOTION, log.LARGEST_MOTION + 1, 999])
def test_a_motion_by_any_number_of_darts_is_in_the_log(k):
    around = Around(1000)
    read = played(around, Move(k), Move(k - 1000))
    assert around.done == read.actions == [k, k]
    assert read.ending == (log.VALUE, "null")


def test_numbers_from_0_on_are_written_and_others_are_illegal():
    around = Around()
    read = played(around, Drop(), Write(0), Write(7), Write(-1), Write(8))
    assert around.done == [Drop(), Write(0), Write(7)]
    assert read.actions == [log.DROPPED, log.WROTE, log.WROTE - 7]
    expected = ("illegal-action", "Write(k) with k from 0 on", "Write(k=-1)", "", False)
    assert read.ending == (log.FAULT, *expected)
