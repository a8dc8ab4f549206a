"""Stretches played by a shared library, in compiled code."""

from __future__ import annotations

from collections.abc import MutableSequence

from allworlds.engines.isolation.jobs import PlayStretch
from allworlds.engines.isolation.messages import StretchResult
from allworlds.engines.isolation.shared_logs import OpenedMemories
from allworlds.explorers import NativeExplorer, threads_left, threads_now


class LibraryPlayer:
    """A player's side of stretches, for a shared library: compiled code plays them.

    Args:
        explorer: loaded here.
        beat: see :func:`allworlds.judging.episode.play`.

    Attributes:
        native: the explorer, as compiled code calls it.
    """

    def __init__(self, explorer: NativeExplorer, beat: MutableSequence[int]) -> None:
        from allworlds.engines.kernel.batches import NativePlayer
        from allworlds.engines.kernel.memory_arrays import StretchArrays

        addresses, state = explorer.library.addresses(), explorer.state()
        self.native = NativePlayer(addresses, state, explorer.handed(), beat)
        self._memories = OpenedMemories(StretchArrays)
        self._threads = threads_now()

    def play(self, job: PlayStretch) -> StretchResult:
        """Play all runs of a stretch."""
        stretch = self._memories.stretch(job)
        size = self.native.play(stretch, job.runs, job.order, job.policy, again=job.again)
        left = threads_left(self._threads)
        self._threads += left
        return StretchResult(size, left)
