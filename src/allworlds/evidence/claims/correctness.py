"""Section V: the invariant, the bound function, and the consequences at the end."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations_with_replacement, pairwise

from allworlds.evidence.claims.claim_types import Checks, Found, Means, of_check, truth
from allworlds.explorers import Algorithm1
from allworlds.judging import LAWS, Case, same_map
from allworlds.maps import MapClass, rooted_maps, unrooted_code
from allworlds.protocol import Choices, Estimate, Transcript
from allworlds.studies.check import check
from allworlds.studies.run import run
from allworlds.world import worlds


def true_before_the_loop(_: Means, *, edges: int) -> Found:
    """Check in every run that S = v0 and U = its darts, embedded by the judge."""
    runs = kept = 0
    for world in worlds(edges=edges, places="all"):
        before = Algorithm1(world.first, Choices()).s.checkpoint(0)
        case = Case(
            world.map, 0, Transcript(world.first, ()), ((0, before),), Estimate(world.map, 0)
        )
        runs += 1
        whole = len(before.sigma) == world.map.degree_at[0]
        laws = all(LAWS[law].check(case) is None for law in ("invariant-1", "invariant-2"))
        kept += laws and whole
    return Found(truth(runs == kept), {"runs": runs})


def kept_by_the_body(means: Means, *, edges: int) -> Found:
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


def augmentations_change_u(_: Means, *, edges: int) -> Found:
    """Check the changes of U in a pass, by the kind of its augmentation."""
    loops = vertices = wrong = 0
    for world in worlds(edges=edges, places="all"):
        episode = run("algorithm1", world).outcome.episode
        shown = [
            Algorithm1(world.first, Choices()).s.checkpoint(0),
            *(checkpoint for _, checkpoint in episode.checkpoints),
        ]
        for before, after in pairwise(shown):
            added = len(after.sigma) - len(before.sigma)
            change = _open(after.alpha) - _open(before.alpha)
            loops += not added
            vertices += added > 0
            wrong += change != (added - 2)
    return Found(truth(wrong == 0), {"loop augmentations": loops, "non-loop": vertices})


def empty_u_is_the_world(_: Means, *, edges: int) -> Found:
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


def edge_index_condition(_: Means, *, edges: int) -> Found:
    """Compare isomorphisms that shift indices with codes, for each pair of maps of one size."""
    pairs = same = agree = 0
    for m in range(1, edges + 1):
        met = list(rooted_maps(m, MapClass.MAPS))
        codes = [unrooted_code(map_) for map_ in met]
        for i, j in combinations_with_replacement(range(len(met)), 2):
            literally = same_map(met[i], met[j])
            pairs += 1
            same += literally
            agree += literally == (codes[i] == codes[j])
    return Found(truth(pairs == agree), {"pairs": pairs, "the same map": same})


CHECKS: Checks = {
    "invariant-at-start": true_before_the_loop,
    "invariant-kept": kept_by_the_body,
    "variant-falls": variant_falls,
    "augmentations": augmentations_change_u,
    "empty-U": empty_u_is_the_world,
    "edge-index": edge_index_condition,
}
