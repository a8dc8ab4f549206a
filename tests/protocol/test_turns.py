"""A program asked turn by turn: what it says, and what it says when it is asked again."""

import json

import pytest

from allworlds.log import Log
from allworlds.protocol.actions import Checkpoint, Do, Drop, End, Move, Percept, Write
from allworlds.protocol.turns import ACTION, BEGIN, ENDED, FAULT, Automaton, Turns, said


def turns_of(explore, **options):
    return Turns(explore, lambda first, choices, told: explore(first), **options)


def test_an_automaton_is_an_explorer_that_ends_with_its_answer():
    def step(left, percept):
        return left - 1, Move(left) if left else End("there")

    run = Automaton(lambda told: told, step)(Percept(3), told=2)
    assert next(run) == Move(2)
    assert run.send(Percept(3)) == Move(1)
    with pytest.raises(StopIteration) as stop:
        run.send(Percept(3))
    assert stop.value.value == "there"


@pytest.mark.parametrize(
    ("end", "words"), [(End(), "end"), (End(3), "end: 3"), (End(answer=False), "end: False")]
)
def test_the_end_of_an_automaton_is_told_with_its_answer(end, words):
    assert str(end) == words


def test_an_automaton_that_raises_is_a_crash_in_that_turn():
    def step(memory, percept):
        return 1 / memory, Move(0)

    turns = turns_of(Automaton(lambda told: told, step))
    begun = [said(words) for words in turns.replies([(0, BEGIN, b"2"), (1, BEGIN, b"0")])]
    assert begun == [(0, ACTION, None), (1, ACTION, None)]
    good, wrong = [said(words) for words in turns.replies([(2, 0, (3, 0)), (3, 1, (3, 0))])]
    assert good == (2, ACTION, 0)
    number, letter, words = wrong
    assert (number, letter) == (0, FAULT)
    law, _, seen, detail, machine = Log(words).ending[1:]
    assert (law, seen, machine) == ("crash", "ZeroDivisionError: division by zero", False)
    assert "return 1 / memory" in detail
    assert detail.count("File ") == 1


def words_of(*messages):
    """The words in the first turn of a program that says these messages."""

    def explore(first):
        for message in messages:  # noqa: UP028  # what is sent is no matter
            yield message

    turns = turns_of(explore)
    return [said(each)[1:] for each in turns.replies([(0, BEGIN, None), (1, 0, (3, 0))])[1:]]


@pytest.mark.parametrize("wrong", [Move("a"), Write(None), Do(float("nan")), Do({1: object()})])
def test_an_action_with_a_wrong_part_is_illegal(wrong):
    [(letter, words)] = words_of(wrong)
    assert letter == FAULT
    law, expected, seen = Log(words).ending[1:4]
    assert law == "illegal-action"
    assert expected == "Move and Write with an integer, Do with a value of JSON"
    assert seen.startswith(f"{type(wrong).__name__}(")


def test_what_is_no_action_is_illegal():
    [(letter, words)] = words_of(3)
    assert letter == FAULT
    legal = "a Move, Drop, Pick, Write, Wait, Watch, Do or Checkpoint"
    assert Log(words).ending[1:4] == ("illegal-action", legal, "3")


def test_actions_and_answers_are_said():
    assert words_of(Move(2)) == [(ACTION, 2)]
    assert words_of(Checkpoint((), (), 0), Write(4)) == [(ACTION, json.dumps({"write": 4}))]
    assert words_of(Do([1])) == [(ACTION, json.dumps({"do": [1]}))]
    assert words_of(Drop()) == [(ACTION, json.dumps({"drop": True}))]
    [(letter, words)] = words_of()
    assert (letter, Log(words).ending[1:]) == (ENDED, ("null",))


@pytest.mark.parametrize(("keeps", "closed"), [(True, []), (False, [0])])
def test_of_a_program_behind_a_pipe_one_run_is_alive_at_a_time(keeps, closed):
    ends, begun = [], []

    def explore(first):
        begun.append(number := len(begun))
        try:
            while True:
                yield Move(number)
        finally:
            ends.append(number)

    turns = turns_of(explore, keeps=keeps)
    first = turns.replies([(0, BEGIN, None), (1, 0, (3, 0))])
    assert (said(first[1])[1:], ends) == ((ACTION, 0), [])
    other = turns.replies([(2, 0, (2, 0))])  # which does not go on from the first
    assert (said(other[0])[1:], ends) == ((ACTION, 1), closed)
    turns.close()
    assert sorted(ends) == [0, 1]


def test_an_interrupt_while_an_action_is_read_is_the_users():
    class Interrupted:
        def __index__(self):
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        words_of(Move(Interrupted()))
