"""The laws that a finished run is held to."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TypeAlias

from allworlds.judge.case import Case, Violation
from allworlds.judge.folding import fold
from allworlds.judge.invariants import invariant_1, invariant_2, variant
from allworlds.maps.combinatorial import CombinatorialMap, Dart

Law: TypeAlias = Callable[[Case], Violation | None]
"""The violation, or None where the law holds."""

Laws: TypeAlias = Mapping[str, Law]


def map_law(case: Case) -> Violation | None:
    """The estimate is the same map as the world (Section V: extended isomorphism)."""
    return _wrong_answer(case, "map") if case.answer == "map" else None


def pose_law(case: Case) -> Violation | None:
    """``here`` stands for the robot's dart: both rooted maps are the same."""
    return _wrong_answer(case, "pose") if case.answer == "pose" else None


def bound_law(case: Case) -> Violation | None:
    """At most ``bound`` edge traversals, retracing included (Section VI)."""
    cost = case.transcript.cost
    if case.bound is None or cost <= case.bound:
        return None
    return Violation("bound", case.bound, cost)


def folding_law(case: Case) -> Violation | None:
    """The log alone determines the map: its folding has no open dart.

    With an open dart left two different worlds agree with the log, so an explorer that is
    right about this one has guessed.
    """
    if not case.folds:
        return None
    folded = fold(case.transcript)
    if not folded.open_darts:
        return None
    darts = "dart" if folded.open_darts == 1 else "darts"
    return Violation(
        "folding",
        "a log that determines the map: no open dart when it is folded",
        f"{folded.open_darts} open {darts} in the folded log: another world agrees with it",
    )


LAWS: dict[str, Law] = {
    "map": map_law,
    "pose": pose_law,
    "invariant-1": invariant_1,
    "invariant-2": invariant_2,
    "variant": variant,
    "folding": folding_law,
    "bound": bound_law,
}
"""The laws of finished runs, in the order in which they are reported."""

PRECEDENCE: tuple[str, ...] = (
    "crash",
    "timeout",
    "illegal-action",
    "no-estimate",
    "budget",
    "nondeterministic",
    *LAWS,
)
"""All laws; when several are broken the first is reported."""


def judge(case: Case, laws: Iterable[Law]) -> Violation | None:
    """The first broken law, or None where all hold.  Cost: O(m) a law and checkpoint."""
    for law in laws:
        violation = law(case)
        if violation:
            return violation
    return None


def _wrong_answer(case: Case, law: str) -> Violation:
    return Violation(
        law,
        rooted_json(case.map, case.trail[-1]),
        rooted_json(case.estimate.map, case.estimate.here),
    )


def rooted_json(map_: CombinatorialMap, here: Dart) -> dict[str, object]:
    """``{"sigma", "alpha", "here"}``."""
    return {**map_.to_json(), "here": here}
