"""The lines of the user's program that run when a finding is played again.

These lines are not in the log, and no verdict depends on them.
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

UserLine: TypeAlias = tuple[str, int]
"""A file and a line in it; ``("", 0)`` if no line is the user's."""

NOWHERE: UserLine = ("", 0)

ONCE = "once"
"""The value of the key ``lines`` of a batch that asks only which lines run (:class:`LinesPlay`).
The value True also asks for the turns in which they run (:class:`TracedPlay`)."""

LATELY, BUSIEST = 1000, 5
"""Two numbers.  In the last ``LATELY`` turns it is counted how often each line ran; the ``BUSIEST``
lines that ran most often are told."""

_OURS = (__file__.rpartition("protocol")[0], sysconfig.get_path("stdlib"))


@cache
def is_users(file: str) -> bool:
    """Whether a file is the user's: no part of Python, of this package, or of an installed one."""
    made = file.startswith("<") and file not in linecache.cache
    return not (made or file.startswith(_OURS) or "-packages" in file)


class TracedPlay:
    """A stand-in for an explorer's generator that notes which lines of the user's program run.

    The stand-in has the methods of generators that a play needs.  A turn goes from a reply to the
    explorer's next message.

    Attributes:
        turns: for each turn two values: whether the explorer showed a checkpoint, and the line of
            its ``yield``.  If the explorer has ended, the last entry has the line where it ended.
        ran: the lines that have run.
        lately: for each of the last :data:`LATELY` turns, how often each line ran.
    """

    def __init__(self) -> None:
        self.turns: list[tuple[bool, UserLine]] = []
        self.ran: set[UserLine] = set()
        self.lately: deque[Counter[UserLine]] = deque(maxlen=LATELY)
        self._left: UserLine = NOWHERE
        self._walk: Generator[Any, Any, Any]

    def player(self, player: actions.Player) -> Any:
        """A function that begins a run of ``player``, and returns this object as its generator.

        The function calls ``player``, and keeps the generator that ``player`` returns; :meth:`send`
        and :meth:`close` call the methods of this generator.  The function is called only once,
        since this object is for one run.
        """

        def play(*told: Any) -> Any:
            self._walk = player(*told)
            return self

        return play

    def send(self, reply: Any) -> Any:
        """Send the reply to the explorer, and return the explorer's next message.

        During the call Python's trace function is replaced; then the earlier one is set again.
        """
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

    def busiest(self) -> list[UserLine]:
        """The lines that ran most in the last :data:`LATELY` turns, the busiest first."""
        every = sum(self.lately, Counter[UserLine]())
        return sorted(every, key=lambda line: (-every[line], line))[:BUSIEST]

    def _end(self, error: BaseException) -> UserLine:
        """The line of the user's program where the explorer ended.

        ``error`` is the exception that ended the explorer's generator, StopIteration after a
        return.  After a return the result is the line that returned; after any other exception, the
        innermost line of the user's program in the traceback.
        """
        line, frames = self._left, error.__traceback__
        while frames and not isinstance(error, StopIteration):
            if is_users(frames.tb_frame.f_code.co_filename):
                line = frames.tb_frame.f_code.co_filename, frames.tb_lineno
            frames = frames.tb_next
        return line


class LinesPlay(TracedPlay):
    """A :class:`TracedPlay` that only notes which lines run: not how often, nor in which turn.

    A function is traced until all its lines have run.  So a play takes some 3 times as long as
    without tracing; with a :class:`TracedPlay`, some 8 times as long (Algorithm 1, up to 60 edges).
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


def _line_of(frame: FrameType) -> UserLine:
    return frame.f_code.co_filename, frame.f_lineno


def _yielding(walk: Any) -> UserLine:
    """The line of the user's program that yields; ``walk`` is the explorer's generator.

    In a chain of ``yield from`` it is the innermost line.
    """
    line = NOWHERE
    while (frame := getattr(walk, "gi_frame", None)) is not None:
        if is_users(frame.f_code.co_filename):
            line = _line_of(frame)
        walk = walk.gi_yieldfrom
    return line


def written(plays: Sequence[TracedPlay]) -> bytes:
    """Traced plays as bytes for a message.

    Each play has three parts: its turns, the lines that ran, and the lines that ran most.
    """
    return json.dumps([(one.turns, sorted(one.ran), one.busiest()) for one in plays]).encode()
