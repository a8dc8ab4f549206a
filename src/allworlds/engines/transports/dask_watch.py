"""Signs of life of a Dask cluster: the answers of its scheduler, and the heartbeats of its workers.

A worker or a scheduler that was stopped, or that is behind a broken network, keeps its connections:
it is known by its silence alone.
"""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Mapping
from time import monotonic
from typing import Any, NoReturn

from allworlds.engines.transports.dask_lanes import ClusterLost
from allworlds.engines.units.effort import DaskCluster

LOOK = 1.0
"""Seconds between two looks."""


class ClusterWatch:
    """The watch over a cluster; its workers come and go.

    Args:
        client: of the scheduler, asynchronous.
        cluster: with the seconds of silence after which a worker or the scheduler is given up.

    Attributes:
        threads: the number of threads of its workers.
    """

    def __init__(self, client: Any, cluster: DaskCluster) -> None:
        self._client, self._cluster = client, cluster
        self._seen: dict[str, tuple[float, float]] = {}
        self._alive = monotonic()
        self.threads = 0

    async def keep(self) -> NoReturn:
        """Look again and again.

        Raises:
            ClusterLost: if the scheduler, or all workers, are silent for too long.
        """
        while True:
            await asyncio.sleep(LOOK)
            await self.look()

    async def look(self) -> None:
        """Count the threads, and give up the workers that are silent for too long.

        Raises:
            ClusterLost: if the scheduler, or all workers, are silent for too long.
        """
        workers = dict((await self._answer(self._client.scheduler.identity()))["workers"])
        now = monotonic()
        self._seen = {name: self._last(name, told, now) for name, told in workers.items()}
        self._alive = max([self._alive, *(since for _, since in self._seen.values())])
        if now - self._alive > self._cluster.timeout:
            raise ClusterLost(f"no worker of {self._cluster} gave a sign of life for {self._limit}")
        for name, (_, since) in self._seen.items():
            if now - since > self._cluster.timeout:
                remove = self._client.scheduler.unregister
                await self._answer(remove(address=name, stimulus_id="allworlds-silent"))
                del workers[name]
        self.threads = sum(told["nthreads"] for told in workers.values())

    @property
    def _limit(self) -> str:
        return f"{self._cluster.timeout:g} s"

    async def _answer(self, asked: Awaitable[Any]) -> Any:
        """The answer of the scheduler."""
        try:
            async with asyncio.timeout(self._cluster.timeout):
                return await asked
        except TimeoutError:
            raise ClusterLost(f"{self._cluster} gave no sign of life for {self._limit}") from None
        except OSError:
            raise ClusterLost(f"{self._cluster} is gone") from None

    def _last(self, name: str, told: Mapping[str, Any], now: float) -> tuple[float, float]:
        """The last heartbeat of a worker, by the scheduler's clock, and since when it is known."""
        before = self._seen.get(name)
        return before if before and before[0] == told["last_seen"] else (told["last_seen"], now)
