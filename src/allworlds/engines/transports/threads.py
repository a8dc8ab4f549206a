"""Units in threads, for engines that release the interpreter's lock."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from itertools import islice, takewhile
from threading import Event
from typing import Any, Protocol, Self, TypeVar

from allworlds.engines.transports.inline import with_last
from allworlds.engines.units.effort import POLL, TimeIsUp, check_deadline
from allworlds.engines.units.unit import PartialResult, R, U, U_contra, UnitEngine

R_co = TypeVar("R_co", covariant=True)


class Haltable(UnitEngine[U_contra, R_co], Protocol[U_contra, R_co]):
    """An engine for threads: its work can be ended before its time."""

    def halt(self) -> None:
        """Cancel the work of every thread; its results are no longer needed."""


class Threads:
    """A pool of threads; leaving the context cancels the work that is running.

    Args:
        workers: the number of threads.
        deadline: on the monotonic clock, or None.
        batch: units that a thread does at a time; many small ones cost less to hand over so.
    """

    def __init__(self, workers: int, deadline: float | None = None, batch: int = 1) -> None:
        self._workers, self._deadline, self._batch = workers, deadline, batch
        self._pool = ThreadPoolExecutor(workers)
        self._ended = Event()
        self._engine: Haltable[Any, Any] | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *raised: object) -> None:
        _, error, _ = raised
        self._ended.set()
        if self._engine is not None:
            self._engine.halt()
        # Who is in a hurry does not wait for what cannot be given up, such as a compiler; after
        # any other error nothing is left that goes on behind the next job's back.
        patient = isinstance(error, Exception | None) and not isinstance(error, TimeIsUp)
        self._pool.shutdown(wait=patient, cancel_futures=True)

    def map(self, engine: Haltable[U, R], units: Iterable[U]) -> Iterator[PartialResult[U, R]]:
        """Yield the parts of all units, in the order in which their batches are done.

        Raises:
            Exception: of the engine, in the first unit that raises one, in the order of units.
        """
        self._engine = engine
        waiting = iter(units)
        at_work: list[Future[list[PartialResult[U, R]]]] = []
        while True:
            while len(at_work) < 2 * self._workers and (batch := [*islice(waiting, self._batch)]):
                at_work.append(self._pool.submit(_done, engine, batch, self._ended))
            if not at_work:
                return
            done = wait(at_work, POLL, FIRST_COMPLETED).done
            wrong = any(future.exception() for future in done)
            for future in at_work:
                if wrong or future in done:
                    yield from future.result()
            at_work = [future for future in at_work if future not in done]
            check_deadline(self._deadline)


def _done(engine: UnitEngine[U, R], batch: Iterable[U], ended: Event) -> list[PartialResult[U, R]]:
    """The parts of some units; of fewer, once the context has ended."""
    return [
        PartialResult(unit, result, last)
        for unit in takewhile(lambda _: not ended.is_set(), batch)
        for result, last in with_last(engine.parts(unit))
    ]
