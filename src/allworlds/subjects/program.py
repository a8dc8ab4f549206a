"""A program in any language as an explorer: JSON lines over a pipe.

One process plays many episodes.  To it: ``{"episode": 1, "percept": P}`` (with ``"told"``
where there is something to tell), then ``{"percept": P}`` after each action.  From it:
``{"move": k}``, ``{"drop": true}``, ``{"pick": true}``, ``{"checkpoint": {...}}`` (unanswered)
or ``{"estimate": {"sigma", "alpha", "here"}}``.  Unknown keys are ignored by both sides.
"""

from __future__ import annotations

import contextlib
import fcntl
import json
import os
import select
import shlex
import shutil
import subprocess
import tempfile
import time
from collections.abc import Generator
from pathlib import Path
from typing import IO, Any, Literal

from allworlds.inputs import InputError
from allworlds.maps.combinatorial import CombinatorialMap, InvalidMap
from allworlds.protocol import (
    Action,
    Checkpoint,
    Estimate,
    ExplorerFault,
    Percept,
    action_from_json,
)

STDERR_KEPT = 4096
LONGEST_LINE = 1 << 24
SAYINGS = {"move", "drop", "pick", "checkpoint", "estimate"}
"""A line of the program has exactly one of these keys."""


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
            raise InputError(f"--exec {command!r} cannot be split into words: {error}") from None
        if not self._arguments:
            raise InputError("--exec needs a command, not an empty string")
        if shutil.which(self._arguments[0]) is None:
            raise InputError(f"--exec {command!r}: {_obstacle(self._arguments[0])}")
        self._timeout = answer_timeout
        self._process: subprocess.Popen[bytes] | None = None
        self._episodes = 0
        self._heard = False
        self._stderr: IO[bytes] | None = None
        self._out = bytearray()

    def explore(
        self, first: Percept, *, told: int | None = None
    ) -> Generator[Action | Checkpoint, Percept, Estimate]:
        """One episode: what the program says, as an explorer would say it.

        Raises:
            ExplorerFault: when the program is silent, ends, or says something else.
        """
        finished = False
        try:
            self._begin(first, told)
            while True:
                message = self._message()
                if len(message.keys() & SAYINGS) != 1:
                    raise self._fault("illegal-action", f"the line {_short(message)}")
                action = action_from_json(message)
                if action is not None:
                    percept = yield action
                    self._send({"percept": percept.to_json()})
                elif "checkpoint" in message:
                    yield _checkpoint(message["checkpoint"])
                elif "estimate" in message:
                    if self._out:
                        raise self._fault(
                            "illegal-action", f"a line after its estimate: {_text(self._out)}"
                        )
                    estimate = _estimate(message["estimate"])
                    finished = True
                    return estimate
                else:
                    raise self._fault("illegal-action", f"the line {_short(message)}")
        finally:
            if not finished:
                # Whatever it would say next belongs to an episode that is over.
                self._kill()

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

    def _begin(self, first: Percept, told: int | None) -> None:
        if self._process is None:
            self._start()
        assert self._stderr is not None
        self._stderr.truncate(0)
        self._read(0)
        if self._out:
            raise self._fault("illegal-action", f"a line before it was asked: {_text(self._out)}")
        self._episodes += 1
        self._heard = False
        opening: dict[str, Any] = {"episode": self._episodes, "percept": first.to_json()}
        if told is not None:
            opening["told"] = told
        self._send(opening)

    def _start(self) -> None:
        self._stderr = tempfile.TemporaryFile()  # noqa: SIM115  # closed with the process
        # The program appends, so that each episode can begin with an empty file.
        fcntl.fcntl(self._stderr, fcntl.F_SETFL, os.O_APPEND)
        try:
            self._process = subprocess.Popen(  # noqa: S603  # running it is what was asked for
                self._arguments,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=self._stderr,
                bufsize=0,
                start_new_session=True,
            )
        except OSError as error:
            self._stderr.close()
            raise ExplorerFault("crash", f"the program cannot be started: {error}") from None
        self._out.clear()

    def _kill(self) -> None:
        process, self._process = self._process, None
        if process is None:
            return
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(process.pid, 9)
        process.wait()
        for stream in (process.stdin, process.stdout, self._stderr):
            if stream is not None:
                with contextlib.suppress(OSError):
                    stream.close()

    def _send(self, message: dict[str, Any]) -> None:
        assert self._process is not None
        assert self._process.stdin is not None
        try:
            self._process.stdin.write(json.dumps(message).encode() + b"\n")
        except OSError:
            raise self._ended() from None

    def _message(self) -> dict[str, Any]:
        line = self._line()
        self._heard = True
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
                raise self._fault("timeout", f"silent for {self._timeout:g} s")
            if not self._read(left):
                raise self._ended()
        line = bytes(self._out[:end])
        del self._out[: end + 1]
        return line

    def _read(self, wait: float) -> bool:
        """Take in what the program says within ``wait`` seconds; False at its end of output."""
        assert self._process is not None
        assert self._process.stdout is not None
        poll = select.poll()
        poll.register(self._process.stdout, select.POLLIN)
        if not poll.poll(wait * 1000):
            return True
        chunk = self._process.stdout.read(1 << 16) or b""
        self._out += chunk
        return bool(chunk)

    def _ended(self) -> ExplorerFault:
        assert self._process is not None
        try:
            seen = f"the end of its output (exit code {self._process.wait(1)})"
        except subprocess.TimeoutExpired:
            seen = "the end of its output"
        if self._process.returncode == 0 and not self._heard:
            seen += ", before a line of this episode: one process plays many, until its input ends"
        return self._fault("crash", seen)

    def _fault(
        self, law: Literal["crash", "timeout", "illegal-action", "no-estimate"], seen: str
    ) -> ExplorerFault:
        assert self._stderr is not None
        end = self._stderr.seek(0, os.SEEK_END)
        self._stderr.seek(max(0, end - STDERR_KEPT))
        detail = self._stderr.read().decode(errors="replace")
        return ExplorerFault(law, seen, f"stderr:\n{detail}" if detail else "")


def _obstacle(name: str) -> str:
    """Why what is named cannot be run."""
    path = Path(name)
    if path.is_dir():
        return f"{name!r} is a directory, not a program"
    if path.is_file():
        if os.sep in name:
            return f"the file {name!r} is not executable; chmod +x, or name its interpreter first"
        return f"there is no program {name!r}; for the file here write './{name}'"
    return f"there is no program {name!r}"


def _checkpoint(value: object) -> Checkpoint:
    if not isinstance(value, dict):
        raise ExplorerFault("illegal-action", f"a checkpoint that is no object: {_short(value)}")
    if missing := _missing(value):
        raise ExplorerFault("illegal-action", f"a checkpoint without {missing}: {_short(value)}")
    return Checkpoint(value["sigma"], value["alpha"], value["here"])


def _estimate(value: object) -> Estimate:
    if not isinstance(value, dict):
        raise ExplorerFault("no-estimate", f"an estimate that is no object: {_short(value)}")
    if missing := _missing(value):
        raise ExplorerFault("no-estimate", f"an estimate without {missing}: {_short(value)}")
    try:
        return Estimate(CombinatorialMap.from_json(value), value["here"])
    except InvalidMap as error:
        raise ExplorerFault("no-estimate", f"no map: {error}") from None


def _missing(value: dict[str, Any]) -> str:
    """The keys that a checkpoint or an estimate lacks."""
    return " and ".join(key for key in ("sigma", "alpha", "here") if key not in value)


def _short(value: object) -> str:
    text = json.dumps(value)
    return text if len(text) <= 200 else text[:197] + "..."


def _text(line: bytes | bytearray) -> str:
    return repr(line[:200].decode(errors="replace"))
