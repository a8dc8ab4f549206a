"""A program whose player is lost: what was answered before is heard again, and no more is lost."""

import pytest

from allworlds.engines.players import Lost, Unsettled
from allworlds.log import fault
from allworlds.protocol.turns import ACTION, BEGIN, FAULT, marshalled, said
from allworlds.robots import program_player
from allworlds.robots.minds import Dialogue
from allworlds.robots.program_player import MOST_LOST, ProgramPlayer, difference


class Player:
    """A player that is lost in each of these turns so many times."""

    def __init__(self, of):
        self.of, self.beat, self.dead = of, [0, 0], False

    def close(self):
        self.of.closed += 1


class Dying(ProgramPlayer):
    """A program; it says of a row the row, and is lost in some of them."""

    def __init__(self, loses):
        self.remarks = []
        super().__init__(None, None, None, 1, self.remarks.append)
        self.loses, self.closed, self.heard = dict(loses), 0, []

    def _start(self):
        self.close()
        self._player, self._anew = Player(self), True

    def answered(self, player, message):
        if player.dead:
            raise Lost("crash", "it is dead", machine=True)
        if message["known"]:
            self.heard.append([*message["content"]])
            return
        for at, row in enumerate(message["content"]):
            player.beat[0] = at
            if self.loses.get(row, 0):
                self.loses[row] -= 1
                player.dead = True
                raise Lost("crash", f"the end in {row}", machine=True)
            yield f"{row}".encode()


@pytest.fixture
def dying(monkeypatch):
    def make(**loses):
        program = Dying(loses)
        monkeypatch.setattr(program_player, "answered", lambda *call: [*program.answered(*call)])
        monkeypatch.setattr(program_player, "said_of", lambda answer: [answer])
        monkeypatch.setattr(program_player, "started", lambda *_: Player(program))
        return program

    return make


def test_turns_are_answered_and_told_again_to_a_player_that_is_new(dying):
    program = dying()
    assert program.replies(["a", "b"]) == [b"a", b"b"]
    program._start()
    assert program.replies(["c"]) == [b"c"]
    assert program.heard == [[], ["a", "b"]]
    program.begin_unit()
    assert program.replies(["d"]) == [b"d"]
    assert program.heard[2:] == [[]]


def test_a_turn_in_which_a_player_is_lost_once_is_asked_again(dying):
    program = dying(b=1)
    assert program.replies(["a", "b", "c"]) == [b"a", b"b", b"c"]
    assert program.remarks == ["a process was lost once: the end in b"]
    assert program._heard == ["a", "b", "c"]


def test_a_turn_in_which_it_is_lost_twice_is_a_fault_and_the_others_are_answered(dying):
    program = dying(b=2)
    first, second, third = program.replies(["a", "b", "c"])
    assert (first, third) == (b"a", b"c")
    assert said(second)[1] == FAULT
    assert said(second)[2] == fault("crash", program_player.AN_ACTION, "the end in b", machine=True)
    assert program.remarks == []
    assert program._heard == ["a", "c"]


def test_a_program_that_is_lost_too_often_is_given_up(dying):
    rows = "abcdefghi"
    assert len(rows) == MOST_LOST + 1
    program = dying(**dict.fromkeys(rows[:-1], 2))
    assert len(program.replies([*rows])) == len(rows)
    again = dying(**dict.fromkeys(rows, 2))
    again._subject = type("Subject", (), {"name": "mine"})
    with pytest.raises(Unsettled, match="players of mine were lost in 9 turns, the last by the"):
        again.replies([*rows])


def test_histories_are_played_some_at_a_time_and_each_alone_after_a_loss(dying, monkeypatch):
    monkeypatch.setattr(program_player, "AT_ONCE", 2)
    program = dying()
    assert [*program.plays(["a", "b", "c"])] == [[b"a"], [b"b"], [b"c"]]
    once = dying(b=1)
    assert [*once.plays(["a", "b", "c"])] == [[b"a"], [b"b"], [b"c"]]
    twice = dying(b=2)
    first, (second,), third = twice.plays(["a", "b", "c"])
    assert (first, third) == ([b"a"], [b"c"])
    assert said(second)[1] == FAULT
    assert twice._lost == 1


def test_a_player_is_closed_once(dying):
    program = dying()
    program.replies(["a"])
    program.close()
    program.close()
    assert program.closed == 1


@pytest.mark.parametrize("wrong", [None, 0, 1, 2])
def test_every_history_is_played_again_the_last_one_first_and_one_difference_is_found(wrong):
    roots = [(2 * which, BEGIN, told) for which, told in enumerate("abc")]
    turns = [turn for root in roots for turn in (root, (root[0] + 1, root[0], "seen"))]
    moved = [marshalled(0, ACTION, k) for k in (0, 1)]
    dialogue = Dialogue(None, {}, turns, [b"", moved[0]] * 3, [], automaton=False)
    asked = []

    class Again:
        def plays(self, histories):
            asked.extend(told for told, _ in histories)
            return [[moved[which == wrong]] for which in (2, 1, 0)]

    found = difference(dialogue, Again())
    assert asked == ["c", "b", "a"]
    if wrong is None:
        assert found is None
    else:
        assert found == (turns[2 * wrong + 1], "move 0", "move 1")
