"""Many runs of an explorer at a time: the memory that a referee shares with each player."""

from __future__ import annotations

import mmap
import os
from collections.abc import MutableSequence
from pathlib import Path
from typing import TYPE_CHECKING

from allworlds.engines.isolation.cast import Cast
from allworlds.engines.isolation.jobs import PlayStretch, Stretched
from allworlds.explorers import NativeExplorer, threads_left, threads_now

if TYPE_CHECKING:
    from allworlds.engines.kernel.batches import Stretch


class Shared:
    """Memory that both a referee and one of its players see; nothing of it is in any folder.

    Args:
        edges: of each world.
    """

    def __init__(self, edges: int) -> None:
        from allworlds.engines.kernel.batches import Stretch

        self._edges = edges
        self._file = os.memfd_create("allworlds")
        size = Stretch.size(edges)
        os.truncate(self._file, size)
        self.stretch = Stretch(mmap.mmap(self._file, size), edges)

    def close(self) -> None:
        """Nobody else can get to it any more."""
        os.close(self._file)

    @property
    def file(self) -> str:
        """Where another process finds it."""
        return f"/proc/{os.getpid()}/fd/{self._file}"

    def played(self, cast: Cast, which: str, runs: int, policy: str) -> int | None:
        """The number of bytes of the logs; None if they are to be made in another way.

        Args:
            cast: of the player.
            which: ``first`` or ``second``.
            runs: how many.
            policy: answers the explorer's choices.
        """
        again = which == "second"
        order = cast.random.getrandbits(63)
        job = PlayStretch(self.file, self._edges, runs, order, policy, again)
        said = cast.stretch(which, job)
        return None if said is None or said.size < 0 or said.threads else said.size


class Shown:
    """A player's side of the memories that it has been shown."""

    def __init__(self) -> None:
        self._seen: dict[str, Stretch] = {}

    def stretch(self, job: PlayStretch) -> Stretch:
        """The memory of a job."""
        from allworlds.engines.kernel.batches import Stretch

        if job.memory not in self._seen:
            with Path(job.memory).open("r+b") as file:
                memory = mmap.mmap(file.fileno(), Stretch.size(job.edges))
            self._seen[job.memory] = Stretch(memory, job.edges)
        return self._seen[job.memory]


class Actor:
    """A native explorer, which plays stretches in compiled code.

    Args:
        explorer: loaded here.
        beat: see :func:`allworlds.judging.episode.play`.
    """

    def __init__(self, explorer: NativeExplorer, beat: MutableSequence[int]) -> None:
        from allworlds.engines.kernel.batches import Actors

        addresses, state = explorer.library.addresses(), explorer.state()
        self._actors = Actors(addresses, state, explorer.handed(), beat)
        self._shown = Shown()
        self._threads = threads_now()

    def play(self, job: PlayStretch) -> Stretched:
        """All runs of a stretch."""
        stretch = self._shown.stretch(job)
        size = self._actors.play(stretch, job.runs, job.order, job.policy, again=job.again)
        left = threads_left(self._threads)
        self._threads += left
        return Stretched(size, left)
