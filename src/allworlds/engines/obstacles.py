"""The checks that the compiled engine cannot do, and why; no compiled code is loaded here."""

from __future__ import annotations

import os

from allworlds.engines.kernel.capabilities import (
    CHECKED,
    EXPLORERS,
    LIGHTHOUSES,
    MOST_BUDGET,
    MOST_EDGES,
)
from allworlds.engines.scope import Given, Scope
from allworlds.explorers.loading import Subject
from allworlds.inputs.checks import show
from allworlds.judging.laws.law_table import LAWS
from allworlds.maps.classes import MapClass
from allworlds.world.lighthouses.base import Lighthouse
from allworlds.world.lighthouses.kinds import LIGHTHOUSES as KINDS
from allworlds.world.lighthouses.marked import Directional

COMPILED_FROM = 5
"""The least m of a check that is worth the compiling; smaller ones end before it would."""

WORTH_LOADING = 2000
"""The number of worlds of a level from which on the compiled judge of users' explorers pays: they
have some 10,000 runs."""

WALKED_FROM = 6
"""The least m whose maps are walked once for every bearing, where that can be done.  Up to
there every bearing is walked."""

COMPILER = "numba", "fast"
"""The package without which there is no compiled engine, and the extra that brings it."""


def obstacle(scope: Scope, subject: Subject) -> str:
    """The reason why the kernel cannot do a check; empty if it can."""
    rules, extent = scope.rules, scope.extent
    if not subject.from_user and subject.name not in EXPLORERS:
        return f"runs only {', '.join(EXPLORERS)}, not {show(subject.name)}"
    if subject.from_user and not hasattr(os, "memfd_create"):
        return "judges users' explorers on Linux alone"
    if kind_of(rules.kind) not in LIGHTHOUSES:
        return f"does not know the lighthouse {show(str(rules.lighthouse))}"
    if isinstance(scope.coverage, Given):
        return "tries every map of a class, and no given worlds"
    if extent.where is not None:
        return f"does not know the condition {show(extent.where.name)}"
    if extent.levels[-1] > MOST_EDGES:
        return f"has room for {MOST_EDGES} edges, not for {extent.levels[-1]}"
    if not rules.task.is_map:
        return f"judges the task map alone, not {show(rules.task.name)}"
    if rules.policy not in ("fifo", "lifo", "nearest"):
        return f"knows the policies fifo, lifo and nearest, not {show(rules.policy)}"
    if unknown := [law for law in rules.applying if law not in CHECKED]:
        return f"does not check the law {unknown[0]!r}"
    if scope.schedules != "one":
        return "plays one schedule a run (see worst for algorithm1)"
    if beyond := rules.the_bound.variables & {"d", "g"}:
        named = " and ".join(sorted(beyond))
        return f"does not know {named} of the bound {show(rules.the_bound.name)}"
    if rules.step_budget is not None and rules.step_budget > MOST_BUDGET:
        return f"has room for a step budget of {MOST_BUDGET}, not of {rules.step_budget}"
    return ""


def kind_of(kind: type[Lighthouse]) -> str:
    """The kernel's name of a kind of lighthouse."""
    if KINDS.get(kind.kind) is kind:
        return kind.kind
    return f"{kind.kind}-single"


def walks(scope: Scope, subject: Subject, edges: int) -> bool:
    """Whether each map of the level is walked once for every bearing."""
    rules = scope.rules
    return (
        edges >= WALKED_FROM
        and subject.name == "algorithm1"
        and rules.kind is Directional
        and scope.extent.map_class is MapClass.MAPS
        and rules.laws in (None, tuple(LAWS))
        and rules.step_budget is None
        and rules.the_bound.variables <= {"n", "m"}
    )
