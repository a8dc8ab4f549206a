"""The parent's side of one worker: starting it, hearing it, noticing its silence, ending it."""

from __future__ import annotations

import json
import mmap
import os
import signal
import subprocess
import sys
import tempfile
import time
from contextlib import suppress
from multiprocessing import Pipe
from typing import Any

from allworlds.inputs import InputError
from allworlds.isolation.jobs import BEAT_WORDS, NO_RUN, HarnessError, Setup
from allworlds.subjects import Subject
from allworlds.work import Limits

_START = (
    "import json, sys; sys.path[:] = json.loads(sys.argv[1]); "
    "from allworlds.isolation.worker import main; main(sys.argv[2:])"
)

GRACE = 2.0
"""Seconds more where the parent is not the first to know: for a foreign program, whose silence
its worker notices itself, and for a worker that has still something to be heard."""


class WorkerProcess:
    """A worker with its pipe and the memory in which its heart beats.

    Args:
        subject: the explorer, which the worker finds by its name.
        limits: patience and memory.
        hash_seed: of the interpreter.  All workers have the same, so that an explorer that
            depends on the order of a set does the same in each; another one tells.
    """

    def __init__(self, subject: Subject, limits: Limits, hash_seed: int = 0) -> None:
        self.silence = f"silent for {limits.answer_timeout:g} s"
        self.patience = limits.answer_timeout + (GRACE if subject.program else 0.0)
        self.connection, theirs = Pipe()
        with tempfile.TemporaryFile() as memory:
            memory.truncate(8 * BEAT_WORDS)
            self._memory = mmap.mmap(memory.fileno(), 8 * BEAT_WORDS)
            self.beat = memoryview(self._memory).cast("Q")
            self.process = subprocess.Popen(  # noqa: S603  # our own module
                [
                    sys.executable,
                    "-c",
                    _START,
                    json.dumps(sys.path),
                    str(theirs.fileno()),
                    str(memory.fileno()),
                ],
                stdin=subprocess.DEVNULL,
                pass_fds=(theirs.fileno(), memory.fileno()),
                # A Ctrl-C is for the parent; and what an explorer leaves behind dies with it.
                start_new_session=True,
                env={**os.environ, "PYTHONHASHSEED": str(hash_seed)},
            )
        theirs.close()
        self._program = subject.program is not None
        self._seen: tuple[int, int] = (0, 0)
        self._since = time.monotonic()
        self.beat[0] = NO_RUN
        self.send(Setup(subject.name, limits.answer_timeout, limits.memory))

    def send(self, job: object) -> None:
        """Hand over a job."""
        self.connection.send(job)

    def receive(self) -> Any:
        """The next message; waits for it.

        Raises:
            EOFError: if the process has ended.
            InputError: if the explorer could not be loaded there, or a bound has no value.
            HarnessError: if the worker itself has failed.
        """
        message = self.connection.recv()
        if isinstance(message, InputError | HarnessError):
            raise message
        return message

    def is_silent(self, grace: float = 0.0) -> bool:
        """The explorer has been thinking about one and the same turn for too long.

        ``grace`` seconds more are allowed where there is reason to.
        """
        now, seen = time.monotonic(), (self.beat[0], self.beat[1])
        if seen[1] == 0 or seen != self._seen:
            self._seen, self._since = seen, now
            return False
        return now - self._since > self.patience + grace

    def has_ended(self) -> bool:
        """The process is no more, and all that it has said has been heard.

        The pipe alone does not tell: a process forked by the explorer may hold it open.
        """
        return self.process.poll() is not None and not self.connection.poll()

    def death(self) -> str:
        """How the process ended, as a sentence."""
        try:
            code = self.process.wait(GRACE)
        except subprocess.TimeoutExpired:
            return "the end of the interpreter's pipe"
        how = f"exit code {code}" if code >= 0 else f"signal {-code}"
        return f"the end of the interpreter ({how})"

    def kill(self) -> None:
        """End the process now, and all that it has started."""
        if self._program:
            # The worker alone knows the program, which stands in a session of its own.
            self.process.terminate()
            with suppress(subprocess.TimeoutExpired):
                self.process.wait(GRACE)
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()
        self.connection.close()
        self.beat.release()
        self._memory.close()
