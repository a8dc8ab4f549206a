"""Transports of this process: one thread, or several."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from itertools import islice, takewhile
from threading import Event
from typing import Any, Self

from allworlds.engines.limits import POLL, DaskCluster, TimeIsUp, check_deadline
from allworlds.engines.units import PartialResult, Transport, U, UnitEngine


def _parts(engine: UnitEngine, unit: U) -> Iterator[PartialResult[U, Any]]:
    """The parts of a unit's result; the last one says that it is."""
    parts = iter(engine.parts(unit))
    result = next(parts)
    for following in parts:
        yield PartialResult(unit, result, last=False)
        result = following
    yield PartialResult(unit, result, last=True)


class ThisThread:
    """The transport in this thread; the engine's work here cannot be stopped from outside."""

    def __init__(self, deadline: float | None = None) -> None:
        self._deadline = deadline

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        """Leave the context; no work goes on."""

    def map(self, engine: UnitEngine, units: Iterable[U]) -> Iterator[PartialResult[U, Any]]:
        """Yield the parts of all units, in their order."""
        for unit in units:
            for part in _parts(engine, unit):
                yield part
                check_deadline(self._deadline)


def local_or_dask(cluster: DaskCluster | None, deadline: float | None) -> Transport[Any]:
    """The transport in this thread, or to the cluster; a local one has a process a core."""
    if cluster is None:
        return ThisThread(deadline)
    from allworlds.engines.dask import Dask

    return Dask(cluster, os.cpu_count() or 1, deadline)


class Threads:
    """A pool of threads; leaving the context has the engine ``halt()`` the work that is running.

    Args:
        workers: the number of threads.
        deadline: on the monotonic clock, or None.
        batch: units that a thread does at a time; many small ones cost less to hand over so.
    """

    def __init__(self, workers: int, deadline: float | None = None, batch: int = 1) -> None:
        self._workers, self._deadline, self._batch = workers, deadline, batch
        self._pool = ThreadPoolExecutor(workers)
        self._ended = Event()
        self._engine: Any = None

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

    def map(self, engine: Any, units: Iterable[U]) -> Iterator[PartialResult[U, Any]]:
        """Yield the parts of all units, in the order in which their batches are done.

        Raises:
            Exception: of the engine, in the first unit that raises one, in the order of units.
        """
        self._engine = engine
        waiting = iter(units)
        at_work: list[Future[list[PartialResult[U, Any]]]] = []
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


def _done(engine: UnitEngine, batch: Iterable[U], ended: Event) -> list[PartialResult[U, Any]]:
    """The parts of some units; of fewer, once the context has ended."""
    return [
        part
        for unit in takewhile(lambda _: not ended.is_set(), batch)
        for part in _parts(engine, unit)
    ]
