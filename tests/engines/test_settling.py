"""A run that ended otherwise when it was tried again, without players."""

from types import SimpleNamespace

import pytest

from allworlds import log as entries
from allworlds.engines import settling
from allworlds.engines.batch import FIRST, SECOND, Due, Judged, RunBatch, Work
from allworlds.engines.judge import PythonJudge
from allworlds.engines.players import Logs
from allworlds.engines.settling import Settler
from allworlds.engines.tally import RunCounter, Tally
from allworlds.engines.units import LevelUnit, Scope
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


# ---------------------------------------------------------------- two plays that differ

RIGHT = entries.motion(0) + entries.answer((0, 1), (1, 0), 1)
RIGHT_TOO = entries.motion(0) + ANSWER
WRONG = entries.motion(0) + entries.answer((1, 0), (1, 0), 0)
OURS = entries.fault("crash", "an action", "a mistake")
THEIRS = entries.fault("crash", "an action", "it was killed", machine=True)


class Plays:
    """The players of a lane; the log of a fresh player depends on the play and the seed alone."""

    def __init__(self, seeds, logs):
        self.seeds, self.logs, self.asked = seeds, logs, []

    def again(self, which, seed, batch, order):
        self.asked.append((which, seed, [*order]))
        return {index: Log(self.logs[which, seed]) for index in order}


def batch_of(first, second):
    """A batch of one run as often as there are logs, with the logs of both plays."""
    batch = RunBatch(JUDGE, Work(LevelUnit(1, (-1,)), Tally(9)), [RUN] * len(first))
    batch.logs = [first, second]
    return batch


def settled(batch, seeds, logs):
    plays = Plays(seeds, logs)
    Settler(JUDGE, plays).settle(batch, twice=True)
    tally = batch.work.tally
    return tally.findings, [*tally.remarks], plays.asked


def test_plays_that_each_seed_repeats_are_judged_under_both_seeds():
    logs = {(FIRST, 0): RIGHT, (SECOND, 1): WRONG, (FIRST, 1): WRONG}
    batch = batch_of([RIGHT] * 4, [WRONG, RIGHT, WRONG, RIGHT])
    (found,), remarks, asked = settled(batch, (0, 1), logs)
    assert (found.law, found.hash_seed) == ("map", 1)
    assert remarks == [settling.hash_seeds.GOES_BY_HASHES]
    orders = [[0, 2], [2, 0]]
    assert asked[:2] == [(FIRST, 0, order) for order in orders]
    assert asked[2:] == [(SECOND, 1, order) for order in orders] + [(FIRST, 1, [0, 2])]


def test_plays_that_are_right_under_both_seeds_refute_nothing():
    logs = {(FIRST, 0): RIGHT, (SECOND, 1): RIGHT_TOO, (FIRST, 1): RIGHT_TOO}
    findings, remarks, _ = settled(batch_of([RIGHT], [RIGHT_TOO]), (0, 1), logs)
    assert (findings, len(remarks)) == ([], 1)


@pytest.mark.parametrize(
    ("seeds", "first", "second"), [((0, 0), RIGHT, WRONG), ((0, 1), RIGHT, RIGHT)]
)
def test_plays_that_no_seed_explains_are_nondeterministic(seeds, first, second):
    logs = {(FIRST, 0): first, (SECOND, seeds[1]): second}
    (found,), remarks, _ = settled(batch_of([RIGHT], [WRONG]), seeds, logs)
    assert (found.law, found.hash_seed, remarks) == ("nondeterministic", None, [])


def test_of_many_runs_that_differ_some_are_played_anew(monkeypatch):
    monkeypatch.setattr(settling, "MOST_SETTLED", 1)
    logs = {(FIRST, 0): RIGHT, (SECOND, 0): RIGHT}
    findings, _, asked = settled(batch_of([RIGHT] * 2, [WRONG] * 2), (0, 0), logs)
    assert len(findings) == 1
    assert [order for *_, order in asked] == [[0]] * 4


def test_equal_plays_are_not_read():
    same = Logs.of([b"no log"])
    assert settled(batch_of(same, Logs.of([b"no log"])), (0, 1), {}) == ([], [], [])
    other = Logs.of([WRONG])
    logs = {(FIRST, 0): RIGHT, (SECOND, 0): RIGHT}
    assert len(settled(batch_of(Logs.of([RIGHT]), other), (0, 0), logs)[0]) == 1


@pytest.mark.parametrize(("one", "other"), [(THEIRS, RIGHT), (RIGHT, THEIRS)])
def test_a_loss_that_may_be_the_machines_is_settled_by_later_plays(one, other, monkeypatch):
    settler, asked = Settler(JUDGE, None), []
    monkeypatch.setattr(settler, "_alike", lambda *what: asked.append(what))
    batch = batch_of([one], [other])
    outcome = settler._of_plays(batch, 0, Log(other), (0, 1))
    assert (outcome.violation.law, len(asked)) == ("nondeterministic", 1)
    monkeypatch.setattr(settler, "_alike", lambda *_: "what they say")
    assert settler._of_plays(batch, 0, Log(other), (0, 1)) == "what they say"
    by_itself = settler._of_plays(batch_of([OURS], [RIGHT]), 0, Log(RIGHT), (0, 1))
    assert by_itself.violation.law == "nondeterministic"


def test_a_run_in_which_a_player_was_lost_is_a_finding_although_the_batch_is_given_up():
    for which, second, law in ((FIRST, OURS, "crash"), (SECOND, OURS, "nondeterministic")):
        batch = batch_of([OURS if which == FIRST else RIGHT], [second])
        batch.lost = {0}
        Settler(JUDGE, None).give_up(which, batch)
        (found,) = batch.work.tally.findings
        assert found.law == law
        assert not batch.tally.rows


@pytest.mark.parametrize(("which", "by_percepts"), [(FIRST, THEIRS), (SECOND, WRONG)])
def test_what_differs_under_a_further_seed_is_explained_by_it(which, by_percepts):
    logs = {(FIRST, 0): RIGHT, (SECOND, 5): by_percepts, (FIRST, 5): WRONG}
    batch = batch_of([RIGHT], [RIGHT])
    settler = Settler(JUDGE, Plays((0, 1), logs))
    settler.explain_under(5, batch, [(0, Log(WRONG))], which)
    (found,) = batch.work.tally.findings
    assert (found.law, found.hash_seed) == ("map", 5)
    tally = batch.work.tally
    assert tally.under(JUDGE.rules) is tally
    assert [each.under for each in tally.findings] == [JUDGE.rules]
