"""A run that ended otherwise when it was tried again, without players."""

from types import SimpleNamespace

import pytest

from allworlds import log as entries
from allworlds.engines import settling
from allworlds.engines.batch import FIRST, SECOND, Due, Judged
from allworlds.engines.judge import PythonJudge
from allworlds.engines.settling import Settler
from allworlds.engines.tally import RunCounter
from allworlds.engines.units import Scope
from allworlds.judging.rules import Rules
from allworlds.log import Log
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.world import Directional, World
from small import EDGE

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


JUDGE = PythonJudge(RunCounter(Scope(Extent(MapClass.MAPS, 1), Rules()), 1), "mine")
RUN = Due(0, 0, World(EDGE, Directional(0)))
ANSWER, WITHOUT_WORDS = entries.answer((0, 1), (1, 0), 0), bytes((entries.FAULT,))
WITH_WORDS = entries.fault("no-estimate", "a map", "None")


def settling_of(first, later, **more):
    """A settler whose player plays a run once more, and a batch of this run."""
    plays = SimpleNamespace(alone=lambda which, batch, index: ((later,), None))
    batch = SimpleNamespace(
        plain=False,
        due=lambda _: RUN,
        outcome=lambda _: JUDGE.judged(RUN, entries.motion(0) + first),
        **more,
    )
    return Settler(JUDGE, plays), batch


def test_a_run_that_made_other_choices_than_were_due_is_nondeterministic():
    settler, batch = settling_of(ANSWER, b"")
    right = batch.outcome(0)
    assert settler._own(batch, 0) == right.outcome
    batch.outcome = lambda _: Judged(right.log, right.outcome, fits=False)
    found = settler._own(batch, 0).violation
    assert (found.law, found.seen) == ("nondeterministic", settling.OTHER_CHOICES)


def test_a_run_of_compiled_code_is_played_once_more_for_its_words():
    settler, batch = settling_of(WITH_WORDS, entries.motion(0) + WITH_WORDS)
    assert settler._in_words(batch, 0).violation.law == "no-estimate"
    assert batch.plain is True


def test_a_run_that_is_another_when_it_is_played_once_more_is_nondeterministic():
    settler, batch = settling_of(ANSWER, entries.motion(0) * 2 + ANSWER)
    found = settler._in_words(batch, 0).violation
    assert (found.law, found.seen) == ("nondeterministic", settling.PLAYED_ONCE_MORE)


def test_words_are_found_where_compiled_code_wrote_none_and_no_player_was_lost():
    settler, batch = settling_of(ANSWER, b"", broken=[0, 1], lost={1})
    found = []
    settler._in_words, settler._own = (
        (lambda _, index: f"words of {index}"),
        lambda _, i: f"own {i}",
    )
    settler.find = lambda _, outcomes: found.append(outcomes)
    settler.settle(batch, twice=False)
    batch.plain = True
    settler.settle(batch, twice=False)
    assert found == [{0: "words of 0", 1: "own 1"}, {0: "own 0", 1: "own 1"}]
