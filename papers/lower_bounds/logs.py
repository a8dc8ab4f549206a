"""Beyond the paper: the information in the log of a robot with a directional lighthouse."""

from __future__ import annotations

from allworlds import CombinatorialMap, World, check, worlds
from allworlds.claims import FoldedLog, Found, Means, Unfinished, of_check, truth
from allworlds.maps import from_rotation
from playing import run_here

OPEN = -1
"""The other end of a dart of the log that the robot has not gone through."""


def logs_fold(means: Means, *, edges: int) -> Found:
    """Check the law ``folding`` over all runs of Algorithm 1."""
    report = check("algorithm1", edges=edges, laws=("folding",), workers=means.workers)
    return of_check(report)


def folding_explores(means: Means, *, edges: int) -> Found:
    """Check that any fair walk with folding, stopped when no dart is open, answers rightly."""
    report = check("folding-oldest", edges=edges, laws=("map", "pose"), workers=means.workers)
    return of_check(report, "merged")


def open_before_the_end(_: Means, *, edges: int) -> Found:
    """Check Algorithm 1's log without its last steps: if an edge is missing, a dart is open."""
    logs = cut = wrong = 0
    for world in worlds(edges=edges, places="all"):
        steps = run_here("algorithm1", world).transcript.steps
        logs += 1
        log = FoldedLog(world.first)
        here = -(world.first.bearing or 0) % world.first.degree
        state, crossed = world.initial, set[int]()
        for action, percept in steps:
            cut += 1
            every = len(crossed) == world.map.edge_count
            wrong += not every and not _open_darts(log)
            here = log.arrive(log.turn(here, action.k), percept)
            state, _ = world.step(state, action)
            crossed.add(min(state.dart, world.map.alpha[state.dart]))
    return Found(truth(wrong == 0), {"logs": logs, "beginnings of logs": cut})


def _open_darts(log: FoldedLog) -> bool:
    """Whether some dart of the log is open."""
    darts = {log.canonical(dart) for dart in range(len(log.node))}
    return any(log.beyond(dart) == OPEN for dart in darts)


def entries_of_v0(_: Means, *, edges: int, explorers: list[str]) -> Found:
    """Check how often right explorers enter v0 in every run: at least m-n+1 times."""
    runs = attained = wrong = 0
    for world in worlds(edges=edges, places="all"):
        needed = world.map.edge_count - world.map.vertex_count + 1
        for name in explorers:
            told = run_here(name, world)
            if told.finding:
                raise Unfinished(f"{name} is not right in {world}")
            steps = told.transcript.steps
            entered = sum(percept.marks for _, percept in steps)
            runs += 1
            wrong += entered < needed
            attained += entered == needed > 0
    return Found(truth(wrong == 0), {"runs": runs, "that enter just so often": attained})


def path_lower_bound(_: Means, *, sizes: list[list[int]], explorers: list[str]) -> Found:
    """v0 at the end of a path of L edges before a world: 2L(m-n+1) traversals at least."""
    runs = wrong = 0
    shares = []
    for vertices, length in sizes:
        map_ = complete_behind_a_path(vertices, length)
        world = World(map_, "directional")
        needed = 2 * length * (map_.edge_count - map_.vertex_count + 1)
        for name in explorers:
            told = run_here(name, world)
            runs += 1
            wrong += told.cost < needed or told.finding is not None
            shares.append(round(needed / told.cost, 3))
    return Found(truth(wrong == 0), {"runs": runs}, {"needed / walked": shares})


def complete_behind_a_path(vertices: int, length: int) -> CombinatorialMap:
    """A complete graph behind a path of this many edges, which begins at v0."""
    path = [[v - 1, v + 1] for v in range(length)]
    path[0] = [1]
    knot = range(length, length + vertices)
    complete = [[w for w in knot if w != v] for v in knot]
    complete[0] = [length - 1, *complete[0]]
    return from_rotation(path + complete)
