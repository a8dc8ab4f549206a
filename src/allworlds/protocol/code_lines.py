"""The lines of the user's code that a play goes through, where a finding is played again.

They never stand in a log, and decide nothing.
"""

import json
import linecache
import sys
import sysconfig
from collections import Counter, deque
from collections.abc import Generator, Sequence
from functools import cache
from types import CodeType, FrameType
from typing import Any, TypeAlias

from typing_extensions import override

from allworlds.protocol import actions

Place: TypeAlias = tuple[str, int]
"""A file and a line in it; ``("", 0)`` where no line is the user's."""

NOWHERE: Place = ("", 0)

ONCE = "once"
"""In place of True, where lines are asked for without the turns in which they run."""

LATELY, BUSIEST = 1000, 5
"""The last turns of a play of which the lines are counted, and the lines of these that are told."""

_OURS = (__file__.rpartition("protocol")[0], sysconfig.get_path("stdlib"))


@cache
def is_users(file: str) -> bool:
    """Whether a file is none of this package, of Python, or of an installed package."""
    made = file.startswith("<") and file not in linecache.cache
    return not (made or file.startswith(_OURS) or "-packages" in file)


class TracedPlay:
    """A player's generator in which lines are noted: it has the part of one that a play needs.

    Attributes:
        turns: for each turn whether it showed a checkpoint, and the place of its ``yield``; the
            last one is the place of the end, where the explorer came to one.
        ran: the lines that have run.
        lately: of each of the last turns how often each line ran.
    """

    def __init__(self) -> None:
        self.turns: list[tuple[bool, Place]] = []
        self.ran: set[Place] = set()
        self.lately: deque[Counter[Place]] = deque(maxlen=LATELY)
        self._left: Place = NOWHERE
        self._walk: Generator[Any, Any, Any]

    def player(self, player: actions.Player) -> Any:
        """The player, whose one run is traced here."""

        def play(*told: Any) -> Any:
            self._walk = player(*told)
            return self

        return play

    def send(self, reply: Any) -> Any:
        """Go on to the next message; whoever traced before goes on afterwards."""
        self.lately.append(Counter())
        before = sys.gettrace()
        sys.settrace(self._trace)
        try:
            message = self._walk.send(reply)
        except BaseException as error:
            self.turns.append((False, self._end(error)))
            raise
        finally:
            sys.settrace(before)
        self.turns.append((type(message) is actions.Checkpoint, _yielding(self._walk)))
        return message

    def close(self) -> None:
        """End the run."""
        self._walk.close()

    def _trace(self, frame: FrameType, event: str, _argument: object) -> Any:
        if not is_users(frame.f_code.co_filename):
            return None
        if event == "line":
            self.ran.add(_line_of(frame))
            self.lately[-1][_line_of(frame)] += 1
        elif event == "return":
            self._left = _line_of(frame)
        return self._trace

    def busiest(self) -> list[Place]:
        """The lines that ran most in the last turns, the busiest first."""
        every = sum(self.lately, Counter[Place]())
        return sorted(every, key=lambda line: (-every[line], line))[:BUSIEST]

    def _end(self, error: BaseException) -> Place:
        """The innermost line of the user's that raised; of a return the line that was left last."""
        line, frames = self._left, error.__traceback__
        while frames and not isinstance(error, StopIteration):
            if is_users(frames.tb_frame.f_code.co_filename):
                line = frames.tb_frame.f_code.co_filename, frames.tb_lineno
            frames = frames.tb_next
        return line


class LinesPlay(TracedPlay):
    """A player's generator of which the lines that run are noted once, and no turns.

    A function all of whose lines have run is traced no more: some 3 times as slow as without,
    where a :class:`TracedPlay` is some 8 times as slow (Algorithm 1, up to 60 edges).
    """

    def __init__(self) -> None:
        super().__init__()
        self._not_yet: dict[CodeType, set[int]] = {}

    @override
    def send(self, reply: Any) -> Any:
        before = sys.gettrace()
        sys.settrace(self._trace)
        try:
            return self._walk.send(reply)
        finally:
            sys.settrace(before)

    @override
    def _trace(self, frame: FrameType, event: str, _argument: object) -> Any:
        code = frame.f_code
        left = self._not_yet.get(code)
        if left is None:
            users = is_users(code.co_filename)
            every = {line for *_, line in code.co_lines() if line} if users else set[int]()
            left = self._not_yet[code] = every - {code.co_firstlineno}
        if event == "line" and frame.f_lineno in left:
            left.remove(frame.f_lineno)
            self.ran.add(_line_of(frame))
        return self._trace if left else None


def _line_of(frame: FrameType) -> Place:
    return frame.f_code.co_filename, frame.f_lineno


def _yielding(walk: Any) -> Place:
    """The innermost line of the user's in a chain of ``yield from``."""
    line = NOWHERE
    while (frame := getattr(walk, "gi_frame", None)) is not None:
        if is_users(frame.f_code.co_filename):
            line = _line_of(frame)
        walk = walk.gi_yieldfrom
    return line


def written(plays: Sequence[TracedPlay]) -> bytes:
    """Traced plays, as a message holds them."""
    return json.dumps([(one.turns, sorted(one.ran), one.busiest()) for one in plays]).encode()
