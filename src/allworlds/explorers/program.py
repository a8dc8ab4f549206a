"""Explorers that are programs in any language; they read and write lines through pipes.

Each percept, action and answer is one JSON object in one line.  One run is an *episode*.
"""

import contextlib
import json
import os
import re
import select
import shlex
import shutil
import subprocess
import sys
import time
from collections.abc import Generator, Sequence
from functools import lru_cache
from pathlib import Path
from random import SystemRandom
from typing import Any, NamedTuple, TypeAlias

from allworlds.inputs.checks import SHOWN, InputError, is_loop_of_links, no_file, show
from allworlds.inputs.nesting import refusal_in
from allworlds.maps.combinatorial import CombinatorialMap, InvalidMap
from allworlds.protocol import actions
from allworlds.words import ended_by, plural

INTERPRETER = re.compile(r"(python|pypy|node|nodejs|ruby|perl|lua|php)[0-9.]*")
"""The names of interpreters; an interpreter runs a script: its first argument that is no option."""

SCRIPT = re.compile(r".+\.([cm]?js|lua|php|pl|py|rb)")
"""The names of files that are scripts for these interpreters."""


def missing_script(words: Sequence[str]) -> str:
    """The reason why the interpreter in a command cannot open its script, for a message.

    ``words`` are the words of the command.  The result is empty if the script exists, or if the
    command is not known to be a call of an interpreter with a script.
    """
    interpreter = Path(words[0]).name
    script = next((word for word in words[1:] if not word.startswith("-")), "")
    is_call = INTERPRETER.fullmatch(interpreter) and SCRIPT.fullmatch(script)
    if not is_call or Path(script).exists():
        return ""
    return f"{interpreter} cannot open {show(script)}: {no_file(script)}"


def obstacle(name: str) -> str:
    """The reason why the system cannot run ``name``, the first word of a command, for a message.

    The caller has already searched for a program of this name, and found none.  The result is never
    empty.
    """
    if is_loop_of_links(name):
        return f"{show(name)} is a loop of links"
    if os.path.isdir(name):  # noqa: PTH112  # takes any text, as below
        return f"{show(name)} is a directory, not a program"
    if os.path.isfile(name) and os.sep in name:  # noqa: PTH113
        return f"the file {show(name)} is not executable; chmod +x, or name its interpreter first"
    hint = f"; for the file here write './{name}'" if os.path.isfile(name) else ""  # noqa: PTH113
    return f"there is no program {show(name)}{hint}"


ROBOTS = ("wait", "watch", "do")
"""The keys of actions that are legal only with several robots."""

SAYINGS = (
    *("move", "drop", "pick", "write", "checkpoint", "estimate", "ambiguous", "answer"),
    *ROBOTS,
)
"""The keys of the program's lines; each line has exactly one of these keys."""

MAP_KEYS, QUOTIENT_KEYS = ("sigma", "alpha", "here"), ("sigma", "alpha", "degree", "marks", "here")

SHORT = 256
"""The number of bytes below which parsed lines are cached; most lines are shorter."""


class EpisodeEnd(NamedTuple):
    """The message with which the program ends an episode: its answer."""

    answer: object


ProgramMessage: TypeAlias = actions.Action | actions.Checkpoint | EpisodeEnd
"""The content of a line that a program has written."""


# ---------------------------------------------------------------- to the program


def beginning(number: int, first: actions.Percept, told: actions.Told) -> bytes:
    """The line to the program that begins an episode.

    Args:
        number: a number for the episode.
        first: the percept at the start.
        told: the value that the lighthouse tells before the start; None: no value is written.
    """
    heard = b"" if told is None else b'"told": %b, ' % json.dumps(told).encode()
    return b'{"episode": %d, ' % number + heard + answering(first)[1:]


def answering(percept: Any) -> bytes:
    """The line to the program that answers its action with a percept.

    In a user's model of a changing world a percept may be any JSON value.
    """
    if isinstance(percept, actions.Percept):
        return _answering(percept)
    return json.dumps({"percept": percept}).encode() + b"\n"


@lru_cache(maxsize=1 << 12)
def _answering(percept: actions.Percept) -> bytes:
    return json.dumps({"percept": percept.to_json()}).encode() + b"\n"


# ---------------------------------------------------------------- from the program


def message_of(line: bytes) -> ProgramMessage:
    """The message in a line that the program has written.

    Raises:
        ExplorerFault: if the line is no message of the protocol, or holds an illegal value.
    """
    try:
        message = json.loads(line)
    except (ValueError, RecursionError):
        raise _illegal(f"a line that is no JSON: {shown(line)}") from None
    if not isinstance(message, dict):
        raise _illegal(f"a line that is no object: {shown(line)}")
    if (said := sum(key in message for key in SAYINGS)) != 1:
        keys = f"it has {said or 'none'} of the keys {', '.join(SAYINGS)}, and needs one"
        raise _illegal(f"the line {_short(message)}: {keys}")
    action: ProgramMessage | None = actions.action_from_json(message)
    if action is not None:
        return action
    if "checkpoint" in message:
        found = _values(message["checkpoint"], "a checkpoint", "illegal-action", *MAP_KEYS)
        return actions.Checkpoint(*found)
    if "estimate" in message:
        return EpisodeEnd(_estimate(message["estimate"]))
    if "ambiguous" in message:
        found = _values(message["ambiguous"], "a quotient", "no-estimate", *QUOTIENT_KEYS)
        return EpisodeEnd(actions.Ambiguous(*found))
    if "answer" in message:
        return EpisodeEnd(message["answer"])
    legal = "move takes an integer, write one from 0 on, drop and pick take true"
    raise _illegal(f"the line {_short(message)}: {legal}")


_message_of_short = lru_cache(maxsize=1 << 12)(message_of)


def _illegal(seen: str) -> actions.ExplorerFault:
    return actions.ExplorerFault("illegal-action", seen)


def _estimate(value: object) -> actions.Estimate:
    _, _, here = _values(value, "an estimate", "no-estimate", *MAP_KEYS)
    try:
        return actions.Estimate(CombinatorialMap.from_json(value), here)  # type: ignore[arg-type]
    except InvalidMap as error:
        raise actions.ExplorerFault("no-estimate", f"no map: {error}", error.tried) from None


def _values(value: object, what: str, law: actions.FaultLaw, *keys: str) -> list[Any]:
    """The values under ``keys`` in ``value``, which is a checkpoint or an answer in JSON.

    Args:
        value: the JSON value.
        what: words for this value in the message of an error.
        law: the law that is broken by an error.
        keys: the keys, in the order of the result.

    Raises:
        ExplorerFault: if ``value`` is no object, or lacks a key.
    """
    if not isinstance(value, dict):
        raise actions.ExplorerFault(law, f"{what} that is no object: {_short(value)}")
    if missing := [key for key in keys if key not in value]:
        raise actions.ExplorerFault(law, f"{what} without {' and '.join(missing)}: {_short(value)}")
    return [value[key] for key in keys]


def _short(value: object) -> str:
    try:
        text = json.dumps(value)
    except (RecursionError, ValueError):  # nested too deeply, or an integer too long
        return show(value)
    return text if len(text) <= SHOWN else text[: SHOWN - 3] + "..."


def shown(line: bytes | bytearray) -> str:
    """The beginning of a line that the program has written, quoted for messages."""
    return repr(line[:SHOWN].decode(errors="replace"))


STDERR_KEPT = 4096
LONGEST_LINE = 1 << 24


class Program:
    """An explorer that is a program, given by ``--exec COMMAND``, and its process.

    The process starts at the first episode, if :meth:`start` has not started it before.

    Args:
        command: the command.  It is split into words like in a shell, but no shell runs it.
        answer_timeout: the seconds of silence after which the process is killed.

    Attributes:
        stays: whether the process may outlive an episode that is broken off.  If ``stays`` is true
            and the process waits for a percept at that moment, it is kept alive for the next
            episode.  In any other case it is killed.  ``stays`` is False at first; a player that
            asks for single turns sets it to True.

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
        there = shutil.which(self._arguments[0])
        if fault := missing_script(self._arguments) if there else obstacle(self._arguments[0]):
            raise InputError(f"--exec {show(command)}: {fault}")
        self._command, self._timeout = command, answer_timeout
        self.stays = False
        self._process: subprocess.Popen[bytes] | None = None
        self._heard = self._is_new = False
        self._err = bytearray()
        self._out = bytearray()
        self._said = select.poll()
        self._in_to = self._out_of = -1

    def explore(
        self, first: actions.Percept, *, told: actions.Told = None
    ) -> Generator[actions.Action | actions.Checkpoint, actions.Percept, object]:
        """Play one episode: yield the actions in the program's lines, and return the answer.

        Args:
            first: the percept at the start.
            told: the value that the lighthouse tells before the start, or None.

        Raises:
            ExplorerFault: if the program is silent, ends, or writes a line that is no message.
        """
        finished = waits = False
        try:
            self._begin(first, told)
            message = self._next_message()
            while not isinstance(message, EpisodeEnd):
                waits = self.stays
                percept = yield message
                waits = False
                if not isinstance(message, actions.Checkpoint):
                    self._send(answering(percept))
                message = self._next_message()
            finished = True
            return message.answer
        finally:
            self._pass_stderr_on()
            if not finished and not waits:
                # Its next message would belong to an episode that has ended.
                self._kill()

    def _next_message(self) -> ProgramMessage:
        """The next message of the program.

        Raises:
            ExplorerFault: if the program ends or is silent, if its message is illegal, or if it
                writes a further line behind its answer.
        """
        line = self._line()
        try:
            message = (_message_of_short if len(line) < SHORT else message_of)(line)
        except actions.ExplorerFault as fault:
            raise self._fault(fault.law, fault.seen, fault.detail) from None
        if isinstance(message, EpisodeEnd) and self._out:
            raise self._fault("illegal-action", f"a line after its answer: {shown(self._out)}")
        return message

    def close(self) -> None:
        """Close the program's input, wait a second for its end, then kill it."""
        process = self._process
        if process is None:
            return
        assert process.stdin is not None
        process.stdin.close()
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(1)
        self._kill()

    def _begin(self, first: actions.Percept, told: actions.Told) -> None:
        if self._process is None:
            self.start()
        self._read(0)  # it may have ended, and its last prints belong to this episode
        if not self._is_new:
            self._err.clear()
        self._is_new = False
        if self._out:
            raise self._fault("illegal-action", f"a line before it was asked: {shown(self._out)}")
        self._heard = False
        # The number must not give information.
        self._send(beginning(SystemRandom().getrandbits(53), first, told))

    def start(self) -> None:
        """Start the process.

        Raises:
            InputError: if the system cannot run the program.
        """
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
            raise InputError(
                f"--exec {show(self._command)} cannot be started: {error.strerror}; legal is a "
                "program of this machine, or a script whose first line names an interpreter"
            ) from None
        self._is_new = True
        streams = self._process.stdin, self._process.stdout, self._process.stderr
        self._in_to, self._out_of, err_of = (each.fileno() for each in streams if each)
        os.set_blocking(self._in_to, False)
        self._said.register(self._out_of, select.POLLIN)
        self._said.register(err_of, select.POLLIN)
        self._out.clear()
        self._err.clear()

    def _kill(self) -> None:
        process, self._process = self._process, None
        self._said = select.poll()
        if process is None:
            return
        with process, contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(process.pid, 9)

    def _send(self, line: bytes) -> None:
        try:
            # A pipe takes such a short line completely or not at all.
            os.write(self._in_to, line)
        except BlockingIOError:
            self._send_when_read(line)
        except OSError:
            raise self._ended("the end of its input: it reads no more, and goes on") from None

    def _send_when_read(self, line: bytes) -> None:
        """Wait until the program has read earlier lines, then send ``line``.

        Raises:
            ExplorerFault: if the program reads nothing until the timeout.
        """
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
                part = f"no whole line in {self._timeout:g} s ({plural(searched, 'byte')} of one)"
                seen = part if searched else f"silent for {self._timeout:g} s"
                tail = f"stdout ended in {shown(self._out[-SHOWN:])}" if searched else ""
                raise self._fault("timeout", seen, tail, machine=True)
            if not self._read(left):
                raise self._ended("the end of its output: it writes no more, and goes on")
        line = bytes(self._out[:end])
        del self._out[: end + 1]
        self._heard = True
        return line

    def _read(self, wait: float) -> bool:
        """Wait for output at most ``wait`` seconds, and read this output.

        Return False if the program's stdout has ended, else True.  Of the program's stderr only the
        end is kept.
        """
        goes_on = True
        for descriptor, _ in self._said.poll(wait * 1000):
            chunk = os.read(descriptor, 1 << 16)
            if descriptor == self._out_of:
                self._out += chunk
                goes_on = bool(chunk)
                continue
            self._err += chunk
            del self._err[:-STDERR_KEPT]
            if not chunk:
                self._said.unregister(descriptor)
        return goes_on

    def _ended(self, seen: str) -> actions.ExplorerFault:
        """The fault of a program that has closed its stdin or stdout.

        Usually the program has ended, or ends within a second; then the fault tells how the program
        ended.  If the program goes on, the fault says ``seen``, words about the closed pipe.

        Raises:
            NestedCheck: if the last line of the program's stderr is the refusal of a nested check,
                because the program has tried to begin a check.
        """
        assert self._process is not None
        with contextlib.suppress(subprocess.TimeoutExpired):
            seen = f"the end of its process ({ended_by(self._process.wait(1))})"
        if self._process.returncode == 0 and not self._heard:
            seen += ", before a line of this episode: one process plays many, until its input ends"
        code = self._process.returncode
        fault = self._fault("crash", seen, machine=code is not None and code < 0)
        if refusal := refusal_in(self._err.decode(errors="replace")):
            raise refusal
        return fault

    def _pass_stderr_on(self) -> None:
        """Write to this process's stderr what the program wrote to stderr in this episode."""
        self._read(0)
        if self._err:
            sys.stderr.write(self._err.decode(errors="backslashreplace"))
            sys.stderr.flush()

    def _fault(
        self, law: actions.FaultLaw, seen: str, detail: str = "", *, machine: bool = False
    ) -> actions.ExplorerFault:
        self._read(0)
        said = self._err.decode(errors="replace")
        details = [detail, f"stderr:\n{said}" if said else ""]
        return actions.ExplorerFault(law, seen, "\n\n".join(filter(None, details)), machine=machine)
