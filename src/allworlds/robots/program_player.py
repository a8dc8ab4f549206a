"""A program as a search asks it, by a player in another process; and its second play.

A player that is lost is started anew, and hears all turns again that were answered before.  A turn
in which it is lost twice is one with a fault.
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
from allworlds.protocol.turns import BEGIN, FAULT, Row, Sensed, marshalled, said
from allworlds.robots.minds import ProgramTurns, value_of

MOST_LOST = 8
"""The number of turns in which a player may be lost before its program is given up."""

AT_ONCE = 1000
"""The histories that the second player gets at once."""


class ProgramPlayer:
    """A program as its player is asked.

    Args:
        subject: the program.
        limits: of the time for an answer, and of memory.
        deadline: on the monotonic clock, or None.
        seed: the hash seed of the player.
        remark: takes a text about a process that was lost once.
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
        self._known: list[Row] = []
        self._lost, self._anew = 0, True

    def forget(self) -> None:
        """Begin a new unit: the program hears of no earlier turn any more."""
        self._known, self._anew = [], True

    def close(self) -> None:
        """End the player."""
        if self._player is not None:
            self._player.close()
            self._player = None

    def answers(self, rows: Sequence[Row]) -> list[bytes]:
        """The words of the program in each turn.

        Raises:
            Unsettled: if players are lost in too many turns.
        """
        try:
            found = self._ask("turns", rows)
        except Lost as lost:
            return self._after(lost, rows)
        self._known += rows
        return found

    def plays(self, histories: Sequence[tuple[Any, Sequence[Sensed]]]) -> Iterator[list[bytes]]:
        """All words of the program in each history, in a play by itself."""
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

    def _after(self, lost: Lost, rows: Sequence[Row]) -> list[bytes]:
        """The words of the program in turns in one of which its player was lost."""
        at = min(max(0, self._player.beat[0]), len(rows) - 1)
        before = rows[:at]
        self._start()
        found = self.answers(before) if before else []
        self._player_after_known()
        try:
            found += self._ask("turns", [rows[at]])
            self._remark(f"a process was lost once: {lost.seen}")
            self._known.append(rows[at])
        except Lost as again:
            self._count(again)
            found.append(_fault(again))
            self._start()
        rest = rows[at + 1 :]
        return found + (self.answers(rest) if rest else [])

    def _count(self, lost: Lost) -> None:
        self._lost += 1
        if self._lost > MOST_LOST:
            raise Unsettled(
                f"players of {self._subject.name} were lost in {self._lost} turns, the last by "
                f"{lost.seen}"
            ) from None

    def _ask(self, kind: str, rows: Sequence[Any]) -> list[bytes]:
        self._player_after_known()
        message = {"kind": kind, "content": [*rows], "runs": len(rows), "known": False}
        return [*answered(self._player, message)]

    def _player_after_known(self) -> None:
        """See that there is a player, which has heard of all turns before."""
        if self._player is None:
            self._start()
        if self._anew:
            self._anew = False
            message = {
                "kind": "turns",
                "content": self._known,
                "runs": len(self._known),
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
    """All words in a history."""
    return said(answer)  # type: ignore[return-value]  # a list here


# ---------------------------------------------------------------- the second play


class History(NamedTuple):
    """A history to be played again.

    Attributes:
        told: before it.
        rows: the numbers of its turns among those of the program, in their order.
    """

    told: Any
    rows: tuple[int, ...]


class Difference(NamedTuple):
    """A turn in which a program says one thing first, and another the second time.

    Attributes:
        row: the turn.
        first, second: what was said.
    """

    row: Row
    first: str
    second: str


def histories_of(kept: ProgramTurns) -> list[History]:
    """Histories in which every turn of a program comes, the longest ones of a trie."""
    came: dict[int, int] = {}  # by the number behind a turn: the turn that led there first
    inner = set[int]()
    for index, (number, before, _) in enumerate(kept.rows):
        behind = said(kept.said[index])[0] if kept.automaton else number
        if before != BEGIN and before in came:
            inner.add(came[before])
        came.setdefault(behind, index)
    found = []
    for index in range(len(kept.rows)):
        if index not in inner:
            way = [index]
            while kept.rows[way[-1]][1] != BEGIN:
                way.append(came[kept.rows[way[-1]][1]])
            found.append(History(kept.rows[way[-1]][2], tuple(reversed(way[:-1]))))
    return found


def difference(kept: ProgramTurns, again: ProgramPlayer) -> Difference | None:
    """The first turn that is another one when every history is played again, the last one first."""
    histories = [history for history in histories_of(kept) if history.rows][::-1]
    sensed = [(told, [kept.rows[row][2] for row in rows]) for told, rows in histories]
    numbers: dict[int, int] = {}
    found = list[tuple[int, Difference]]()
    for history, answers in zip(histories, again.plays(sensed), strict=True):
        rows = (*_beginning(kept, history.told), *history.rows)
        # Where a player was lost alone, nothing is known but that.
        for row, answer in zip(rows[-len(answers) :], answers, strict=True):
            first, second = kept.said[row], answer
            if _alike(first, second, numbers):
                continue
            words = [str(value_of(*said(each)[1:])) if each else "" for each in (first, second)]
            if words[0] == words[1]:
                words = ["one memory", "another one"]
            found.append((row, Difference(kept.rows[row], *words)))
            break
    return min(found)[1] if found else None


def _beginning(kept: ProgramTurns, told: Any) -> Iterator[int]:
    for index, (_, before, heard) in enumerate(kept.rows):
        if before == BEGIN and heard == told:
            yield index
            return


def _alike(first: bytes, second: bytes, numbers: dict[int, int]) -> bool:
    """Whether two turns are the same, if memories are the same whose numbers are paired."""
    if not first or not second:
        return first == second
    (one, *words), (other, *others) = said(first), said(second)
    return words == others and numbers.setdefault(one, other) == other
