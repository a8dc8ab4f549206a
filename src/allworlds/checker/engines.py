"""Which engine does a check: the general one, or the compiled one where it can."""

from __future__ import annotations

from typing import Literal, TypeAlias

from allworlds.checker.scope import Scope, ScopeError
from allworlds.maps.classes import MapClass
from allworlds.subjects import Subject

Engine: TypeAlias = Literal["python", "kernel"]

ENGINES = ("auto", "python", "kernel")

FROM_EDGES = 6
"""The least bound from which ``auto`` takes the compiled engine where it can."""

TO_EDGES = 12
"""The greatest bound that the compiled engine has room for."""


def engine_for(name: str, scope: Scope, subject: Subject) -> Engine:
    """The engine that is to be used.

    Args:
        name: ``auto``, ``python`` or ``kernel``.
        scope: what is to be checked.
        subject: the explorer.

    Raises:
        ScopeError: for a name that is none, or where the kernel is named and cannot do it.
    """
    if name not in ENGINES:
        raise ScopeError(f"engine {name!r} is none of {', '.join(ENGINES)}")
    if name == "python":
        return "python"
    obstacle = _obstacle(scope, subject)
    if name == "kernel":
        if obstacle:
            raise ScopeError(f"engine 'kernel' {obstacle}; give auto or python")
        return "kernel"
    return "kernel" if not obstacle and scope.bounds.levels[-1] >= FROM_EDGES else "python"


def _obstacle(scope: Scope, subject: Subject) -> str:
    """Why the compiled engine cannot do it; empty if it can."""
    rules, bounds = scope.rules, scope.bounds
    if subject.name != "algorithm1":
        return f"runs only algorithm1, not {subject.name!r}"
    if rules.lighthouse != "directional":
        return f"knows only the lighthouse directional, not {rules.lighthouse!r}"
    if bounds.map_class is not MapClass.MAPS:
        return f"knows only the class maps, not {bounds.map_class.value!r}"
    if bounds.levels[-1] > TO_EDGES:
        return f"has room for {TO_EDGES} edges, not for {bounds.levels[-1]}"
    if rules.policy not in ("fifo", "lifo", "nearest"):
        return f"knows the policies fifo, lifo and nearest, not {rules.policy!r}"
    if scope.schedules != "one":
        return "walks one schedule (see worst for all of them)"
    if rules.laws:
        return "checks all laws together, not a choice of them"
    if rules.step_budget is not None:
        return "knows only the default step budget"
    if not rules.the_bound.variables <= {"n", "m"}:
        return f"knows only bounds over n and m, not {rules.the_bound.name!r}"
    return ""
