"""Memory for many runs of a user's explorer, shared by both sides.

Neither compiled code nor NumPy is loaded with it, so that a process that only plays starts fast.
"""

from __future__ import annotations

import mmap
from array import array
from collections.abc import Sequence
from math import prod
from typing import Any, Literal

MOST_PLACES = 64
"""A number above that of a lighthouse's places in one map."""

# The columns of what is said of a run besides: its budget, what is told, its number in its unit,
# and against records how many motions were made.
RUN_BUDGET = 0
RUN_TOLD = 1
RUN_NUMBER = 2
RUN_MOTIONS = 3
HEAD = 4

# The columns of a laid-out world, for each dart: the first dart of its vertex, its partner, and
# what is sensed on arriving by it.
FIRST, PARTNER, DEGREE, MARKS, BEARING = range(5)
WIDE = 5

LONGEST_STRETCH = 2048
"""The largest number of runs in a stretch, but for those of its last world."""

ROWS = LONGEST_STRETCH + MOST_PLACES
"""Room for the runs of a stretch, and of its last world."""

LOG_BYTES = 1 << 20
"""Room for the logs of a stretch, and as much for its percepts: 512 bytes a run."""


class Stretch:
    """Memory for the runs of a stretch, shared by both sides.

    Args:
        memory: shared; of :meth:`size` bytes.
        edges: of each world.

    Attributes:
        heads: of each run its budget, the number told, its number, and that of its motions.
        worlds: of each run its world, dart by dart; not for plays against records.
        percepts, starts: the percepts, three bytes each, and where those of a run begin.
        logs, begins: the logs, and where that of each run begins.
        wide: the number of bytes of a world.
    """

    def __init__(self, memory: mmap.mmap, edges: int) -> None:
        self._memory, self._at = memory, 0
        self.wide = WIDE * 2 * edges
        self.heads = self.part("i", ROWS, HEAD)
        self.begins = self.part("i", ROWS)
        self.starts = self.part("i", ROWS)
        self.worlds = self.part("B", ROWS, self.wide)
        self.percepts = self.part("B", LOG_BYTES)
        self.logs = self.part("B", LOG_BYTES)

    def part(self, kind: Literal["i", "B"], *shape: int) -> Any:
        """The next part of the memory, a view of numbers without rows.

        Args:
            kind: ``i`` for numbers of 32 bits, ``B`` for bytes.
            shape: its rows, and the length of each.
        """
        begin, size = self._at, array(kind).itemsize * prod(shape)
        self._at += size
        return memoryview(self._memory)[begin : self._at].cast(kind)

    @staticmethod
    def size(edges: int) -> int:
        """The number of bytes of the whole memory."""
        rows = ROWS
        return rows * (4 * HEAD + 8 + WIDE * 2 * edges) + 2 * LOG_BYTES

    def put(self, logs: bytes | bytearray, begins: Sequence[int]) -> int:
        """Write logs here; return the number of their bytes, or -1 if there is no room."""
        if len(logs) > len(self.logs):
            return -1
        self.begins[: len(begins)] = array("i", begins)
        self.logs[: len(logs)] = memoryview(logs)
        return len(logs)
