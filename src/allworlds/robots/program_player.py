"""A program that a player in another process plays turn by turn; the second play of a program.

A player is lost if its process has died or was silent for too long.  In place of a lost player a
new player is started, which hears all earlier turns again.  If the new player is lost in the same
turn, the reply in that turn is a fault.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import islice
from typing import Any, NamedTuple

from allworlds.engines.limits import Limits
from allworlds.engines.players import Lost, Setup, Unsettled, answered, started
from allworlds.explorers.loading import Subject
from allworlds.log import fault
from allworlds.protocol.playing import AN_ACTION
from allworlds.protocol.turns import BEGIN, FAULT, NumberedTurn, Sensed, marshalled, said
from allworlds.robots.minds import Dialogue, value_of

MOST_LOST = 8
"""The number of turns in which a player may be lost twice; with more the job is given up."""

AT_ONCE = 1000
"""The number of histories in one message to the second player."""


class ProgramPlayer:
    """A program that a player in another process plays turn by turn.

    Args:
        subject: the program.
        limits: the limits of the time for an answer, and of memory.
        deadline: the time, on the monotonic clock, after which nobody waits for a reply; or None.
        seed: the hash seed of the player.
        remark: the function that is called with a text about a player that was lost only once.
    """

    def __init__(
        self,
        subject: Subject,
        limits: Limits,
        deadline: float | None,
        seed: int,
        remark: Callable[[str], None],
    ) -> None:
        self._subject, self._seed, self._remark = subject, seed, remark
        self._setup = Setup(subject, limits, deadline=deadline)
        self._player: Any = None
        self._heard: list[NumberedTurn] = []
        self._lost, self._anew = 0, True

    def begin_unit(self) -> None:
        """Begin a new unit: the player forgets all earlier turns."""
        self._heard, self._anew = [], True

    def close(self) -> None:
        """End the player."""
        if self._player is not None:
            self._player.close()
            self._player = None

    def replies(self, turns: Sequence[NumberedTurn]) -> list[bytes]:
        """The program's reply in each turn.

        Raises:
            Unsettled: if players are lost in too many turns.
        """
        try:
            found = self._ask("turns", turns)
        except Lost as lost:
            return self._after(lost, turns)
        self._heard += turns
        return found

    def plays(self, histories: Sequence[tuple[Any, Sequence[Sensed]]]) -> Iterator[list[bytes]]:
        """Yield the program's replies in each history, which is played from its beginning.

        A history is a pair: the value that the robot is told, and all its percepts in their order.
        """
        every = iter(histories)
        while some := [*islice(every, AT_ONCE)]:
            try:
                for answer in self._ask("histories", some):
                    yield said_of(answer)
            except Lost as lost:
                for one in some:
                    yield self._alone(one, lost)

    def _alone(self, history: tuple[Any, Sequence[Sensed]], lost: Lost) -> list[bytes]:
        self._start()
        try:
            return said_of(self._ask("histories", [history])[0])
        except Lost as again:
            self._count(again)
            return [_fault(lost)]

    def _after(self, lost: Lost, turns: Sequence[NumberedTurn]) -> list[bytes]:
        """The replies in all turns ``turns``, after the player was lost in one of them.

        The lost player has left the index i of that turn.  A new player takes the turns before turn
        i, and then turn i alone.  If it is lost in turn i, too, the reply to turn i is a fault, and
        a third player is started.  In both cases the last player takes the turns after turn i.
        ``lost`` says how the first player was lost.

        Raises:
            Unsettled: if players are lost in too many turns.
        """
        at = min(max(0, self._player.beat[0]), len(turns) - 1)
        before = turns[:at]
        self._start()
        found = self.replies(before) if before else []
        self._ensure_player()
        try:
            found += self._ask("turns", [turns[at]])
            self._remark(f"a process was lost once: {lost.seen}")
            self._heard.append(turns[at])
        except Lost as again:
            self._count(again)
            found.append(_fault(again))
            self._start()
        rest = turns[at + 1 :]
        return found + (self.replies(rest) if rest else [])

    def _count(self, lost: Lost) -> None:
        self._lost += 1
        if self._lost > MOST_LOST:
            raise Unsettled(
                f"players of {self._subject.name} were lost in {self._lost} turns, the last by "
                f"{lost.seen}"
            ) from None

    def _ask(self, kind: str, turns: Sequence[Any]) -> list[bytes]:
        self._ensure_player()
        message = {"kind": kind, "content": [*turns], "runs": len(turns), "known": False}
        return [*answered(self._player, message)]

    def _ensure_player(self) -> None:
        """Start a player if there is none; let a new player hear all earlier turns of the unit."""
        if self._player is None:
            self._start()
        if self._anew:
            self._anew = False
            message = {
                "kind": "turns",
                "content": self._heard,
                "runs": len(self._heard),
                "known": True,
                "anew": True,
            }
            answered(self._player, message)

    def _start(self) -> None:
        self.close()
        self._player = started(self._setup, self._seed)
        self._anew = True


def _fault(lost: Lost) -> bytes:
    words = fault(lost.law, AN_ACTION, lost.seen, machine=lost.machine)
    return marshalled(0, FAULT, words)


def said_of(answer: bytes) -> list[bytes]:
    """The program's replies in a history, from the player's answer."""
    return said(answer)  # type: ignore[return-value]  # a list here


# ---------------------------------------------------------------- the second play


class History(NamedTuple):
    """A history that the second player plays: the turns of one robot from the start on.

    Attributes:
        told: the value that the robot is told before its first percept.
        indices: the indices of the history's turns among all turns of the dialogue, in their order.
    """

    told: Any
    indices: tuple[int, ...]


class Difference(NamedTuple):
    """A turn in which two plays of a program differ.

    Attributes:
        turn: the turn.
        first, second: the program's action, end or fault in each of the two plays, in words.
    """

    turn: NumberedTurn
    first: str
    second: str


def histories_of(dialogue: Dialogue) -> list[History]:
    """Histories that together contain every turn of a dialogue.

    Each history is a path from the start to a turn after which no further turn was asked.
    """
    turns = dialogue.turns
    reached_by: dict[int, int] = {}  # the turn that first led to a number, or to a memory
    inner = set[int]()
    for index, (number, before, _) in enumerate(turns):
        after = said(dialogue.replies[index])[0] if dialogue.automaton else number
        if before != BEGIN and before in reached_by:
            inner.add(reached_by[before])
        reached_by.setdefault(after, index)
    found = []
    for index in range(len(turns)):
        if index not in inner:
            way = [index]
            while turns[way[-1]][1] != BEGIN:
                way.append(reached_by[turns[way[-1]][1]])
            found.append(History(turns[way[-1]][2], tuple(reversed(way[:-1]))))
    return found


def difference(dialogue: Dialogue, again: ProgramPlayer) -> Difference | None:
    """The first turn in which two plays of a program differ; None if no reply differs.

    The first play is ``dialogue``.  In the second play the player ``again`` plays all histories of
    the dialogue, in the reverse order.
    """
    histories = [history for history in histories_of(dialogue) if history.indices][::-1]
    turns, numbers = dialogue.turns, dict[int, int]()
    sensed = [(told, [turns[index][2] for index in indices]) for told, indices in histories]
    found = list[tuple[int, Difference]]()
    for history, replies in zip(histories, again.plays(sensed), strict=True):
        indices = (*_beginning(dialogue, history.told), *history.indices)
        # If the player was lost in this history alone, its last reply is the only one.
        for index, reply in zip(indices[-len(replies) :], replies, strict=True):
            first, second = dialogue.replies[index], reply
            if _alike(first, second, numbers):
                continue
            words = [str(value_of(*said(each)[1:])) if each else "" for each in (first, second)]
            if words[0] == words[1]:
                words = ["one memory", "another one"]
            found.append((index, Difference(turns[index], *words)))
            break
    return min(found)[1] if found else None


def _beginning(dialogue: Dialogue, told: Any) -> Iterator[int]:
    for index, (_, before, heard) in enumerate(dialogue.turns):
        if before == BEGIN and heard == told:
            yield index
            return


def _alike(first: bytes, second: bytes, numbers: dict[int, int]) -> bool:
    """Whether two replies are equal, apart from the numbers of an automaton's memories.

    A reply of an automaton holds the number of the memory after the turn.  Each play numbers the
    memories anew, so one memory may have two numbers.  ``numbers`` is a dictionary from a memory's
    number in the first play to its number in the second play; a missing number is added.
    """
    if not first or not second:
        return first == second
    (one, *words), (other, *others) = said(first), said(second)
    return words == others and numbers.setdefault(one, other) == other
