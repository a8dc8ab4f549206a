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
        size = self._stretch(job)
        left = threads_left(self._threads)
        self._threads += left
        return StretchResult(size, left)

    def _stretch(self, job: PlayStretch) -> int:
        """The number of bytes of the logs of a stretch; -1 if there is no room for one of them."""
        stretch, due = self._memories.stretch(job), job.schedules
        if due is None or job.again:
            whole = (stretch, job.runs, job.order, job.policy)
            return self.native.play(*whole, again=job.again, every=due is not None)
        size = self.native.play_schedules(stretch, job.runs, due.row, due.script, due.most)
        return size or -1
