"""The laws that a finished run is held to.

A new one is a function of a :class:`~allworlds.judging.laws.case.Case` and an entry of ``LAWS``;
a law that ends a run before it is finished, such as ``timeout``, stands in ``ALWAYS`` alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Annotated, TypeAlias

from msgspec import Struct

from allworlds.document.struct import one_of
from allworlds.judging.laws.case import Case, Violation, ambiguity_law
from allworlds.judging.laws.folding import fold
from allworlds.judging.laws.invariants import invariant_1, invariant_2, variant
from allworlds.protocol.answers import Estimate

Check: TypeAlias = Callable[[Case], Violation | None]
"""The function of a law: the violation, or None if the law holds."""


class Setting(Struct, frozen=True):
    """The conditions on which it depends whether a law applies.

    Attributes:
        folds: whether every arrival at v0 tells where the robot is, and no promise, such as
            planarity, can make an explorer right without folding.
        bounded: whether there is a bound on the traversals.
        maps: the task is to find the map.
    """

    folds: bool
    bounded: bool
    maps: bool = True


class Law(Struct, frozen=True):
    """One law of a finished run.

    Attributes:
        asks: what it asks of an explorer, in a sentence.
        check: the function that a run is held to.
        applies: whether the law means anything in a setting.
        idle: the reason why it does not, if it does not.
    """

    asks: str
    check: Check
    applies: Callable[[Setting], bool] = lambda _: True
    idle: str = ""


def map_law(case: Case) -> Violation | None:
    """Require that the estimate is the same map as the world (Section V: extended isomorphism)."""
    return _wrong_answer(case, "map") if case.answer == "map" else None


def pose_law(case: Case) -> Violation | None:
    """Require that ``here`` stands for the robot's dart: both rooted maps are the same."""
    return _wrong_answer(case, "pose") if case.answer == "pose" else None


def bound_law(case: Case) -> Violation | None:
    """Require at most ``bound`` edge traversals, retracing included (Section VI)."""
    cost = case.transcript.cost
    if case.bound is None or cost <= case.bound:
        return None
    return Violation("bound", case.bound, cost)


def folding_law(case: Case) -> Violation | None:
    """Require that the log alone determines the map: its folding has no open dart.

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


def _maps(setting: Setting) -> bool:
    return setting.maps


_OTHER_TASK = "is about the task map alone"

LAWS: dict[str, Law] = {
    "map": Law(
        "The answer must be the same map as the world.",
        map_law,
        _maps,
        _OTHER_TASK,
    ),
    "pose": Law(
        "The dart 'here' of the answer must stand for the robot's place.",
        pose_law,
        _maps,
        _OTHER_TASK,
    ),
    "invariant-1": Law(
        "At every checkpoint, S must be embedded in the world.", invariant_1, _maps, _OTHER_TASK
    ),
    "invariant-2": Law(
        "At every checkpoint, U must hold no end of an explored edge.",
        invariant_2,
        _maps,
        _OTHER_TASK,
    ),
    "variant": Law(
        "From checkpoint to checkpoint, the number of unexplored edges must fall.",
        variant,
        _maps,
        _OTHER_TASK,
    ),
    "folding": Law(
        "The percepts must leave no other world possible: no answer may be guessed.",
        folding_law,
        lambda setting: setting.folds and setting.maps,
        "holds only under the directional lighthouse in the classes maps and simple: a promise can "
        "make an explorer right without it",
    ),
    "bound": Law(
        "The walk must not cost more than the bound.",
        bound_law,
        lambda setting: setting.bounded,
        "has no effect where the bound is none; name a bound too",
    ),
}
"""The laws of finished runs, in the order in which they are reported."""

ALWAYS = {
    "crash": "The explorer must not raise, and its process must not end.",
    "timeout": "The explorer must not be silent for longer than the answer timeout.",
    "illegal-action": "The explorer must yield nothing but motions, markers and checkpoints.",
    "no-estimate": "The explorer must return a map and a dart of it.",
    "budget": "The explorer must end within the step budget.",
    "nondeterministic": "The explorer must repeat its actions when its percepts are repeated.",
    "ambiguity": "An answer that names no map must be the quotient of all that look alike.",
    "task": "The answer and the walk must be what the task asks for.",
}
"""The laws that cannot be left out, each with what it asks."""

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
    "task",
    *(law for law in LAWS if law not in ("map", "pose")),
)
"""All laws; when several are broken the first is reported."""

ASKED = {law: LAWS[law].asks if law in LAWS else ALWAYS[law] for law in PRECEDENCE}
"""What each law asks, in the order of precedence."""

LawName: TypeAlias = Annotated[str, one_of(*PRECEDENCE)]

TASK = "task"
JUDGED = (*LAWS, TASK)
"""The laws of finished runs, and the one that a task is by itself."""

JudgedLaw: TypeAlias = Annotated[str, one_of(*JUDGED)]


OF_CHECKPOINTS = ("invariant-1", "invariant-2", "variant")
"""The laws that say nothing of a run without checkpoints."""


def checked_laws(laws: Iterable[str], runs: int, checkpoints: int) -> tuple[str, ...]:
    """The laws that were checked, given the numbers of runs and of checkpoints."""
    if not runs:
        return ()
    return tuple(law for law in laws if checkpoints or law not in OF_CHECKPOINTS)


def judge(case: Case, laws: Iterable[Check]) -> Violation | None:
    """The first broken law, or None if all hold.

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
