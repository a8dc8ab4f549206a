"""The transport that brings units to lanes, in this process and in forked processes.

A lane is a judge with its two players.  In general one lane is in this process.  But if the user
has written a lighthouse, a *task* or a *condition*, all lanes are forked, because this code could
end its process.  A task is the demand on a run; by default, to answer with the map.  A condition is
a property of maps that selects the worlds.  :func:`workers_for` lists all cases in which no lane is
in this process.

With several workers, the lane in this process begins first, because a small job ends before forked
lanes are ready.  Lanes are forked after everything is loaded.  If a forked lane ends too early,
other lanes do its units again.  A lane gets one unit at a time, as soon as the lane can begin that
unit.
"""

from __future__ import annotations

import gc
import os
import signal
import sys
import time
import traceback
import warnings
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from itertools import islice
from random import Random
from typing import TYPE_CHECKING, Any, NoReturn, Self

from msgspec import Struct, field

from allworlds.engines import linux, players, tally
from allworlds.engines.lane import Lane
from allworlds.engines.limits import POLL, Limits, check_deadline
from allworlds.engines.units import AcrossUnit, PartialResult, Transport, UnitOfRuns
from allworlds.explorers.loading import Subject
from allworlds.inputs.checks import (
    INTERRUPTS,
    InputError,
    interrupts_held,
    leave_interrupts_to_owner,
)
from allworlds.words import ended_by

if TYPE_CHECKING:
    from multiprocessing.connection import Connection  # loaded where there are processes

AT_A_TIME = 4096
"""The number of units that are put into a random order at a time."""

MOST_ATTEMPTS = 2
"""The job is given up once this number of lanes has ended too early with the same unit."""

AHEAD = 2
"""The largest number of units that a forked lane has at a time."""

ALONE = 1.5
"""Seconds from the beginning during which the lane of this process is the only lane."""

FIRST_LEVELS = 0.8
"""Seconds from the beginning during which the lane of this process may begin a level.

Forked lanes do the levels that begin later.
"""

_KNOWN = (InputError, players.Unsettled, tally.EnginesDisagree, players.HarnessError)


class _Process:
    """A lane in a process of its own, which was forked from this process, the owner.

    Args:
        lanes: the object that brings units to lanes; its field ``make`` makes the lane.
        others: the forked lanes that exist already; the new process closes its copies of their
            links.
    """

    def __init__(self, lanes: Lanes, others: Sequence[_Process]) -> None:
        from multiprocessing.connection import Pipe

        self.link, theirs = Pipe()
        self.units: list[UnitOfRuns] = []  # a unit may occur twice
        for stream in (sys.stdout, sys.stderr):
            with suppress(Exception):
                stream.flush()
        gc.freeze()
        parent = os.getpid()
        with interrupts_held():  # an interrupted fork would go on with its owner's program
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", DeprecationWarning)  # other threads take no part
                self.pid = os.fork()
            if self.pid == 0:
                linux.end_with_parent(parent)
                for other in (self, *others):  # so that each link closes when the owner ends
                    other.link.close()
                _serve(theirs, lanes, first_lane=not others)
        gc.unfreeze()
        theirs.close()

    def end(self) -> str:
        """End the process and its players; return in words how the process ended."""
        self.link.close()
        code = linux.ended_within(2.0, self.pid)
        if code is None:
            for each in (self.pid, *linux.descendants(self.pid)):
                with suppress(ProcessLookupError, PermissionError):
                    os.kill(each, signal.SIGKILL)
            _, status = os.waitpid(self.pid, 0)
            code = os.waitstatus_to_exitcode(status)
        return ended_by(code)


def _heard(processes: Sequence[_Process], seconds: float) -> list[_Process]:
    """Wait at most these seconds for messages; return the processes that have sent messages."""
    if not processes:
        return []
    from multiprocessing.connection import wait

    by_link = {process.link: process for process in processes}
    return [by_link[link] for link in wait([*by_link], seconds)]  # type: ignore[index]  # its own


class Lanes(Struct):
    """Brings units to lanes: one lane in this process, the others in processes of their own.

    Attributes:
        subject: the explorer.
        limits: the number of lanes, and the limits of each.
        deadline: the end of the time limit, on the monotonic clock; or None.
        here: whether one lane is in this process; this lane begins before the forked lanes.
        apart: whether there may be forked lanes.
        models: whether a lighthouse, task or condition of the user judges runs or chooses worlds.
        make: the function or class that makes a lane.
    """

    subject: Subject
    limits: Limits
    deadline: float | None = None
    here: bool = True
    apart: bool = False
    models: bool = False
    make: Callable[..., Any] = Lane
    _began: float = 0.0
    _lane: Lane | None = None
    _processes: list[_Process] = field(default_factory=list)
    _lost: Counter[str] = field(default_factory=Counter)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._close_lane()
        for process in self._processes:
            process.end()
        self._processes.clear()

    def map(
        self, counter: tally.RunCounter, units: Iterable[UnitOfRuns]
    ) -> Iterator[PartialResult]:
        """Yield the parts of the units' results, in the order in which the parts are ready.

        ``counter`` lists the runs of a unit and counts them; each lane gets a copy.

        Raises:
            TimeIsUp: when the time limit has been reached.
            InputError: if the explorer cannot be loaded, or if a lighthouse, task or condition of
                the user fails.
            Unsettled: if processes are lost again and again.
        """
        waiting = in_any_order(units) if self.subject.from_user else iter(units)
        unit, again, first = next(waiting, None), list[UnitOfRuns](), self._lane_here(counter)
        last = unit
        while True:
            alone = first is not None and (not self.apart or time.monotonic() < self._began + ALONE)
            while unit and first and alone and first.hungry:
                first.offer(unit)
                last, unit = unit, next(waiting, None)
            while not alone and (unit or again) and (process := self._idle()):
                if unit and not again:
                    again, unit = [unit], next(waiting, None)
                process.units.append(again.pop())
                with suppress(OSError):  # then it is lost, which is noticed below
                    process.link.send((counter, process.units[-1]))
            at_work = [process for process in self._processes if process.units]
            busy = first is not None and first.busy
            if first and busy:
                yield from first.turn([process.link.fileno() for process in at_work])
            elif not (unit or again or at_work):
                break
            for process in _heard(at_work, 0 if busy else POLL):
                try:
                    part = process.link.recv()
                except (EOFError, OSError):
                    for left in self._replace(process):
                        again.append(left)
                        yield PartialResult(left, counter.tally(), last=False, anew=True)
                    continue
                if isinstance(part, _KNOWN):
                    raise part
                if part.last:
                    process.units.remove(next(u for u in process.units if u.key == part.unit.key))
                yield part
            check_deadline(self.deadline)
        if first and first.keeps and last:
            yield PartialResult(last, first.end(), last=False)

    def _lane_here(self, counter: tally.RunCounter) -> Lane | None:
        """The lane in this process; None if forked lanes do the work.

        The lane has the counter ``counter``.  A lane with another counter is closed, and a new lane
        is made.
        """
        self._began = self._began or time.monotonic()
        late = self.apart and time.monotonic() > self._began + FIRST_LEVELS
        apart = not self.here or late or bool(self._processes)
        if apart or (self._lane is not None and self._lane.counter != counter):
            self._close_lane()
        if apart:
            return None
        if self._lane is None:
            self._lane = self.make(self.subject, counter, self.limits, deadline=self.deadline)
        return self._lane

    def _close_lane(self) -> None:
        if self._lane is not None:
            self._lane.close()
            self._lane = None

    def _idle(self) -> _Process | None:
        """The forked lane that gets the next unit; None if each lane has enough units.

        The result is a new lane if one may be started, else the lane with the fewest units.
        """
        least = min(self._processes, key=lambda one: len(one.units), default=None)
        if least is None or (least.units and len(self._processes) < self.limits.workers):
            self._processes.append(_Process(self, self._processes))
            return self._processes[-1]
        return least if len(least.units) < AHEAD else None

    def _replace(self, process: _Process) -> list[UnitOfRuns]:
        """Remove a forked lane whose process has ended too early; return its units.

        Raises:
            InputError: if too many lanes have ended while they did one of these units, and a
                lighthouse, task or condition of the user takes part.
            Unsettled: if too many lanes have ended while they did one of these units, and no
                lighthouse, task or condition of the user takes part.
        """
        self._processes.remove(process)
        how, left = process.end(), process.units
        for unit in left:
            self._lost[unit.key] += 1
            if self._lost[unit.key] >= MOST_ATTEMPTS:
                lost = f"{MOST_ATTEMPTS} processes were lost over one unit, the last by {how}"
                if self.models:
                    raise InputError(f"{lost}: a lighthouse, task or condition of yours ends them")
                raise players.Unsettled(lost)
        return left


def _serve(link: Connection, lanes: Lanes, *, first_lane: bool) -> NoReturn:
    """Run a lane in this forked process: take units and send parts of results.

    The process ends when the owner closes the link.

    Args:
        link: the connection to the owner.
        lanes: the object that makes the lane.
        first_lane: whether this is the first forked lane, as in :class:`Lane`.
    """
    status = 1
    try:
        os.setsid()
        leave_interrupts_to_owner()
        signal.pthread_sigmask(signal.SIG_UNBLOCK, INTERRUPTS)
        if lanes.limits.memory is not None and not lanes.subject.from_user:
            linux.limit_memory(lanes.limits.memory)
        _lane_of(link, lanes, first_lane=first_lane)
        status = 0
    except (EOFError, OSError):
        pass
    except BaseException as error:  # noqa: BLE001  # any other error is ours
        known = isinstance(error, _KNOWN)
        with suppress(Exception):
            link.send(error if known else players.HarnessError(traceback.format_exc()))
    finally:
        os._exit(status)


def _lane_of(link: Connection, lanes: Lanes, *, first_lane: bool) -> None:
    counter, unit = link.recv()
    lane = lanes.make(lanes.subject, counter, lanes.limits, first_lane=first_lane)
    try:
        lane.offer(unit)
        while True:
            while link.poll(0 if lane.busy else None):
                asked, unit = link.recv()
                if asked != lane.counter:
                    lane.close()
                    lane = lanes.make(lanes.subject, asked, lanes.limits, first_lane=first_lane)
                lane.offer(unit)
            for part in lane.turn([link.fileno()]):
                if part.last and not lane.busy and lane.keeps:
                    part.result.add(lane.end())
                link.send(part)
    finally:
        lane.close()


def in_any_order(units: Iterable[UnitOfRuns]) -> Iterator[UnitOfRuns]:
    """The units in a random order.

    The units are taken :data:`AT_A_TIME` by AT_A_TIME, and each such group is put into a random
    order.  But within its group an :class:`AcrossUnit` comes last.  Its runs also belong to other
    units.  When the AcrossUnit begins, most of these units are done, and their logs may be used
    again.
    """
    every, order = iter(units), Random()  # noqa: S311  # from the system; no verdict depends on it
    while some := list(islice(every, AT_A_TIME)):
        order.shuffle(some)
        some.sort(key=lambda unit: isinstance(unit, AcrossUnit))
        yield from some


def workers_for(
    subject: Subject,
    limits: Limits,
    deadline: float | None = None,
    *,
    models: bool = False,
    make: Callable[..., Any] = Lane,
) -> Transport:
    """The transport that brings units to the lanes for an explorer.

    If no other process can load the explorer, the only lane is in this process.  For any other
    explorer:

    - Every lane is a forked process if ``models`` is set, if the memory of a built-in explorer is
      limited, or if the explorer is a shared library and there are several workers.
    - Otherwise one lane is in this process; if there are several workers, the others are forked.

    Args:
        subject: the explorer.
        limits: the number of lanes, and the limits of each.
        deadline: the end of the time limit, on the monotonic clock; or None.
        models: whether a lighthouse, task or condition of the user judges runs or chooses worlds.
        make: the function or class that makes a lane.
    """
    players.child_path()  # raises for a missing current directory, before any process starts
    only_here = subject.from_user and not subject.importable
    limited = limits.memory is not None and not subject.from_user
    apart = not only_here and (limits.workers > 1 or models or limited)
    # Players of libraries load compiled code, which takes longer than a small job.
    here = only_here or not (models or limited or (apart and subject.compiled))
    return Lanes(subject, limits, deadline, here, apart, models, make)
