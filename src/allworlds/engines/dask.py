"""Units on the workers of a Dask cluster.

This process sends *tasks* to the workers; in this module a task is some units, with the engine that
does them, and with a function.  Called on a worker, the function makes a transport: an object that
brings units to the engine there, see :mod:`allworlds.engines.units`.  For a user's explorer the
transport holds one lane, and so this module calls each such transport a *lane*. A worker keeps its
lanes for later tasks, so that each thread of the worker starts a user's explorer only once.  A task
returns the whole results of its units.  If a worker is lost, another worker does its tasks again.
"""

import asyncio
import logging
import os
import subprocess
import sys
from collections.abc import Callable, Coroutine, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, wait
from contextlib import ExitStack, contextmanager, suppress
from functools import lru_cache
from itertools import islice, takewhile
from tempfile import TemporaryDirectory
from threading import Lock, Timer
from time import monotonic, perf_counter
from typing import Any, NoReturn, Self
from uuid import uuid4

from allworlds.engines.engine_table import ThisThread
from allworlds.engines.limits import LOCAL, POLL, ClusterLost, check_deadline
from allworlds.engines.units import PartialResult, Sum, Transport
from allworlds.inputs.checks import InputError, ensure_installed, show
from allworlds.version import __version__

PATIENCE, SILENCE, IDLE = 10.0, 60.0, 120.0
"""Seconds in which a scheduler must first answer; seconds after which a silent scheduler or worker
is given up; seconds after which unused lanes are closed."""


class Dask:
    """Brings units to a Dask cluster; the end of the ``with`` block cancels unfinished tasks.

    Args:
        address: the address of the scheduler, or :data:`LOCAL` for a new cluster on this machine.
        workers: the number of processes of the new cluster.
        deadline: the end of the time limit, on the monotonic clock; or None.
        inside: the picklable function that makes the transport within a worker.
        probe: the picklable function that returns the reason why a worker cannot do the job, or
            an empty text.
        order: the function that puts the units into the order in which they are sent.
    """

    def __init__(
        self,
        address: str,
        workers: int = 1,
        deadline: float | None = None,
        inside: Callable[[], Transport] = ThisThread,
        probe: Callable[[], str] = str,
        order: Callable[[Iterable[Any]], Iterable[Any]] = iter,
    ) -> None:
        ensure_installed("distributed", "distributed", "--dask")
        import distributed

        self._distributed: Any = distributed
        self._address, self._workers, self._deadline = address, workers, deadline
        self._named = f"the Dask scheduler {address}"
        self._inside, self._probe, self._order = inside, probe, order
        self._stack: Any = ExitStack()
        self._job, self._threads = uuid4().hex, 0
        self._cost = 1.0  # seconds a unit, the last tasks counting most

    def __enter__(self) -> Self:
        utils, address = self._distributed.utils, self._address
        with self._stack as stack:
            # An error of a cluster is reported in one line, without Dask's own logs.
            stack.enter_context(utils.silence_logging_cmgr(logging.CRITICAL))
            if address == LOCAL:
                address = stack.enter_context(local_cluster(self._workers))
            # The loop's thread alone waits for the cluster, so that the caller can be interrupted.
            self._runner = utils.LoopRunner()
            self._runner.start()
            stack.callback(self._runner.stop)
            self._begin(self._connect(address)).result()
            stack.push(self._leave)
            self._watched = self._begin(self._watch())
            self._stack = stack.pop_all()
        return self

    def __exit__(self, *error: object) -> None:
        self._stack.__exit__(*error)

    def map(self, engine: Any, units: Iterable[Any]) -> Iterator[PartialResult]:
        """Yield the whole result of each unit, in the order in which the results are ready.

        Raises:
            TimeIsUp: when the time limit has been reached.
            ClusterLost: if workers are lost again and again, or the cluster is silent.
            InputError: if a worker cannot do the job.
        """
        waiting, at_work = iter(self._order(units)), dict[Future[Any], list[Any]]()
        packed = self._distributed.protocol.pickle.dumps((self._inside, self._probe, engine))
        self._cost *= 16  # as it grows with a level
        while True:
            while len(at_work) < 3 * max(2, self._threads):
                # A task itself costs some milliseconds; a scheduler does a hundred a second.
                number = int(max(0.25, self._threads / 100) / self._cost)
                if not (batch := [*islice(waiting, max(1, number))]):
                    break
                at_work[self._begin(self._done(self._job, __version__, packed, batch))] = batch
            if not at_work:
                return
            for future in wait([*at_work, self._watched], POLL, FIRST_COMPLETED).done:
                results, seconds = future.result()  # of the watch, its error
                batch = at_work.pop(future)
                self._cost = (self._cost + seconds / len(batch)) / 2
                for unit, result in zip(batch, results, strict=True):
                    yield PartialResult(unit, result, last=True)
            check_deadline(self._deadline)

    def _begin(self, work: Coroutine[Any, Any, Any]) -> Future[Any]:
        return asyncio.run_coroutine_threadsafe(work, self._runner.loop.asyncio_loop)

    def _leave(self, kind: type[BaseException] | None, *_: object) -> None:
        # After an interrupt the caller does not wait long: the cluster notices the end by itself.
        seconds = 2.0 if kind is None or issubclass(kind, Exception) else 0.2
        with suppress(Exception):
            self._runner.run_sync(self._goodbye, callback_timeout=seconds)

    async def _goodbye(self) -> None:
        await self._client.run(end_job, self._job, on_error="ignore")
        await self._client.close()

    async def _connect(self, address: str) -> None:
        distributed, kind, why = self._distributed, "", f"it is silent for {PATIENCE:g} s"
        security = distributed.Security().get_connection_args("client")
        try:
            # A Dask client would wait forever for a silent scheduler.
            async with distributed.rpc(address, connection_args=security) as server:
                kind = (await asyncio.wait_for(server.identity(), PATIENCE))["type"]
            why = f"a {kind.lower()} answers there, which is no scheduler"
        except Exception as error:  # noqa: BLE001  # whatever another service has sent
            why = f"no scheduler answers there: {str(error) or why}"
        if kind != "Scheduler":
            legal = f"legal are the address of one, as tcp://HOST:8786, and {LOCAL}"
            raise InputError(f"dask {show(address)}: {why}; {legal}")
        self._client = await distributed.Client(address, asynchronous=True, set_as_default=False)

    async def _watch(self) -> NoReturn:
        """Watch the workers as long as the cluster is in use.

        Each second the number of threads of all workers is written to ``self._threads``, from which
        :meth:`map` computes the number and the size of tasks.  A worker that has sent the scheduler
        no heartbeat for :data:`SILENCE` seconds is given up, even if its connection is still open.

        Raises:
            ClusterLost: if the scheduler or all workers are silent for too long, or if the
                scheduler is gone.
        """
        scheduler, limit = self._client.scheduler, SILENCE
        silence = f"for {limit:g} s"
        heard, beats = monotonic(), dict[tuple[str, float], float]()
        try:
            while True:
                workers = (await asyncio.wait_for(scheduler.identity(), limit))["workers"]
                seen = [(name, worker["last_seen"]) for name, worker in workers.items()]
                now = monotonic()
                beats = {beat: beats.get(beat, now) for beat in seen}
                heard = max([heard, *beats.values()])
                if now - heard > limit:
                    raise ClusterLost(f"no worker of {self._named} gave a sign of life {silence}")
                for (name, _), since in beats.items():
                    if now - since > limit:
                        del workers[name]
                        ended = scheduler.unregister(address=name, stimulus_id="silent")
                        await asyncio.wait_for(ended, limit)
                self._threads = sum(worker["nthreads"] for worker in workers.values())
                await asyncio.sleep(1)
        except TimeoutError:
            raise ClusterLost(f"{self._named} gave no sign of life {silence}") from None
        except OSError:
            raise ClusterLost(f"{self._named} is gone") from None

    async def _done(self, *task: Any) -> Any:
        try:
            return await self._client.submit(done, *task, pure=False)
        except self._distributed.scheduler.KilledWorker as error:
            raise ClusterLost(f"Dask workers were lost over the same units: {error}") from None
        except self._distributed.CancelledError:
            raise ClusterLost(f"{self._named} is gone") from None


@lru_cache(8)
def _unpacked(job: str, version: str, packed: bytes) -> tuple[Any, Any]:  # noqa: ARG001  # each its own
    """A pair: the function that makes lanes on this worker, and the engine.

    All tasks of a level have the same bytes; so the pair is cached.

    Args:
        job: the name of the job, so that each job has a pair of its own.
        version: the version of allworlds that has sent the task.
        packed: as bytes, the function that makes lanes, the function that returns the reason why
            this worker cannot do the job, and the engine.

    Raises:
        InputError: if the worker has another version, or cannot do the job.
    """
    from distributed import get_worker, protocol

    said = f"has allworlds {__version__}, not {version}"
    if version == __version__:
        inside, probe, engine = protocol.pickle.loads(packed)  # type: ignore[no-untyped-call]  # Dask is not typed
        if not (said := probe()):
            return inside, engine
    raise InputError(f"the Dask worker {get_worker().address}: {said}")


class _Job:
    """The state of one job on a worker: its engine, its idle lanes, and whether it has ended."""

    def __init__(self) -> None:
        self.turn, self.timer = Lock(), Timer(IDLE, self.close)
        self.idle: list[Transport] = []
        self.ended, self.engine = False, None

    def close(self) -> None:
        """Close the idle lanes."""
        with self.turn:
            idle, self.idle = self.idle, []
        for lane in idle:
            lane.__exit__(None, None, None)


_JOBS: dict[str, _Job] = {}


def done(job: str, version: str, packed: bytes, batch: list[Any]) -> tuple[list[Any], float]:
    """Do some units on a worker; return their results, and the seconds that the work took.

    Args:
        job: the name of the job.
        version: the version of allworlds that has sent the task.
        packed: the engine and two functions as bytes, see :func:`_unpacked`.
        batch: the units.

    Raises:
        InputError: if this worker cannot do the job.
        ClusterLost: if the job has ended meanwhile, so that nobody needs these results.
    """
    state, began, results = _JOBS.setdefault(job, _Job()), perf_counter(), dict[str, Sum]()
    with state.turn:
        if state.ended:
            raise ClusterLost("the job has ended")
        inside, engine = _unpacked(job, version, packed)
        lane = state.idle.pop() if state.idle else inside().__enter__()
        state.engine = engine
    try:
        for part in takewhile(lambda _: not state.ended, lane.map(engine, batch)):
            if part.anew:
                results.pop(part.unit.key, None)
            whole = results.setdefault(part.unit.key, part.result)
            if whole is not part.result:
                whole.add(part.result)
    except BaseException:
        lane.__exit__(None, None, None)
        raise
    with state.turn:
        state.idle.append(lane)
        state.timer.cancel()
        state.timer = Timer(0 if state.ended else IDLE, state.close)
        state.timer.daemon = True  # the owner may have been killed
        state.timer.start()
    if state.ended:
        raise ClusterLost("the job has ended")
    return [results[unit.key] for unit in batch], perf_counter() - began


def end_job(job: str) -> None:
    """Cancel all work for a job on this worker."""
    state = _JOBS.setdefault(job, _Job())
    state.ended = True
    getattr(state.engine, "halt", int)()
    state.close()


@contextmanager
def local_cluster(workers: int) -> Iterator[str]:
    """A context with the address of a new cluster on this machine, with this number of workers.

    All processes of the cluster descend from one process.  So at the end of the context all of them
    are found and killed, even if they no longer answer.
    """
    start = f"import sys; sys.path[:] = {sys.path}; from {__name__} import serve; serve({workers})"
    with TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        process: Any = subprocess.Popen(  # noqa: S603  # our own module
            [sys.executable, "-P", "-W", "ignore", "-c", start],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            # By default Dask samples each worker a hundred times a second.
            env=os.environ
            | {"DASK_DISTRIBUTED__WORKER__PROFILE__ENABLED": "False"}
            | {"DASK_TEMPORARY_DIRECTORY": folder},
            start_new_session=True,  # only the owner gets a Ctrl-C
        )
        try:
            if not (address := process.stdout.readline().decode().strip()):
                raise ClusterLost("the local Dask cluster has not started")
            yield address
        finally:
            import psutil  # comes with distributed

            cluster = psutil.Process(process.pid)
            for one in (*cluster.children(recursive=True), cluster):
                one.kill()
            process.communicate()


def serve(workers: int) -> None:
    """Start a cluster with this number of workers, and print its address.

    The cluster ends when stdin ends.

    This is the program of the process that :func:`local_cluster` starts.
    """
    from distributed import LocalCluster

    stdout = os.dup(1)
    os.dup2(2, 1)  # the owner must not read what workers print
    more = {"dashboard_address": "127.0.0.1:0", "silence_logs": logging.CRITICAL}
    with LocalCluster(n_workers=workers, threads_per_worker=1, **more) as cluster:  # type: ignore[no-untyped-call]
        os.write(stdout, f"{cluster.scheduler_address}\n".encode())
        sys.stdin.read()
