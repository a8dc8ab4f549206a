"""The two plays of a lane, and fresh ones, by players that are no processes."""

from collections import deque
from random import Random
from types import SimpleNamespace

import pytest

from allworlds import log
from allworlds.engines import plays
from allworlds.engines.batch import FIRST, SECOND
from allworlds.engines.player import NO_RUN
from allworlds.engines.players import Lost
from allworlds.engines.plays import BothPlays, RunsToPlay

OVER = bytes((log.OVER,))


class Player:
    """A player that says what is put into its list."""

    def __init__(self):
        self.jobs, self.beat, self.description = deque(), [NO_RUN, 0], "loaded"
        self.says = []

    def give(self, job, message):
        self.jobs.append((job, message))

    def heard(self):
        return [(self.jobs.popleft()[0], logs) for logs in self.says]


class Batch:
    """Three runs, whose judge writes down what it is asked for."""

    def __init__(self, *, plain):
        self.plain, self.taken = plain, []
        self.by = SimpleNamespace(
            worlds=lambda batch, indices: ("worlds", [*indices]),
            percepts=lambda batch, indices, *order: ("percepts", [*indices], *order),
        )

    def __len__(self):
        return 3

    def take(self, which, indices, logs):
        self.taken.append((which, [*indices], logs))


@pytest.fixture
def both(monkeypatch):
    made = BothPlays(None, (0, 1), Random(1))
    monkeypatch.setattr(plays, "started", lambda *_: Player())
    return made


def test_the_second_player_is_given_an_order_unless_compiled_code_draws_it(both):
    compiled, python = Batch(plain=False), Batch(plain=True)
    assert both._message(FIRST, python, range(3)) == ("worlds", [0, 1, 2])
    assert both._message(SECOND, compiled, range(3)) == ("percepts", [0, 1, 2])
    for batch, indices in ((python, [0, 1, 2]), (compiled, [0, 2])):
        orders = {(*both._message(SECOND, batch, indices)[2],) for _ in range(60)}
        assert {(*sorted({*order}),) for order in orders} == {(*range(len(indices)),)}
        assert {len(order) for order in orders} == {len(indices), len(indices) + 1}


def test_runs_without_room_for_their_logs_are_played_in_python(both):
    batch = Batch(plain=False)
    both.give(SECOND, batch, range(3))
    (player,) = both.players
    player.says = [None]
    assert both.hear(SECOND) == []
    assert batch.plain is True
    ((job, message),) = player.jobs
    assert (job, message[0], len(message)) == (RunsToPlay(batch, range(3)), "percepts", 3)
    player.says = [["a", "b", "c"]]
    assert both.hear(SECOND) == [batch]
    assert batch.taken == [(SECOND, [0, 1, 2], ["a", "b", "c"])]
    assert both.hear(FIRST) == []


def test_a_player_is_lost_in_a_run_or_outside_of_one_or_without_a_batch(both):
    batch = Batch(plain=True)
    both.give(FIRST, batch, [0, 2])
    (player,) = both.players
    for number, index in ((NO_RUN, None), (0, 0), (1, 2), (2, None)):
        player.beat[0] = number
        assert both.lost_in(FIRST) == (batch, index)
    player.description = None
    assert both.lost_in(FIRST) == (None, None)
    player.description = "loaded"
    player.jobs.clear()
    assert both.lost_in(FIRST) == (None, None)


def test_after_a_loss_each_run_is_played_alone(both, monkeypatch):
    asked = []

    def anew(seed, message):
        asked.append((seed, message))
        lost = 1 in message and len(message) > 1
        return (
            ([OVER], Lost("crash", "it died", machine=True))
            if lost
            else ([OVER] * len(message), None)
        )

    monkeypatch.setattr(both, "anew", anew)
    found = both.fresh(7, list, [0, 1, 2])
    assert asked == [(7, [0, 1, 2]), (7, [0]), (7, [1]), (7, [2])]
    assert [*found] == [0, 1, 2]
    asked.clear()
    assert [*both.fresh(7, list, [0, 2])] == [0, 2]
    assert asked == [(7, [0, 2])]


def test_a_fresh_player_plays_as_its_player_does(both, monkeypatch):
    asked = []
    monkeypatch.setattr(
        both, "anew", lambda seed, message: asked.append((seed, message)) or ([OVER], None)
    )
    batch = Batch(plain=True)
    for which in (FIRST, SECOND):
        both.alone(which, batch, 1)
        assert [*both.again(which, 7, batch, [2])] == [2]
    assert asked == [
        (0, ("worlds", [1])),
        (7, ("worlds", [2])),
        (1, ("percepts", [1])),
        (7, ("percepts", [2])),
    ]
