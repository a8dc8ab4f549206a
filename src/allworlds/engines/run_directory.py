"""The finished units of a job: not kept, in a run directory, or in several."""

from __future__ import annotations

import fcntl
import os
import sqlite3
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from typing_extensions import override

from allworlds.engines import database
from allworlds.engines.database import Database, Identity, is_at, named
from allworlds.engines.kept_form import to_kept
from allworlds.engines.units import Sum
from allworlds.inputs.checks import InputError, a_path, show
from allworlds.outcome import Exit, NoResult
from allworlds.words import listed

LOCK, OPENED = "lock", os.O_RDWR | os.O_CREAT | os.O_CLOEXEC
"""The name of the file that is locked, and how it is opened: it is made where it is missing."""

ENDED = "complete"
"""The value that is noted under ``ended`` when the job is complete."""

PATIENCE = 3.0
"""Seconds to wait for a command that is about to end, before another one is refused."""


class Gap(NoResult):
    """Raised if parts of a whole are missing."""

    exit = Exit.INCOMPLETE


class Records:
    """The records of a job; by default nothing is kept."""

    def result(self, key: str) -> Any:
        """Return the JSON value of a finished unit; None for any other."""

    def keep(self, key: str, result: Sum) -> None:
        """Take in a finished unit with its whole result."""

    def recall(self, name: str) -> Any:
        """Return the value that was noted under a name; None if there is none."""

    def note(self, name: str, value: Any) -> None:
        """Note a JSON value under a name."""


NO_RECORDS = Records()


@dataclass(slots=True)
class RunDirectory(Records):
    """The records of a job that goes on after an interruption.

    If there is no room for a unit, or the directory was removed, it is lost with a notice; the job
    goes on.

    Attributes:
        database: its file.
        lock: held on the directory.
        notice: takes messages to the user.
        found: the units that were finished when it was opened; each is asked for at most once, and
            no other process adds units.
    """

    database: Database
    lock: Lock
    notice: Callable[[str], None]
    found: frozenset[str]
    _full: bool = False
    _alone: bool = True

    @override
    def result(self, key: str) -> Any:
        return self.database.result(key) if key in self.found else None

    @override
    def keep(self, key: str, result: Sum) -> None:
        kept = to_kept(result)
        self._write(lambda: self.database.keep(key, result.worlds, time.time(), kept))

    @override
    def recall(self, name: str) -> Any:
        return self.database.recall(name)

    @override
    def note(self, name: str, value: Any) -> None:
        self._write(lambda: self.database.note(name, value))

    def _write(self, write: Callable[[], None]) -> None:
        if self._full:
            return
        where = named(self.database.path)
        if not self.database.is_there:
            self._full = True
            self.notice(f"{where} was removed; the job goes on without it, and keeps nothing")
            return
        if self._alone and not self.lock.is_held:
            self._alone = False
            self.notice(
                f"{where} is in use by another command, too, since its file {LOCK} was removed; "
                "both go on"
            )
        try:
            write()
        except sqlite3.OperationalError as error:
            self._full = True
            self.notice(
                f"{where} takes no more: {error}; what it holds is kept, and the job goes on "
                "without it"
            )


@dataclass(frozen=True, slots=True)
class Merged(Records):
    """The records of several run directories as those of one job, to which nothing is added."""

    directories: Sequence[Database]

    def result(self, key: str) -> Any:
        """The JSON value of a unit.

        Raises:
            Gap: if it is not finished.
            InputError: if it was finished twice.
        """
        found = [(d, told) for d in self.directories if (told := d.result(key)) is not None]
        if len(found) > 1:
            names = listed([show(str(d.path)) for d, _ in found])
            raise InputError(f"run directories overlap: unit {key} is in {names}")
        if not found:
            raise Gap(f"unit {key} is not finished{self._unfinished()}")
        return found[0][1]

    def recall(self, name: str) -> Any:
        """The value that one of the directories has noted under a name.

        Raises:
            Gap: if none has.
        """
        for directory in self.directories:
            if (told := directory.recall(name)) is not None:
                return told
        raise Gap(f"a finding has not been confirmed yet{self._unfinished()}")

    def _unfinished(self) -> str:
        names = [
            f"{show(str(directory.path))} (shard {directory.identity.shard})"
            for directory in self.directories
            if directory.recall("ended") != ENDED
        ]
        return f": give the commands of {listed(names)} again" if names else ""


@contextmanager
def records_in(
    run: str | Path | None, identity: Callable[[], Identity], notice: Callable[[str], None]
) -> Iterator[Records]:
    """The records of a job in a directory, which is made where it is missing.

    Args:
        run: the directory; None for no records.
        identity: of the job; not asked for without a directory.
        notice: takes messages to the user.

    Raises:
        InputError: if the directory is of another job, in use, damaged, or cannot be written.
    """
    if run is None:
        yield NO_RECORDS
        return
    path = a_path("run", run)
    with ExitStack() as stack:
        lock = stack.enter_context(_locked(path))
        opened = _opened(path, identity())
        stack.callback(opened.close)
        opened.begin_session(time.time())
        yield RunDirectory(opened, lock, notice, frozenset(opened.keys()))


def _opened(path: Path, identity: Identity) -> Database:
    if not (path / database.FILE).exists():
        names = {file.name for file in path.iterdir()}
        others = sorted(n for n in names if n != LOCK and not n.startswith(database.DRAFT))
        if others:
            raise InputError(
                f"{named(path)} holds {show(others[0])}, which is not ours; give a new or an empty "
                "one"
            )
        return database.created(path, identity)
    opened = database.opened(path)
    its = opened.identity
    said = identity.difference(its)
    if not said and its.shard != identity.shard:
        said = f"is of shard {its.shard}, not {identity.shard}"
    if said:
        opened.close()
        raise InputError(f"{named(path)} {said}")
    return opened


class Lock:
    """The lock of a directory: who holds it is the only one who adds to it."""

    def __init__(self, path: Path) -> None:
        self._path, self._file = path, os.open(path, OPENED, 0o666)

    def take(self) -> bool:
        """Take the lock; return whether nobody else has it."""
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        return True

    @property
    def is_held(self) -> bool:
        """Whether the lock that was taken is still held; if its file was removed, it is made anew.

        It is lost if meanwhile somebody else has made the file, and taken the lock.
        """
        with suppress(OSError):  # a directory in which no file can be made has no other command
            if not is_at(self._path, os.fstat(self._file)):
                another = os.open(self._path, OPENED, 0o666)
                self.close()
                self._file = another
                return self.take()
        return True

    def close(self) -> None:
        """Release the lock."""
        os.close(self._file)


@contextmanager
def _locked(path: Path) -> Iterator[Lock]:
    """A context in which no other process adds to the directory."""
    try:
        path.mkdir(parents=True, exist_ok=True)
        lock = Lock(path / LOCK)
    except OSError as error:
        raise InputError(f"{named(path)} cannot be written: {error.strerror}") from None
    try:
        until = time.monotonic() + PATIENCE
        while not lock.take():
            if time.monotonic() > until:
                raise InputError(f"{named(path)} is in use by another command")
            time.sleep(0.05)
        yield lock
    finally:
        lock.close()


def in_use(path: Path) -> bool:
    """Whether a process adds to the directory now."""
    with suppress(OSError):
        lock = os.open(path / LOCK, os.O_RDONLY | os.O_CLOEXEC)
        try:
            fcntl.flock(lock, fcntl.LOCK_SH | fcntl.LOCK_NB)
        except BlockingIOError:
            return True
        finally:
            os.close(lock)
    return False


@contextmanager
def merged(runs: Sequence[str | Path]) -> Iterator[tuple[Identity, Merged]]:
    """The records of all shards of one job, and the job's identity.

    Raises:
        InputError: if they are not of one job, or overlap.
        Gap: if a shard is missing.
    """
    if not runs:
        raise InputError("merge needs at least one run directory")
    with ExitStack() as stack:
        paths = [a_path("run", run) for run in runs]
        directories = [stack.enter_context(database.reading(path)) for path in paths]
        first = directories[0]
        seen: dict[str, Database] = {}
        for one in directories:
            if said := first.identity.difference(one.identity):
                raise InputError(f"{named(one.path)} {said} as {show(str(first.path))}")
            shard = one.identity.shard
            if (other := seen.setdefault(shard, one)) is not one:
                raise InputError(
                    f"run directories overlap: {show(str(other.path))} and {show(str(one.path))} "
                    f"are both shard {shard}"
                )
        shards = first.identity.shards
        missing = [f"{k}/{shards}" for k in range(shards) if f"{k}/{shards}" not in seen]
        if missing:
            more = f" and {len(missing) - 9} more" if len(missing) > 9 else ""
            noun, verb = ("shard", "is") if len(missing) == 1 else ("shards", "are")
            raise Gap(
                f"{noun} {', '.join(missing[:9])}{more} {verb} missing: "
                "give the run directory of each shard"
            )
        yield first.identity, Merged(directories)
