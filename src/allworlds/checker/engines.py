"""The engines: what does a check, and where; a new one is an entry of the table."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

from allworlds.inputs import InputError
from allworlds.isolation import workers_for
from allworlds.maps.classes import MapClass
from allworlds.runs import Examination, Scope
from allworlds.subjects import Subject
from allworlds.work import Limits, Threads, Transport

FROM_EDGES = 6
"""The least bound from which ``auto`` takes the compiled engine where it can."""

TO_EDGES = 12
"""The greatest bound that the compiled engine has room for."""

COMPILED_LAWS = ("map", "pose", "invariant-1", "invariant-2", "variant", "folding", "bound")
"""The laws that the compiled engine checks, all together."""


class EnginesDisagree(Exception):
    """Two engines say different things about one world."""


@dataclass(frozen=True, slots=True)
class Job:
    """What an engine is to do.

    Attributes:
        scope, subject: what is checked.
        limits: workers, and time.
        keep: how many findings are kept.
        deadline: on the monotonic clock, or None.
        notice: takes what the user may want to know now.
    """

    scope: Scope
    subject: Subject
    limits: Limits
    keep: int
    deadline: float | None
    notice: Callable[[str], None]


@dataclass(frozen=True, slots=True)
class Way:
    """An engine made ready, and the transport by which units get to it and tallies back."""

    transport: Transport[Any]
    engine: Any


class Engine(Protocol):
    """A kind of engine."""

    name: str

    @property
    def symmetry(self) -> str:
        """Where one run is counted for several, why that is right; else empty."""

    def obstacle(self, scope: Scope, subject: Subject) -> str:
        """Why it cannot do a check; empty if it can."""

    def ready(self, job: Job) -> Way:
        """The engine for this job.

        Raises:
            EnginesDisagree: if it is not to be trusted.
        """


class General:
    """Every explorer, every option: generators in worker processes."""

    name = "python"
    symmetry = ""

    def obstacle(self, scope: Scope, subject: Subject) -> str:  # noqa: ARG002  # it can do all
        """None."""
        return ""

    def ready(self, job: Job) -> Way:
        """Worker processes where the explorer can be found by its name, else this process."""
        workers = workers_for(job.subject, job.limits, job.deadline)
        return Way(workers, Examination(job.scope, job.keep))


class Compiled:
    """Algorithm 1 in compiled code, in threads."""

    name = "kernel"

    @property
    def symmetry(self) -> str:
        """Bearings."""
        from allworlds.checker.compiled import SYMMETRY

        return SYMMETRY

    def obstacle(self, scope: Scope, subject: Subject) -> str:
        """The first option that it does not know."""
        rules, extent = scope.rules, scope.extent
        if subject.name != "algorithm1":
            return f"runs only algorithm1, not {subject.name!r}"
        if rules.lighthouse != "directional":
            return f"knows only the lighthouse directional, not {rules.lighthouse!r}"
        if extent.map_class is not MapClass.MAPS:
            return f"knows only the class maps, not {extent.map_class.value!r}"
        if extent.levels[-1] > TO_EDGES:
            return f"has room for {TO_EDGES} edges, not for {extent.levels[-1]}"
        if rules.policy not in ("fifo", "lifo", "nearest"):
            return f"knows the policies fifo, lifo and nearest, not {rules.policy!r}"
        if scope.schedules != "one":
            return "walks one schedule (see worst for all of them)"
        if rules.laws:
            return "checks all laws together, not a choice of them"
        if unknown := [law for law in rules.applying if law not in COMPILED_LAWS]:
            return f"does not check the law {unknown[0]!r}"
        if rules.step_budget is not None:
            return "knows only the default step budget"
        if not rules.the_bound.variables <= {"n", "m"}:
            return f"knows only bounds over n and m, not {rules.the_bound.name!r}"
        return ""

    def ready(self, job: Job) -> Way:
        """Threads, after both engines have agreed on every small world."""
        from allworlds.checker.compiled import BATCH, CompiledExamination

        threads = Threads(job.limits.workers, job.deadline, BATCH)
        return Way(threads, CompiledExamination.ready(job))


ENGINES: dict[str, Engine] = {engine.name: engine for engine in (General(), Compiled())}
"""Every engine by its name."""


def engine_for(name: str, scope: Scope, subject: Subject) -> Engine:
    """The engine that is to be used.

    Args:
        name: ``auto``, or one of :data:`ENGINES`.
        scope: what is to be checked.
        subject: the explorer.

    Raises:
        InputError: for a name that is none, or for an engine that cannot do it.
    """
    if name == "auto":
        compiled = ENGINES["kernel"]
        able = not compiled.obstacle(scope, subject) and scope.extent.levels[-1] >= FROM_EDGES
        return compiled if able else ENGINES["python"]
    if name not in ENGINES:
        raise InputError(f"engine {name!r} is none of auto, {', '.join(ENGINES)}")
    if obstacle := ENGINES[name].obstacle(scope, subject):
        raise InputError(f"engine {name!r} {obstacle}; give auto or python")
    return ENGINES[name]
