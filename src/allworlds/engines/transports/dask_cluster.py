"""Units on the machines of a Dask cluster.

A task is some units with an engine and a way to have it done; what comes back are whole results,
and so a unit whose worker is lost is simply done again, by another one.  What a worker has of a
job is in :mod:`allworlds.engines.transports.dask_lanes`.
"""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from itertools import islice
from time import monotonic
from typing import Any, Self
from uuid import uuid4

from allworlds.engines.transports.dask_lanes import ClusterLost, Errand, LaneResult, done, end_job
from allworlds.engines.transports.inline import ThisThread
from allworlds.engines.units.effort import POLL, check_deadline
from allworlds.engines.units.unit import PartialResult, Transport
from allworlds.inputs import InputError, show
from allworlds.version import __version__

LOCAL = "local"
"""In place of an address: a cluster of this machine alone, which is started and ended."""

_LEGAL = f"legal are the address of one, as tcp://HOST:8786, and {LOCAL}"

PATIENCE = 10.0
"""Seconds in which a scheduler must answer."""

TRIES = 3
"""So often it is tried to speak with a scheduler."""

AHEAD = 3
"""For each thread of the cluster so many tasks are on their way."""

LEAST, TASK = 0.04, 1.0
"""Seconds that a task takes at least and at most, as far as whole units allow: to send one costs
some thousandths of a second."""

TASKS_A_SECOND = 100
"""More of them a scheduler, and whoever adds up, had better not be given; so the tasks of a large
cluster take longer."""

GROWTH = 16
"""A unit of the next level is thought to cost so many times as much, until one has been done."""

IN_SIGHT = 512
"""For each thread of the cluster so many units are looked for beforehand; the fewer are left, the
fewer make a task, so that all threads end at about the same time."""

QUIET = {
    "distributed.worker.profile.enabled": False,
    "distributed.admin.tick.interval": "500ms",
    "distributed.admin.system-monitor.interval": "2s",
}
"""What a local cluster is started with: by itself Dask looks a hundred times a second at what each
worker does, for a page that nobody sees here."""


def all_well() -> str:
    """What speaks against a worker: nothing."""
    return ""


@dataclass(slots=True)
class Pace:
    """How many units make a task, by what others have cost so far.

    Attributes:
        cost: seconds a unit, the last tasks counting most; None before the first.
    """

    cost: float | None = None

    def units(self, left: int, threads: int) -> int:
        """The next task's, where so many are in sight, for a cluster with so many threads."""
        if self.cost is None:
            return 1
        most = max(TASK, threads / TASKS_A_SECOND) / self.cost
        return max(1, int(min(most, max(LEAST / self.cost, left / (2 * threads)))))

    def begin_level(self) -> None:
        """Other units follow, which cost more."""
        if self.cost is not None:
            self.cost *= GROWTH

    def took(self, units: int, seconds: float | None) -> None:
        """A task of so many units took so long; None says nothing."""
        if seconds is None:
            return
        cost = max(seconds / units, 1e-6)
        self.cost = cost if self.cost is None else (self.cost + cost) / 2


class Dask:
    """The transport to a Dask scheduler; whoever leaves the context cancels what is not done.

    Args:
        scheduler: its address, or :data:`LOCAL`.
        workers: processes of a local cluster.
        inside: on a worker, how units get to the engine there; picklable.
        probe: what speaks against a worker, asked there once; picklable.
        order: of the units.
        deadline: on the monotonic clock, or None.

    Raises:
        InputError: if Dask is not installed.
    """

    def __init__(
        self,
        scheduler: str,
        workers: int = 1,
        deadline: float | None = None,
        inside: Callable[[], Transport[Any]] = ThisThread,
        probe: Callable[[], str] = all_well,
        order: Callable[[Iterable[Any]], Iterable[Any]] = iter,
    ) -> None:
        self._distributed = _installed()
        self._scheduler, self._workers = scheduler, workers
        self._inside, self._probe, self._order = inside, probe, order
        self._deadline = deadline
        self._job = uuid4().hex
        self._stack = ExitStack()
        self._client: Any = None
        self._threads, self._looked = 0, 0.0
        self._pace = Pace()

    def __enter__(self) -> Self:
        with self._stack as stack:
            address: Any = self._scheduler
            if address == LOCAL:
                address = stack.enter_context(local_cluster(self._workers))
            self._client = stack.enter_context(self._connected(address))
            self._stack = stack.pop_all()
        return self

    def __exit__(self, *_: object) -> None:
        with self._stack, suppress(Exception):
            # A worker that is lost just now need not be told.
            self._client.run(end_job, self._job, on_error="ignore")

    def map(self, engine: Any, units: Iterable[Any]) -> Iterator[PartialResult[Any, Any]]:
        """The parts of all units, each of them whole, as they come.

        Raises:
            TimeIsUp: when the time limit has been reached.
            ClusterLost: if workers are lost again and again.
            InputError: if a worker cannot do it.
        """
        waiting, sight = iter(self._order(units)), deque[Any]()
        packed = Errand(self._inside, self._probe, engine).packed()
        at_work: dict[Any, list[Any]] = {}
        pace = self._pace
        pace.begin_level()
        try:
            while True:
                while len(at_work) < AHEAD * self._counted():
                    sight.extend(islice(waiting, IN_SIGHT * self._threads - len(sight)))
                    number = min(len(sight), pace.units(len(sight), self._threads))
                    if not (batch := [sight.popleft() for _ in range(number)]):
                        break
                    task = (self._job, __version__, packed, batch)
                    at_work[self._client.submit(done, *task, pure=False)] = batch
                if not at_work:
                    return
                for future in self._finished(at_work):
                    came = self._result(future)
                    pace.took(len(came.results), came.seconds)
                    for unit, result in zip(at_work.pop(future), came.results, strict=True):
                        yield PartialResult(unit, result, last=True)
                check_deadline(self._deadline)
        finally:
            if at_work:
                self._client.cancel(list(at_work))

    def _connected(self, address: Any) -> Any:
        try:
            if self._scheduler != LOCAL:
                self._greet(address)
            return self._client_of(address)
        except InputError:
            raise
        except (OSError, ValueError, TypeError) as error:
            raise InputError(
                f"dask {show(self._scheduler)}: no scheduler answers there "
                f"({type(error).__name__}); {_LEGAL}"
            ) from None

    def _greet(self, address: str) -> None:
        """Nothing, if a scheduler answers in time.

        A client itself waits without end for one that is silent, and takes the words of another
        service, as of the scheduler's own dashboard, for lengths.
        """
        with ThreadPoolExecutor(1) as apart:  # a notebook has a loop in this thread
            try:
                said = apart.submit(asyncio.run, _identity(address)).result()
            except (OSError, ValueError, TypeError):
                raise
            except Exception as error:  # noqa: BLE001  # whatever others have sent
                raise InputError(
                    f"dask {show(address)}: what answers there is no scheduler "
                    f"({type(error).__name__}); {_LEGAL}"
                ) from None
        if (kind := said.get("type")) in ("Worker", "Nanny"):
            raise InputError(
                f"dask {show(address)}: a {str(kind).lower()} answers there; give the address of "
                "its scheduler"
            )

    def _client_of(self, address: Any) -> Any:
        for _ in range(TRIES - 1):
            # A thread of it that does not begin within ten seconds, on a busy machine, it takes
            # for a mistake of its own.
            with suppress(AssertionError):
                return self._distributed.Client(address, timeout=PATIENCE)
        return self._distributed.Client(address, timeout=PATIENCE)

    def _counted(self) -> int:
        """The threads of the cluster, counted once a second; workers come and go."""
        if monotonic() > self._looked + 1:
            self._threads = max(2, sum(self._client.nthreads().values()))
            self._looked = monotonic()
        return self._threads

    def _finished(self, at_work: Iterable[Any]) -> list[Any]:
        """Those that have come back; after a moment none."""
        try:
            told = self._distributed.wait(list(at_work), POLL, return_when="FIRST_COMPLETED")
        except TimeoutError:
            return []
        return list(told.done)

    def _result(self, future: Any) -> LaneResult:
        from distributed.scheduler import KilledWorker

        try:
            came: LaneResult = future.result()
        except KilledWorker as error:
            raise ClusterLost(f"Dask workers were lost over the same units: {error}") from None
        except self._distributed.CancelledError:
            raise ClusterLost(f"the Dask scheduler {self._scheduler} is gone") from None
        return came


async def _identity(address: str) -> Mapping[str, Any]:
    """What a server of Dask says that it is.

    Raises:
        Exception: any; ``TimeoutError`` if it says nothing in time.
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
            "--dask needs the package distributed: pip install 'allworlds[distributed]'"
        ) from None
    return distributed


@contextmanager
def local_cluster(workers: int) -> Iterator[Any]:
    """A cluster of so many processes on this machine, each with one thread; it ends with it.

    Raises:
        InputError: if Dask is not installed.
    """
    distributed = _installed()
    import dask

    # Without an address of its own the scheduler would ask for port 8787, which others may have.
    address = "127.0.0.1:0"
    with (
        dask.config.set(QUIET),
        distributed.LocalCluster(
            n_workers=workers, threads_per_worker=1, dashboard_address=address, silence_logs=50
        ) as cluster,
    ):
        yield cluster
