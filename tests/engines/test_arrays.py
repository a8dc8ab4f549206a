"""The memory that a record takes, and the memory of a batch."""

from pathlib import Path

import pytest

from allworlds.engines.kernel import arrays
from allworlds.engines.kernel.arrays import JOB, Stretch, new
from allworlds.engines.players import Logs


def resident():
    """The memory of this process, in bytes."""
    status = Path("/proc/self/status").read_text(encoding="ascii")
    (kilobytes,) = (line.split()[1] for line in status.splitlines() if line.startswith("VmRSS"))
    return 1024 * int(kilobytes)


def test_a_large_record_takes_memory_for_what_is_written_to_alone():
    new(JOB)  # an allocator keeps memory of this size, once it has been given back
    before = resident()
    records = [new(JOB) for _ in range(8)]
    del records[::2]
    records += [new(JOB) for _ in range(4)]
    assert not any(record.number for record in records)
    assert resident() - before < JOB.itemsize


@pytest.fixture
def small(monkeypatch):
    """The memory of a batch with room for logs of five bytes in all."""
    monkeypatch.setattr(arrays, "LOG_BYTES", 5)
    return Stretch.of(1)


def test_logs_stand_one_behind_the_other(small):
    assert small.put(Logs(b"before" + Logs.of([b"a", b"", b"bcde"]).message, 3, at=6)) == 5
    assert (small.logs.tobytes(), small.begins[:3].tolist()) == (b"abcde", [0, 1, 1])
    assert small.put(Logs.of([b"xy"])) == 2
    assert (small.logs.tobytes(), small.begins[0]) == (b"xycde", 0)


def test_logs_without_room_are_not_written(small):
    assert small.put(Logs.of([b"abc", b"def"])) == -1
    assert not small.logs.any()
    assert not small.begins.any()
