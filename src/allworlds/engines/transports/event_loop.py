"""An event loop in a thread of its own, for what is said to other machines."""

from __future__ import annotations

import asyncio
from collections.abc import Coroutine
from concurrent.futures import Future
from threading import Event, Thread
from typing import Any, TypeVar

T = TypeVar("T")


class EventLoop:
    """A loop whose thread alone waits for answers: the caller can be interrupted at any time."""

    def __init__(self) -> None:
        self._running = Event()
        self._thread = Thread(target=asyncio.run, args=(self._run(),), daemon=True)
        self._thread.start()
        self._running.wait()

    async def _run(self) -> None:
        self._loop, self._ended = asyncio.get_running_loop(), asyncio.Event()
        self._running.set()
        await self._ended.wait()

    def begin(self, work: Coroutine[Any, Any, T]) -> Future[T]:
        """The future result of a coroutine; to cancel the one is to cancel the other."""
        return asyncio.run_coroutine_threadsafe(work, self._loop)

    def result(self, work: Coroutine[Any, Any, T]) -> T:
        """The result of a coroutine, which is cancelled if the caller is interrupted."""
        future = self.begin(work)
        try:
            return future.result()
        finally:
            future.cancel()

    def end(self, last: Coroutine[Any, Any, None], seconds: float) -> None:
        """Cancel all work when a last coroutine has come to its end.

        The caller waits for at most that many seconds; the thread ends with the process.
        """

        async def ended() -> None:
            try:
                await last
            finally:
                self._ended.set()

        self.begin(ended())
        self._thread.join(seconds)
