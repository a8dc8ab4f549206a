"""The memory that a record takes."""

from pathlib import Path

from allworlds.engines.kernel.arrays import JOB, new


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
