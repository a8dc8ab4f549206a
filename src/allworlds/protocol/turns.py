"""Programs of robots: after each percept a program is asked for its next action.

This module knows no worlds and no schedules.  A *history* is the value that a robot is told before
the start, and the robot's percepts after it.  Several histories may begin alike, and go on with
different percepts.  A *turn* is one step of a history, a tuple ``(number, before, percept)``.  The
first turn of a history brings the told value, in place of a percept, and its ``before`` is
:data:`BEGIN`.  Each later turn brings one percept; its ``before`` says which steps came before.

A program is a generator or an automaton.  In a turn of a generator, ``before`` is the number of the
turn before it in the same history.  A generator is kept alive after a turn, and gets the next
percept.  If the same history also goes on with another percept, a new generator replays the
history, since a generator cannot be copied.

An automaton computes its action and its next memory from its memory and the percept.  Its memories
are never sent to another process; instead, each memory has a number, which is no number of a turn.
In a turn of an automaton, ``before`` is the number of the memory before the turn.
"""

from __future__ import annotations

import json
import marshal
from collections.abc import Callable, Generator, MutableSequence, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, TypeAlias

from allworlds.inputs import checks
from allworlds.protocol import actions, playing
from allworlds.protocol.choices import Choices

ALIVE = 100_000
"""The largest number of generators that :class:`Turns` keeps alive."""

Sensed: TypeAlias = tuple[int, ...] | bytes
"""A percept in a message: the numbers of a :class:`Percept`, or a JSON value as canonical text."""

NumberedTurn: TypeAlias = tuple[int, int, Any]
"""A turn: its number, the number of the turn before it, and the percept.

For an automaton the second number is that of the memory before the turn.  In the first turn of a
history the second number is :data:`BEGIN`, and in place of the percept stands the value that the
robot is told before the start.
"""

BEGIN = -1
"""The value of ``before`` in the first turn of a history."""

ACTION, ENDED, FAULT = "aef"
"""The letters of a program's replies: an action, the program's answer, or a fault."""

LEGAL = "a Move, Drop, Pick, Write, Wait, Watch, Do or Checkpoint"


@dataclass(frozen=True)
class Automaton:
    """A program with a memory: its action is a function of the memory and of one percept.

    Attributes:
        start: the memory at the start, any hashable value; or a function that returns this memory,
            given the value that the robot is told before the start.
        step: the function ``step(memory, percept) -> (memory, action)``.  The action
            ``End(answer)`` ends the program.

    If an automaton has finitely many memories, a search can decide questions about its infinite
    runs.  The command ``check`` accepts an automaton as an explorer.
    """

    start: Any
    step: Callable[[Any, Any], tuple[Any, Any]]

    def begun(self, told: Any) -> Any:
        """The memory at the start, if the robot was told the value ``told`` before the start."""
        return self.start(told) if callable(self.start) else self.start

    def __call__(self, first: Any, *, told: Any = None) -> Generator[Any, Any, Any]:
        """Play as an explorer: the generator yields the actions, and returns the answer."""
        memory, percept = self.begun(told), first
        while True:
            memory, action = self.step(memory, percept)
            if type(action) is actions.End:
                return action.answer
            percept = yield action


class Turns:
    """One program of a robot, which is asked turn by turn for its next action.

    Args:
        explore: the function of the program, or an automaton.
        player: the same program as a function that begins a run, see :class:`actions.Player`.
        beat: two numbers that another process reads: while they stay the same, the program is
            silent.  ``beat[0]`` is the index of the turn on which the program works, in the list
            that :meth:`replies` got; in :meth:`plays` the index of the history.  ``beat[1]`` is 0
            while the program does not work; else it is above 0, and grows with each percept that a
            generator gets, also in a replay.
        keeps: whether several runs are kept alive.  A program outside Python, which is asked
            through a pipe, has one run at a time.
    """

    def __init__(
        self,
        explore: Any,
        player: actions.Player,
        beat: MutableSequence[int] | None = None,
        *,
        keeps: bool = True,
    ) -> None:
        self._explore, self._player = explore, player
        self._most = ALIVE if keeps else 1
        self._beat = [0, 0] if beat is None else beat
        self._told: dict[int, Any] = {}
        self._before: dict[int, int] = {}
        self._sensed: dict[int, Sensed] = {}
        self._alive: dict[int, Generator[Any, Any, Any]] = {}
        self._memories: list[Any] = []
        self._numbers: dict[Any, int] = {}

    def replies(self, turns: Sequence[NumberedTurn], *, known: bool = False) -> list[bytes]:
        """The program's reply in each turn, as bytes that :func:`said` reads, or empty bytes.

        In the first turn of a history a generator has no percept yet, so its reply is empty bytes.

        Args:
            turns: the turns, in their order.
            known: whether another process of the program has answered these turns already, and this
                process only learns them.  If so, a generator is not asked: its turns are stored for
                later replays, and its replies are empty bytes.  An automaton is asked again, so
                that its memories get numbers in this process, too; the same turns in the same order
                give the same numbers.
        """
        found = []
        for index, turn in enumerate(turns):
            self._beat[0], self._beat[1] = index, 1
            if isinstance(self._explore, Automaton):
                found.append(self._step(*turn))
            else:
                self._note(turn)
                found.append(b"" if known or turn[1] == BEGIN else self._turn(turn[0]))
        self._beat[1] = 0
        return found

    def plays(self, histories: Sequence[tuple[Any, Sequence[Sensed]]]) -> list[bytes]:
        """All replies of the program in each of several histories.

        A history is given as the value that the robot is told before the start, and its percepts.
        The result has one element for each history: bytes, from which :mod:`marshal` reads the list
        of the replies in the turns of this history.  These replies are those of :meth:`replies`.

        Later turns cannot go on from these histories, since the histories are not kept.  But the
        memories that an automaton had in them keep their numbers.
        """
        found = []
        for index, (told, history) in enumerate(histories):
            self._beat[0], self._beat[1] = index, 1
            anew = Turns(self._explore, self._player, self._beat, keeps=True)
            anew._memories, anew._numbers = self._memories, self._numbers
            turn, words = (0, BEGIN, told), list[bytes]()
            for number, sensed in enumerate(history, 1):
                before = anew.replies([turn])[0]
                words.append(before)
                automaton = isinstance(self._explore, Automaton)
                turn = number, said(before)[0] if automaton else number - 1, sensed
            words.append(anew.replies([turn])[0])
            anew.close()
            found.append(marshal.dumps(words))
        self._beat[1] = 0
        return found

    def close(self) -> None:
        """End every run that is alive."""
        for generator in self._alive.values():
            playing.closed(generator)
        self._alive.clear()

    # ---------------------------------------------------------------- automata

    def _step(self, _number: int, memory: int, sensed: Any) -> bytes:
        """The reply of an automaton in a turn, with the number of its memory after the turn.

        ``memory`` is the number of the automaton's memory before the turn, ``sensed`` the new
        percept.  If ``memory`` is :data:`BEGIN`, ``sensed`` is the value that the robot is told
        before the start.
        """
        try:
            if memory == BEGIN:
                after, letter, words = self._explore.begun(told_of(sensed)), ACTION, None
            else:
                made = self._explore.step(self._memories[memory], percept_of(sensed))
                if not isinstance(made, tuple) or len(made) != 2:
                    expected = "(memory, action) from step"
                    return marshalled(0, FAULT, _illegal(expected, made))
                after, action = made
                ended = type(action) is actions.End
                letter, words = _answer(action.answer) if ended else _action(action)
            number = self._numbers.setdefault(after, len(self._numbers))
            if number == len(self._memories):
                self._memories.append(after)
        except BaseException as error:  # noqa: BLE001  # the user's code
            return marshalled(0, FAULT, playing.raised(error, own=1))
        return marshalled(number, letter, words)

    # ---------------------------------------------------------------- generators

    def _note(self, turn: NumberedTurn) -> None:
        number, before, sensed = turn
        if before == BEGIN:
            self._told[number] = sensed
        else:
            self._before[number], self._sensed[number] = before, sensed

    def _turn(self, number: int) -> bytes:
        """The reply of a generator in the turn with this number, the last turn of its history."""
        generator = self._alive.pop(self._before[number], None)
        history, at = [self._sensed[number]], self._before[number]
        while generator is None and at in self._before:
            history.append(self._sensed[at])
            at = self._before[at]
        try:
            message: Any = None
            if generator is None and self._most == 1:
                self.close()
            for sensed in reversed(history):
                self._beat[1] += 1
                percept = percept_of(sensed)
                if generator is None:
                    generator = self._player(percept, Choices(), told_of(self._told[at]))
                    message = next(generator)
                else:
                    message = generator.send(percept)
                while type(message) is actions.Checkpoint:
                    message = generator.send(None)
        except StopIteration as stop:
            return marshalled(0, *_answer(stop.value))
        except BaseException as error:  # noqa: BLE001  # the user's code
            return marshalled(0, FAULT, playing.raised(error, own=1))
        letter, words = _action(message)
        if letter == ACTION and generator is not None and len(self._alive) < self._most:
            self._alive[number] = generator
        else:
            playing.closed(generator)
        return marshalled(0, letter, words)


# ---------------------------------------------------------------- on the way


def percept_of(sensed: Sensed) -> Any:
    """The percept that a program gets; ``sensed`` is this percept as it stands in a message.

    If ``sensed`` is the text of a JSON value, each call makes a new value, so a program that
    changes its percept changes no other percept.
    """
    return json.loads(sensed) if isinstance(sensed, bytes) else _percept(*sensed)


@lru_cache(maxsize=1 << 12)
def _percept(*numbers: Any) -> actions.Percept:
    return actions.Percept(*numbers)


def told_of(told: bytes | None) -> Any:
    """The value that a robot is told, read from canonical JSON."""
    return None if told is None else json.loads(told)


def marshalled(number: int, letter: str, words: Any) -> bytes:
    """A program's reply as bytes that :func:`said` reads.

    Args:
        number: the number of the automaton's memory after the turn; 0 for a generator.
        letter: the kind of reply: :data:`ACTION`, :data:`ENDED` or :data:`FAULT`.
        words: the action, the answer, or the fault.
    """
    return marshal.dumps((number, letter, words))


def said(answer: bytes) -> tuple[int, str, Any]:
    """The three parts of a reply: the number, the letter and the words of :func:`marshalled`."""
    return marshal.loads(answer)  # type: ignore[no-any-return]  # noqa: S302  # of our own process


def _action(message: Any) -> tuple[str, Any]:
    """The letter and the words for a message of a program; see :func:`marshalled`.

    For a motion the words are its number, for any other action a JSON text.  If the message is no
    action, the letter is :data:`FAULT`, and the words are an entry of a log.
    """
    kind = type(message)
    try:
        if kind is actions.Move:
            return ACTION, checks.integer(message.k)
        if kind is actions.Write:
            return ACTION, json.dumps({"write": checks.integer(message.k)})
        if kind is actions.Do:
            words = json.dumps({"do": message.value}, allow_nan=False, default=checks.integer)
            return ACTION, words
    except BaseException as error:  # noqa: BLE001  # the parts are the user's code
        checks.let_users_interrupt(error)
        return FAULT, _illegal("Move and Write with an integer, Do with a value of JSON", message)
    if kind in (actions.Drop, actions.Pick, actions.Wait, actions.Watch):
        return ACTION, json.dumps({str(message): True})
    return FAULT, _illegal(LEGAL, message)


@lru_cache(maxsize=1 << 12)
def action_of(words: int | str) -> Any:
    """The action, read from the words that :func:`_action` makes."""
    if isinstance(words, int):
        return actions.Move(words)
    return actions.action_from_json(json.loads(words))


def _answer(answer: Any) -> tuple[str, bytes]:
    return ENDED, playing.any_answer_entry(answer)


def _illegal(expected: str, message: object) -> bytes:
    return playing.illegal(expected, message)
