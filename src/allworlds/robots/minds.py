"""The next action of a robot: a function of its percepts, never of a world.

A *mind* is a number.  The mind of a generator stands for its *history*: all its percepts so far.
The histories are the nodes of a tree, in which each percept leads from a node to a child.  The mind
of an automaton stands for its memory, with the action that is *due*: the robot has still to do it.
The *value* of a mind is the action that is due; or, in place of an action, :class:`Ended` or
:class:`ProgramFault` if the robot's program does not go on.  A search needs three answers: the mind
after one more percept, the value of a mind, and the mind after the due action.

By the action ``Watch`` a robot does nothing, and is not activated again until its percept differs
from the percept at the Watch.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple, Protocol

from msgspec import Struct

from allworlds.judging.episode import ending_of
from allworlds.log import Log
from allworlds.protocol.actions import Watch
from allworlds.protocol.turns import (
    ACTION,
    BEGIN,
    ENDED,
    NumberedTurn,
    Sensed,
    action_of,
    said,
)


class Ended(NamedTuple):
    """The value of a mind, in place of an action, if its program has ended with an answer.

    The robot stays where it is.
    """

    answer: Any

    def __str__(self) -> str:
        return "end" if self.answer is None else "end with an answer"


class ProgramFault(NamedTuple):
    """The value of a mind, in place of an action, if its program has failed.

    A program fails by an error, by silence, or by an illegal reply.

    Attributes:
        law: the law that the program breaks.
        seen: what the program has done, in words.
        detail: a traceback, or the end of the program's stderr; may be empty.
    """

    law: str
    seen: str
    detail: str = ""

    def __str__(self) -> str:
        return f"{self.law}: {self.seen}"


class RobotProgram(Protocol):
    """A program of robots that can be asked turn by turn."""

    def replies(self, turns: Sequence[NumberedTurn]) -> Sequence[bytes]:
        """The program's reply in each turn: bytes that :func:`allworlds.protocol.turns.said` reads.

        ``turns`` has only new turns.  The program remembers all turns of earlier calls, and a new
        turn names the turn before it by its number (:data:`allworlds.protocol.turns.NumberedTurn`).
        In the first turn of a history the program is only started, and gets no percept; so the
        reply of a generator is empty.
        """


class Dialogue(Struct):
    """The turns of one program so far, and its replies.

    Attributes:
        program: the program.
        roots: a dictionary from the value that a robot is told to the robot's mind before its first
            percept.
        turns: all turns so far, in their order.
        replies: the program's reply in each of these turns.
        waiting: the turns that the next message to the program will hold, each in a pair with the
            mind after the turn.  For a generator this mind is known: it stands for the history with
            the new percept.  For an automaton this mind depends on the reply, and -1 stands in its
            place.
        automaton: whether the program is an automaton; None if the program has not been asked yet.
    """

    program: RobotProgram
    roots: dict[bytes | None, int]
    turns: list[NumberedTurn]
    replies: list[bytes]
    waiting: list[tuple[NumberedTurn, int]]
    automaton: bool | None = None


class Minds:
    """The minds of all robots, shared by several searches.

    A mind is a number.  It stands for all that a robot's program remembers, with the action that
    the robot has still to do.

    Args:
        programs: the programs of the team, each once.

    Attributes:
        value: for each mind the action that is due, or the end or the fault of its program; None if
            no action is due.
        sensed: for each mind the last percept, if it is needed: a mind that is a history contains
            it; and if the due action is Watch, the next percepts are compared with it. Else None.
        depth: for each mind the number of activations; 0 for automata.
        watches: for each mind whether the due action is Watch.
        dialogues: for each program its turns and replies.
    """

    def __init__(self, programs: Sequence[RobotProgram]) -> None:
        self.value: list[Any] = []
        self.sensed: list[Sensed | None] = []
        self.depth: list[int] = []
        self.watches: list[bool] = []

        self.dialogues = [Dialogue(program, {}, [], [], []) for program in programs]
        self._program_of: list[int] = []
        self._memory: list[int] = []  # for a history: the mind before
        self._after: dict[tuple[int, Any], int] = {}
        self._minds: dict[Any, int] = {}
        self._steps: dict[Any, tuple[int, Any]] = {}
        self._promised: list[Any] = []

    def root(self, program: int, told: bytes | None) -> int:
        """The mind of a robot before its first percept.

        ``program`` is the index of the robot's program, ``told`` the value that the robot is told.

        Raises:
            Lost: if the player of the program is lost.
        """
        dialogue = self.dialogues[program]
        if told in dialogue.roots:
            return dialogue.roots[told]
        mind = len(self.value)
        turn = (mind, BEGIN, told)
        (reply,) = dialogue.program.replies([turn])
        dialogue.turns.append(turn)
        dialogue.replies.append(reply)
        dialogue.automaton = bool(reply)
        if dialogue.automaton:
            memory, letter, words = said(reply)
            fault = None if letter == ACTION else value_of(letter, words)
            mind = self._automaton(program, memory, fault, None)
        else:
            self._new(program, -1, None, None, 0)
        dialogue.roots[told] = mind
        return mind

    @property
    def finite(self) -> bool:
        """Whether all programs are automata, so that the graph of configurations is finite."""
        return all(each.automaton for each in self.dialogues)

    @property
    def histories(self) -> bool:
        """Whether no program is an automaton, so that every activation makes a history longer."""
        return not any(each.automaton for each in self.dialogues)

    def look(self, mind: int, sensed: Sensed) -> int:
        """The mind that follows ``mind`` after the percept ``sensed``, or a promise of this mind.

        A promise is a number below 0; it stands for a mind that depends on the program's reply.
        After :meth:`ask`, :meth:`resolved` returns the promised mind.
        """
        key = mind, sensed
        found = self._after.get(key)
        if found is not None:
            return found
        program = self._program_of[mind]
        dialogue = self.dialogues[program]
        if not dialogue.automaton:
            found = self._new(program, mind, None, sensed, self.depth[mind] + 1)
            dialogue.waiting.append(((found, mind, sensed), found))
            self._after[key] = found
            return found
        memory = self._memory[mind]
        step = program, memory, sensed
        if step not in self._steps:
            self._steps[step] = (-1, None)
            dialogue.waiting.append(((0, memory, sensed), -1))
        self._promised.append((key, step))
        return -len(self._promised)

    def ask(self) -> None:
        """Send each program all its waiting turns, in one message."""
        for program, dialogue in enumerate(self.dialogues):
            if not dialogue.waiting:
                continue
            turns = [turn for turn, _ in dialogue.waiting]

            replies = dialogue.program.replies(turns)
            dialogue.turns += turns
            dialogue.replies += replies
            for (turn, mind), reply in zip(dialogue.waiting, replies, strict=True):
                memory, letter, words = said(reply)
                value = value_of(letter, words)
                if mind < 0:
                    self._steps[program, turn[1], turn[2]] = memory, value
                else:
                    self.value[mind], self.watches[mind] = value, type(value) is Watch
            dialogue.waiting = []

    def resolved(self, mind: int) -> int:
        """The promised mind, if ``mind`` is a promise of :meth:`look`; else ``mind`` itself.

        The promise must have been made after the last call of :meth:`forget`.
        """
        if mind >= 0:
            return mind
        key, step = self._promised[-mind - 1]
        found = self._after.get(key)
        if found is None:
            _, sensed = key
            memory, value = self._steps[step]
            found = self._automaton(step[0], memory, value, sensed)
            self._after[key] = found
        return found

    def forget(self) -> None:
        """Forget all promises."""
        self._promised.clear()

    def after(self, mind: int) -> int:
        """The mind that follows the mind ``mind`` once its action is done.

        For a generator the result is ``mind`` itself, since an action adds nothing to a history.
        For an automaton the result is the mind with the same memory, and without a due action, but
        for two exceptions, in which the result is ``mind`` itself: the automaton has ended; or its
        action is Watch, and the mind must keep the percept with which later ones are compared.
        """
        program = self._program_of[mind]
        stays = self.watches[mind] or type(self.value[mind]) is Ended
        if stays or not self.dialogues[program].automaton:
            return mind
        return self._automaton(program, self._memory[mind], None, None)

    def precedes(self, mind: int, before: int) -> bool:
        """Whether a turn can be the next turn of a robot that has the mind ``mind``.

        ``before`` is the second number of the turn (:data:`allworlds.protocol.turns.NumberedTurn`),
        which says what the program remembers before the turn: for a generator it is a mind, for an
        automaton the number of a memory.  :data:`BEGIN` is the second number of a first turn.  For
        BEGIN the result is True if the mind belongs to a generator that has got no percept yet, or
        to an automaton whose due action is not Watch.
        """
        automaton = self.dialogues[self._program_of[mind]].automaton
        first = self.depth[mind] == 0 and self.sensed[mind] is None
        own = self._memory[mind] if automaton else mind
        return first if before == BEGIN else own == before

    def _automaton(self, program: int, memory: int, value: Any, sensed: Sensed | None) -> int:
        sensed = sensed if type(value) is Watch else None
        # Equal actions may be different ones: Do(1) and Do(True).
        key = program, memory, repr(value), sensed
        if key not in self._minds:
            self._minds[key] = self._new(program, memory, value, sensed, 0)
        return self._minds[key]

    def _new(self, program: int, memory: int, value: Any, sensed: Sensed | None, depth: int) -> int:
        self.value.append(value)
        self.watches.append(type(value) is Watch)
        self.sensed.append(sensed)
        self.depth.append(depth)
        self._program_of.append(program)
        self._memory.append(memory)
        return len(self.value) - 1


def value_of(letter: str, words: Any) -> Any:
    """The value of a mind after a program's reply: an action, the program's end, or its fault.

    None if no action is due.

    Args:
        letter: the kind of the reply: ``ACTION``, ``ENDED`` or ``FAULT`` of
            :mod:`allworlds.protocol.turns`.
        words: the content of the reply. For ``ACTION`` it is the action in the form that
            :func:`allworlds.protocol.turns.action_of` reads, or None for no action. For the other
            kinds it is the entry with which a log ends (:class:`allworlds.log.Log`): the answer, or
            the fault.
    """
    if letter == ACTION:
        return None if words is None else action_of(words)
    ending = ending_of(Log(words))
    if letter == ENDED and hasattr(ending, "answer"):
        return Ended(ending.answer)
    return ProgramFault(ending.law, ending.seen, ending.detail)  # type: ignore[union-attr]
