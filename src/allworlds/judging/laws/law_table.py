"""The laws that a finished run is held to.

A new one is a function of a :class:`~allworlds.judging.laws.case.Case` and an entry of ``LAWS``;
what ends a run before it is finished, such as ``timeout``, stands in ``PRECEDENCE`` alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Annotated, TypeAlias

from allworlds.document import one_of
from allworlds.judging.laws.case import Case, Violation
from allworlds.judging.laws.folding import fold
from allworlds.judging.laws.invariants import invariant_1, invariant_2, variant
from allworlds.judging.laws.quotient_answers import ambiguity_law
from allworlds.protocol import Estimate

Check: TypeAlias = Callable[[Case], Violation | None]
"""The violation, or None where the law holds."""

Checks: TypeAlias = Mapping[str, Check]


@dataclass(frozen=True, slots=True)
class Setting:
    """What it depends on whether a law applies.

    Attributes:
        folds: the lighthouse turns every arrival at v0 into a place, and no promise, such as
            planarity, can make an explorer right without folding.
        bounded: there is a bound on the traversals.
    """

    folds: bool
    bounded: bool


@dataclass(frozen=True, slots=True)
class Law:
    """One law of a finished run.

    Attributes:
        check: what a run is held to.
        applies: whether the law means anything in a setting.
        idle: why it does not, where it does not.
    """

    check: Check
    applies: Callable[[Setting], bool] = lambda _: True
    idle: str = ""


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
    "map": Law(map_law),
    "pose": Law(pose_law),
    "invariant-1": Law(invariant_1),
    "invariant-2": Law(invariant_2),
    "variant": Law(variant),
    "folding": Law(
        folding_law,
        lambda setting: setting.folds,
        "holds only under the directional lighthouse in the classes maps and simple: a promise can "
        "make an explorer right without it",
    ),
    "bound": Law(
        bound_law,
        lambda setting: setting.bounded,
        "has no effect where the bound is none; name a bound too",
    ),
}
"""The laws of finished runs, in the order in which they are reported."""

PRECEDENCE: tuple[str, ...] = (
    "crash",
    "timeout",
    "illegal-action",
    "no-estimate",
    "budget",
    "nondeterministic",
    "map",
    "pose",
    "ambiguity",
    *(law for law in LAWS if law not in ("map", "pose")),
)
"""All laws; when several are broken the first is reported."""

LawName: TypeAlias = Annotated[str, one_of(*PRECEDENCE)]
JudgedLaw: TypeAlias = Annotated[str, one_of(*LAWS)]


def judge(case: Case, laws: Iterable[Check]) -> Violation | None:
    """The first broken law, or None where all hold.

    An answer that names no map is always held to the law ``ambiguity``: no law that can be
    left out is about it.  Cost: O(m) a law and checkpoint.
    """
    for check in (ambiguity_law, *laws):
        violation = check(case)
        if violation:
            return violation
    return None


def _wrong_answer(case: Case, law: str) -> Violation:
    assert isinstance(case.estimate, Estimate)
    truth = Estimate(case.map, case.trail[-1])
    return Violation(law, truth, case.estimate)
