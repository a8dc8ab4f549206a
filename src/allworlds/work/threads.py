"""Units in threads, for engines that let go of the interpreter's lock."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from itertools import islice
from typing import Protocol, Self, TypeVar

from allworlds.work.effort import POLL, check_deadline
from allworlds.work.here import with_last
from allworlds.work.work import Engine, Part, R, U, U_contra

R_co = TypeVar("R_co", covariant=True)


class Halts(Protocol):
    """An engine that can be told to give up."""

    def halt(self) -> None:
        """Give up what is being done in any thread; its results are not asked for any more."""


class Haltable(Engine[U_contra, R_co], Halts, Protocol[U_contra, R_co]):
    """What is done in threads must be able to end before its time."""


class Threads:
    """So many threads; what is being done when the context ends is given up.

    Args:
        workers: how many.
        deadline: on the monotonic clock, or None.
        batch: units that a thread does at a time; many small ones cost less to hand over so.
    """

    def __init__(self, workers: int, deadline: float | None = None, batch: int = 1) -> None:
        self._workers, self._deadline, self._batch = workers, deadline, batch
        self._pool = ThreadPoolExecutor(workers)
        self._engine: Halts | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        if self._engine is not None:
            self._engine.halt()
        # Whoever interrupts does not wait for what cannot be given up, such as a compiler.
        self._pool.shutdown(wait=not any(error), cancel_futures=True)

    def map(self, engine: Haltable[U, R], units: Iterable[U]) -> Iterator[Part[U, R]]:
        """The parts of all units, in the order in which their batches are done."""
        self._engine = engine
        waiting = iter(units)
        at_work: set[Future[list[Part[U, R]]]] = set()
        while True:
            while len(at_work) < 2 * self._workers and (batch := [*islice(waiting, self._batch)]):
                at_work.add(self._pool.submit(_done, engine, batch))
            if not at_work:
                return
            done, at_work = wait(at_work, POLL, FIRST_COMPLETED)
            for future in done:
                yield from future.result()
            check_deadline(self._deadline)


def _done(engine: Engine[U, R], batch: Iterable[U]) -> list[Part[U, R]]:
    return [
        Part(unit, result, last) for unit in batch for result, last in with_last(engine.parts(unit))
    ]
