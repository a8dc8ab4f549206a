"""Batches played by a shared library, in compiled code; loaded by players alone."""

from __future__ import annotations

import mmap
from collections.abc import MutableSequence
from itertools import pairwise
from typing import Any

from numpy import frombuffer, int32, uint8

from allworlds.engines.kernel.batches import NativePlayer
from allworlds.engines.kernel.memory_arrays import StretchArrays
from allworlds.engines.kernel.stretch import HEAD, Stretch
from allworlds.explorers import NativeExplorer, threads_left, threads_now


class LibraryPlayer:
    """A library that plays batches which compiled code has laid out.

    Args:
        explorer: loaded here.
        beat: the number of the run, and the explorer's turns in it.
    """

    def __init__(self, explorer: NativeExplorer, beat: MutableSequence[int]) -> None:
        addresses, state = explorer.library.addresses(), explorer.state()
        self._native = NativePlayer(addresses, state, explorer.handed(), beat)
        self._memories: dict[int, Any] = {}
        self._threads = threads_now()

    def play(self, batch: dict[str, Any]) -> bytes | None:
        """The lengths of the logs, and the logs; None if they do not fit, or threads are left."""
        edges, runs, order = batch["edges"], batch["runs"], batch["seed"]
        if edges not in self._memories:
            self._memories[edges] = StretchArrays(mmap.mmap(-1, Stretch.size(edges)), edges)
        memory = self._memories[edges]
        heads = frombuffer(batch["heads"], int32).reshape(runs, HEAD)
        memory.heads[:runs] = heads
        if batch["again"]:
            sensed = frombuffer(batch["percepts"], uint8)
            memory.percepts[: len(sensed)] = sensed
            memory.starts[:runs] = frombuffer(batch["starts"], int32)[:runs]
        else:
            worlds = frombuffer(batch["worlds"], uint8)
            memory.worlds[:runs] = worlds.reshape(runs, memory.wide)
        size = self._native.play(memory, runs, order, batch["policy"], again=batch["again"])
        left = threads_left(self._threads)
        self._threads += left
        if size < 0 or left:
            return None
        return _in_order(memory.begins[:runs].tolist(), size, memory.logs)


def _in_order(begins: list[int], size: int, logs: Any) -> bytes:
    """The lengths of logs that were written in another order, and the logs in theirs."""
    following = sorted([*begins, size])
    behind = dict(pairwise(following))
    parts = [logs[begin : behind[begin]].tobytes() for begin in begins]
    return b"".join([*(len(part).to_bytes(4, "little") for part in parts), *parts])
