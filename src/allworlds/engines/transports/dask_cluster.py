"""Units on the machines of a Dask cluster.

A task is some units with an engine and the transport on the worker; its results are whole, so a
unit whose worker is lost is done again, by another worker.  The state of a job on a worker is in
:mod:`allworlds.engines.transports.dask_lanes`; who is silent is given up by
:mod:`allworlds.engines.transports.dask_watch`.
"""

from __future__ import annotations

import asyncio
import logging
import os
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import FIRST_COMPLETED, Future, wait
from contextlib import ExitStack, suppress
from itertools import islice
from typing import Any, Self
from uuid import uuid4

from msgspec import Struct

from allworlds.engines.transports.dask_lanes import ClusterLost, Errand, LaneResult, done, end_job
from allworlds.engines.transports.dask_local import local_cluster
from allworlds.engines.transports.dask_watch import ClusterWatch
from allworlds.engines.transports.event_loop import EventLoop
from allworlds.engines.transports.inline import ThisThread
from allworlds.engines.units.effort import LOCAL, POLL, DaskCluster, check_deadline
from allworlds.engines.units.unit import PartialResult, Transport
from allworlds.inputs import INSTALL, InputError, show
from allworlds.version import __version__

_LEGAL = f"legal are the address of one, as tcp://HOST:8786, and {LOCAL}"

PATIENCE = 10.0
"""Seconds in which a scheduler must answer."""

MOMENT, WHILE = 0.2, 2.0
"""Seconds in which a cluster may take note of the end: of an interrupted job, and of another."""

AHEAD = 3
"""The number of tasks that are sent ahead for each thread of the cluster."""

LEAST, TASK = 0.04, 1.0
"""Seconds that a task takes at least and at most, as far as whole units allow: sending one takes
some thousandths of a second."""

TASKS_A_SECOND = 100
"""The largest number of tasks that the scheduler and the adding up can bear; so the tasks of a
large cluster take longer."""

GROWTH = 16
"""The assumed growth of a unit's cost at the next level, until one has been done."""

IN_SIGHT = 512
"""The number of units that are made ahead for each thread of the cluster; the fewer are left, the
fewer make a task, so that all threads end at about the same time."""


def all_well() -> str:
    """Return the empty text: a worker needs no check."""
    return ""


class Pace(Struct):
    """The number of units in a task, by the cost of earlier ones.

    Attributes:
        cost: seconds a unit, the last tasks counting most; None before the first.
    """

    cost: float | None = None

    def units(self, left: int, threads: int) -> int:
        """The number of units of the next task, given the units in sight and the threads."""
        if self.cost is None:
            return 1
        most = max(TASK, threads / TASKS_A_SECOND) / self.cost
        return max(1, int(min(most, max(LEAST / self.cost, left / (2 * threads)))))

    def begin_level(self) -> None:
        """Take note that units of the next level follow, which cost more."""
        if self.cost is not None:
            self.cost *= GROWTH

    def took(self, units: int, seconds: float | None) -> None:
        """Take note of a task's number of units and its seconds; None is ignored."""
        if seconds is None:
            return
        cost = max(seconds / units, 1e-6)
        self.cost = cost if self.cost is None else (self.cost + cost) / 2


class Dask:
    """The transport to a Dask scheduler; leaving the context cancels the unfinished tasks.

    Args:
        cluster: with the address of the scheduler.
        workers: processes of a local cluster.
        inside: makes the transport on a worker; picklable.
        probe: returns the reason against a worker, asked there once; picklable.
        order: of the units.
        deadline: on the monotonic clock, or None.

    Raises:
        InputError: if Dask is not installed.
    """

    def __init__(
        self,
        cluster: DaskCluster,
        workers: int = 1,
        deadline: float | None = None,
        inside: Callable[[], Transport[Any]] = ThisThread,
        probe: Callable[[], str] = all_well,
        order: Callable[[Iterable[Any]], Iterable[Any]] = iter,
    ) -> None:
        self._distributed = _installed()
        self._cluster, self._workers = cluster, workers
        self._inside, self._probe, self._order = inside, probe, order
        self._deadline = deadline
        self._job = uuid4().hex
        self._stack = ExitStack()
        self._pace = Pace()
        self._loop: EventLoop
        self._client: Any = None
        self._watch: ClusterWatch
        self._at_work: dict[Future[LaneResult], list[Any]] = {}

    def __enter__(self) -> Self:
        from distributed.utils import silence_logging_cmgr

        with self._stack as stack:
            # What befalls a cluster is told in one line, and not in Dask's own.
            stack.enter_context(silence_logging_cmgr(logging.CRITICAL))
            address = self._cluster.address
            if address == LOCAL:
                address = stack.enter_context(local_cluster(self._workers))
            # All is said in there, since a cluster may be silent for ever.
            self._loop = EventLoop()
            stack.push(self._leave)
            self._watch = self._loop.result(self._connected(address))
            self._stack = stack.pop_all()
        return self

    def __exit__(self, *error: object) -> None:
        raised: Any = error
        self._stack.__exit__(*raised)

    def map(self, engine: Any, units: Iterable[Any]) -> Iterator[PartialResult[Any, Any]]:
        """Yield the parts of all units, each of them whole, as they come.

        Raises:
            TimeIsUp: when the time limit has been reached.
            ClusterLost: if workers are lost again and again, or the cluster is silent.
            InputError: if a worker cannot do the job.
        """
        waiting, sight = iter(self._order(units)), deque[Any]()
        packed = Errand(self._inside, self._probe, engine).packed()
        at_work, pace = self._at_work, self._pace
        pace.begin_level()
        watched = self._loop.begin(self._watch.keep())
        try:
            while True:
                threads = max(2, self._watch.threads)
                while len(at_work) < AHEAD * threads:
                    sight.extend(islice(waiting, IN_SIGHT * threads - len(sight)))
                    number = min(len(sight), pace.units(len(sight), threads))
                    if not (batch := [sight.popleft() for _ in range(number)]):
                        break
                    task = (self._job, __version__, packed, batch)
                    at_work[self._loop.begin(self._done(task))] = batch
                if not at_work:
                    return
                if watched.done():
                    watched.result()
                for future in wait(at_work, POLL, FIRST_COMPLETED).done:
                    came = future.result()
                    pace.took(len(came.results), came.seconds)
                    for unit, result in zip(at_work.pop(future), came.results, strict=True):
                        yield PartialResult(unit, result, last=True)
                check_deadline(self._deadline)
        finally:
            watched.cancel()
            self._cancel()

    def _cancel(self) -> None:
        for future in self._at_work:
            future.cancel()
        self._at_work.clear()

    def _leave(self, kind: type[BaseException] | None, *_: object) -> None:
        self._cancel()
        # Who is in a hurry does not wait for the cluster; it notices by itself.
        patient = kind is None or issubclass(kind, Exception)
        self._loop.end(self._goodbye(), WHILE if patient else MOMENT)

    async def _goodbye(self) -> None:
        """Tell the workers and the scheduler of the end."""
        if self._client is not None:
            with suppress(Exception):
                # A worker that is lost just now need not be told.
                await self._client.run(end_job, self._job, on_error="ignore")
            await self._client.close()

    async def _connected(self, address: str) -> ClusterWatch:
        """The watch over the cluster that answers there.

        Raises:
            InputError: if none does in time.
        """
        try:
            if self._cluster.address != LOCAL:
                await _greet(address)
            self._client = self._distributed.Client(
                address, asynchronous=True, timeout=PATIENCE, set_as_default=False
            )
            await self._client
        except (OSError, ValueError, TypeError) as error:
            if isinstance(error, InputError):
                raise
            raise InputError(
                f"dask {show(address)}: no scheduler answers there: {_why(error)}; {_LEGAL}"
            ) from None
        watch = ClusterWatch(self._client, self._cluster)
        await watch.look()
        return watch

    async def _done(self, task: tuple[Any, ...]) -> LaneResult:
        from distributed.scheduler import KilledWorker

        try:
            came: LaneResult = await self._client.submit(done, *task, pure=False)
        except KilledWorker as error:
            raise ClusterLost(f"Dask workers were lost over the same units: {error}") from None
        except self._distributed.CancelledError:
            raise ClusterLost(f"{self._cluster} is gone") from None
        return came


def _why(error: Exception) -> str:
    """The reason why no scheduler answers, in a few words."""
    match error:
        case TimeoutError():
            return f"it is silent for {PATIENCE:g} s"
        case OSError():
            return error.strerror or "there is no connection"
    return "this is no address"


async def _greet(address: str) -> None:
    """Raise InputError unless a scheduler answers.

    A client of Dask waits without end for a silent one, and takes the bytes of another
    service, such as the scheduler's own dashboard, for lengths.
    """
    try:
        said = await _identity(address)
    except (OSError, ValueError, TypeError):
        raise
    except Exception:  # noqa: BLE001  # whatever others have sent
        raise InputError(
            f"dask {show(address)}: what answers there is no scheduler; {_LEGAL}"
        ) from None
    if (kind := said.get("type")) in ("Worker", "Nanny"):
        raise InputError(
            f"dask {show(address)}: a {str(kind).lower()} answers there; give the address of "
            "its scheduler"
        )


async def _identity(address: str) -> Mapping[str, Any]:
    """The identity that a server of Dask tells.

    Raises:
        Exception: any; ``TimeoutError`` if there is no answer in time.
    """
    from distributed import Security, rpc

    security = Security().get_connection_args("client")  # type: ignore[no-untyped-call]  # as above
    async with rpc(address, connection_args=security) as server:  # type: ignore[no-untyped-call]
        said: Mapping[str, Any] = await asyncio.wait_for(server.identity(), PATIENCE)
    return said


def _installed() -> Any:
    try:
        import distributed
    except ImportError:
        raise InputError(
            f"--dask needs the package distributed: {INSTALL.format('distributed')}"
        ) from None
    return distributed


def here_or(cluster: DaskCluster | None, deadline: float | None) -> Transport[Any]:
    """The transport in this thread, or to the cluster; a local one has a process a core."""
    if cluster is None:
        return ThisThread(deadline)
    return Dask(cluster, os.cpu_count() or 1, deadline)
