"""Stretches and trees played by a shared library, in compiled code."""

from __future__ import annotations

from collections.abc import MutableSequence
from typing import TYPE_CHECKING

from allworlds.engines.isolation.jobs import PlaySegments, PlayStretch, PlayTree
from allworlds.engines.isolation.messages import StretchResult
from allworlds.engines.isolation.shared_logs import OpenedMemories
from allworlds.explorers import NativeExplorer, threads_left, threads_now

if TYPE_CHECKING:
    from allworlds.engines.kernel.chunks import CopyingPlayer


class LibraryPlayer:
    """A player's side of stretches and trees, for a shared library: compiled code plays them.

    Args:
        explorer: loaded here.
        beat: see :func:`allworlds.judging.episode.play`.

    Attributes:
        native: the explorer, as compiled code calls it.
    """

    def __init__(self, explorer: NativeExplorer, beat: MutableSequence[int]) -> None:
        from allworlds.engines.kernel.batches import NativePlayer
        from allworlds.engines.kernel.memory_arrays import StretchArrays, TreeArrays

        addresses, state = explorer.library.addresses(), explorer.state()
        self.native = NativePlayer(addresses, state, explorer.handed(), beat)
        self._states = addresses["clone"], addresses["new"]
        self._copying: CopyingPlayer | None = None
        self._memories = OpenedMemories(StretchArrays, TreeArrays)
        self._threads = threads_now()

    def play(self, job: PlayStretch | PlayTree | PlaySegments) -> StretchResult:
        """Play all runs of a stretch, or of a chunk of a tree."""
        size, last = self._played(job)
        left = threads_left(self._threads)
        self._threads += left
        return StretchResult(size, left, last)

    def _played(self, job: PlayStretch | PlayTree | PlaySegments) -> tuple[int, bool]:
        """The number of bytes, and whether a tree ends here."""
        if isinstance(job, PlayStretch):
            return self._stretch(job), False
        if self._copying is None:
            from allworlds.engines.kernel.chunks import CopyingPlayer

            self._copying = CopyingPlayer(self.native, self._states)
        memory = self._memories.tree(job)
        if isinstance(job, PlayTree):
            return self._copying.play(memory, job.request, job.chunk, job.runs)
        return self._copying.play_again(memory, job.policy, job.roots), False

    def _stretch(self, job: PlayStretch) -> int:
        """The number of bytes of the logs of a stretch; -1 if there is no room for one of them."""
        stretch, due = self._memories.stretch(job), job.schedules
        if due is None or job.again:
            whole = (stretch, job.runs, job.order, job.policy)
            return self.native.play(*whole, again=job.again, every=due is not None)
        size = self.native.play_schedules(stretch, job.runs, due.row, due.script, due.most)
        return size or -1
