"""Section V: the invariant, the bound function, and the consequences at the end."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations_with_replacement, pairwise
from typing import Any

from allworlds import (
    Checkpoint,
    Choices,
    CombinatorialMap,
    Estimate,
    Percept,
    World,
    check,
    run,
    worlds,
)
from allworlds.claims import Algorithm1, Found, Means, of_check, truth
from allworlds.maps import rooted_maps, unrooted_code


def invariant_at_start(_: Means, *, edges: int) -> Found:
    """Check in every run that S = v0 and U = its darts, embedded by the judge."""
    runs = kept = 0
    for world in worlds(edges=edges, places="all"):
        before = _at_start(world)
        told = run(_showing(before), world, laws=("invariant-1", "invariant-2"))
        runs += 1
        whole = len(before.sigma) == world.map.degree_at[0]
        shown = len(told.outcome.episode.checkpoints) == 1
        kept += whole and shown and told.finding is None
    return Found(truth(runs == kept), {"runs": runs})


def _at_start(world: World) -> Checkpoint:
    """The S of Algorithm 1 before the loop."""
    return Algorithm1(world.first, Choices()).s.checkpoint(0)


def _showing(checkpoint: Checkpoint) -> Any:
    """An explorer that shows one checkpoint and answers with one loop."""

    def explore(_first: Percept) -> Any:
        yield checkpoint
        return Estimate(CombinatorialMap((1, 0), (1, 0)), 0)

    return explore


def invariant_kept(means: Means, *, edges: int) -> Found:
    """Check I-1 and I-2 at every checkpoint, after loops and after new vertices."""
    laws = ("invariant-1", "invariant-2")
    report = check("algorithm1", edges=edges, laws=laws, workers=means.workers)
    found = of_check(report, "loop", "non-loop")
    return Found(found.verdict, {**found.witnesses, "checkpoints": report.tally.checkpoints})


def variant_falls(means: Means, *, edges: int) -> Found:
    """Check that T falls at every checkpoint, and is 0 at the end."""
    report = check("algorithm1", edges=edges, laws=("variant",), workers=means.workers)
    found = of_check(report)
    return Found(found.verdict, {**found.witnesses, "checkpoints": report.tally.checkpoints})


def augmentations(_: Means, *, edges: int) -> Found:
    """Check the changes of U in a pass, by the kind of its augmentation."""
    loops = vertices = wrong = 0
    for world in worlds(edges=edges, places="all"):
        episode = run("algorithm1", world).outcome.episode
        shown = [
            _at_start(world),
            *(checkpoint for _, checkpoint in episode.checkpoints),
        ]
        for before, after in pairwise(shown):
            added = len(after.sigma) - len(before.sigma)
            change = _open(after.alpha) - _open(before.alpha)
            loops += not added
            vertices += added > 0
            wrong += change != (added - 2)
    return Found(truth(wrong == 0), {"loop augmentations": loops, "non-loop": vertices})


def empty_U(_: Means, *, edges: int) -> Found:  # noqa: N802  # as the paper names it
    """Check that the first checkpoint without an open dart has all m edges, and is the last."""
    runs = right = 0
    for world in worlds(edges=edges, places="all"):
        shown = [c for _, c in run("algorithm1", world).outcome.episode.checkpoints]
        ended = [i for i, checkpoint in enumerate(shown) if not _open(checkpoint.alpha)]
        runs += 1
        whole = len(shown[-1].alpha) == 2 * world.map.edge_count
        right += ended == [len(shown) - 1] and whole
    return Found(truth(runs == right), {"runs": runs})


def _open(alpha: Sequence[int]) -> int:
    return sum(d == e for d, e in enumerate(alpha))


def edge_index(_: Means, *, edges: int) -> Found:
    """Compare isomorphisms that shift indices with codes, for each pair of maps of one size."""
    pairs = same = agree = 0
    for m in range(1, edges + 1):
        met = list(rooted_maps(m))
        codes = [unrooted_code(map_) for map_ in met]
        for i, j in combinations_with_replacement(range(len(met)), 2):
            literally = _same(met[i], met[j])
            pairs += 1
            same += literally
            agree += literally == (codes[i] == codes[j])
    return Found(truth(pairs == agree), {"pairs": pairs, "the same map": same})


def _same(one: CombinatorialMap, other: CombinatorialMap) -> bool:
    """Whether some renaming of the darts takes sigma to sigma and alpha to alpha."""
    return len(one.sigma) == len(other.sigma) and any(
        _renamed(one, other, dart) for dart in other.darts
    )


def _renamed(one: CombinatorialMap, other: CombinatorialMap, dart: int) -> bool:
    """Whether the renaming is one that takes dart 0 to this one."""
    name = {0: dart}
    for d in (queue := [0]):
        for mine, its in ((one.sigma, other.sigma), (one.alpha, other.alpha)):
            image = name.get(mine[d])
            if image is None:
                name[mine[d]] = its[name[d]]
                queue.append(mine[d])
            elif image != its[name[d]]:
                return False
    return len({*name.values()}) == len(name)
