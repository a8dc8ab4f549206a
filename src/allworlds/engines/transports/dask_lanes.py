"""The state of a job on a Dask worker: its engine, which is sent once, and its lanes.

A *lane* is a transport that outlives the tasks of its job: as many as the worker has threads.
So the processes in which a user's explorer is played are started once, and not for each task.
"""

from __future__ import annotations

import threading
from collections import defaultdict
from collections.abc import Callable
from time import monotonic, perf_counter
from typing import Any, NamedTuple

from msgspec import Struct

from allworlds.engines.units.unit import Sum, Transport
from allworlds.inputs import InputError
from allworlds.version import __version__

IDLE = 120.0
"""Seconds after which a worker closes unused lanes; their owner may have been killed."""


class ClusterLost(Exception):
    """Raised if workers are lost again and again, or the scheduler is lost."""


class Errand(Struct, frozen=True):
    """The common part of all tasks of a level.

    Attributes:
        inside: makes the transport on a worker.
        probe: returns the reason against a worker, asked there once.
        engine: does a unit.
    """

    inside: Callable[[], Transport[Any]]
    probe: Callable[[], str]
    engine: Any

    def packed(self) -> bytes:
        """The errand as bytes; packed once for all tasks."""
        from distributed.protocol.pickle import dumps

        travels: bytes = dumps(self)  # type: ignore[no-untyped-call]  # Dask is not typed
        return travels


class LaneResult(NamedTuple):
    """The result of a task: whole results, in the order of its units, and the seconds.

    The first task of a lane tells no seconds, since it spends most of them on starting the lane.
    """

    results: list[Any]
    seconds: float | None


class _Lanes:
    """The state of one job on a worker."""

    def __init__(self) -> None:
        self.errands: dict[bytes, Errand] = {}
        self.idle: list[Transport[Any]] = []
        self.ended = self.watched = False
        self.well = False
        self.used = monotonic()

    def errand(self, packed: bytes) -> Errand:
        """The errand of the job; unpacked once."""
        if packed not in self.errands:
            from distributed.protocol.pickle import loads

            self.errands[packed] = loads(packed)  # type: ignore[no-untyped-call]  # as above
        return self.errands[packed]


_JOBS: defaultdict[str, _Lanes] = defaultdict(_Lanes)
_TURN = threading.Lock()


def done(job: str, version: str, packed: bytes, batch: list[Any]) -> LaneResult:
    """Do some units; return their results, each whole.

    Args:
        job: name; every job has its own lanes.
        version: of the package, where the job comes from.
        packed: an :class:`Errand`.
        batch: the units.

    Raises:
        InputError: if this worker cannot do the job.
        ClusterLost: if the job has ended.
    """
    errand, lane = _lane(job, version, packed)
    new = lane is None
    if lane is None:
        lane = errand.inside().__enter__()
    began = perf_counter()
    results: dict[str, Sum] = {}
    try:
        for part in lane.map(errand.engine, batch):
            _go_on(job)
            key = part.unit.key
            if key in results:
                results[key].add(part.result)
            else:
                results[key] = part.result
    except BaseException:
        lane.__exit__(None, None, None)
        raise
    _give_back(job, lane)
    return LaneResult(
        [results[unit.key] for unit in batch], None if new else perf_counter() - began
    )


def end_job(job: str) -> None:
    """Cancel all work for a job on this worker."""
    lanes = _JOBS[job]
    lanes.ended = True
    for errand in list(lanes.errands.values()):
        if halt := getattr(errand.engine, "halt", None):
            halt()
    lanes.errands.clear()
    _close_idle(job)


def _go_on(job: str) -> None:
    if _JOBS[job].ended:
        raise ClusterLost("the job has ended")


def _lane(job: str, version: str, packed: bytes) -> tuple[Errand, Transport[Any] | None]:
    """The errand, and an idle lane; None if there is no idle one."""
    with _TURN:
        _go_on(job)
        lanes = _JOBS[job]
        if not lanes.well and version != __version__:
            raise _unfit(f"has allworlds {__version__}, not {version}")
        errand = lanes.errand(packed)
        if not lanes.well and (said := errand.probe()):
            raise _unfit(said)
        lanes.well = True
        return errand, lanes.idle.pop() if lanes.idle else None


def _unfit(said: str) -> InputError:
    from distributed import get_worker

    return InputError(f"the Dask worker {get_worker().address}: {said}")


def _give_back(job: str, lane: Transport[Any]) -> None:
    with _TURN:
        lanes = _JOBS[job]
        lanes.used = monotonic()
        lanes.idle.append(lane)
        if not lanes.ended and not lanes.watched:
            lanes.watched = True
            _look_in(job, IDLE)
    if lanes.ended:
        _close_idle(job)


def _look_in(job: str, seconds: float) -> None:
    """Check after some time whether the lanes are still used."""
    timer = threading.Timer(seconds, _close_unused, (job,))
    timer.daemon = True
    timer.start()


def _close_unused(job: str) -> None:
    """Close the lanes if they were unused for too long, else check again later."""
    lanes = _JOBS[job]
    with _TURN:
        left = lanes.used + IDLE - monotonic()
        lanes.watched = left > 0 and not lanes.ended
        if lanes.watched:
            _look_in(job, left)
            return
        lanes.errands.clear()
    _close_idle(job)


def _close_idle(job: str) -> None:
    with _TURN:
        idle, _JOBS[job].idle = _JOBS[job].idle, []
    for lane in idle:
        lane.__exit__(None, None, None)
