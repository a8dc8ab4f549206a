"""Memory that a referee shares with each player, for many runs and their logs."""

from __future__ import annotations

import mmap
import os
from pathlib import Path
from typing import TYPE_CHECKING

from allworlds.engines.isolation.jobs import PlayStretch
from allworlds.engines.kernel.stretch import Stretch

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

    def play(self, players: PlayerPair, which: str, runs: int, policy: str) -> int | None:
        """Let a player play; return the size of its logs, or None if they cannot be trusted.

        Args:
            players: the pair of the player.
            which: ``first`` or ``second``.
            runs: the number of runs.
            policy: answers the explorer's choices.
        """
        order = players.random.getrandbits(63)
        job = PlayStretch(self.file, self._edges, runs, order, policy, again=which == "second")
        result = players.play_stretch(which, job)
        return None if result is None or result.size < 0 or result.threads else result.size


class OpenedMemories:
    """A player's side of the shared memories; each is opened once.

    Args:
        kind: how a player looks at them.
    """

    def __init__(self, kind: type[Stretch] = Stretch) -> None:
        self._kind = kind
        self._opened: dict[str, Stretch] = {}

    def stretch(self, job: PlayStretch) -> Stretch:
        """The memory of a stretch."""
        if job.memory not in self._opened:
            memory = _mapped(job.memory, Stretch.size(job.edges))
            self._opened[job.memory] = self._kind(memory, job.edges)
        return self._opened[job.memory]


def _mapped(path: str, size: int) -> mmap.mmap:
    with Path(path).open("r+b") as file:
        memory = mmap.mmap(file.fileno(), size)
    if hasattr(mmap, "MADV_DONTFORK"):  # a copy made by the explorer must not write here
        memory.madvise(mmap.MADV_DONTFORK)
    return memory
