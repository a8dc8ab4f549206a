"""Beyond the paper: the information in the log of a robot with a directional lighthouse."""

from __future__ import annotations

from allworlds.evidence.claims.claim_types import (
    Checks,
    Found,
    Means,
    Unfinished,
    of_check,
    truth,
)
from allworlds.judging import fold
from allworlds.maps import CombinatorialMap, from_rotation
from allworlds.outcome import Verdict
from allworlds.studies.check import check
from allworlds.studies.run import run
from allworlds.world import Directional, World, worlds


def every_log_folds(means: Means, *, edges: int) -> Found:
    """Check the law ``folding`` over all runs of Algorithm 1."""
    report = check("algorithm1", edges=edges, laws=("folding",), workers=means.workers)
    return of_check(report)


def folding_is_an_explorer(means: Means, *, edges: int) -> Found:
    """Check that any fair walk with folding, stopped when no dart is open, answers rightly."""
    report = check("folding-oldest", edges=edges, laws=("map", "pose"), workers=means.workers)
    return of_check(report, "merged")


def folding_too_early(_: Means, *, edges: int) -> Found:
    """Check Algorithm 1's log without its last steps: if an edge is missing, a dart is open."""
    logs = cut = wrong = 0
    for world in worlds(edges=edges, places="all"):
        transcript = run("algorithm1", world).outcome.episode.transcript
        logs += 1
        for length in range(len(transcript.steps)):
            shorter = type(transcript)(transcript.first, transcript.steps[:length])
            cut += 1
            walked = _edges_walked(world, shorter)
            wrong += walked < world.map.edge_count and not fold(shorter).open_darts
    return Found(truth(wrong == 0), {"logs": logs, "beginnings of logs": cut})


def _edges_walked(world: World, transcript: object) -> int:
    """The number of the world's edges that were crossed."""
    state, crossed = world.initial, set()
    for action, _ in transcript.steps:  # type: ignore[attr-defined]
        state, _seen = world.step(state, action)
        crossed.add(min(state.dart, world.map.alpha[state.dart]))
    return len(crossed)


def entries_of_v0(_: Means, *, edges: int, explorers: list[str]) -> Found:
    """Check how often right explorers enter v0 in every run: at least m-n+1 times."""
    runs = attained = wrong = 0
    for world in worlds(edges=edges, places="all"):
        needed = world.map.edge_count - world.map.vertex_count + 1
        for name in explorers:
            told = run(name, world)
            if told.verdict is not Verdict.HOLDS:
                raise Unfinished(f"{name} is not right in {world}")
            steps = told.outcome.episode.transcript.steps
            entered = sum(percept.marks for _, percept in steps)
            runs += 1
            wrong += entered < needed
            attained += entered == needed > 0
    return Found(truth(wrong == 0), {"runs": runs, "that enter just so often": attained})


def far_from_the_cycles(_: Means, *, sizes: list[list[int]], explorers: list[str]) -> Found:
    """v0 at the end of a path of L edges before a world: 2L(m-n+1) traversals at least."""
    runs = wrong = 0
    shares = []
    for vertices, length in sizes:
        map_ = complete_behind_a_path(vertices, length)
        world = World(map_, Directional(0))
        needed = 2 * length * (map_.edge_count - map_.vertex_count + 1)
        for name in explorers:
            told = run(name, world)
            runs += 1
            wrong += told.outcome.cost < needed or told.verdict is not Verdict.HOLDS
            shares.append(round(needed / told.outcome.cost, 3))
    return Found(truth(wrong == 0), {"runs": runs}, {"needed / walked": shares})


def complete_behind_a_path(vertices: int, length: int) -> CombinatorialMap:
    """A complete graph behind a path of this many edges, which begins at v0."""
    path = [[v - 1, v + 1] for v in range(length)]
    path[0] = [1]
    knot = range(length, length + vertices)
    complete = [[w for w in knot if w != v] for v in knot]
    complete[0] = [length - 1, *complete[0]]
    return from_rotation(path + complete)


CHECKS: Checks = {
    "logs-fold": every_log_folds,
    "folding-explores": folding_is_an_explorer,
    "open-before-the-end": folding_too_early,
    "entries-of-v0": entries_of_v0,
    "path-lower-bound": far_from_the_cycles,
}
