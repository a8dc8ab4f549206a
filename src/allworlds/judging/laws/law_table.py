"""**The** table of the laws of finished runs, and each law as a function.

A new law needs a function of a :class:`Case` (a run together with its world), and an entry in
``LAWS``.  The function of a law returns the violation, or None if the law holds.  ``ASKED`` holds
for every law a sentence about what an explorer must do; for a law in ``LAWS`` this sentence is
copied from ``LAWS``.  A law outside ``LAWS``, such as ``timeout``, which ends a run early, has its
entry in ``ASKED`` alone.

For the laws about checkpoints :func:`embed` finds the image of each dart of S, the explored part in
a checkpoint: the image is a dart of the world.  The image of the checkpoint's ``here`` is the dart
where the robot stood at the checkpoint; the images of all other darts follow along sigma and the
explored edges, because S is connected.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import cached_property
from itertools import count
from operator import ne
from typing import TYPE_CHECKING, Annotated, Literal, TypeAlias

from msgspec import Struct

from allworlds.documents.document import one_of
from allworlds.inputs.checks import show
from allworlds.judging.laws.folding import fold
from allworlds.maps.combinatorial import CombinatorialMap, Dart, carries, numbering
from allworlds.maps.quotient import is_ambiguous, project
from allworlds.protocol.actions import Ambiguous, Answer, Checkpoint, Estimate

if TYPE_CHECKING:
    from allworlds.judging.walk import Walk


class Case(Struct, frozen=True, dict=True):
    """A finished run together with its world, by which the run is judged.

    Attributes:
        walk: the robot's walk, which also holds the world.
        checkpoints: the checkpoints of the run, each in a pair with the number of steps before it.
        estimate: the explorer's answer: an estimate with a valid map, or a rooted quotient with
            valid permutations.  ``estimate.here`` is a dart of this map or quotient.  None if no
            answer is judged, for example because the task does not ask for a map.
        bound: the largest number of traversals that the law ``bound`` allows; None if there is no
            bound.
    """

    walk: Walk
    checkpoints: tuple[tuple[int, Checkpoint], ...]
    estimate: Answer | None
    bound: int | None = None

    @property
    def map(self) -> CombinatorialMap:
        """The map of the world."""
        return self.walk.world.map

    @property
    def start(self) -> Dart:
        """The dart that the robot faced at the start."""
        return self.walk.world.start

    @cached_property
    def answer(self) -> Literal["right", "pose", "map", "open"]:
        """The judgement of the answer's map and ``here``: ``right``, or what is wrong.

        ``pose``: the map is the world's, but no isomorphism takes ``here`` to the robot's dart.
        ``map``: the map is not the world's map.
        ``open``: the answer has no map; it is a rooted quotient, or None.
        """
        if not isinstance(self.estimate, Estimate):
            return "open"
        estimate, truth = self.estimate.map, self.map
        if len(estimate.sigma) != len(truth.sigma):
            return "map"
        order = numbering(estimate.sigma, estimate.alpha, self.estimate.here)

        def fits(dart: Dart) -> bool:
            return carries(estimate.sigma, estimate.alpha, order, truth.sigma, truth.alpha, dart)

        if fits(self.walk.here):
            return "right"
        return "pose" if any(fits(dart) for dart in truth.darts) else "map"


Value: TypeAlias = Estimate | int | str
"""A value in a violation: the value that a law demands, or the value that the run has instead.

An estimate for the laws ``map`` and ``pose``, an integer for ``bound``, a text for all other laws.
"""


class Violation(Struct, frozen=True):
    """A broken law.

    Attributes:
        law: the name of the law.
        expected, seen: what the law demands, and what the run has instead: estimates for the laws
            ``map`` and ``pose``, integers for ``bound``, sentences for all other laws.
        step: the number of steps before the checkpoint that breaks the law; None if the violation
            is not about one checkpoint.
    """

    law: str
    expected: Value
    seen: Value
    step: int | None = None


# ---------------------------------------------------------------- the answer


def map_law(case: Case) -> Violation | None:
    """Require that the estimate has the same map as the world (Section V: extended isomorphism)."""
    return _wrong_answer(case, "map") if case.answer == "map" else None


def pose_law(case: Case) -> Violation | None:
    """Require that ``here`` stands for the robot's dart.

    That is: the answer's map, rooted at ``here``, is the same rooted map as the world's map, rooted
    at the robot's dart.
    """
    return _wrong_answer(case, "pose") if case.answer == "pose" else None


def _wrong_answer(case: Case, law: str) -> Violation:
    assert isinstance(case.estimate, Estimate)
    truth = Estimate(case.map, case.walk.here)
    return Violation(law, truth, case.estimate)


def ambiguity_law(case: Case) -> Violation | None:
    """Require that an answer without a map is the world's quotient, rooted at the robot's dart.

    The world must also have a lookalike: another world, with a map of any class, such that each
    walk has the same percepts in both worlds.  An answer without a map is legal only under the
    lighthouse ``position``.  There the robot senses the degree, and one mark at the vertex of the
    start.  The explorer may be told n and m before the start, but these numbers exclude no
    lookalike: all lookalikes have the same n and m.

    Cost: O(m log m).
    """
    answer = case.estimate
    if not isinstance(answer, Ambiguous):
        return None
    map_, v0 = case.map, case.map.vertex_of[case.start]
    marks = [int(vertex == v0) for vertex in map_.vertex_of]
    quotient, classes = project((map_, marks, case.start))
    # The criterion needs the root at v0, but the robot may be elsewhere.
    if not is_ambiguous(quotient):
        return Violation(
            "ambiguity",
            "the map: no other world looks like this one",
            f"Ambiguous, {_words(_canonical(answer))}",
        )
    rooted = quotient.rerooted(classes[case.walk.here])
    labels = tuple([label for label in rooted.labels if isinstance(label, int)])
    truth = Ambiguous(rooted.sigma, rooted.alpha, rooted.degree, labels, 0)
    if _canonical(answer) == truth:
        return None
    return Violation("ambiguity", _words(truth), _words(_canonical(answer)))


def _canonical(answer: Ambiguous) -> Ambiguous:
    """The quotient ``answer`` in canonical numbering, in which ``here`` is dart 0."""
    order = numbering(answer.sigma, answer.alpha, answer.here)
    number = {q: i for i, q in enumerate(order)}
    return Ambiguous(
        tuple(number[answer.sigma[q]] for q in order),
        tuple(number[answer.alpha[q]] for q in order),
        tuple(answer.degree[q] for q in order),
        tuple(answer.marks[q] for q in order),
        0,
    )


def _words(answer: Ambiguous) -> str:
    """The rooted quotient ``answer`` in words."""
    names = ("sigma", "alpha", "degree", "marks")
    parts = (f"{name} {list(getattr(answer, name))}" for name in names)
    return f"the quotient rooted at 0 with {', '.join(parts)}"


# ---------------------------------------------------------------- the walk


def bound_law(case: Case) -> Violation | None:
    """Require at most ``case.bound`` edge traversals, retracing included (Section VI)."""
    cost = case.walk.cost
    if case.bound is None or cost <= case.bound:
        return None
    return Violation("bound", case.bound, cost)


def folding_law(case: Case) -> Violation | None:
    """Require that the log alone determines the map: the folded log has no open dart.

    If a dart is open, two different worlds agree with the log, so that an explorer with the right
    answer has guessed.
    """
    folded = fold(case.walk.transcript)
    if not folded.open_darts:
        return None
    darts = "dart" if folded.open_darts == 1 else "darts"
    return Violation(
        "folding",
        "a log that determines the map: no open dart when it is folded",
        f"{folded.open_darts} open {darts} in the folded log: another world agrees with it",
    )


# ---------------------------------------------------------------- the checkpoints (Section V)


def invariant_1(case: Case) -> Violation | None:
    """Require I-1 at every checkpoint: S is the explored subgraph of the world.

    That is: :func:`embed` finds an injective function from the darts of S to darts of the world;
    the images of the darts round a vertex of S are all darts round a vertex of the world, in the
    same cyclic order; and the robot has walked along every edge of S before the checkpoint.
    """
    for steps, checkpoint in case.checkpoints:
        if broken := _wrong_s(case, steps, checkpoint):
            return _violation("invariant-1", "S is the explored part of the world", steps, broken)
    return None


def _wrong_s(case: Case, steps: int, checkpoint: Checkpoint) -> str | None:
    """The reason why the S of a checkpoint breaks I-1; None if I-1 holds.

    ``steps`` is the number of steps before the checkpoint.  If I-1 would hold with another
    ``here``, the reason says so.
    """
    broken = _wrong_part(case, steps, checkpoint)
    darts = len(checkpoint.sigma)
    if broken and darts <= len(case.map.sigma):
        for here in range(darts):
            if _wrong_part(case, steps, replace(checkpoint, here=here)) is None:
                shown = show(checkpoint.here)
                return f"S is right, but here = {shown}; the robot stands at dart {here} of S"
    return broken


def _wrong_part(case: Case, steps: int, checkpoint: Checkpoint) -> str | None:
    embedding = embed(case.map, case.walk.darts[steps], checkpoint)
    if isinstance(embedding, str):
        return embedding
    crossed, other = case.walk.crossed, case.map.alpha
    for d, e in enumerate(checkpoint.alpha):
        edge = min(embedding[d], other[embedding[d]])
        if e != d and crossed.get(edge, steps) >= steps:
            return f"S holds an edge at its dart {d} that has never been walked"
    return None


def invariant_2(case: Case) -> Violation | None:
    """Require I-2 at every checkpoint: U is the set of unexplored darts at the explored vertices.

    An explorer shows an open dart u as a dart with alpha(u) = u.  Since the explorer can be wrong,
    its alpha need not be a permutation: alpha(d) = u may also hold for another dart d of S.  Then u
    is the other end of an explored edge, and I-2 is broken.  The function checks only this.  If I-1
    holds, S has every dart of each explored vertex, so nothing else can break I-2.  The law
    ``invariant-1`` checks whether I-1 holds.
    """
    for steps, checkpoint in case.checkpoints:
        if broken := _half_entered(checkpoint):
            return _violation(
                "invariant-2",
                "U holds the unexplored darts at explored vertices, and no others",
                steps,
                broken,
            )
    return None


def _half_entered(checkpoint: Checkpoint) -> str | None:
    alpha = checkpoint.alpha
    for d, e in enumerate(alpha):
        if e != d and 0 <= e < len(alpha) and alpha[e] == e:
            return f"dart {e} is in U, but it is the other end of the explored dart {d}"
    return None


def variant(case: Case) -> Violation | None:
    """Require that the variant t is less from checkpoint to checkpoint, and 0 at the last one.

    t = |E_G| - |E_S| is the number of edges of the world that are not in the S of the checkpoint.
    """
    previous = None
    for steps, checkpoint in case.checkpoints:
        explored = sum(map(ne, count(), checkpoint.alpha))
        t = case.map.edge_count - (explored + 1) // 2
        if previous is not None and t >= previous:
            return Violation(
                "variant",
                f"t = |E_G| - |E_S| below {previous} after the next pass",
                f"t = {t} at the checkpoint after step {steps}",
                steps,
            )
        previous = t
    if previous:
        return Violation("variant", "t = |E_G| - |E_S| = 0 at the end", f"t = {previous}")
    return None


def embed(map_: CombinatorialMap, dart: Dart, checkpoint: Checkpoint) -> list[Dart] | str:
    """The images of the darts 0, 1, ... of S; or the reason in words why there are no images.

    S is the explored part in ``checkpoint``; ``map_`` is the map of the world.  The image of a dart
    of S is a dart of ``map_``.  The image of the checkpoint's ``here`` is ``dart``, where the robot
    is in the world.  All other images follow from two rules: image(sigma(d)) = sigma(image(d)); and
    image(alpha(d)) = alpha(image(d)) unless d is open, which means alpha(d) = d.  Different darts
    must have different images.

    If S breaks I-2, there are darts d and u with alpha(d) = u, although u is open.  Then d and u
    count as the two darts of one edge: the second rule also holds for u, as if alpha(u) were d.

    Cost: O(|S|).
    """
    sigma, alpha = checkpoint.sigma, checkpoint.alpha
    size, here = len(sigma), checkpoint.here
    if len(alpha) != size or not 0 <= here < size:
        return f"here = {show(here)}, with {size} darts in sigma and {len(alpha)} in alpha"
    image, free = [-1] * size, [True] * len(map_.sigma)
    image[here], free[dart] = dart, False
    claims = {e: d for d, e in enumerate(alpha) if e != d and 0 <= e < size and alpha[e] == e}
    partners = [claims.get(d, e) for d, e in enumerate(alpha)] if claims else alpha
    ways = (("sigma", sigma, map_.sigma), ("alpha", partners, map_.alpha))
    for x in (queue := [here]):
        for name, way, true_way in ways:
            y, true = way[x], true_way[image[x]]
            if y == x and name == "alpha":
                continue  # An open dart leads nowhere so far.
            if not 0 <= y < size:
                return f"{name}({x}) = {show(y)} is no dart of S"
            if image[y] == -1 and free[true]:
                image[y], free[true] = true, False
                queue.append(y)
            elif image[y] != true:
                return f"with the robot at dart {here}, {name}({x}) = {y} is not so in the world"
    if len(queue) < size:
        return f"dart {image.index(-1)} of S is not connected with the robot's dart"
    return image


def first_wrong(case: Case) -> tuple[int, str] | None:
    """The index of the first checkpoint that breaks I-1 or I-2, and the reason in words.

    The index is that in ``case.checkpoints``.  The result is None if no checkpoint breaks I-1 or
    I-2.
    """
    for number, (steps, checkpoint) in enumerate(case.checkpoints):
        if broken := _half_entered(checkpoint) or _wrong_s(case, steps, checkpoint):
            return number, broken
    return None


def _violation(law: str, expected: str, steps: int, broken: str) -> Violation:
    return Violation(law, expected, f"at the checkpoint after step {steps}: {broken}", steps)


Check: TypeAlias = Callable[[Case], Violation | None]
"""The function of a law: it returns the violation, or None if the law holds."""


MAPS, FOLDS, BOUNDED = "maps", "folds", "bounded"
"""The conditions under which laws are checked.

``maps``: the task is ``map``.  ``folds``: the task is ``map``; the lighthouse is such that each
arrival at v0 determines the robot's dart; and the class of the worlds promises no property, such as
planarity, by which an explorer can be right although its log does not determine the map.
``bounded``: there is a bound on the traversals.
"""

IDLE = {
    MAPS: "is about the task map alone",
    FOLDS: "is checked only under the directional lighthouse in the classes maps and simple: "
    "elsewhere a promise can make an explorer right that breaks this law",
    BOUNDED: "has no effect where the bound is none; name a bound too",
}
"""For each condition the end of a message about a law that needs the condition.

The message says why the law is not checked when the condition is not met.
"""


class Law(Struct, frozen=True):
    """One law of a finished run.

    Attributes:
        asks: the requirement on an explorer, in a sentence.
        check: the function that returns the violation of the law in a run, or None.
        needs: the condition under which the law is checked; every law has one.  ``maps``: the task
            is ``map``.  ``folds``: the task is ``map``, and the lighthouse and the class are such
            that the log of every correct explorer determines the map (see :data:`FOLDS`).
            ``bounded``: there is a bound on the traversals.
    """

    asks: str
    check: Check
    needs: str = MAPS


LAWS: dict[str, Law] = {
    "map": Law("The answer must be the same map as the world.", map_law),
    "pose": Law("The dart 'here' of the answer must stand for the robot's dart.", pose_law),
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
"""The laws of finished runs: if a run breaks several of these laws, the first one is reported."""

ASKED = {
    "crash": "The explorer must not raise, and its process must not end.",
    "timeout": "The explorer must not be silent for longer than the answer timeout.",
    "illegal-action": "The explorer must yield nothing but motions, markers and checkpoints.",
    "no-estimate": "The explorer must return a map and a dart of it.",
    "budget": "The explorer must end within the step budget.",
    "nondeterministic": "The explorer must repeat its actions when its percepts are repeated.",
    "map": LAWS["map"].asks,
    "pose": LAWS["pose"].asks,
    "ambiguity": "An answer without a map must be the quotient of all worlds that look alike.",
    "task": "The answer and the walk must be what the task asks for.",
    **{name: law.asks for name, law in LAWS.items()},
}
"""For each law the requirement on an explorer, in a sentence.

A user can exclude only laws in ``LAWS`` from a check.
"""

PRECEDENCE = (*ASKED,)
"""The names of all laws; if a run breaks several laws, the first one is reported."""

LawName: TypeAlias = Annotated[str, one_of(*PRECEDENCE)]

TASK = "task"
JUDGED = (*LAWS, TASK)
"""The laws of finished runs, and the law ``task``."""

JudgedLaw: TypeAlias = Annotated[str, one_of(*JUDGED)]


OF_CHECKPOINTS = ("invariant-1", "invariant-2", "variant")
"""The laws that say nothing about a run without checkpoints."""


def checked_laws(laws: Iterable[str], runs: int, checkpoints: int) -> tuple[str, ...]:
    """Those of the laws in ``laws`` that a check has tested in at least one run.

    ``laws`` and the result hold names of laws.  ``runs`` is the number of the runs, and
    ``checkpoints`` the number of all their checkpoints.  If there was no run, the result is empty.
    If there was no checkpoint, the laws about checkpoints are left out.
    """
    if not runs:
        return ()
    return tuple(law for law in laws if checkpoints or law not in OF_CHECKPOINTS)


def first_broken(case: Case, laws: Iterable[Check]) -> Violation | None:
    """The violation of the first law that the run breaks; None if all laws hold.

    ``laws`` holds the functions of the laws, in the order in which they are checked.  The law
    ``ambiguity`` is always checked first, because no other law is about an answer without a map.
    Cost: O(m) for each law and checkpoint.
    """
    for check in (ambiguity_law, *laws):
        violation = check(case)
        if violation:
            return violation
    return None
