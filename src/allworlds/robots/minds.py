"""The next action of a robot: a function of what it has sensed, never of a world.

A *mind* is a number.  Of a generator it stands for a history of percepts, a node of a trie; of an
automaton for its memory, with the action that is due.  A search asks three things: the mind after
one percept more, the action that it wants, and the mind once that is done.
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
    Row,
    Sensed,
    action_of,
    said,
)


class Ended(NamedTuple):
    """The program has ended with an answer; its robot stays where it is."""

    answer: Any

    def __str__(self) -> str:
        return "end" if self.answer is None else "end with an answer"


class ProgramFault(NamedTuple):
    """The program has raised, was silent, or has said what is no action."""

    law: str
    seen: str
    detail: str = ""

    def __str__(self) -> str:
        return f"{self.law}: {self.seen}"


class RobotProgram(Protocol):
    """A program as it is asked."""

    def answers(self, rows: Sequence[Row]) -> Sequence[bytes]:
        """The words of the program in each turn: see :class:`allworlds.protocol.turns.Turns`."""


class ProgramTurns(Struct):
    """The turns of one program so far.

    Attributes:
        roots: the first mind, by what is told.
        automaton: whether it is one; None: it was not asked yet.
        rows: all turns that were asked for, in their order.
        said: what it said in each.
        waiting: the turns of the next message, each with its mind; of an automaton -1.
    """

    program: RobotProgram
    roots: dict[bytes | None, int]
    rows: list[Row]
    said: list[bytes]
    waiting: list[tuple[Row, int]]
    automaton: bool | None = None


class Minds:
    """The minds of all robots of some searches.

    Args:
        programs: those of the team, each once.

    Attributes:
        value: for each mind the action that is due, how its program has ended, or None.
        sensed: for each mind what it has sensed last, if it watches, or is a history.
        depth: for each mind the number of activations; of automata 0.
        messages: the number of turns of each message.
    """

    def __init__(self, programs: Sequence[RobotProgram]) -> None:
        self.value: list[Any] = []
        self.sensed: list[Sensed | None] = []
        self.depth: list[int] = []
        self.watches: list[bool] = []
        self.messages: list[int] = []
        self.kept = [ProgramTurns(program, {}, [], [], []) for program in programs]
        self._of: list[int] = []
        self._memory: list[int] = []  # of a history the mind before
        self._after: dict[tuple[int, Any], int] = {}
        self._minds: dict[Any, int] = {}
        self._steps: dict[Any, tuple[int, Any]] = {}
        self._asked: list[Any] = []

    def root(self, program: int, told: bytes | None) -> int:
        """The mind of a robot that has sensed nothing yet; of robots that are told alike it is one.

        Raises:
            Lost: if the program cannot be asked.
        """
        kept = self.kept[program]
        if told in kept.roots:
            return kept.roots[told]
        mind = len(self.value)
        row = (mind, BEGIN, told)
        (answer,) = kept.program.answers([row])
        kept.rows.append(row)
        kept.said.append(answer)
        kept.automaton = bool(answer)
        if kept.automaton:
            memory, letter, words = said(answer)
            fault = None if letter == ACTION else value_of(letter, words)
            mind = self._automaton(program, memory, fault, None)
        else:
            self._new(program, -1, None, None, 0)
        kept.roots[told] = mind
        return mind

    @property
    def finite(self) -> bool:
        """Whether all programs are automata: then every run can be followed for ever."""
        return all(kept.automaton for kept in self.kept)

    @property
    def histories(self) -> bool:
        """Whether no program is an automaton: then every activation makes a history longer."""
        return not any(kept.automaton for kept in self.kept)

    def look(self, mind: int, sensed: Sensed) -> int:
        """The mind after one percept more; one below 0 is known once all are settled."""
        key = mind, sensed
        found = self._after.get(key)
        if found is not None:
            return found
        program = self._of[mind]
        kept = self.kept[program]
        if not kept.automaton:
            found = self._new(program, mind, None, sensed, self.depth[mind] + 1)
            kept.waiting.append(((found, mind, sensed), found))
            self._after[key] = found
            return found
        memory = self._memory[mind]
        step = program, memory, sensed
        if step not in self._steps:
            self._steps[step] = (-1, None)
            kept.waiting.append(((0, memory, sensed), -1))
        self._asked.append((key, step))
        return -len(self._asked)

    def settle(self) -> None:
        """Ask for all that is not known yet: of each program in one message."""
        for program, kept in enumerate(self.kept):
            if not kept.waiting:
                continue
            rows = [row for row, _ in kept.waiting]
            self.messages.append(len(rows))
            answers = kept.program.answers(rows)
            kept.rows += rows
            kept.said += answers
            for (row, mind), answer in zip(kept.waiting, answers, strict=True):
                memory, letter, words = said(answer)
                value = value_of(letter, words)
                if mind < 0:
                    self._steps[program, row[1], row[2]] = memory, value
                else:
                    self.value[mind], self.watches[mind] = value, type(value) is Watch
            kept.waiting = []

    def settled(self, mind: int) -> int:
        """The mind that :meth:`look` has promised since :meth:`forget`."""
        if mind >= 0:
            return mind
        key, step = self._asked[-mind - 1]
        found = self._after.get(key)
        if found is None:
            _, sensed = key
            memory, value = self._steps[step]
            found = self._automaton(step[0], memory, value, sensed)
            self._after[key] = found
        return found

    def forget(self) -> None:
        """Forget what was promised."""
        self._asked.clear()

    def after(self, mind: int) -> int:
        """The mind once its action is done: of that an automaton knows nothing any more."""
        program = self._of[mind]
        kept = self.watches[mind] or type(self.value[mind]) is Ended
        if kept or not self.kept[program].automaton:
            return mind
        return self._automaton(program, self._memory[mind], None, None)

    def precedes(self, mind: int, before: int) -> bool:
        """Whether a turn whose number before is that one begins in a mind."""
        automaton = self.kept[self._of[mind]].automaton
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
        self._of.append(program)
        self._memory.append(memory)
        return len(self.value) - 1


def value_of(letter: str, words: Any) -> Any:
    """The action, or the end, that a program has said."""
    if letter == ACTION:
        return None if words is None else action_of(words)
    ending = ending_of(Log(words))
    if letter == ENDED and hasattr(ending, "answer"):
        return Ended(ending.answer)
    return ProgramFault(ending.law, ending.seen, ending.detail)  # type: ignore[union-attr]
