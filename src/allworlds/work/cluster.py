"""Units on the machines of a Dask cluster.

A task is some units with an engine and a way to have it done; what comes back are whole results,
and so a unit whose worker is lost is simply done again, by another one.  On a worker a *lane* is a
transport that outlives the tasks of its job: as many as the worker has threads.
"""

from __future__ import annotations

import threading
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator
from contextlib import ExitStack, suppress
from itertools import islice
from time import monotonic
from typing import Any, Self
from uuid import uuid4

from allworlds.inputs import InputError, show
from allworlds.version import __version__
from allworlds.work.effort import POLL, check_deadline
from allworlds.work.here import Here
from allworlds.work.work import Part, Sum, Transport

LOCAL = "local"
"""In place of an address: a cluster of this machine alone, which is started and ended."""

PATIENCE = 10.0
"""Seconds in which a scheduler must answer."""

IDLE = 120.0
"""Seconds after which a worker closes lanes that nobody uses; their owner may have been killed."""

TRIES = 3
"""So often it is tried to speak with a scheduler."""

AHEAD = 3
"""For each thread of the cluster so many tasks are on their way."""


class Lost(Exception):
    """Workers were lost again and again, or the scheduler was."""


def all_well() -> str:
    """What speaks against a worker: nothing."""
    return ""


class Dask:
    """The transport to a Dask scheduler; whoever leaves the context cancels what is not done.

    Args:
        scheduler: its address, or :data:`LOCAL`.
        workers: processes of a local cluster.
        inside: on a worker, how units get to the engine there; picklable.
        probe: what speaks against a worker, asked there once; picklable.
        order: of the units.
        batch: units of a task.
        deadline: on the monotonic clock, or None.

    Raises:
        InputError: if Dask is not installed.
    """

    def __init__(
        self,
        scheduler: str,
        workers: int = 1,
        deadline: float | None = None,
        batch: int = 1,
        inside: Callable[[], Transport[Any]] = Here,
        probe: Callable[[], str] = all_well,
        order: Callable[[Iterable[Any]], Iterable[Any]] = iter,
    ) -> None:
        self._distributed = _installed()
        self._scheduler, self._workers = scheduler, workers
        self._inside, self._probe, self._order = inside, probe, order
        self._batch, self._deadline = batch, deadline
        self._job = uuid4().hex
        self._stack = ExitStack()
        self._client: Any = None
        self._threads, self._looked = 0, 0.0

    def __enter__(self) -> Self:
        with self._stack as stack:
            address: Any = self._scheduler
            if address == LOCAL:
                address = stack.enter_context(_local_cluster(self._distributed, self._workers))
            self._client = stack.enter_context(self._connected(address))
            self._stack = stack.pop_all()
        return self

    def __exit__(self, *_: object) -> None:
        with self._stack, suppress(Exception):
            # A worker that is lost just now need not be told.
            self._client.run(end_job, self._job, on_error="ignore")

    def map(self, engine: Any, units: Iterable[Any]) -> Iterator[Part[Any, Any]]:
        """The parts of all units, each of them whole, as they come.

        Raises:
            TimeIsUp: when the time limit has been reached.
            Lost: if workers are lost again and again.
            InputError: if a worker cannot do it.
        """
        waiting = iter(self._order(units))
        at_work: dict[Any, list[Any]] = {}
        try:
            while True:
                while len(at_work) < self._window() and (batch := [*islice(waiting, self._batch)]):
                    task = (self._job, __version__, self._inside, self._probe, engine, batch)
                    at_work[self._client.submit(done, *task, pure=False)] = batch
                if not at_work:
                    return
                for future in self._finished(at_work):
                    results = self._result(future)
                    for unit, result in zip(at_work.pop(future), results, strict=True):
                        yield Part(unit, result, last=True)
                check_deadline(self._deadline)
        finally:
            if at_work:
                self._client.cancel(list(at_work))

    def _connected(self, address: Any) -> Any:
        try:
            return self._client_of(address)
        except (OSError, ValueError, TypeError) as error:
            raise InputError(
                f"dask {show(self._scheduler)}: no scheduler answers there "
                f"({type(error).__name__}); legal are the address of one, as "
                f"tcp://HOST:8786, and {LOCAL}"
            ) from None

    def _client_of(self, address: Any) -> Any:
        for _ in range(TRIES - 1):
            # A thread of it that does not begin within ten seconds, on a busy machine, it takes
            # for a mistake of its own.
            with suppress(AssertionError):
                return self._distributed.Client(address, timeout=PATIENCE)
        return self._distributed.Client(address, timeout=PATIENCE)

    def _window(self) -> int:
        """How many tasks may be on their way; workers come and go."""
        if monotonic() > self._looked + 1:
            self._threads = sum(self._client.nthreads().values())
            self._looked = monotonic()
        return AHEAD * max(self._threads, 2)

    def _finished(self, at_work: Iterable[Any]) -> list[Any]:
        """Those that have come back; after a moment none."""
        try:
            told = self._distributed.wait(list(at_work), POLL, return_when="FIRST_COMPLETED")
        except TimeoutError:
            return []
        return list(told.done)

    def _result(self, future: Any) -> list[Any]:
        from distributed.scheduler import KilledWorker

        try:
            results: list[Any] = future.result()
        except KilledWorker as error:
            raise Lost(f"Dask workers were lost over the same units: {error}") from None
        except self._distributed.CancelledError:
            raise Lost(f"the Dask scheduler {self._scheduler} is gone") from None
        return results


def _installed() -> Any:
    try:
        import distributed
    except ImportError:
        raise InputError(
            "--dask needs the package distributed: pip install 'allworlds[distributed]'"
        ) from None
    return distributed


def _local_cluster(distributed: Any, workers: int) -> Any:
    # Without an address of its own the scheduler would ask for port 8787, which others may have.
    address = "127.0.0.1:0"
    return distributed.LocalCluster(
        n_workers=workers, threads_per_worker=1, dashboard_address=address, silence_logs=50
    )


# ---------------------------------------------------------------- on a worker


class _Lanes:
    """What a worker has of one job."""

    def __init__(self) -> None:
        self.idle: list[Transport[Any]] = []
        self.at_work: list[Any] = []
        self.ended = False
        self.well = False
        self.used = monotonic()


_JOBS: defaultdict[str, _Lanes] = defaultdict(_Lanes)
_TURN = threading.Lock()


def done(
    job: str,
    version: str,
    inside: Callable[[], Transport[Any]],
    probe: Callable[[], str],
    engine: Any,
    batch: list[Any],
) -> list[Any]:
    """The results of some units, each whole, in their order."""
    lane = _lane(job, version, inside, probe)
    lanes = _JOBS[job]
    lanes.at_work.append(engine)
    results: dict[str, Sum] = {}
    try:
        for part in lane.map(engine, batch):
            _go_on(lanes)
            key = part.unit.key
            if key in results:
                results[key].add(part.result)
            else:
                results[key] = part.result
    except BaseException:
        lane.__exit__(None, None, None)
        raise
    else:
        _give_back(job, lane)
    finally:
        lanes.at_work.remove(engine)
    return [results[unit.key] for unit in batch]


def _go_on(lanes: _Lanes) -> None:
    if lanes.ended:
        raise Lost("the job has ended")


def end_job(job: str) -> None:
    """Give up whatever is being done for a job on this worker."""
    lanes = _JOBS[job]
    lanes.ended = True
    for engine in list(lanes.at_work):
        if halt := getattr(engine, "halt", None):
            halt()
    _close_idle(job)


def _lane(
    job: str, version: str, inside: Callable[[], Transport[Any]], probe: Callable[[], str]
) -> Transport[Any]:
    with _TURN:
        lanes = _JOBS[job]
        if not lanes.well:
            said = f"has allworlds {__version__}, not {version}" if version != __version__ else ""
            if said := said or probe():
                raise InputError(f"the Dask worker {_address()}: {said}")
            lanes.well = True
        if lanes.idle:
            return lanes.idle.pop()
    return inside().__enter__()


def _give_back(job: str, lane: Transport[Any]) -> None:
    with _TURN:
        lanes = _JOBS[job]
        lanes.used = monotonic()
        lanes.idle.append(lane)
    if lanes.ended:
        _close_idle(job)
    else:
        timer = threading.Timer(IDLE, _close_unused, (job,))
        timer.daemon = True
        timer.start()


def _close_unused(job: str) -> None:
    if monotonic() - _JOBS[job].used >= IDLE:
        _close_idle(job)


def _close_idle(job: str) -> None:
    with _TURN:
        idle, _JOBS[job].idle = _JOBS[job].idle, []
    for lane in idle:
        lane.__exit__(None, None, None)


def _address() -> str:
    from distributed import get_worker

    address: str = get_worker().address
    return address
