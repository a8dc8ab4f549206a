"""A run that ended otherwise when it was tried again, without players."""

from types import SimpleNamespace

import pytest

from allworlds import log as entries
from allworlds.engines import settling
from allworlds.engines.batch import FIRST, SECOND
from allworlds.engines.settling import Settler
from allworlds.log import Log

MAP = Log(entries.answer((0, 1), (1, 0), 1))
CRASH = Log(entries.fault("crash", "an action", "it was killed", machine=True))
SILENT = Log(entries.fault("timeout", "an action", "silent for 2 s", machine=True))


@pytest.fixture
def tried(monkeypatch):
    """What becomes of a run, by its play, another one, and two later ones; and the remarks."""
    monkeypatch.setattr(settling, "Recorded", SimpleNamespace(of=lambda *_: "record"))

    def settled(one, other, log, again):
        settler, remarks = object.__new__(Settler), []
        settler.plays = SimpleNamespace(
            again=lambda *_: {3: log}, fresh=lambda seed, *_: {3: again} if seed == 2 else {}
        )
        settler.judge = SimpleNamespace(percepts_message=lambda runs: runs)
        settler.differ = lambda first, second: first is not second
        settler._anew = lambda _, anew: SimpleNamespace(episode=anew)
        tally = SimpleNamespace(remark=remarks.append)
        batch = SimpleNamespace(
            due=lambda _: "due",
            outcome=lambda _: SimpleNamespace(log=one),
            work=SimpleNamespace(tally=tally),
        )
        outcome = settler._alike(batch, 3, other, {FIRST: 1, SECOND: 2})
        return outcome and outcome.episode, remarks

    return settled


SAID = "a run ended otherwise when it was tried again; at first: "


@pytest.mark.parametrize(
    ("one", "other", "at_first"),
    [
        (CRASH, MAP, "it was killed"),
        (MAP, SILENT, "silent for 2 s"),
        (Log(entries.answer((0, 1), (1, 0), 0)), CRASH, "it ended with an answer"),
    ],
)
def test_what_two_later_plays_say_alike_stands_with_a_remark(tried, one, other, at_first):
    assert tried(one, other, MAP, MAP) == (MAP, [SAID + at_first])


def test_later_plays_that_are_not_alike_settle_nothing(tried):
    assert tried(CRASH, MAP, MAP, CRASH) == (None, [])


def test_an_illegal_action_without_words_is_the_same_as_with_them():
    moves = b"".join(map(entries.motion, (0, 1)))
    end = entries.fault("illegal-action", "a move", "a 5")
    assert settling._is_refused(Log(moves + end), Log(moves + entries.motion(2) + end))
    assert not settling._is_refused(Log(moves + end), Log(moves + end))
    assert not settling._is_refused(Log(moves + end), MAP)
