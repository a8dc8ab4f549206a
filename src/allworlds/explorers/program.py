"""A program behind a pipe, and the words of its command."""

from __future__ import annotations

import contextlib
import errno
import json
import os
import re
import secrets
import select
import shlex
import shutil
import subprocess
import sys
import time
from collections.abc import Generator, Sequence
from functools import lru_cache
from pathlib import Path
from random import Random
from typing import Any, Literal, NamedTuple, TypeAlias

from allworlds.inputs.checks import SHOWN, InputError, is_loop_of_links, show
from allworlds.maps.combinatorial import CombinatorialMap, InvalidMap
from allworlds.protocol.actions import Action, Percept
from allworlds.protocol.answers import Ambiguous, Checkpoint, Estimate
from allworlds.protocol.faults import ExplorerFault
from allworlds.protocol.player import Told
from allworlds.protocol.transcript import action_from_json
from allworlds.words import ended_by, plural

SECONDS = 5
"""The time after which a program that is asked for its errors of syntax is left alone."""


class Interpreter(NamedTuple):
    """The command line of an interpreter.

    Attributes:
        language: in words.
        letters: options after which no file is run, such as ``-c CODE``, each by its letter.
        words: the same, written out.
        values: options with a value in the next word.
        endings: of a file's name that may be left out.
        looks: the options with which it reads a file and does not run it; none if there are none.
    """

    language: str
    letters: str = "e"
    words: tuple[str, ...] = ()
    values: tuple[str, ...] = ()
    endings: tuple[str, ...] = ()
    looks: tuple[str, ...] = ()


INTERPRETERS = {
    r"python[0-9.]*|pypy3?": Interpreter(
        "Python",
        "cm",
        values=("-W", "-X", "--check-hash-based-pycs"),
        looks=("-c", "import sys; f = sys.argv[1]; compile(open(f, 'rb').read(), f, 'exec')"),
    ),
    r"node|nodejs": Interpreter(
        "JavaScript",
        "epi",
        ("--eval", "--print", "--interactive", "--run", "--test"),
        ("-r", "--require", "--import", "--loader", "--experimental-loader", "-C", "--conditions"),
        (".js", ".json"),
        ("--check",),
    ),
    r"(da|ba|k|z)?sh": Interpreter("shell script", "cs", values=("-o", "-O"), looks=("-n",)),
    r"ruby": Interpreter("Ruby", values=("-I", "-r", "-C")),
    r"perl": Interpreter("Perl", "eEx", values=("-I",)),
    r"lua[0-9.]*": Interpreter("Lua", "ei", values=("-l",)),
    r"php[0-9.]*": Interpreter("PHP", "rBRES", values=("-d", "-c", "-f")),
}
"""Programs that run a file, by patterns for their names."""

ERROR = r"^.*?\b(\w*(?:Syntax|Indentation|Tab) ?[Ee]rror\b.*)$"
"""The line of an error of syntax on stderr."""


def missing_script(words: Sequence[str]) -> str:
    """The reason why an interpreter cannot open its script; empty if it can, or if unknown."""
    call = _call(words)
    if call is None:
        return ""
    # Where an option may have a value, the script is one of the other words.
    scripts = call.files[:1] if call.sure else call.files
    endings = ("", *call.interpreter.endings)
    if any(Path(script + ending).exists() for script in scripts for ending in endings):
        return ""
    reason = "it is a loop of links" if is_loop_of_links(call.files[0]) else "there is no such file"
    return f"{Path(call.program).name} cannot open {show(call.files[0])}: {reason}"


def syntax_error(words: Sequence[str]) -> str:
    """The reason why an interpreter cannot read its script; empty if it can, or if unknown.

    A script that seems to have an error is run without any input: its interpreter must say so.
    """
    call = _call(words)
    if call is None or not call.interpreter.looks:
        return ""
    script, language = call.files[0], call.interpreter.language
    if not _said([call.program, *call.interpreter.looks, script]):
        return ""
    said = _said(words)
    message = re.search(ERROR, said, re.MULTILINE)
    if message is None:
        return ""
    line = re.search(rf"{re.escape(script)}\D{{1,10}}([0-9]+)", said)
    where = f", line {line[1]}" if line else ""
    return f"{show(script)}{where} is no {language}: {message[1]}"


def _said(words: Sequence[str]) -> str:
    """The text on stderr of a command without an input; empty if it does not fail at once."""
    try:
        ended = subprocess.run(  # noqa: S603  # running it is what was asked for
            words, stdin=subprocess.DEVNULL, capture_output=True, timeout=SECONDS, check=False
        )
    except (OSError, subprocess.TimeoutExpired):
        return ""
    return ended.stderr.decode(errors="replace") if ended.returncode else ""


class _Call(NamedTuple):
    """A call of an interpreter.

    Attributes:
        program, interpreter: the word that names it, and its entry in the table.
        files: the script and its arguments.
        sure: whether the first of these is the script.
    """

    program: str
    interpreter: Interpreter
    files: list[str]
    sure: bool


def _call(words: Sequence[str]) -> _Call | None:
    """The call of an interpreter that runs a file; None for any other command."""
    rest = _without_env(words)
    program = rest.pop(0) if rest else ""
    name = Path(program).name
    interpreter = next((i for names, i in INTERPRETERS.items() if re.fullmatch(names, name)), None)
    if interpreter is None:
        return None
    sure = True
    while rest and rest[0].startswith("-"):
        option = rest.pop(0)
        if option == "--":
            break
        if _runs_no_file(option, interpreter):
            return None
        if option in interpreter.values:
            del rest[:1]
        elif option.startswith("--") and "=" not in option:
            sure = False
    return _Call(program, interpreter, rest, sure) if rest else None


def _without_env(words: Sequence[str]) -> list[str]:
    """The words of a command behind ``env`` and its options."""
    rest = [*words]
    if Path(rest[0]).name == "env":
        rest.pop(0)
        while rest and (rest[0].startswith("-") or "=" in rest[0]):
            if rest.pop(0) in ENV_VALUES:
                del rest[:1]
    return rest


ENV_VALUES = ("-u", "-C", "--unset", "--chdir")
"""The options of ``env`` with a value in the next word."""


def _runs_no_file(option: str, interpreter: Interpreter) -> bool:
    if option.startswith("--"):
        return option.partition("=")[0] in interpreter.words
    return option == "-" or any(letter in interpreter.letters for letter in option[1:])


def obstacle(name: str) -> str:
    """The reason why a command cannot be run."""
    path = Path(name)
    if is_loop_of_links(name):
        return f"{show(name)} is a loop of links"
    try:
        path.stat()
    except OSError as error:
        if error.errno != errno.ENOENT:
            return f"{show(name)}: {error.strerror}"
    except ValueError:
        return f"there is no program {show(name)}: no file can be named so"
    if path.is_dir():
        return f"{show(name)} is a directory, not a program"
    if path.is_file():
        if os.sep in name:
            return (
                f"the file {show(name)} is not executable; chmod +x, or name its interpreter first"
            )
        return f"there is no program {show(name)}; for the file here write './{name}'"
    return f"there is no program {show(name)}"


RunLaw: TypeAlias = Literal["crash", "timeout", "illegal-action", "no-estimate"]
"""The laws that a program breaks by what it writes."""

SAYINGS = ("move", "drop", "pick", "write", "checkpoint", "estimate", "ambiguous", "answer")
"""A line of the program has exactly one of these keys."""

MAP_KEYS, QUOTIENT_KEYS = ("sigma", "alpha", "here"), ("sigma", "alpha", "degree", "marks", "here")

SHORT = 64
"""Lines of fewer bytes, as most are, are parsed once."""


class EpisodeEnd(NamedTuple):
    """The answer of an episode, which is over."""

    answer: object


Message: TypeAlias = Action | Checkpoint | EpisodeEnd
"""A line of the program, as a value."""


# ---------------------------------------------------------------- to the program


def beginning(number: int, first: Percept, told: Told) -> bytes:
    """The line that begins an episode."""
    heard = b"" if told is None else b'"told": %b, ' % json.dumps(told).encode()
    return b'{"episode": %d, ' % number + heard + answering(first)[1:]


@lru_cache(maxsize=1 << 12)
def answering(percept: Percept) -> bytes:
    """The line that answers an action."""
    return json.dumps({"percept": percept.to_json()}).encode() + b"\n"


# ---------------------------------------------------------------- from the program


def message_of(line: bytes) -> Message:
    """The message of a line.

    Raises:
        ExplorerFault: if it is no line of the protocol, or what it says is malformed.
    """
    action = _short_action(line) if len(line) < SHORT else None
    return _message_of(line) if action is None else action


@lru_cache(maxsize=1 << 12)
def _short_action(line: bytes) -> Action | None:
    """The action of a short line; None if the line must be parsed more carefully."""
    try:
        message = json.loads(line)
    except (ValueError, RecursionError):
        return None
    one = isinstance(message, dict) and _sayings(message) == 1
    return action_from_json(message) if one else None


def _message_of(line: bytes) -> Message:
    try:
        message = json.loads(line)
    except (ValueError, RecursionError):
        raise _illegal(f"a line that is no JSON: {shown(line)}") from None
    if not isinstance(message, dict):
        raise _illegal(f"a line that is no object: {shown(line)}")
    if (said := _sayings(message)) != 1:
        keys = f"it has {said or 'none'} of the keys {', '.join(SAYINGS)}, and needs one"
        raise _illegal(f"the line {_short(message)}: {keys}")
    action = action_from_json(message)
    if action is not None:
        return action
    if "checkpoint" in message:
        found = _values(message["checkpoint"], "a checkpoint", "illegal-action", *MAP_KEYS)
        return Checkpoint(*found)
    if "estimate" in message:
        return EpisodeEnd(_estimate(message["estimate"]))
    if "ambiguous" in message:
        found = _values(message["ambiguous"], "a quotient", "no-estimate", *QUOTIENT_KEYS)
        return EpisodeEnd(Ambiguous(*found))
    if "answer" in message:
        return EpisodeEnd(message["answer"])
    legal = "move takes an integer, write one from 0 on, drop and pick take true"
    raise _illegal(f"the line {_short(message)}: {legal}")


def _sayings(message: dict[str, Any]) -> int:
    """The number of keys of :data:`SAYINGS` in a message."""
    return sum(key in message for key in SAYINGS)


def _illegal(seen: str) -> ExplorerFault:
    return ExplorerFault("illegal-action", seen)


def _estimate(value: object) -> Estimate:
    _, _, here = _values(value, "an estimate", "no-estimate", *MAP_KEYS)
    try:
        return Estimate(CombinatorialMap.from_json(value), here)  # type: ignore[arg-type]
    except InvalidMap as error:
        raise ExplorerFault("no-estimate", f"no map: {error}", error.tried) from None


def _values(value: object, what: str, law: RunLaw, *keys: str) -> list[Any]:
    """The values of a checkpoint or an answer under these keys."""
    if not isinstance(value, dict):
        raise ExplorerFault(law, f"{what} that is no object: {_short(value)}")
    if missing := [key for key in keys if key not in value]:
        raise ExplorerFault(law, f"{what} without {' and '.join(missing)}: {_short(value)}")
    return [value[key] for key in keys]


def _short(value: object) -> str:
    try:
        text = json.dumps(value)
    except (RecursionError, ValueError):  # nested too deeply, or an integer too long
        return show(value)
    return text if len(text) <= SHOWN else text[: SHOWN - 3] + "..."


def shown(line: bytes | bytearray) -> str:
    """A line as it is shown: its beginning, quoted."""
    return repr(line[:SHOWN].decode(errors="replace"))


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
        self._read(0)
        self._err.clear()
        if self._out:
            raise self._fault("illegal-action", f"a line before it was asked: {shown(self._out)}")
        self._heard = False
        self._send(beginning(self._numbers.getrandbits(53), first, told))

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
                part = f"no whole line in {self._timeout:g} s ({plural(searched, 'byte')} of one)"
                seen = part if searched else f"silent for {self._timeout:g} s"
                raise self._fault("timeout", seen, machine=True)
            if not self._read(left):
                raise self._ended("the end of its output: it writes no more, and goes on")
        line = bytes(self._out[:end])
        del self._out[: end + 1]
        self._heard = True
        return line

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
        self, law: RunLaw, seen: str, detail: str = "", *, machine: bool = False
    ) -> ExplorerFault:
        self._drain()
        said = self._err.decode(errors="replace")
        told = [detail, f"stderr:\n{said}" if said else ""]
        return ExplorerFault(law, seen, "\n\n".join(filter(None, told)), machine=machine)
