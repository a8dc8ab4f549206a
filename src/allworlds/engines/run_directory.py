"""Run directories: the finished units of a job in an SQLite file, each with a checksum.

The identity of a job is all that its report depends on.  Results are merged only if the identities
of their jobs are equal.  The file holds JSON texts and no code.  Each unit is written in one
transaction, so that a killed process loses only the units that it was doing.  The checksum of a row
is checked when the row is read.  A command locks the file ``lock`` of the directory while it adds
units, so that no other command adds units at the same time.
"""

import fcntl
import hashlib
import json
import os
import shutil
import sqlite3
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from typing_extensions import override

from allworlds import outcome, words
from allworlds.engines.kept_units import ENDED, FORMAT, Identity, KeptUnits, to_kept
from allworlds.engines.units import Sum
from allworlds.inputs.checks import InputError, a_path, show
from allworlds.version import __version__

in_order = json.JSONEncoder(separators=(",", ":")).encode
"""The function from a JSON value to its text; the keys keep their order, which reports show."""


FILE, DRAFT = "units.sqlite", "draft.sqlite"

APPLICATION = 0x616C6C77
"""The number in the header of an SQLite file that marks the file of a run directory."""

SCHEMA = 2
"""The version of the tables below and of their content; files of other versions are refused."""

TABLES = """
CREATE TABLE meta (name TEXT PRIMARY KEY, value TEXT NOT NULL, checksum TEXT NOT NULL) STRICT;
CREATE TABLE units (
    key TEXT PRIMARY KEY, worlds INTEGER NOT NULL, finished REAL NOT NULL,
    result TEXT NOT NULL, checksum TEXT NOT NULL
) STRICT;
CREATE TABLE sessions (started REAL NOT NULL) STRICT;
"""

BUSY = 10.0
"""Seconds to wait while another process has locked the file of units."""


def named(path: Path) -> str:
    """The words for a run directory in messages: ``run directory`` and the path."""
    return f"run directory {show(str(path))}"


def damaged(path: Path, how: str) -> InputError:
    """The error for a run directory that has changed since it was written.

    ``how`` says what has changed.
    """
    return InputError(
        f"{named(path)} is damaged: {how}; remove it and begin again, or bring it back from a copy"
    )


@contextmanager
def saying_where(path: Path) -> Iterator[None]:
    """A context in which an error of SQLite becomes an InputError that names the directory."""
    try:
        yield
    except sqlite3.OperationalError as error:
        raise InputError(f"{named(path)} cannot be used: {error}") from None
    except (sqlite3.DatabaseError, UnicodeDecodeError) as error:
        raise damaged(path, str(error)) from None


class Database:
    """The open file of a run directory, with the identity of its job."""

    def __init__(self, path: Path, connection: sqlite3.Connection, identity: Identity) -> None:
        self.path, self.identity, self._connection = path, identity, connection
        self._seal = identity.digest
        self._file = (path / FILE).stat()

    @property
    def is_there(self) -> bool:
        """Whether the opened file is still in the directory, neither removed nor replaced."""
        try:
            return os.path.samestat((self.path / FILE).stat(), self._file)
        except OSError:
            return False

    def close(self) -> None:
        """Close the connection to the file."""
        self._connection.close()

    def result(self, key: str) -> Any:
        """The JSON value of a finished unit; None for any other unit.

        Raises:
            InputError: if the row of the unit has changed since it was written.
        """
        row = self._first("SELECT * FROM units WHERE key = ?", key)
        return None if row is None else json.loads(self._sound(f"unit {key}", *row)[3])

    def units(self) -> Iterator[tuple[str, int, float, Any]]:
        """Yield key, number of worlds, time of the end, and result of each finished unit."""
        with saying_where(self.path):
            for row in self._connection.execute("SELECT * FROM units"):
                key, worlds, finished, result, _ = self._sound(f"unit {row[0]}", *row)
                yield key, worlds, finished, json.loads(result)

    def keep(self, key: str, worlds: int, finished: float, result: Any) -> None:
        """Write a finished unit in a transaction of its own.

        A row of the same unit is replaced.  Such a row can exist if the file ``lock`` was removed,
        and another command has done the same unit; the results of both commands are equal.

        Args:
            key: the name of the unit.
            worlds: the number of its worlds.
            finished: the time of its end.
            result: its result, a JSON value.

        Raises:
            sqlite3.OperationalError: if there is no room for the unit.
        """
        row = self._sealed(key, worlds, finished, in_order(result))
        self._connection.execute("INSERT OR REPLACE INTO units VALUES (?, ?, ?, ?, ?)", row)

    def recall(self, name: str) -> Any:
        """The value that was noted under the name ``name``; None if no value was noted.

        Raises:
            InputError: if the value has changed since it was written.
        """
        row = self._first("SELECT * FROM meta WHERE name = ?", name)
        return None if row is None else json.loads(self._sound(f"its {name}", *row)[1])

    def note(self, name: str, value: Any) -> None:
        """Note a JSON value under a name; it replaces an earlier value.

        Raises:
            sqlite3.OperationalError: if there is no room for the value.
        """
        row = self._sealed(name, in_order(value))
        self._connection.execute("INSERT OR REPLACE INTO meta VALUES (?, ?, ?)", row)

    def begin_session(self, now: float) -> None:
        """Note the time at which a process begins to add units."""
        self._first("INSERT INTO sessions VALUES (?)", now)

    def last_session(self) -> float:
        """The latest time at which a process began to add units."""
        (started,) = self._first("SELECT max(started) FROM sessions")
        return float(started or 0)

    def _first(self, query: str, *values: Any) -> Any:
        """The first row that a query returns; None if the query returns no row."""
        with saying_where(self.path):
            return self._connection.execute(query, values).fetchone()

    def _sealed(self, *row: Any) -> tuple[Any, ...]:
        return (*row, checksum(self._seal, *row))

    def _sound(self, what: str, *row: Any) -> tuple[Any, ...]:
        if self._sealed(*row[:-1]) != row:
            raise damaged(self.path, f"{what} is not what was written")
        return row


def checksum(seal: str, *row: Any) -> str:
    """A digest of a row and of ``seal``, which is the digest of the identity of the job."""
    return hashlib.sha256(repr((seal, *row)).encode(errors="backslashreplace")).hexdigest()[:32]


def created(path: Path, identity: Identity) -> Database:
    """Create the SQLite file of a new run directory, and open it.

    The file appears complete or not at all.
    """
    draft = path / DRAFT
    with saying_where(path):
        for file in path.glob(f"{DRAFT}*"):
            file.unlink()
        connection = _connected(draft, "rwc")
        try:
            connection.executescript(
                f"BEGIN; PRAGMA application_id = {APPLICATION}; PRAGMA user_version = {SCHEMA}; "
                f"{TABLES}"
            )
            row = ("identity", identity.text)
            connection.execute("INSERT INTO meta VALUES (?, ?, ?)", (*row, checksum("", *row)))
            connection.execute("COMMIT")
        finally:
            connection.close()
        draft.rename(path / FILE)
    return opened(path)


def opened(path: Path) -> Database:
    """Open the SQLite file of a run directory to add units.

    Raises:
        InputError: if the file belongs to no run directory, has another version, or is damaged.
    """
    with saying_where(path):
        connection = _connected(path / FILE, "rw")
        try:
            identity = _looked_through(path, connection)
            _write_ahead(connection)
        except BaseException:
            connection.close()
            raise
    return Database(path, connection, identity)


@contextmanager
def reading(path: Path) -> Iterator[Database]:
    """A context with the SQLite file of a run directory, open for reading.

    In this context another process may add units.

    Raises:
        InputError: if there is no file, if the file belongs to no run directory, if it has another
            version, or if it is damaged.
    """
    if not (path / FILE).is_file():
        raise InputError(f"{show(str(path))} is no run directory: it holds no {FILE}")
    with ExitStack() as stack:
        copies = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        stack.enter_context(saying_where(path))
        try:
            connection = _connected(path / FILE, "ro")
            stack.callback(connection.close)
            connection.execute("SELECT count(*) FROM sqlite_master")
        except sqlite3.OperationalError:
            # If nothing can be written, SQLite cannot read its log of the latest additions.
            for file in path.glob(f"{FILE}*"):
                if not file.name.endswith("-shm"):
                    shutil.copyfile(file, copies / file.name)
            connection = _connected(copies / FILE, "rw")
            stack.callback(connection.close)
        yield Database(path, connection, _looked_through(path, connection))


def _connected(file: Path, mode: str) -> sqlite3.Connection:
    address = f"{file.absolute().as_uri()}?mode={mode}"
    return sqlite3.connect(
        address, timeout=BUSY, isolation_level=None, uri=True, check_same_thread=False
    )


def _write_ahead(connection: sqlite3.Connection) -> None:
    connection.execute("PRAGMA journal_mode = WAL")
    # A killed process loses no unit; a power failure loses the latest units at most.
    connection.execute("PRAGMA synchronous = NORMAL")


def _looked_through(path: Path, connection: sqlite3.Connection) -> Identity:
    """Check the whole SQLite file of a run directory; return the identity of its job.

    Args:
        path: the directory, for messages.
        connection: the connection to the file.

    Raises:
        InputError: if the file belongs to no run directory, has another version, or is damaged.
    """
    (application,) = connection.execute("PRAGMA application_id").fetchone()
    if application != APPLICATION:
        raise InputError(f"{show(str(path))} is no run directory: its {FILE} is somebody else's")
    (schema,) = connection.execute("PRAGMA user_version").fetchone()
    if schema != SCHEMA:
        raise InputError(f"{named(path)} is of schema {schema}; this program reads {SCHEMA}")
    for (said,) in connection.execute("PRAGMA integrity_check"):
        if said != "ok":
            raise damaged(path, str(said).splitlines()[0])
    row = connection.execute("SELECT * FROM meta WHERE name = 'identity'").fetchone()
    if row is None or checksum("", *row[:-1]) != row[-1]:
        raise damaged(path, "what it is of is not what was written")
    identity = Identity.of_text(row[1])
    if identity.format != FORMAT:
        raise InputError(
            f"{named(path)} is of format {identity.format}, written by version {identity.version}; "
            f"this version, {__version__}, reads format {FORMAT}"
        )
    return identity


LOCK = "lock"
"""The name of the file that a command locks while it adds units; it is made if it is missing."""

PATIENCE = 3.0
"""Seconds to wait for another command that uses the directory, before this command is refused."""


class Gap(outcome.NoResult):
    """Raised if merged run directories lack a unit, or a noted value, of the whole job."""

    exit = outcome.Exit.INCOMPLETE


@dataclass(slots=True)
class RunDirectory(KeptUnits):
    """The finished units of a job, in a directory, so that an interrupted job can go on later.

    If there is no room for a unit, or if the directory was removed, the user gets a message, the
    job goes on, and no further unit is kept.

    Attributes:
        database: the open file of the directory.
        notice: the function that shows the user a message.
        added: the number of units that this process has added.
    """

    database: Database
    notice: Callable[[str], None]
    added: int = 0
    _full: bool = False

    @override
    def result(self, key: str) -> Any:
        return self.database.result(key)

    @override
    def keep(self, key: str, result: Sum) -> None:
        kept = to_kept(result)
        self._write(lambda: self.database.keep(key, result.worlds, time.time(), kept))
        self.added += 1

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
        try:
            write()
        except sqlite3.OperationalError as error:
            self._full = True
            self.notice(
                f"{where} takes no more: {error}; what it holds is kept, and the job goes on "
                "without it"
            )


@dataclass(frozen=True, slots=True)
class Merged(KeptUnits):
    """The finished units of several run directories, taken as one job; no unit is added."""

    directories: Sequence[Database]

    def result(self, key: str) -> Any:
        """The JSON value of a finished unit.

        Raises:
            Gap: if the unit is in no directory.
            InputError: if the unit is in several directories.
        """
        found = [(d, kept) for d in self.directories if (kept := d.result(key)) is not None]
        if len(found) > 1:
            names = words.listed([show(str(d.path)) for d, _ in found])
            raise InputError(f"run directories overlap: unit {key} is in {names}")
        if not found:
            raise Gap(f"unit {key} is not finished{self._unfinished()}")
        return found[0][1]

    def recall(self, name: str) -> Any:
        """The value that one of the directories has noted under the name ``name``.

        Raises:
            Gap: if no directory has noted a value under this name.
        """
        for directory in self.directories:
            if (value := directory.recall(name)) is not None:
                return value
        raise Gap(f"a finding has not been confirmed yet{self._unfinished()}")

    def _unfinished(self) -> str:
        names = [
            f"{show(str(directory.path))} (shard {directory.identity.shard})"
            for directory in self.directories
            if directory.recall("ended") != ENDED
        ]
        return f": give the commands of {words.listed(names)} again" if names else ""


@contextmanager
def kept_in(
    run: str | Path, identity: Callable[[], Identity], notice: Callable[[str], None]
) -> Iterator[KeptUnits]:
    """A context with a job's finished units in a directory, which is made if it is missing.

    Args:
        run: the directory.
        identity: the function that returns the job's identity, called with the directory locked.
        notice: the function that shows the user a message.

    Raises:
        InputError: if the directory is of another job, in use, damaged, or cannot be written.
    """
    path = a_path("run", run)
    with ExitStack() as stack:
        stack.enter_context(_locked(path))
        found = _of_job(path, identity())
        stack.callback(found.close)
        found.begin_session(time.time())
        yield RunDirectory(found, notice)


def _of_job(path: Path, identity: Identity) -> Database:
    if not (path / FILE).exists():
        names = {file.name for file in path.iterdir()}
        others = sorted(n for n in names if n != LOCK and not n.startswith(DRAFT))
        if others:
            raise InputError(
                f"{named(path)} holds {show(others[0])}, which is not ours; give a new or an empty "
                "one"
            )
        return created(path, identity)
    found = opened(path)
    its = found.identity
    said = identity.difference(its)
    if not said and its.shard != identity.shard:
        said = f"is of shard {its.shard}, not {identity.shard}"
    if said:
        found.close()
        raise InputError(f"{named(path)} {said}")
    return found


@contextmanager
def _locked(path: Path) -> Iterator[None]:
    """A context in which no other process adds to the directory."""
    try:
        path.mkdir(parents=True, exist_ok=True)
        lock = os.open(path / LOCK, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o666)
    except OSError as error:
        raise InputError(f"{named(path)} cannot be written: {error.strerror}") from None
    try:
        until = time.monotonic() + PATIENCE
        while _is_taken(lock, fcntl.LOCK_EX):
            if time.monotonic() > until:
                raise InputError(f"{named(path)} is in use by another command")
            time.sleep(0.05)
        yield
    finally:
        os.close(lock)


def _is_taken(lock: int, how: int) -> bool:
    """Try to lock a file without waiting; return whether the lock of another process prevents it.

    If the result is False, the file is now locked.  If it is True, this process has no lock.

    ``lock`` is the descriptor of the file.  ``how`` is the wanted lock: ``LOCK_EX``, an exclusive
    lock, which any other lock prevents; or ``LOCK_SH``, a shared lock, which only an exclusive lock
    prevents.
    """
    try:
        fcntl.flock(lock, how | fcntl.LOCK_NB)
    except BlockingIOError:
        return True
    return False


def in_use(path: Path) -> bool:
    """Whether a process is adding units to the directory."""
    with suppress(OSError):
        lock = os.open(path / LOCK, os.O_RDONLY | os.O_CLOEXEC)
        try:
            return _is_taken(lock, fcntl.LOCK_SH)
        finally:
            os.close(lock)
    return False
