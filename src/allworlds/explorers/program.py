"""A program in any language as an explorer: JSON lines over a pipe.

One process plays many episodes.  To it: ``{"episode": 1, "percept": P}`` (with ``"told"``
if there is something to tell), then ``{"percept": P}`` after each action.  From it:
``{"move": k}``, ``{"drop": true}``, ``{"pick": true}``, ``{"write": k}``,
``{"checkpoint": {...}}`` (unanswered) or ``{"estimate": {"sigma", "alpha", "here"}}`` or
``{"ambiguous": {"sigma", "alpha", "degree", "marks", "here"}}``, or ``{"answer": VALUE}`` where
the task is not ``map``.  Unknown keys are ignored by both sides.

A program whose first line is ``{"forks": true}`` (unanswered) can keep its state:  to it
``{"fork": N}`` (unanswered) and later, in place of an ``episode``, ``{"goto": N, "percept": P}``.
"""

from __future__ import annotations

import contextlib
import json
import os
import secrets
import select
import shlex
import shutil
import subprocess
import sys
import time
from collections.abc import Callable, Generator, Sequence
from functools import lru_cache
from random import Random
from typing import Any, Literal, NamedTuple

from allworlds.explorers.command_words import missing_script, obstacle, syntax_error
from allworlds.inputs import SHOWN, InputError, show
from allworlds.maps import CombinatorialMap, InvalidMap
from allworlds.protocol import (
    Action,
    Ambiguous,
    Checkpoint,
    Estimate,
    ExplorerFault,
    Percept,
    Told,
    action_from_json,
)
from allworlds.words import ended_by, plural

STDERR_KEPT = 4096
LONGEST_LINE = 1 << 24
SAYINGS = ("move", "drop", "pick", "write", "checkpoint", "estimate", "ambiguous", "answer")
"""A line of the program has exactly one of these keys."""

ANSWERS = {"estimate", "ambiguous", "answer"}
"""The keys of a line that ends an episode."""

SHORT = 64
"""Lines of fewer bytes, as most are, are parsed once."""


class EpisodeEnd(NamedTuple):
    """The answer of an episode, which is over."""

    answer: object


class Program:
    """The process behind ``--exec COMMAND``; started at the first episode.

    Args:
        command: split as a shell splits words; no shell is involved.
        answer_timeout: seconds of silence after which it is killed.

    Attributes:
        forks: whether the program has said that it can keep its state.

    Raises:
        InputError: if the command is empty, or its program is not found or cannot be run.
    """

    def __init__(self, command: str, answer_timeout: float) -> None:
        try:
            self._arguments = shlex.split(command)
        except ValueError as error:
            raise InputError(
                f"--exec {show(command)} cannot be split into words: {error}"
            ) from None
        if not self._arguments:
            raise InputError("--exec needs a command, not an empty string")
        found = shutil.which(self._arguments[0])
        if found is None:
            raise InputError(f"--exec {show(command)}: {obstacle(self._arguments[0])}")
        if missing := missing_script(self._arguments):
            raise InputError(f"--exec {show(command)}: {missing}")
        self.path = found
        self._timeout = answer_timeout
        self._process: subprocess.Popen[bytes] | None = None
        self._numbers = Random(secrets.randbits(64))  # noqa: S311  # they are to tell nothing
        self._heard = False
        self._lines = 0
        self._unanswered = False
        self._from: int | None = None
        self.forks = False
        self._err = bytearray()
        self._out = bytearray()
        self._said = select.poll()
        self._in_to = self._out_of = -1

    def ensure_readable(self) -> None:
        """Raise InputError if its interpreter cannot read its script."""
        if error := syntax_error(self._arguments):
            raise InputError(f"--exec {show(shlex.join(self._arguments))}: {error}")

    def explore(
        self, first: Percept, *, told: Told = None
    ) -> Generator[Action | Checkpoint, Percept, object]:
        """Play one episode: turn the program's lines into actions and an answer.

        Raises:
            ExplorerFault: when the program is silent, ends, or writes something else.
        """
        finished = False
        try:
            message = self.begin(first, told)
            while not isinstance(message, EpisodeEnd):
                percept = yield message
                message = self.go_on(percept)
            finished = True
            return message.answer
        finally:
            self._pass_stderr_on()
            if not finished:
                # Whatever it would say next belongs to an episode that is over.
                self._kill()

    def explore_by_copies(
        self, first: Percept, *, told: Told = None
    ) -> Generator[Action | Checkpoint, Percept, object]:
        """Play one episode, in which each step is made twice: from a state that has been kept, too.

        A program that keeps no states plays it as ever.

        Raises:
            ExplorerFault: as :meth:`explore`.
        """
        finished = False
        try:
            message = self.begin(first, told)
            while not isinstance(message, EpisodeEnd):
                percept = yield message
                if self.forks and not isinstance(message, Checkpoint):
                    self.fork(0)
                    while isinstance(self.go_on(percept), Checkpoint):
                        pass
                    self.goto(0)
                message = self.go_on(percept)
            finished = True
            return message.answer
        finally:
            self._pass_stderr_on()
            if not finished:
                self._kill()

    def begin(self, first: Percept, told: Told) -> Action | Checkpoint | EpisodeEnd:
        """Begin an episode; return the first message.

        Raises:
            ExplorerFault: as :meth:`explore`.
        """
        self._begin(first, told)
        return self._next_message()

    def go_on(self, percept: Percept | None) -> Action | Checkpoint | EpisodeEnd:
        """Answer an action, and return the next message; a checkpoint is not answered.

        Raises:
            ExplorerFault: as :meth:`explore`.
        """
        if self._from is not None:
            assert percept is not None
            self._empty()
            self._send(b'{"goto": %d, ' % self._from + _answering(percept)[1:])
            self._from = None
        elif not self._unanswered:
            assert percept is not None
            self._send(_answering(percept))
        return self._next_message()

    def fork(self, number: int) -> None:
        """Ask the program to keep its state by that number."""
        self._send(b'{"fork": %d}\n' % number)

    def goto(self, number: int) -> None:
        """Let the program go on from that state with the next percept."""
        if self._process is None:
            raise ExplorerFault(
                "crash", "the program that kept states has been ended", machine=True
            )
        self._from, self._unanswered = number, False

    def _next_message(self) -> Action | Checkpoint | EpisodeEnd:
        """The program's next message."""
        line = self._line()
        action = _short_action(line) if len(line) < SHORT else None
        self._unanswered = False
        if action is not None:
            return action
        message = self._message(line)
        if self._lines == 1 and message.get("forks") is True:
            self.forks = True
            return self._next_message()
        if (said := _sayings(message)) != 1:
            keys = f"it has {said or 'none'} of the keys {', '.join(SAYINGS)}, and needs one"
            raise self._fault("illegal-action", f"the line {_short(message)}: {keys}")
        action = action_from_json(message)
        if action is not None:
            return action
        if "checkpoint" in message:
            self._unanswered = True
            return _checkpoint(message["checkpoint"])
        if message.keys() & ANSWERS:
            if self._out:
                raise self._fault("illegal-action", f"a line after its answer: {_text(self._out)}")
            return EpisodeEnd(_answer(message))
        legal = "move takes an integer, write one from 0 on, drop and pick take true"
        raise self._fault("illegal-action", f"the line {_short(message)}: {legal}")

    def close(self) -> None:
        """Close the program's input, wait a second for its end, then kill it."""
        process = self._process
        if process is None:
            return
        if process.stdin:
            with contextlib.suppress(OSError):
                process.stdin.close()
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(1)
        self._kill()

    def _begin(self, first: Percept, told: Told) -> None:
        if self._process is None:
            self._start()
        self._empty()
        self._heard, self._from = False, None
        number = self._numbers.getrandbits(53)
        heard = b"" if told is None else b'"told": %b, ' % json.dumps(told).encode()
        self._send(b'{"episode": %d, ' % number + heard + _answering(first)[1:])

    def _empty(self) -> None:
        """Raise ExplorerFault if the program has said more than it was asked for."""
        self._read(0)
        self._err.clear()
        if self._out:
            raise self._fault("illegal-action", f"a line before it was asked: {_text(self._out)}")

    def _start(self) -> None:
        try:
            self._process = subprocess.Popen(  # noqa: S603  # running it is what was asked for
                self._arguments,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                bufsize=0,
                start_new_session=True,
            )
        except OSError as error:
            raise ExplorerFault("crash", f"the program cannot be started: {error}") from None
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        assert self._process.stderr is not None
        self._in_to, self._out_of = self._process.stdin.fileno(), self._process.stdout.fileno()
        os.set_blocking(self._in_to, False)
        self._said = select.poll()
        self._said.register(self._process.stdout, select.POLLIN)
        self._said.register(self._process.stderr, select.POLLIN)
        self._out.clear()
        self._err.clear()
        self._lines = 0

    def end(self) -> None:
        """End the program; the next episode starts it anew."""
        self._pass_stderr_on()
        self._kill()

    def _kill(self) -> None:
        process, self._process = self._process, None
        self._in_to = self._out_of = -1
        if process is None:
            return
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(process.pid, 9)
        process.wait()
        for stream in (process.stdin, process.stdout, process.stderr):
            if stream is not None:
                with contextlib.suppress(OSError):
                    stream.close()

    def _send(self, line: bytes) -> None:
        try:
            # A line is shorter than what a pipe takes whole or not at all.
            os.write(self._in_to, line)
        except BlockingIOError:
            self._send_when_read(line)
        except OSError:
            raise self._ended("the end of its input: it reads no more, and goes on") from None

    def _send_when_read(self, line: bytes) -> None:
        """Send a line to a program that has not read those before."""
        reads = select.poll()
        reads.register(self._in_to, select.POLLOUT)
        if not reads.poll(self._timeout * 1000):
            unread = f"it writes on, and for {self._timeout:g} s it has read nothing of the answers"
            raise self._fault("illegal-action", unread, machine=True)
        self._send(line)

    def _message(self, line: bytes) -> dict[str, Any]:
        try:
            message = json.loads(line)
        except (ValueError, RecursionError):
            raise self._fault("illegal-action", f"a line that is no JSON: {_text(line)}") from None
        if not isinstance(message, dict):
            raise self._fault("illegal-action", f"a line that is no object: {_text(line)}")
        return message

    def _line(self) -> bytes:
        deadline = time.monotonic() + self._timeout
        searched = 0
        while (end := self._out.find(b"\n", searched)) < 0:
            searched = len(self._out)
            if len(self._out) > LONGEST_LINE:
                raise self._fault("illegal-action", f"a line of over {LONGEST_LINE} bytes")
            left = deadline - time.monotonic()
            if left <= 0:
                raise self._fault("timeout", self._silence(), machine=True)
            if not self._read(left):
                raise self._ended("the end of its output: it writes no more, and goes on")
        line = bytes(self._out[:end])
        del self._out[: end + 1]
        self._heard = True
        self._lines += 1
        return line

    def _silence(self) -> str:
        """The words for a time in which no line came."""
        begun = len(self._out)
        if not begun:
            return f"silent for {self._timeout:g} s"
        return f"no whole line in {self._timeout:g} s ({plural(begun, 'byte')} of one)"

    def _read(self, wait: float) -> bool:
        """Read the program's output for up to ``wait`` seconds; return False at its end of output.

        Only the end of its stderr is kept.
        """
        goes_on = True
        for descriptor, _ in self._said.poll(wait * 1000):
            if descriptor == self._out_of:
                chunk = os.read(descriptor, 1 << 16)
                self._out += chunk
                goes_on = bool(chunk)
            else:
                self._read_err()
        return goes_on

    def _read_err(self) -> None:
        assert self._process is not None
        assert self._process.stderr is not None
        if text := self._process.stderr.read(1 << 16):
            self._err += text
            del self._err[:-STDERR_KEPT]
        else:
            self._said.unregister(self._process.stderr)
            self._process.stderr.close()

    def _ended(self, seen: str) -> ExplorerFault:
        """The fault of a program that has ended, or has closed a pipe, which ``seen`` tells."""
        assert self._process is not None
        with contextlib.suppress(subprocess.TimeoutExpired):
            seen = f"the end of its process ({ended_by(self._process.wait(1))})"
        if self._process.returncode == 0 and not self._heard:
            seen += ", before a line of this episode: one process plays many, until its input ends"
        code = self._process.returncode
        return self._fault("crash", seen, machine=code is not None and code < 0)

    def _pass_stderr_on(self) -> None:
        """Print the program's stderr of this episode."""
        self._drain()
        if self._err:
            sys.stderr.write(self._err.decode(errors="backslashreplace"))
            sys.stderr.flush()

    def _drain(self) -> None:
        """Read the program's stderr as far as it is written."""
        process = self._process
        while process and process.stderr and not process.stderr.closed:
            poll = select.poll()
            poll.register(process.stderr, select.POLLIN)
            before = len(self._err)
            if not poll.poll(0):
                return
            self._read(0)
            if len(self._err) in (before, STDERR_KEPT):
                return

    def _fault(
        self,
        law: Literal["crash", "timeout", "illegal-action", "no-estimate"],
        seen: str,
        *,
        machine: bool = False,
    ) -> ExplorerFault:
        self._drain()
        detail = self._err.decode(errors="replace")
        told = f"stderr:\n{detail}" if detail else ""
        return ExplorerFault(law, seen, told, machine=machine)


def _sayings(message: dict[str, Any]) -> int:
    """The number of keys of :data:`SAYINGS` in a message."""
    return sum(key in message for key in SAYINGS)


@lru_cache(maxsize=1 << 12)
def _short_action(line: bytes) -> Action | None:
    """The action of a short line; None if the line must be parsed more carefully."""
    try:
        message = json.loads(line)
    except (ValueError, RecursionError):
        return None
    one = isinstance(message, dict) and _sayings(message) == 1
    return action_from_json(message) if one else None


@lru_cache(maxsize=1 << 12)
def _answering(percept: Percept) -> bytes:
    """The line that answers an action."""
    return json.dumps({"percept": percept.to_json()}).encode() + b"\n"


def _checkpoint(value: object) -> Checkpoint:
    if not isinstance(value, dict):
        raise ExplorerFault("illegal-action", f"a checkpoint that is no object: {_short(value)}")
    if missing := _missing(value):
        raise ExplorerFault("illegal-action", f"a checkpoint without {missing}: {_short(value)}")
    return Checkpoint(value["sigma"], value["alpha"], value["here"])


def _answer(message: dict[str, Any]) -> object:
    if "estimate" in message:
        return _estimate(message["estimate"])
    if "answer" in message:
        return message["answer"]
    return _ambiguous(message["ambiguous"])


def _estimate(value: object) -> Estimate:
    if not isinstance(value, dict):
        raise ExplorerFault("no-estimate", f"an estimate that is no object: {_short(value)}")
    if missing := _missing(value):
        raise ExplorerFault("no-estimate", f"an estimate without {missing}: {_short(value)}")
    try:
        return Estimate(CombinatorialMap.from_json(value), value["here"])
    except InvalidMap as error:
        raise ExplorerFault("no-estimate", f"no map: {error}", error.tried) from None


def _ambiguous(value: object) -> Ambiguous:
    if not isinstance(value, dict):
        raise ExplorerFault("no-estimate", f"a quotient that is no object: {_short(value)}")
    if missing := _missing(value, ("sigma", "alpha", "degree", "marks", "here")):
        raise ExplorerFault("no-estimate", f"a quotient without {missing}: {_short(value)}")
    return Ambiguous(*(value[key] for key in ("sigma", "alpha", "degree", "marks", "here")))


def _missing(value: dict[str, Any], keys: Sequence[str] = ("sigma", "alpha", "here")) -> str:
    """The missing keys of a checkpoint or an answer, in words."""
    return " and ".join(key for key in keys if key not in value)


def _short(value: object) -> str:
    try:
        text = json.dumps(value)
    except (RecursionError, ValueError):  # nested too deeply, or an integer too long
        return show(value)
    return text if len(text) <= SHOWN else text[: SHOWN - 3] + "..."


def _text(line: bytes | bytearray) -> str:
    return repr(line[:SHOWN].decode(errors="replace"))


class ProgramRuns:
    """The runs of a program that keeps its states, in a process that plays trees."""

    def __init__(self, program: Program) -> None:
        self._program = program

    def begin(self, first: Percept, told: Told) -> object:
        """Begin a run; return the first action, or the answer."""
        return self._message(lambda: self._program.begin(first, told))

    def step(self, percept: Percept) -> object:
        """Go on; return the next action, or the answer."""
        return self._message(lambda: self._program.go_on(percept))

    def store(self, place: int) -> None:
        """Let the program keep its state by that number."""
        self._program.fork(place)

    def restore(self, place: int, *, last: bool) -> None:  # noqa: ARG002  # another one takes its place
        """Go on from the state that is kept by that number."""
        self._program.goto(place)

    def _message(self, asked: Callable[[], Action | Checkpoint | EpisodeEnd]) -> object:
        try:
            message = asked()
        except BaseException:
            self._program.end()
            raise
        return message.answer if isinstance(message, EpisodeEnd) else message
