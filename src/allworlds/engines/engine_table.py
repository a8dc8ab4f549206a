"""The engines: what does a check, and where; a new one is an entry of the table."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial
from typing import Annotated, Any, Protocol, TypeAlias

from allworlds.document import one_of
from allworlds.engines.compiled.sizes import COMPILED_FROM
from allworlds.engines.isolation.workers import in_any_order, workers_for
from allworlds.engines.job import Job
from allworlds.engines.python.python_engine import PythonEngine
from allworlds.engines.python.scope import Scope
from allworlds.engines.transports.dask_cluster import Dask
from allworlds.engines.transports.split import Split
from allworlds.engines.transports.threads import Threads
from allworlds.engines.units.unit import Transport
from allworlds.explorers import Subject, content_digest, not_alike, with_content
from allworlds.inputs import InputError, show


@dataclass(frozen=True, slots=True)
class ReadyEngine:
    """An engine made ready, and the transport by which units get to it and tallies back."""

    transport: Transport[Any]
    engine: Any  # a UnitEngine, or a WorkerEngine for workers


class EngineKind(Protocol):
    """A kind of engine."""

    name: str

    def symmetry(self, scope: Scope, subject: Subject) -> str:
        """Where one run is counted for several, why that is right; else empty."""

    def obstacle(self, scope: Scope, subject: Subject) -> str:
        """Why it cannot do a check; empty if it can."""

    def ready(self, job: Job) -> ReadyEngine:
        """The engine for this job.

        Raises:
            EnginesDisagree: if it is not to be trusted.
        """


class General:
    """Every explorer, every option: generators in worker processes."""

    name = "python"

    def symmetry(self, scope: Scope, subject: Subject) -> str:  # noqa: ARG002  # never
        """Each run is played."""
        return ""

    def obstacle(self, scope: Scope, subject: Subject) -> str:  # noqa: ARG002  # it can do all
        """None."""
        return ""

    def ready(self, job: Job) -> ReadyEngine:
        """Worker processes where the explorer can be found by its name, else this process."""
        engine = PythonEngine(job.scope, job.keep)
        if job.dask is not None:
            return ReadyEngine(_cluster(job, job.dask), engine)
        return ReadyEngine(workers_for(job.subject, job.limits, job.deadline), engine)


class Compiled:
    """The judge in compiled code: built-in explorers in threads, foreign ones in processes."""

    name = "kernel"

    def symmetry(self, scope: Scope, subject: Subject) -> str:
        """Bearings, in large maps."""
        from allworlds.engines.compiled.requests import walks
        from allworlds.engines.compiled.tallies import SYMMETRY

        return SYMMETRY if walks(scope, subject, scope.extent.levels[-1]) else ""

    def obstacle(self, scope: Scope, subject: Subject) -> str:
        """The first option that it does not know."""
        if subject.from_user and not subject.importable and subject.native is None:
            # Said before the kernel is loaded, which takes half a second.
            return f"judges no explorer that lives in this process alone, as {show(subject.name)}"
        from allworlds.engines.compiled.requests import obstacle

        return obstacle(scope, subject)

    def ready(self, job: Job) -> ReadyEngine:
        """Threads, after both engines have agreed on every small world.

        For a foreign explorer processes: there both agree as they go.
        """
        if job.subject.from_user:
            from allworlds.engines.compiled.stretches import StretchEngine

            apart = StretchEngine(job.scope, job.keep)
            if job.dask is not None:
                return ReadyEngine(_cluster(job, job.dask), apart)
            apart.compiled(job)
            return ReadyEngine(workers_for(job.subject, job.limits, job.deadline), apart)
        from allworlds.engines.compiled.tallies import BATCH, CompiledEngine

        engine, workers = CompiledEngine.ready(job), job.limits.workers
        near = Threads(workers, job.deadline, BATCH)
        if job.dask is None:
            return ReadyEngine(near, engine)
        far = Dask(job.dask, workers, job.deadline)
        return ReadyEngine(Split(engine.is_soon_done, near, far), engine)


def _cluster(job: Job, scheduler: str) -> Dask:
    """Workers of a cluster, on each of which an explorer is played as it would be here."""
    subject, limits = with_content(job.subject), replace(job.limits, workers=1, time_limit=None)
    if subject.from_user and not subject.importable:
        raise InputError(
            f"explorer {show(subject.name)} lives in this process alone and cannot be sent to "
            "others; put it into a file of its own"
        )
    return Dask(
        scheduler,
        job.limits.workers,
        job.deadline,
        inside=partial(workers_for, subject, limits),
        probe=partial(not_alike, subject, content_digest(subject), limits.answer_timeout),
        order=in_any_order if subject.from_user else iter,
    )


ENGINES: dict[str, EngineKind] = {engine.name: engine for engine in (General(), Compiled())}

EngineName: TypeAlias = Annotated[str, one_of(*ENGINES)]
"""Every engine by its name."""


def why_not_compiled(scope: Scope, subject: Subject) -> str:
    """Why a native explorer is not judged in compiled code, in a large check; else empty."""
    if not subject.compiled or scope.extent.levels[-1] < COMPILED_FROM:
        return ""
    obstacle = ENGINES["kernel"].obstacle(scope, subject)
    return f"the kernel {obstacle}; the python engine goes on, far slower" if obstacle else ""


def engine_for(name: str, scope: Scope, subject: Subject, memory: int | None = None) -> EngineKind:
    """The engine that is to be used.

    Args:
        name: ``auto``, or one of :data:`ENGINES`.
        scope: what is to be checked.
        subject: the explorer.
        memory: MB that it may have, compiled code included.

    Raises:
        InputError: for a name that is none, or for an engine that cannot do it.
    """
    if name == "auto":
        compiled = ENGINES["kernel"]
        small = scope.extent.levels[-1] < COMPILED_FROM
        # Hundreds of MB of address space are the compiled engine's own.
        small |= memory is not None and subject.from_user and not subject.compiled
        return ENGINES["python"] if small or compiled.obstacle(scope, subject) else compiled
    if name not in ENGINES:
        raise InputError(f"engine {show(name)} is not one of auto, {', '.join(ENGINES)}")
    if obstacle := ENGINES[name].obstacle(scope, subject):
        raise InputError(f"engine {show(name)} {obstacle}; give auto or python")
    return ENGINES[name]
