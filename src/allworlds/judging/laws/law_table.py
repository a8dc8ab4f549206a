"""The laws that a finished run is held to.

A new one is a function of a :class:`~allworlds.judging.laws.finished_run.Case` and an entry of
``LAWS``; a law that ends a run before it is finished, such as ``timeout``, stands in ``ASKED``
alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Annotated, TypeAlias

from msgspec import Struct

from allworlds.document.struct import one_of
from allworlds.judging.laws.finished_run import (
    Case,
    Violation,
    ambiguity_law,
    bound_law,
    folding_law,
    invariant_1,
    invariant_2,
    map_law,
    pose_law,
    variant,
)

Check: TypeAlias = Callable[[Case], Violation | None]
"""The function of a law: the violation, or None if the law holds."""


MAPS, FOLDS, BOUNDED = "maps", "folds", "bounded"
"""The conditions of laws: the task is to find the map; besides, every arrival at v0 tells where the
robot is, and no promise, such as planarity, can make an explorer right without folding; there is a
bound on the traversals."""

IDLE = {
    MAPS: "is about the task map alone",
    FOLDS: "holds only under the directional lighthouse in the classes maps and simple: a promise "
    "can make an explorer right without it",
    BOUNDED: "has no effect where the bound is none; name a bound too",
}
"""The reason why a law means nothing where its condition is not met."""


class Law(Struct, frozen=True):
    """One law of a finished run.

    Attributes:
        asks: what it asks of an explorer, in a sentence.
        check: the function that a run is held to.
        needs: the condition under which it applies.
    """

    asks: str
    check: Check
    needs: str = MAPS


LAWS: dict[str, Law] = {
    "map": Law("The answer must be the same map as the world.", map_law),
    "pose": Law("The dart 'here' of the answer must stand for the robot's place.", pose_law),
    "invariant-1": Law("At every checkpoint, S must be embedded in the world.", invariant_1),
    "invariant-2": Law("At every checkpoint, U must hold no end of an explored edge.", invariant_2),
    "variant": Law(
        "From checkpoint to checkpoint, the number of unexplored edges must fall.", variant
    ),
    "folding": Law(
        "The percepts must leave no other world possible: no answer may be guessed.",
        folding_law,
        FOLDS,
    ),
    "bound": Law("The walk must not cost more than the bound.", bound_law, BOUNDED),
}
"""The laws of finished runs, in the order in which they are reported."""

ASKED = {
    "crash": "The explorer must not raise, and its process must not end.",
    "timeout": "The explorer must not be silent for longer than the answer timeout.",
    "illegal-action": "The explorer must yield nothing but motions, markers and checkpoints.",
    "no-estimate": "The explorer must return a map and a dart of it.",
    "budget": "The explorer must end within the step budget.",
    "nondeterministic": "The explorer must repeat its actions when its percepts are repeated.",
    "map": LAWS["map"].asks,
    "pose": LAWS["pose"].asks,
    "ambiguity": "An answer that names no map must be the quotient of all that look alike.",
    "task": "The answer and the walk must be what the task asks for.",
    **{name: law.asks for name, law in LAWS.items()},
}
"""What each law asks; those that are not in ``LAWS`` cannot be left out."""

PRECEDENCE = (*ASKED,)
"""All laws; when several are broken the first is reported."""

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
