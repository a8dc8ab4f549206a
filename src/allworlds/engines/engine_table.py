"""**The** table of the engines, the data of a job for an engine, and two transports.

The two transports bring units to engines in this process: in this thread, or in several threads.
This module knows the checks that the compiled engine cannot do, and loads no compiled code.  A new
engine is a new entry of the table.
"""

import os
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from functools import partial
from itertools import islice, takewhile
from threading import Event
from typing import Annotated, Any, Self, TypeAlias

from msgspec import Struct

from allworlds.documents.document import one_of, replace
from allworlds.engines import lanes, tally
from allworlds.engines.kernel import capabilities
from allworlds.engines.limits import POLL, Limits, TimeIsUp, check_deadline
from allworlds.engines.units import PartialResult, Scope, Transport, UnitEngine
from allworlds.explorers.loading import Subject
from allworlds.explorers.sources import content_digest, not_alike, with_content
from allworlds.inputs.checks import InputError, NotInstalled, lack_of, not_one_of, show
from allworlds.judging.laws.law_table import LAWS
from allworlds.maps.classes import MapClass
from allworlds.world.lighthouses import base, marked


def _parts(engine: UnitEngine, unit: Any) -> Iterator[PartialResult]:
    """Yield the parts of a unit's result; only the last part has ``last`` set."""
    parts = iter(engine.parts(unit))
    result = next(parts)
    for following in parts:
        yield PartialResult(unit, result, last=False)
        result = following
    yield PartialResult(unit, result, last=True)


class ThisThread:
    """Brings units to an engine in this thread.

    ``deadline`` is the end of the time limit, on the monotonic clock, or None.  The time is checked
    after each part of a result.
    """

    def __init__(self, deadline: float | None = None) -> None:
        self._deadline = deadline

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        """Do nothing: there is no work to end, because all work is done inside :meth:`map`."""

    def map(self, engine: UnitEngine, units: Iterable[Any]) -> Iterator[PartialResult]:
        """Yield the parts of the units' results, in the order of the units.

        Raises:
            TimeIsUp: when the time limit has been reached.
        """
        for unit in units:
            for part in _parts(engine, unit):
                yield part
                check_deadline(self._deadline)


def local_or_dask(
    cluster: str | None, deadline: float | None, workers: int = 0, batch: int = 1
) -> Transport:
    """The transport that brings units to a Dask cluster, to threads, or to this thread.

    Args:
        cluster: the address of the scheduler of the cluster; None for threads or this thread.
        deadline: the end of the time limit, on the monotonic clock; or None.
        workers: for a cluster on this machine, the number of its processes, with 0 for one process
            on each core; without a cluster, the number of threads, with 0 for this thread alone.
        batch: the number of units that a thread gets at a time.
    """
    if cluster is None:
        return Threads(workers, deadline, batch) if workers else ThisThread(deadline)
    from allworlds.engines.dask import Dask

    return Dask(cluster, workers or os.cpu_count() or 1, deadline)


class Threads:
    """Brings units to a pool of threads.

    At the end of the ``with`` block the call ``engine.halt()`` stops the work of the threads.

    Args:
        workers: the number of threads.
        deadline: the end of the time limit, on the monotonic clock; or None.
        batch: the number of units that a thread gets at a time; larger batches cost less.
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
        # After an interrupt or a time limit nobody waits for work that cannot be stopped, such as
        # a compiler.  After any other error all work must have ended before the next job.
        patient = isinstance(error, Exception | None) and not isinstance(error, TimeIsUp)
        self._pool.shutdown(wait=patient, cancel_futures=True)

    def map(self, engine: Any, units: Iterable[Any]) -> Iterator[PartialResult]:
        """Yield the parts of the units' results, in the order in which batches of units are done.

        Raises:
            TimeIsUp: when the time limit has been reached.
            Exception: if the engine raises it; of several exceptions, that of the first batch.
        """
        self._engine = engine
        waiting = iter(units)
        at_work: list[Future[list[PartialResult]]] = []
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


def _done(engine: UnitEngine, batch: Iterable[Any], ended: Event) -> list[PartialResult]:
    """The parts of the results of the units ``batch``.

    Once ``ended`` is set, no further unit is begun.
    """
    return [
        part
        for unit in takewhile(lambda _: not ended.is_set(), batch)
        for part in _parts(engine, unit)
    ]


COMPILED_FROM = 5
"""The least m for which compiling pays: a check up to fewer edges ends before the compiler ends."""

WORTH_LOADING = 2000
"""The least number of worlds of a level for which it pays to load the compiled judge.  Such a
level has some 10,000 runs."""

WALKED_FROM = 6
"""The least m for which one walk in a map may count for every bearing, see :func:`walks`.  With
fewer edges the explorer walks once for every bearing."""

COMPILER = "numba", "fast"
"""The package that the compiled engine needs, and the extra that installs it."""


class Job(Struct, frozen=True):
    """The data of a check that an engine needs.

    Attributes:
        scope, subject: the scope of the check, and the explorer.
        limits: the number of workers, the time-outs and the memory.
        keep: the largest number of findings that are kept.
        deadline: the end of the time limit, on the monotonic clock; or None.
        notice: the function that shows the user a text while the job goes on.
        cluster: the address of the Dask scheduler that does the work; None without Dask.
    """

    scope: Scope
    subject: Subject
    limits: Limits
    keep: int
    deadline: float | None
    notice: Callable[[str], None]
    cluster: str | None = None


class ReadyEngine(Struct, frozen=True):
    """An engine that is ready for a job, and the transport that brings the job's units to it."""

    transport: Transport
    engine: Any  # of the kind that the transport takes; None if every unit is kept


def obstacle(scope: Scope, subject: Subject) -> str:
    """The reason why the kernel cannot do a check; empty if the kernel can do the check.

    The reason is a clause whose subject is the kernel, such as "has room for 12 edges, not for 13".
    """
    rules, extent = scope.rules, scope.extent
    if not subject.from_user and subject.name not in capabilities.EXPLORERS:
        return f"runs only {', '.join(capabilities.EXPLORERS)}, not {show(subject.name)}"
    if subject.from_user and not hasattr(os, "memfd_create"):
        return "judges users' explorers on Linux alone"
    if kind_of(rules.kind) not in capabilities.LIGHTHOUSES:
        return f"does not know the lighthouse {show(str(rules.lighthouse))}"
    if extent.given is not None:
        return "tries every map of a class, and no given worlds"
    if extent.where is not None:
        return f"does not know the condition {show(extent.where.name)}"
    if extent.levels[-1] > capabilities.MOST_EDGES:
        return f"has room for {capabilities.MOST_EDGES} edges, not for {extent.levels[-1]}"
    if not rules.task.is_map:
        return f"judges the task map alone, not {show(rules.task.name)}"
    if rules.policy not in ("fifo", "lifo", "nearest"):
        return f"knows the policies fifo, lifo and nearest, not {show(rules.policy)}"
    if unknown := [law for law in rules.applying if law not in capabilities.CHECKED]:
        return f"does not check the law {unknown[0]!r}"
    if scope.schedules != "one":
        return "plays one schedule a run (see worst for algorithm1)"
    if beyond := rules.the_bound.variables & {"d", "g"}:
        named = " and ".join(sorted(beyond))
        return f"does not know {named} of the bound {show(rules.the_bound.name)}"
    if rules.step_budget is not None and rules.step_budget > capabilities.MOST_BUDGET:
        return (
            f"has room for a step budget of {capabilities.MOST_BUDGET}, not of {rules.step_budget}"
        )
    return ""


def kind_of(kind: type[base.Lighthouse]) -> str:
    """The kernel's name of a kind of lighthouse; empty if the kernel knows no such kind."""
    single = "-single" if kind.chosen == {"single": True} else ""
    known = isinstance(kind.kind, str) and (single or not kind.chosen)  # not one that is composed
    return kind.kind + single if known else ""


def walks(scope: Scope, subject: Subject, edges: int) -> bool:
    """Whether one walk in a map stands for the runs under all directions of the marker.

    This is so if all of the following hold: the maps have at least :data:`WALKED_FROM` edges, and
    are all maps (the class ``maps``); the explorer is Algorithm 1 under the directional lighthouse;
    the laws and the step budget are the default ones; and the bound depends on n and m alone.
    """
    rules = scope.rules
    return (
        edges >= WALKED_FROM
        and subject.name == "algorithm1"
        and rules.kind is marked.Directional
        and scope.extent.map_class is MapClass.MAPS
        and rules.laws in (None, tuple(LAWS))
        and rules.step_budget is None
        and rules.the_bound.variables <= {"n", "m"}
    )


class EngineKind:
    """The Python engine, which knows every explorer and every option.

    This class is also the base class of the other engines.
    """

    name = "python"

    def symmetry(self, scope: Scope, subject: Subject) -> str:  # noqa: ARG002  # never
        """Return the text that tells users why one run stands for several runs.

        It is empty if each run is played, as here.
        """
        return ""

    def obstacle(self, scope: Scope, subject: Subject) -> str:  # noqa: ARG002  # none
        """Return the reason why this engine cannot do a check; empty if the engine can do it."""
        return ""

    def ready(self, job: Job) -> ReadyEngine:
        """Return the engine for this job, with its transport.

        Raises:
            EnginesDisagree: if a comparison with another engine shows an error.
        """
        return ReadyEngine(players_for(job), tally.RunCounter(job.scope, job.keep))


class Compiled(EngineKind):
    """The compiled engine: threads play built-in explorers, processes play users' explorers."""

    name = "kernel"

    def symmetry(self, scope: Scope, subject: Subject) -> str:
        """The text that tells users why one walk in a large map stands for several runs.

        It is empty if each run is played.
        """
        if not walks(scope, subject, scope.extent.levels[-1]):
            return ""
        from allworlds.engines.compiled_engine import SYMMETRY

        return SYMMETRY

    def obstacle(self, scope: Scope, subject: Subject) -> str:
        """Return the reason why this engine cannot do a check; empty if the engine can do it.

        The reason is a clause, about an option that the engine does not know, or about a missing
        package.
        """
        if subject.from_user and not subject.importable and subject.native is None:
            return f"judges no explorer that lives in this process alone, as {show(subject.name)}"
        return obstacle(scope, subject) or lack_of(*COMPILER)

    def ready(self, job: Job) -> ReadyEngine:
        """Return the engine with a transport to threads, or to lanes for a user's explorer.

        Before a check in threads, the results of this engine and of the Python engine are compared
        in every small world.  In lanes, the judges of both engines are compared during the check.
        """
        if job.subject.from_user:
            # An engine that is asked for by its name is used in small worlds, too.
            least = WORTH_LOADING if job.scope.extent.levels[-1] >= COMPILED_FROM else 0
            return ReadyEngine(players_for(job), tally.RunCounter(job.scope, job.keep, least))
        from allworlds.engines.compiled_engine import BATCH, CompiledEngine

        engine = CompiledEngine.ready(job)
        there = local_or_dask(job.cluster, job.deadline, job.limits.workers, BATCH)
        return ReadyEngine(there, engine)


def players_for(job: Job) -> Transport:
    """The transport that brings units to lanes, on this machine or on the workers of a cluster.

    A lane plays and judges the explorer.

    Raises:
        InputError: if the explorer cannot be sent to the workers of a cluster.
    """
    if job.cluster is None:
        # Code of the user's may judge the runs, or choose the worlds.
        models = bool(job.scope.rules.files or getattr(job.scope.extent.where, "codes", ()))
        return lanes.workers_for(job.subject, job.limits, job.deadline, models=models)
    from allworlds.engines.dask import Dask

    subject, limits = with_content(job.subject), replace(job.limits, workers=1, time_limit=None)
    if subject.from_user and not subject.importable:
        raise InputError(
            f"explorer {show(subject.name)} lives in this process alone and cannot be sent to "
            "others; put it into a file of its own"
        )
    return Dask(
        job.cluster,
        job.limits.workers,
        job.deadline,
        inside=partial(lanes.workers_for, subject, limits),
        probe=partial(not_alike, subject, content_digest(subject), limits.answer_timeout),
        order=lanes.in_any_order if subject.from_user else iter,
    )


ENGINES: dict[str, EngineKind] = {engine.name: engine for engine in (EngineKind(), Compiled())}

EngineName: TypeAlias = Annotated[str, one_of(*ENGINES)]
"""The name of one of the engines."""


def why_not_compiled(scope: Scope, subject: Subject, memory: int | None = None) -> str:
    """The reason why a check cannot use the compiled engine, if the user must be told of it.

    The user is told if the check would have taken far less time, and may have expected it.  Let m
    be the number of edges of the last level.  The explorer is a shared library and m is at least
    :data:`COMPILED_FROM`; or only the package numba is missing, which can be installed, and m is
    larger than :data:`COMPILED_FROM`.  In all other cases the result is empty.  It is also empty if
    the user's own limit of the memory keeps compiled code out (:func:`_is_kept_out`).

    ``memory`` is the limit of the address space in MB; None without a limit.
    """
    most = scope.extent.levels[-1]
    if most < COMPILED_FROM or _is_kept_out(subject, memory):
        return ""
    obstacle = ENGINES["kernel"].obstacle(scope, subject)
    expected = subject.compiled or (most > COMPILED_FROM and obstacle == lack_of(*COMPILER))
    lacking = f"the kernel {obstacle}; the python engine goes on, far slower"
    return lacking if obstacle and expected else ""


def _is_kept_out(subject: Subject, memory: int | None) -> bool:
    """Whether compiled code must not judge this explorer, because the user has limited the memory.

    Compiled code needs hundreds of MB of address space; so any limit keeps it out, however large
    the limit is.  The result is always False for built-in explorers and for shared libraries.
    ``memory`` is the limit in MB; None without a limit.
    """
    return memory is not None and subject.from_user and not subject.compiled


def engine_for(name: str, scope: Scope, subject: Subject, memory: int | None = None) -> EngineKind:
    """The engine called ``name``; for ``auto`` the faster one that can do the check.

    For ``auto`` the result is the Python engine in three cases.  First: all worlds have fewer than
    :data:`COMPILED_FROM` edges.  Second: the compiled engine cannot do the check.  Third: the user
    has limited the memory, and :func:`_is_kept_out` says that compiled code has no room.

    Args:
        name: ``auto`` or the name of an engine.
        scope: the scope of the check.
        subject: the explorer.
        memory: the user's limit of the address space in MB; None without a limit.

    Raises:
        InputError: for an unknown name, or for an engine that cannot do the check.
    """
    if name == "auto":
        compiled = ENGINES["kernel"]
        small = scope.extent.levels[-1] < COMPILED_FROM or _is_kept_out(subject, memory)
        return ENGINES["python"] if small or compiled.obstacle(scope, subject) else compiled
    if name not in ENGINES:
        raise not_one_of("engine", name, ("auto", *ENGINES))
    if obstacle := ENGINES[name].obstacle(scope, subject):
        kind = NotInstalled if obstacle == lack_of(*COMPILER) else InputError
        raise kind(f"engine {show(name)} {obstacle}; give auto or python")
    return ENGINES[name]
