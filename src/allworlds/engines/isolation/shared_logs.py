"""Memory that a referee shares with each player, for many runs and their logs."""

from __future__ import annotations

import mmap
import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from allworlds.engines.isolation.jobs import DueSchedules, PlaySegments, PlayStretch, PlayTree
from allworlds.engines.isolation.messages import StretchResult
from allworlds.engines.kernel.stretch import Stretch
from allworlds.engines.kernel.tree_memory import TreeMemory
from allworlds.engines.kernel.tree_requests import Chunk, TreeRequest

if TYPE_CHECKING:
    from allworlds.engines.isolation.player_pair import PlayerPair


class StretchMemory:
    """Memory that a referee shares with one of its players, without a name in any folder.

    Args:
        edges: the number of edges of each world.
    """

    def __init__(self, edges: int) -> None:
        from allworlds.engines.kernel.memory_arrays import StretchArrays

        self._edges = edges
        self._file = os.memfd_create("allworlds")
        size = Stretch.size(edges)
        os.truncate(self._file, size)
        self.stretch = StretchArrays(mmap.mmap(self._file, size), edges)

    def close(self) -> None:
        """Close the memory: no other process can open it any more."""
        os.close(self._file)

    @property
    def file(self) -> str:
        """The path by which another process opens it."""
        return f"/proc/{os.getpid()}/fd/{self._file}"

    def play(
        self,
        players: PlayerPair,
        which: str,
        runs: int,
        policy: str,
        schedules: DueSchedules | None = None,
    ) -> int | None:
        """Let a player play; return the size of its logs, or None if they cannot be trusted.

        Args:
            players: the pair of the player.
            which: ``first`` or ``second``.
            runs: the number of runs.
            policy: answers the explorer's choices.
            schedules: those that are due, if every schedule is tried.
        """
        order, again = players.random.getrandbits(63), which == "second"
        job = PlayStretch(
            self.file, self._edges, runs, order, policy, again=again, schedules=schedules
        )
        result = players.play_stretch(which, job)
        return None if result is None or result.size < 0 or result.threads else result.size


class TreeMemoryPair:
    """Memory for chunks of trees, which a referee shares with its first and its second player."""

    def __init__(self) -> None:
        from allworlds.engines.kernel.memory_arrays import TreeArrays

        self._files = [os.memfd_create("allworlds") for _ in range(2)]
        for file in self._files:
            os.truncate(file, TreeMemory.size())
        self.first, self.second = (
            TreeArrays(mmap.mmap(file, TreeMemory.size())) for file in self._files
        )

    def play(
        self, players: PlayerPair, request: TreeRequest, chunk: Chunk, runs: int
    ) -> StretchResult | None:
        """Let the first player play a chunk; return None if its log cannot be trusted."""
        return _trusted(
            players.play_stretch("first", PlayTree(self._path(0), request, chunk, runs))
        )

    def play_again(
        self, players: PlayerPair, policy: str, roots: Sequence[int], runs: int
    ) -> StretchResult | None:
        """Let the second player play segments; return None if its log cannot be trusted."""
        order = players.random.sample(roots, len(roots))
        return _trusted(
            players.play_stretch("second", PlaySegments(self._path(1), policy, (*order,), runs))
        )

    def _path(self, which: int) -> str:
        return f"/proc/{os.getpid()}/fd/{self._files[which]}"


def _trusted(result: StretchResult | None) -> StretchResult | None:
    return None if result is None or result.threads else result


class OpenedMemories:
    """A player's side of the shared memories; each is opened once.

    Args:
        stretch, tree: how a player looks at them.
    """

    def __init__(
        self, stretch: type[Stretch] = Stretch, tree: type[TreeMemory] = TreeMemory
    ) -> None:
        self._stretch, self._tree = stretch, tree
        self._opened: dict[str, Any] = {}

    def stretch(self, job: PlayStretch) -> Stretch:
        """The memory of a stretch."""
        if job.memory not in self._opened:
            memory = _mapped(job.memory, Stretch.size(job.edges))
            self._opened[job.memory] = self._stretch(memory, job.edges)
        return cast("Stretch", self._opened[job.memory])

    def tree(self, job: PlayTree | PlaySegments) -> TreeMemory:
        """The memory of a tree."""
        if job.memory not in self._opened:
            self._opened[job.memory] = self._tree(_mapped(job.memory, TreeMemory.size()))
        return cast("TreeMemory", self._opened[job.memory])


def _mapped(path: str, size: int) -> mmap.mmap:
    with Path(path).open("r+b") as file:
        memory = mmap.mmap(file.fileno(), size)
    if hasattr(mmap, "MADV_DONTFORK"):  # a copy made by the explorer must not write here
        memory.madvise(mmap.MADV_DONTFORK)
    return memory
