"""Section IV: Algorithm 1, its tests, and the facts they rest on."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations, product
from tempfile import TemporaryDirectory
from typing import Any, TypeAlias

from allworlds import (
    Choices,
    CombinatorialMap,
    Percept,
    World,
    ambiguity,
    check,
    run,
    worlds,
    worst,
)
from allworlds.claims import (
    Algorithm1,
    EverySchedule,
    Found,
    Means,
    Picture,
    Unfinished,
    of_check,
    truth,
)
from allworlds.maps import project, rooted_maps
from passes import played
from position import marked, pair_of_corpus

READABLE_EDGES = 3
"""The largest m for which the readable search over schedules takes seconds."""


def lighthouse_suffices(means: Means, *, edges: int) -> Found:
    """Algorithm 1, first in, first out, gives the map and the pose."""
    report = check("algorithm1", edges=edges, laws=("map", "pose"), workers=means.workers)
    return of_check(report)


def every_schedule(means: Means, *, edges: int, most_expensive: int) -> Found:
    """Check all laws under all sequences of choices; in larger worlds the most expensive one.

    Retracing that is too long exceeds (1)+(2) from four edges on, where there are ten million
    sequences of choices.
    """
    report = check("algorithm1", edges=edges, schedules="all", workers=means.workers)
    found = of_check(report)
    episodes = sum(row.episodes for row in report.tally.rows.values())
    tried = wrong = 0
    for m in range(edges + 1, most_expensive + 1):
        for map_ in rooted_maps(m):
            world = World(map_, "directional")
            told = run("algorithm1", world, choices=_most_expensive_choices(world))
            tried += 1
            wrong += told.finding is not None
    seen = {**found.witnesses, "schedules": episodes, "most expensive schedules": tried}
    return Found(truth(found.verdict == "holds" and not wrong), seen)


class Planned(Choices):
    """An answerer with prepared choices, given as darts of S."""

    def __init__(self, darts: Iterable[int]) -> None:
        super().__init__()
        self._darts = iter(darts)

    def pick(self, options: Sequence[int], of: str, cost: object = None) -> int:  # noqa: ARG002
        """Pick the next dart of the plan."""
        index = list(options).index(next(self._darts))
        self.record.append(index)
        return options[index]


def _most_expensive_choices(world: World) -> list[int]:
    """The indices that Algorithm 1 takes on a most expensive schedule."""
    planned = Planned(EverySchedule(world.map, world.start).most_expensive_picks())
    played(Algorithm1(world.first, planned).explore(), world)
    return planned.record


def three_cases(means: Means, *, edges: int) -> Found:
    """Check that each outcome of a test occurs, and that the run then keeps every law."""
    report = check("algorithm1", edges=edges, workers=means.workers)
    return of_check(report, "case-1", "case-2", "case-3")


def tests_decide(means: Means, *, edges: int) -> Found:
    """Every hypothesis in every state, on every simple path: confirmed exactly if true.

    The compiled search counts the tests; the readable one does those of small worlds once more.
    """
    report = worst_rows(means, edges)
    wrong = sum(row.wrong_tests or 0 for row in report.rows)
    seen = {
        "worlds": sum(row.worlds for row in report.rows),
        "tests of false hypotheses": sum(row.tests or 0 for row in report.rows),
    }
    seen["worlds searched twice"] = len(readable_worst(min(edges, READABLE_EDGES)))
    return Found(truth(wrong == 0), seen)


def readable_worst(edges: int) -> list[tuple[int, int]]:
    """Edges of each world, and the cost of its most expensive schedule by the readable search.

    It raises an error if a false hypothesis can be confirmed.
    """
    return [
        (m, EverySchedule(map_, 0).worst) for m in range(1, edges + 1) for map_ in rooted_maps(m)
    ]


def worst_rows(means: Means, edges: int) -> Any:
    """The exact worst cases of Algorithm 1.

    Raises:
        Unfinished: where a count or a replay disagrees.
    """
    report = worst(edges=edges, workers=means.workers).uninterrupted()
    if not report.agrees:
        raise Unfinished("the worst cases are not those of their replays")
    return report


def not_both(_: Means, *, edges: int) -> Found:
    """Two hypotheses in one state, each with any simple path: motions and expected percepts.

    A state is a set of explored edges that hang together with v0.  The path of a hypothesis y
    begins with a motion counted from y, and the percepts end with a bearing at v0.
    """
    pairs = same_motions = same_percepts = both = 0
    for _world, _goals, plans in _tests(edges):
        for (dart, (motions, percepts)), (other, (moved, seen)) in combinations(plans, 2):
            if dart == other:
                continue
            pairs += 1
            same_motions += motions == moved
            same_percepts += percepts == seen
            both += motions == moved and percepts == seen
    witnesses = {
        "pairs": pairs,
        "with the same motions": same_motions,
        "with the same percepts": same_percepts,
    }
    return Found(truth(both == 0), witnesses)


def marker_on_the_way(_: Means, *, edges: int) -> Found:
    """Walk every test until it meets the marker, or another degree than is expected.

    In every state the robot follows each open dart; every other one with the degree and the marks
    that it senses there is a hypothesis, and is tested on each simple path.
    """
    true = met = alone = wrong = 0
    for world, goals, plans in _tests(edges):
        map_, percepts = world.map, world.percepts
        for goal, (hypothesis, (motions, expected)) in product(goals, plans):
            at = map_.alpha[goal]
            if hypothesis == goal or not _alike(percepts[at], expected[0]):
                continue
            holds = at == hypothesis
            true += holds
            for motion, planned in zip(motions[:-1], expected[1:], strict=False):
                at = map_.alpha[map_.turn(at, motion)]
                if percepts[at].marks:
                    met += 1
                    alone += percepts[at].degree == planned.degree
                    wrong += holds
                if percepts[at] != planned:
                    break
    seen = {"true hypotheses": true, "tests that meet it": met, "where the degree agrees": alone}
    return Found(truth(wrong == 0), seen)


def _alike(one: Percept, other: Percept) -> bool:
    return (one.degree, one.marks) == (other.degree, other.marks)


_Plan: TypeAlias = tuple[list[int], list[Percept]]


def _tests(edges: int) -> Iterator[tuple[World, list[int], list[tuple[int, _Plan]]]]:
    """Every state: its open darts, and the tests of each on all simple paths that are not empty."""
    for m in range(1, edges + 1):
        for map_ in rooted_maps(m):
            world = World(map_, "directional")
            for explored in _explored_parts(map_):
                darts = _open_darts(map_, explored)
                plans = [
                    (dart, _plan(world, dart, path))
                    for dart in darts
                    for path in _simple_paths(map_, explored, map_.vertex_of[dart])
                    if path
                ]
                yield world, darts, plans


def _explored_parts(map_: CombinatorialMap) -> Iterator[frozenset[int]]:
    """Every possible set of explored edges: those connected with v0, given by their darts."""
    seen = {frozenset[int]()}
    queue = [frozenset[int]()]
    for explored in queue:
        yield explored
        for dart in _open_darts(map_, explored):
            more = explored | {dart, map_.alpha[dart]}
            if more not in seen:
                seen.add(more)
                queue.append(more)


def _open_darts(map_: CombinatorialMap, explored: frozenset[int]) -> list[int]:
    known = {map_.vertex_of[0]} | {map_.vertex_of[d] for d in explored}
    return [d for d in map_.darts if map_.vertex_of[d] in known and d not in explored]


def _simple_paths(
    map_: CombinatorialMap,
    explored: frozenset[int],
    vertex: int,
    avoiding: frozenset[int] = frozenset(),
) -> Iterator[tuple[int, ...]]:
    """Simple paths to v0, by the darts by which the vertices are left."""
    if vertex == map_.vertex_of[0]:
        yield ()
        return
    for dart in map_.vertices[vertex]:
        beyond = map_.vertex_of[map_.alpha[dart]]
        if dart in explored and beyond not in avoiding | {vertex}:
            for rest in _simple_paths(map_, explored, beyond, avoiding | {vertex}):
                yield (dart, *rest)


def _plan(world: World, entry: int, path: tuple[int, ...]) -> _Plan:
    """The motions of a test and the percepts that it expects, with the vertex where it begins."""
    at, motions = entry, []
    expected = [world.percepts[entry]]
    for dart in path:
        motions.append(world.map.offset(at, dart))
        at = world.map.alpha[dart]
        expected.append(world.percepts[at])
    return motions, expected


def direction_needed(_: Means) -> Found:
    """K4 in the plane and on the torus: alike by position, apart with any two directions."""
    plain = ambiguity.twins(*pair_of_corpus("pair-k4"))
    one, other = (world.map for world in plain.worlds)
    first, second = ([w.map.turn(w.start, k) for k in range(w.first.degree)] for w in plain.worlds)
    pairs = [
        ambiguity.twins(
            marked(one, "directional", i, first[0]), marked(other, "directional", j, second[0])
        )
        for i, j in product(first, second)
    ]
    apart = sum(pair.distinguishable for pair in pairs)
    pictures = (Picture("in the plane", plain.worlds[0]), Picture("on the torus", plain.worlds[1]))
    return Found(
        truth(plain.twins and apart == len(pairs)), {"pairs of directions": apart}, {}, pictures
    )


def no_twins_with_direction(_: Means, *, edges: int) -> Found:
    """Check in every run: no two darts look alike, and no two worlds have one quotient."""
    runs = 0
    met = set()
    whole = True
    for world in worlds(edges=edges, places="all"):
        quotient = project((world.map, world.percepts, 0)).quotient
        whole = whole and quotient.sheets == 1
        met.add((quotient.sigma, quotient.alpha, quotient.labels))
        runs += 1
    return Found(truth(whole and len(met) == runs), {"runs": runs})


def no_twins_smt(_: Means, *, edges: int) -> Found:
    """Ask z3 for different worlds that look alike.

    Controls: each formula with one of its two requirements left out, which must have a model; and
    the same question with the position alone, where there are twins.
    """
    with TemporaryDirectory(prefix="allworlds-claims-") as directory:
        result = _searched("directional", edges, directory)
        for level, left_out in product(result.levels, ambiguity.REQUIREMENTS):
            if not ambiguity.has_model_without(level.formula, left_out):
                name = level.formula.name
                raise Unfinished(f"{name} has no model even without this: {left_out}")
    with TemporaryDirectory(prefix="allworlds-claims-") as directory:
        control = _searched("position", edges, directory)
    if control.pair is None or not ambiguity.twins(*control.pair).twins:
        raise Unfinished("the solver finds no twins where only the position is marked")
    seen = {
        "pairs of sizes": len(result.levels),
        "models with one requirement left out": len(result.levels) * len(ambiguity.REQUIREMENTS),
        "twins without a direction": 1,
    }
    return Found(truth(result.status == "unsat"), seen)


def _searched(lighthouse: str, edges: int, out: str) -> Any:
    found = ambiguity.search(lighthouse=lighthouse, vertices=edges + 1, edges=edges, out=out)
    result = found.uninterrupted()
    if result.status == "unknown" or result.vacuous:
        raise Unfinished(f"the search has no answer: {result.status}")
    return result
