"""The file of a run directory: a job's identity, and finished units, each with a checksum.

Results are put together only if their identities are equal.  The file, of SQLite, holds JSON texts,
and no code.  Each unit is one transaction: a killed process loses the unit that it was at, and
nothing else.  Every row is checked when it is read.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import sqlite3
import tempfile
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from typing import Annotated, Any, Self

from allworlds.document.reading import taken
from allworlds.document.struct import Document, Positive, ShardText, Text, about
from allworlds.engines.units import Portion, a_shard, shard_numbers, shards_of
from allworlds.inputs.checks import InputError, show
from allworlds.version import __version__
from allworlds.words import plural

FORMAT = 3
"""The format of identities and of what is kept under them: raised whenever either changes."""


class Identity(Document):
    """A verb, with everything that its result depends on."""

    verb: Annotated[Text, about("its name")]
    parameters: Annotated[dict[str, Any], about("by their names, as JSON values")]
    explorer: Annotated[
        dict[str, Any],
        about("the name, and what else is to be known of it without loading it; its digest"),
    ]
    shard: Annotated[ShardText, about("which part of the units is done")]
    version: Annotated[Text, about("of this program")] = __version__
    format: Annotated[Positive, about("of what is kept: a number that `FORMAT` has had")] = FORMAT

    @property
    def text(self) -> str:
        """Canonical JSON, the same for equal identities."""
        return canonical(self.to_json())

    @property
    def digest(self) -> str:
        """SHA-256 of the text, in hexadecimal."""
        return hashlib.sha256(self.text.encode()).hexdigest()

    @classmethod
    def of_text(cls, text: str) -> Self:
        """The identity of :attr:`text`."""
        return taken({"format": 1} | json.loads(text), cls, "identity")

    @property
    def portion(self) -> Portion:
        """The part of the units that is done: the whole, or a shard."""
        return a_shard(shard_numbers(self.shard))

    @property
    def code(self) -> dict[str, str]:
        """The user's code that it needs, as it was recorded: see ``as_recorded``."""
        code: dict[str, str] = self.parameters.get("code", {})
        return code

    @property
    def shards(self) -> int:
        """The number of shards into which the job is cut."""
        return shards_of(self.portion)

    def difference(self, other: Identity) -> str:
        """The difference of the other one, as a clause about the other; empty if there is none.

        The number of a shard makes no difference here; the number of all shards does.
        """
        if other.format != self.format:
            return f"is of format {other.format}, not {self.format}"
        if other.version != self.version:
            return f"is of version {show(other.version)}, not {show(self.version)}"
        if other.verb != self.verb:
            return f"is of {show(other.verb)}, not {show(self.verb)}"
        for name in sorted({*self.parameters, *other.parameters}):
            mine, its = self.parameters.get(name), other.parameters.get(name)
            if mine != its and isinstance(mine, dict) and isinstance(its, dict):
                changed = sorted(code for code in mine if mine[code] != its.get(code))
                return f"is of another text of {', '.join(map(show, changed or its))}"
            if mine != its:
                said = name.replace("_", "-")
                return f"is of {said} = {_in_words(its)}, not {_in_words(mine)}"
        mine, its = self.explorer["name"], other.explorer["name"]
        if mine != its:
            return f"is of the explorer {show(its)}, not {show(mine)}"
        if other.explorer != self.explorer:
            return f"is of another text of the explorer {show(mine)}, or of its program"
        if other.shards != self.shards:
            part = f"shard {other.shard}" if other.shards > 1 else "the whole job"
            return f"is of {part}, and not of a job in {plural(self.shards, 'part')}"
        return ""


def _in_words(value: Any) -> str:
    """A parameter as the command line has it: without a value the default, a list with commas."""
    if value is None:
        return "the default"
    return ",".join(map(str, value)) if isinstance(value, list | tuple) else show(value)


canonical = json.JSONEncoder(sort_keys=True, separators=(",", ":")).encode
"""The canonical text of a JSON value, equal for equal values."""

in_order = json.JSONEncoder(separators=(",", ":")).encode
"""A JSON value as a text that keeps the order of keys, in which a report tells them."""


FILE, DRAFT = "units.sqlite", "draft.sqlite"

APPLICATION = 0x616C6C77
"""The number in the header of the file that marks a run directory."""

SCHEMA = 2
"""The version of the tables below, and of their content."""

TABLES = """
CREATE TABLE meta (name TEXT PRIMARY KEY, value TEXT NOT NULL, checksum TEXT NOT NULL) STRICT;
CREATE TABLE units (
    key TEXT PRIMARY KEY, worlds INTEGER NOT NULL, finished REAL NOT NULL,
    result TEXT NOT NULL, checksum TEXT NOT NULL
) STRICT;
CREATE TABLE sessions (started REAL NOT NULL) STRICT;
"""

BUSY = 10.0
"""Seconds to wait for a reader."""


def named(path: Path) -> str:
    """A run directory, as messages name it."""
    return f"run directory {show(str(path))}"


def damaged(path: Path, how: str) -> InputError:
    """The error for a run directory that is not as it was written."""
    return InputError(
        f"{named(path)} is damaged: {how}; remove it and begin again, or bring it back from a copy"
    )


@contextmanager
def saying_where(path: Path) -> Iterator[None]:
    """A context in which errors of SQLite become errors about the directory, in one line."""
    try:
        yield
    except sqlite3.OperationalError as error:
        raise InputError(f"{named(path)} cannot be used: {error}") from None
    except (sqlite3.DatabaseError, UnicodeDecodeError) as error:
        raise damaged(path, str(error)) from None


class Database:
    """An open file of units, in a directory, with the identity of its job."""

    def __init__(self, path: Path, connection: sqlite3.Connection, identity: Identity) -> None:
        self.path, self.identity, self._connection = path, identity, connection
        self._seal = identity.digest
        self._file: os.stat_result | None = None
        with suppress(OSError):
            self._file = (path / FILE).stat()

    @property
    def is_there(self) -> bool:
        """Whether its file is the one that was opened: it was neither removed nor replaced."""
        return is_at(self.path / FILE, self._file)

    def close(self) -> None:
        """Close the connection to the file."""
        self._connection.close()

    def result(self, key: str) -> Any:
        """The JSON value of a finished unit; None of any other.

        Raises:
            InputError: if it is not as it was written.
        """
        row = self._first("SELECT * FROM units WHERE key = ?", key)
        return None if row is None else json.loads(self._sound(f"unit {key}", *row)[3])

    def keys(self) -> list[str]:
        """The keys of the finished units."""
        with saying_where(self.path):
            return [key for (key,) in self._connection.execute("SELECT key FROM units")]

    def rows(self) -> Iterator[tuple[str, int, float, Any]]:
        """Of every finished unit its key, worlds, time and result, in no order."""
        with saying_where(self.path):
            for row in self._connection.execute("SELECT * FROM units"):
                key, worlds, finished, result, _ = self._sound(f"unit {row[0]}", *row)
                yield key, worlds, finished, json.loads(result)

    def keep(self, key: str, worlds: int, finished: float, result: Any) -> None:
        """Write a finished unit, in a transaction of its own.

        If another command writes the unit, too, because its lock was removed, the results are
        equal.

        Raises:
            sqlite3.OperationalError: if there is no room for it.
        """
        row = self._sealed(key, worlds, finished, in_order(result))
        self._connection.execute("INSERT OR REPLACE INTO units VALUES (?, ?, ?, ?, ?)", row)

    def recall(self, name: str) -> Any:
        """The value that was noted under a name; None if there is none."""
        row = self._first("SELECT * FROM meta WHERE name = ?", name)
        return None if row is None else json.loads(self._sound(f"its {name}", *row)[1])

    def note(self, name: str, value: Any) -> None:
        """Note a JSON value under a name, in place of what was there.

        Raises:
            sqlite3.OperationalError: if there is no room for it.
        """
        row = self._sealed(name, in_order(value))
        self._connection.execute("INSERT OR REPLACE INTO meta VALUES (?, ?, ?)", row)

    def begin_session(self, now: float) -> None:
        """Note the time at which a process begins to add to it."""
        self._first("INSERT INTO sessions VALUES (?)", now)

    def last_session(self) -> float:
        """The time at which a process last began to add to it."""
        (started,) = self._first("SELECT max(started) FROM sessions")
        return float(started or 0)

    def _first(self, query: str, *values: Any) -> Any:
        """The first row of the answer; None if there is none."""
        with saying_where(self.path):
            return self._connection.execute(query, values).fetchone()

    def _sealed(self, *row: Any) -> tuple[Any, ...]:
        return (*row, checksum(self._seal, *row))

    def _sound(self, what: str, *row: Any) -> tuple[Any, ...]:
        if self._sealed(*row[:-1]) != row:
            raise damaged(self.path, f"{what} is not what was written")
        return row


def is_at(path: Path, file: os.stat_result | None) -> bool:
    """Whether that path leads to that file, and to no other."""
    try:
        return file is not None and os.path.samestat(path.stat(), file)
    except OSError:
        return False


def checksum(seal: str, *row: Any) -> str:
    """A digest of a row, and of its job."""
    return hashlib.sha256(repr((seal, *row)).encode(errors="backslashreplace")).hexdigest()[:32]


def created(path: Path, identity: Identity) -> Database:
    """The new file of a directory that has none; it is there whole, or not at all."""
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
    """Open the file of a directory to add to it.

    Raises:
        InputError: if it is no run directory's, of another version, or damaged.
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
    """A context with the file of a directory, open for reading, even while a process adds to it.

    Raises:
        InputError: as :func:`opened`; and if there is none.
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
            # Where nothing can be written the log of the last additions cannot be looked into.
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
    # A killed process loses nothing; a machine that loses its power the last units at most.
    connection.execute("PRAGMA synchronous = NORMAL")


def _looked_through(path: Path, connection: sqlite3.Connection) -> Identity:
    """The identity in the file, after a check of all its pages."""
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
