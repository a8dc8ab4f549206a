"""Memory for a tree of runs, shared by a referee and a player.

Neither compiled code nor NumPy is loaded with it.

A tree of runs is walked chunk by chunk, and every chunk begins at the start of a run.  The first
player writes the log of a chunk: the bytes of one run after the other, each from the branch on at
which it leaves the one before.  For the second player a chunk is cut into segments, between two
branches: what is sensed there, and where its bytes stand in the log.
"""

from __future__ import annotations

import mmap

from allworlds.engines.kernel.stretch import Parts
from allworlds.engines.kernel.tree_requests import SEGMENT

LOG_BYTES = 1 << 21
"""Room for the log of a chunk; a player begins no run behind half of it."""

SLACK = 8
"""The number of bytes behind a log that may be read."""

MOST_RUNS = 1 << 14
"""The largest number of runs in a chunk."""

MOST_SINGLES = 64
"""The largest number of runs of earlier chunks that are played again with a chunk, each from its
start: without a copy."""

LONGEST_SINGLE = 4096
"""The largest number of bytes of such a run, log and percepts together."""

MOST_SEGMENTS = 2 * MOST_RUNS + MOST_SINGLES
"""Room for segments: each run but the first ends at most two."""

PERCEPT_BYTES = 2 * LOG_BYTES
"""Room for percepts."""


class TreeMemory(Parts):
    """Memory for a chunk.

    Args:
        memory: shared; of :meth:`size` bytes.

    Attributes:
        segments: a row for each.
        percepts: three bytes each.
        logs: the log of the chunk.
    """

    def __init__(self, memory: mmap.mmap) -> None:
        super().__init__(memory)
        self.segments = self.part("i", MOST_SEGMENTS, SEGMENT)
        self.percepts = self.part("B", PERCEPT_BYTES)
        self.logs = self.part("B", LOG_BYTES + SLACK)

    @staticmethod
    def size() -> int:
        """The number of bytes of the whole memory."""
        return 4 * MOST_SEGMENTS * SEGMENT + PERCEPT_BYTES + LOG_BYTES + SLACK

    def put(self, log: bytes | bytearray, at: int = 0) -> int:
        """Write bytes of a log; return their number, or -1 if there is no room."""
        if at + len(log) > LOG_BYTES:
            return -1
        self.logs[at : at + len(log)] = memoryview(log)
        return len(log)
