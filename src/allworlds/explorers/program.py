"""A program in any language as an explorer: lines of JSON over a pipe.

One process plays many episodes; :mod:`allworlds.explorers.program_lines` has the lines.
"""

from __future__ import annotations

import contextlib
import os
import secrets
import select
import shlex
import shutil
import subprocess
import sys
import time
from collections.abc import Generator
from random import Random
from typing import Literal

from allworlds.explorers.command_words import missing_script, obstacle, syntax_error
from allworlds.explorers.program_lines import (
    EpisodeEnd,
    Message,
    answering,
    beginning,
    message_of,
    shown,
)
from allworlds.inputs import InputError, show
from allworlds.protocol import Action, Checkpoint, ExplorerFault, Percept, Told
from allworlds.words import ended_by, plural

STDERR_KEPT = 4096
LONGEST_LINE = 1 << 24


class Program:
    """The process behind ``--exec COMMAND``; started at the first episode.

    Args:
        command: split as a shell splits words; no shell is involved.
        answer_timeout: seconds of silence after which it is killed.

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
            self._begin(first, told)
            message = self._next_message()
            while not isinstance(message, EpisodeEnd):
                percept = yield message
                if not isinstance(message, Checkpoint):
                    self._send(answering(percept))
                message = self._next_message()
            finished = True
            return message.answer
        finally:
            self._pass_stderr_on()
            if not finished:
                # Whatever it would say next belongs to an episode that is over.
                self._kill()

    def _next_message(self) -> Message:
        """The program's next message."""
        line = self._line()
        try:
            message = message_of(line)
        except ExplorerFault as fault:
            raise self._fault(fault.law, fault.seen, fault.detail) from None
        if isinstance(message, EpisodeEnd) and self._out:
            raise self._fault("illegal-action", f"a line after its answer: {shown(self._out)}")
        return message

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
        self._heard = False
        self._send(beginning(self._numbers.getrandbits(53), first, told))

    def _empty(self) -> None:
        """Raise ExplorerFault if the program has said more than it was asked for."""
        self._read(0)
        self._err.clear()
        if self._out:
            raise self._fault("illegal-action", f"a line before it was asked: {shown(self._out)}")

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
        detail: str = "",
        *,
        machine: bool = False,
    ) -> ExplorerFault:
        self._drain()
        said = self._err.decode(errors="replace")
        told = [detail, f"stderr:\n{said}" if said else ""]
        return ExplorerFault(law, seen, "\n\n".join(filter(None, told)), machine=machine)
