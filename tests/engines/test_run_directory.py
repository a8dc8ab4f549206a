"""A run directory is believed where it is whole, and refused in one line where it is not."""

import json
import sqlite3
from contextlib import ExitStack, closing

import pytest
from msgspec import Struct

from allworlds.documents.document import replace
from allworlds.engines import run_directory
from allworlds.engines.kept_units import FORMAT, Identity
from allworlds.engines.run_directory import FILE, SCHEMA, checksum, in_use, kept_in, reading
from allworlds.inputs.checks import InputError
from allworlds.version import __version__

JOB = Identity(
    verb="check",
    parameters={"edges": 2, "bound": "n+m"},
    explorer={"name": "a", "digest": "1"},
    shard="0/1",
)


class Rows(Struct):
    """A result."""

    rows: list[int]

    @property
    def worlds(self):
        return max(self.rows, default=1)


def nothing(text):
    raise AssertionError(text)


@pytest.fixture
def finished(tmp_path):
    """A run directory with some units in it."""
    with kept_in(tmp_path / "run", lambda: JOB, nothing) as records:
        for number in range(9):
            records.keep(f"2:-{number}", Rows([number] * 9))
        records.note("ended", "complete")
    return tmp_path / "run"


def opened(run, job=JOB):
    with kept_in(run, lambda: job, nothing) as records:
        return [records.result(f"2:-{number}") for number in range(10)]


def test_a_directory_that_is_opened_again_keeps_units_as_fast_as_a_new_one(finished):
    connection = run_directory.opened(finished)._connection
    (mode,), (synchronous,) = (
        connection.execute(f"PRAGMA {name}").fetchone() for name in ("journal_mode", "synchronous")
    )
    connection.close()
    assert (mode, synchronous) == ("wal", 1)  # NORMAL


def test_what_is_kept_is_there_again(finished):
    assert opened(finished) == [{"rows": [number] * 9} for number in range(9)] + [None]
    with reading(finished) as read:
        assert read.identity == JOB
        assert {key: (worlds, result) for key, worlds, _, result in read.units()} == {
            f"2:-{number}": (number, {"rows": [number] * 9}) for number in range(9)
        }
        assert read.recall("ended") == "complete"
        assert read.recall("something else") is None


OTHERS = {
    "verb": (replace(JOB, verb="worst"), "is of 'check', not 'worst'"),
    "version": (replace(JOB, version="9.9"), "not '9.9'"),
    "edges": (replace(JOB, parameters={"edges": 3, "bound": "n+m"}), "is of edges = 2, not 3"),
    "bound": (
        replace(JOB, parameters={"edges": 2, "bound": None}),
        "is of bound = 'n+m', not the default",
    ),
    "laws": (
        replace(JOB, parameters={"edges": 2, "bound": ["map", "pose"]}),
        "is of bound = 'n+m', not map,pose",
    ),
    "name": (
        replace(JOB, explorer={"name": "b", "digest": "1"}),
        "is of the explorer 'a', not 'b'",
    ),
    "text": (
        replace(JOB, explorer={"name": "a", "digest": "2"}),
        "another text of the explorer 'a'",
    ),
    "shards": (replace(JOB, shard="0/2"), "is of the whole job, and not of a job in 2 parts"),
}


@pytest.mark.parametrize("name", OTHERS)
def test_a_directory_of_another_job_is_refused(finished, name):
    job, said = OTHERS[name]
    before = (finished / FILE).read_bytes()
    with pytest.raises(InputError, match=r"run directory .*") as refusal:
        opened(finished, job)
    assert said in str(refusal.value)
    assert "\n" not in str(refusal.value)
    assert (finished / FILE).read_bytes() == before


def test_another_shard_of_the_same_job_is_refused(tmp_path):
    first, second = (replace(JOB, shard=f"{k}/2") for k in range(2))
    opened(tmp_path, first)
    with pytest.raises(InputError, match="is of shard 0/2, not 1/2"):
        opened(tmp_path, second)


def test_a_directory_of_other_files_is_refused(tmp_path):
    (tmp_path / "letters.txt").touch()
    with pytest.raises(InputError, match=r"holds 'letters\.txt', which is not ours"):
        opened(tmp_path)


def test_a_directory_that_nobody_can_write_is_refused():
    with pytest.raises(InputError, match="run directory '/proc/run' cannot be written: "):
        opened("/proc/run")


def test_a_directory_in_use_is_refused(finished, monkeypatch):
    monkeypatch.setattr("allworlds.engines.run_directory.PATIENCE", 0.1)
    with (
        kept_in(finished, lambda: JOB, nothing),
        pytest.raises(InputError, match="is in use by another command"),
    ):
        opened(finished)
    assert len(opened(finished)) == 10


def test_a_directory_in_use_is_asked_for_again_a_little_later(finished, monkeypatch):
    other = ExitStack()
    other.enter_context(kept_in(finished, lambda: JOB, nothing))
    monkeypatch.setattr("time.sleep", lambda _seconds: other.close())
    assert len(opened(finished)) == 10


def test_a_creation_that_was_ended_is_begun_anew(tmp_path):
    (tmp_path / run_directory.DRAFT).write_bytes(b"SQLite format 3\0, and no more")
    assert opened(tmp_path) == [None] * 10
    assert not (tmp_path / run_directory.DRAFT).exists()


@pytest.mark.parametrize(
    ("statement", "said"),
    [
        ("PRAGMA application_id = 7", "somebody else's"),
        (f"PRAGMA user_version = {SCHEMA + 1}", f"is of schema {SCHEMA + 1}; this program reads"),
        ("UPDATE meta SET value = replace(value, '2', '3') WHERE name = 'identity'", "is damaged"),
        ("DELETE FROM meta", "is damaged"),
        ("UPDATE units SET result = '{}'", "is damaged: unit 2:-0 is not what was written"),
        ("UPDATE units SET worlds = 7", "is damaged: unit 2:-0"),
        ("UPDATE units SET key = '2:-99' WHERE key = '2:-0'", None),
        ("DROP TABLE units", "cannot be used: no such table"),
    ],
)
def test_a_file_that_was_changed_is_refused(finished, statement, said):
    with closing(sqlite3.connect(finished / FILE)) as connection, connection:
        connection.execute(statement)
    if said is None:
        # The unit has gone, and is done again; whoever reads all finds the other one.
        assert opened(finished)[0] is None
        with (
            pytest.raises(InputError, match="unit 2:-99 is not what was written"),
            reading(finished) as read,
        ):
            list(read.units())
        return
    with pytest.raises(InputError, match=said):
        opened(finished)


def test_rows_of_another_directory_are_refused(finished, tmp_path):
    other = replace(JOB, parameters={"edges": 3})
    with kept_in(tmp_path / "other", lambda: other, nothing) as records:
        records.keep("2:-1", Rows([]))
    for name in ("run", "other"):
        with closing(sqlite3.connect(tmp_path / name / FILE)) as connection, connection:
            connection.execute("DELETE FROM units WHERE key != '2:-1'")
            if name == "other":
                connection.execute("ATTACH ? AS whole", (str(finished / FILE),))
                connection.execute("DELETE FROM units")
                connection.execute("INSERT INTO units SELECT * FROM whole.units")
    with pytest.raises(InputError, match="unit 2:-1 is not what was written"):
        opened(tmp_path / "other", other)


def test_no_file_is_no_run_directory(tmp_path):
    with (
        pytest.raises(InputError, match=r"is no run directory: it holds no units\.sqlite"),
        reading(tmp_path),
    ):
        pass
    (tmp_path / FILE).write_text("no database\n" * 500)
    for look in (lambda: opened(tmp_path), lambda: reading(tmp_path).__enter__()):
        with pytest.raises(InputError, match="is damaged: file is not a database"):
            look()


def test_a_checksum_depends_on_every_field():
    row = ("2:-1", 3, 1.5, "{}")
    changed = [("2:-2", 3, 1.5, "{}"), ("2:-1", 4, 1.5, "{}"), ("2:-1", 3, 1.25, "{}")]
    sums = [checksum("a", *one) for one in (row, *changed, (*row[:3], "[]"))]
    assert len({*sums, checksum("b", *row)}) == 6


def test_a_file_that_cannot_be_read_is_left_closed(finished, monkeypatch):
    real, made = sqlite3.connect, []

    def noted(*address, **options):
        made.append(real(*address, **options))
        return made[-1]

    (finished / FILE).write_bytes(b"somebody else's" * 100)
    monkeypatch.setattr(sqlite3, "connect", noted)
    with pytest.raises(InputError, match="not a database"), reading(finished):
        pass
    (connection,) = made
    with pytest.raises(sqlite3.ProgrammingError, match="closed"):
        connection.execute("SELECT 1")


class NotWritable(sqlite3.Connection):
    """Opened where nothing may be written: the log of the last additions is out of reach."""

    def execute(self, *_):
        raise sqlite3.OperationalError("unable to open database file")


@pytest.mark.parametrize("opens", [False, True])
def test_a_directory_that_cannot_be_written_can_be_read(finished, monkeypatch, opens):
    real, refused = sqlite3.connect, []

    def read_only(address, *more, **options):
        if "mode=ro" in address and not refused:
            refused.append(address)
            if opens:
                return real(address, *more, factory=NotWritable, **options)
            raise sqlite3.OperationalError("unable to open database file")
        return real(address, *more, **options)

    monkeypatch.setattr(sqlite3, "connect", read_only)
    with reading(finished) as read:
        assert len([*read.units()]) == 9
    assert refused


def test_of_several_texts_those_that_differ_are_named():
    one, other = ({"sha256": {"a.json": "1", "b.json": of}} for of in "23")
    jobs = [replace(JOB, parameters=JOB.parameters | texts) for texts in (one, other)]
    assert jobs[0].difference(jobs[1]) == "is of another text of 'b.json'"


def test_an_identity_of_another_format_differs():
    assert JOB.difference(replace(JOB, format=JOB.format + 1)) == (
        f"is of format {JOB.format + 1}, not {JOB.format}"
    )


def test_a_directory_of_another_format_is_refused(finished):
    with closing(sqlite3.connect(finished / FILE)) as connection, connection:
        name, value, _ = connection.execute("SELECT * FROM meta WHERE name = 'identity'").fetchone()
        later = json.dumps(json.loads(value) | {"format": FORMAT + 1, "version": "9.9"})
        connection.execute(
            "UPDATE meta SET value = ?, checksum = ? WHERE name = ?",
            (later, checksum("", name, later), name),
        )
    with pytest.raises(InputError) as refusal:
        opened(finished)
    assert str(refusal.value).endswith(
        f"is of format {FORMAT + 1}, written by version 9.9; this version, {__version__}, reads "
        f"format {FORMAT}"
    )


class Damaged(sqlite3.Connection):
    """A file in which SQLite finds two faults."""

    def execute(self, statement, *more):
        if statement == "PRAGMA integrity_check":
            return [("row 3 missing\nfrom index",), ("row 4 missing",)]
        return super().execute(statement, *more)


def test_a_file_that_sqlite_finds_damaged_is_refused(finished, monkeypatch):
    real = sqlite3.connect
    monkeypatch.setattr(sqlite3, "connect", lambda *a, **b: real(*a, factory=Damaged, **b))
    with (
        pytest.raises(InputError, match=r"is damaged: row 3 missing; remove it"),
        reading(finished),
    ):
        pass


@pytest.mark.parametrize("replaced", [False, True])
def test_a_job_whose_directory_is_removed_goes_on_without_it(finished, replaced):
    told = []
    with kept_in(finished, lambda: JOB, told.append) as records:
        (finished / FILE).rename(finished / "old")
        if replaced:
            (finished / FILE).touch()
        for number in (20, 21):
            records.keep(f"2:-{number}", Rows([number]))
        (finished / "old").replace(finished / FILE)
        records.keep("2:-22", Rows([22]))
        assert [records.result(f"2:-{number}") for number in (20, 21, 22)] == [None] * 3
        assert records.added == 3
    (said,) = told
    assert said.endswith("was removed; the job goes on without it, and keeps nothing")


def test_a_job_whose_directory_takes_no_more_goes_on_without_it(finished, monkeypatch):
    told, tried = [], []

    def full(*row):
        tried.append(row)
        raise sqlite3.OperationalError("database or disk is full")

    with kept_in(finished, lambda: JOB, told.append) as records:
        monkeypatch.setattr(records.database, "keep", full)
        for number in (20, 21):
            records.keep(f"2:-{number}", Rows([number]))
    assert len(tried) == 1
    (said,) = told
    assert said.endswith(
        "takes no more: database or disk is full; what it holds is kept, and the job goes on "
        "without it"
    )


def test_a_directory_is_in_use_while_units_are_added(finished, tmp_path):
    assert in_use(finished) is False
    with kept_in(finished, lambda: JOB, nothing):
        assert in_use(finished) is True
    assert in_use(tmp_path / "nowhere") is False
