"""I-1, I-2 and the variant t of Section V, checked at every checkpoint.

The judge embeds the published S into the true map by itself: the dart that the explorer
calls its place goes to the robot's true dart, and everything else follows along sigma and
the explored edges, because S is connected.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import count
from operator import ne

from msgspec import Struct

from allworlds.inputs.checks import show
from allworlds.judging.laws.case import Case, Violation
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol.answers import Checkpoint


class BrokenInvariant(Struct, frozen=True):
    """The reason why a published S cannot be embedded."""

    reason: str


def invariant_1(case: Case) -> Violation | None:
    """I-1: S is the explored subgraph of the world, in the same cyclic orders.

    That is: the embedding exists and is injective, whole vertices go to whole vertices, and
    every edge of S has been walked.
    """
    for steps, checkpoint in case.checkpoints:
        if broken := _wrong_s(case, steps, checkpoint):
            return _violation("invariant-1", "S is the explored part of the world", steps, broken)
    return None


def _wrong_s(case: Case, steps: int, checkpoint: Checkpoint) -> BrokenInvariant | None:
    """The reason why S is wrong; where it is right with another ``here``, that is the reason."""
    broken = _wrong_part(case, steps, checkpoint)
    darts = len(checkpoint.sigma)
    if broken and darts <= len(case.map.sigma):
        for here in range(darts):
            if _wrong_part(case, steps, replace(checkpoint, here=here)) is None:
                shown = show(checkpoint.here)
                return BrokenInvariant(
                    f"S is right, but here = {shown}; the robot stands at dart {here} of S"
                )
    return broken


def _wrong_part(case: Case, steps: int, checkpoint: Checkpoint) -> BrokenInvariant | None:
    embedding = embed(case.map, case.trail[steps], checkpoint)
    if isinstance(embedding, BrokenInvariant):
        return embedding
    for d, e in enumerate(checkpoint.alpha):
        if e != d and case.walked.get(embedding[d], steps) >= steps:
            return BrokenInvariant(f"S holds an edge at its dart {d} that has never been walked")
    return None


def invariant_2(case: Case) -> Violation | None:
    """I-2: U is the set of unexplored darts at the explored vertices.

    The darts of S's vertices are all there by I-1; what is left is that no dart in U belongs
    to an edge of S.
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


def _half_entered(checkpoint: Checkpoint) -> BrokenInvariant | None:
    alpha = checkpoint.alpha
    for d, e in enumerate(alpha):
        if e != d and 0 <= e < len(alpha) and alpha[e] == e:
            return BrokenInvariant(
                f"dart {e} is in U, but it is the other end of the explored dart {d}"
            )
    return None


def variant(case: Case) -> Violation | None:
    """The variant t = |E_G| - |E_S| falls at every checkpoint and has ended at 0."""
    previous = None
    for steps, checkpoint in case.checkpoints:
        explored = sum(map(ne, count(), checkpoint.alpha))
        t = case.map.edge_count - (explored + 1) // 2
        if previous is not None and t >= previous:
            return Violation(
                "variant",
                f"t = |E_G| - |E_S| below {previous} after the next pass",
                f"t = {t} {at_checkpoint(steps)}",
                steps,
            )
        previous = t
    if previous:
        return Violation("variant", "t = |E_G| - |E_S| = 0 at the end", f"t = {previous}")
    return None


def embed(
    map_: CombinatorialMap, dart: Dart, checkpoint: Checkpoint
) -> list[Dart] | BrokenInvariant:
    """The dart of the world for each dart of S, or the reason why there is none.

    A dart in U whose partner claims it (the fault of I-2) is embedded by its partner.
    Cost: O(|S|).
    """
    sigma, alpha = checkpoint.sigma, checkpoint.alpha
    size, here = len(sigma), checkpoint.here
    if len(alpha) != size or not 0 <= here < size:
        return BrokenInvariant(
            f"here = {show(here)}, with {size} darts in sigma and {len(alpha)} in alpha"
        )
    image, free = [-1] * size, [True] * len(map_.sigma)
    image[here], free[dart] = dart, False
    claims = {e: d for d, e in enumerate(alpha) if e != d and 0 <= e < size and alpha[e] == e}
    partners = [claims.get(d, e) for d, e in enumerate(alpha)] if claims else alpha
    ways = (("sigma", sigma, map_.sigma), ("alpha", partners, map_.alpha))
    for x in (queue := [here]):
        for name, way, true_way in ways:
            y, true = way[x], true_way[image[x]]
            if y == x and name == "alpha":
                continue  # An open dart leads nowhere yet.
            if not 0 <= y < size:
                return BrokenInvariant(f"{name}({x}) = {show(y)} is no dart of S")
            if image[y] == -1 and free[true]:
                image[y], free[true] = true, False
                queue.append(y)
            elif image[y] != true:
                return BrokenInvariant(
                    f"with the robot at dart {here}, {name}({x}) = {y} is not so in the world"
                )
    if len(queue) < size:
        return BrokenInvariant(
            f"dart {image.index(-1)} of S is not connected with the robot's dart"
        )
    return image


def first_wrong(case: Case) -> tuple[int, str] | None:
    """The steps before the first checkpoint that breaks an invariant, and what is wrong with it."""
    for steps, checkpoint in case.checkpoints:
        if broken := _half_entered(checkpoint) or _wrong_s(case, steps, checkpoint):
            return steps, broken.reason
    return None


def at_checkpoint(steps: int) -> str:
    """The words in which a violation names the checkpoint after that step."""
    return f"at the checkpoint after step {steps}"


def _violation(law: str, expected: str, steps: int, broken: BrokenInvariant) -> Violation:
    return Violation(law, expected, f"{at_checkpoint(steps)}: {broken.reason}", steps)
