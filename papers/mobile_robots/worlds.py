"""Worlds and starts that several claims share."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import combinations
from typing import Any

from allworlds import Automaton, CombinatorialMap, Do, Model
from allworlds.maps import MapClass, rooted_maps
from allworlds.robots import SearchOutcome, named_model, search

SCHEDULERS: tuple[Any, ...] = ("fsync", "ssync", "central", "async")

EDGE = CombinatorialMap((0, 1), (1, 0))
PATH_3 = CombinatorialMap((0, 2, 1, 3), (1, 0, 3, 2))
PATH_4 = CombinatorialMap((0, 2, 1, 4, 3, 5), (1, 0, 3, 2, 5, 4))
STAR_3 = CombinatorialMap((1, 2, 0, 3, 4, 5), (3, 4, 5, 0, 1, 2))


def ring(vertices: int) -> CombinatorialMap:
    """The ring; dart 2v leads from vertex v to v + 1, dart 2v + 1 back to v - 1."""
    darts = range(2 * vertices)
    alpha = [(d + 3 if d % 2 == 0 else d - 3) % (2 * vertices) for d in darts]
    return CombinatorialMap([d ^ 1 for d in darts], alpha)


def simple_worlds(edges: int) -> Iterator[CombinatorialMap]:
    """Every simple map with at most so many edges, with every root."""
    for size in range(1, edges + 1):
        yield from rooted_maps(size, MapClass.SIMPLE)


def starts_apart(map_: CombinatorialMap) -> Iterator[tuple[int, int]]:
    """Every start of two robots at different vertices, one of them at the root."""
    for dart in map_.darts:
        if map_.vertex_of[dart] != map_.vertex_of[0]:
            yield 0, dart


def placements(vertices: int, robots: int) -> list[tuple[int, ...]]:
    """Every start on different vertices of a ring, robot 0 at vertex 0, the others in order."""
    others = combinations(range(1, vertices), robots - 1)
    return [(0, *(2 * vertex for vertex in each)) for each in others]


def places_of(start: Sequence[int]) -> list[int]:
    """The vertices of darts on a ring."""
    return [dart // 2 for dart in start]


def gaps_of(places: Sequence[int], vertices: int) -> tuple[int, ...]:
    """The edges from each robot on a ring to the next one."""
    following = [*places[1:], places[0] + vertices]
    return tuple(after - before for before, after in zip(places, following, strict=True))


def arrangements(vertices: int, robots: int) -> list[tuple[int, ...]]:
    """The starts on a ring, one of those that are equal but for a turn or a reflection."""
    kept = {}
    for start in placements(vertices, robots):
        gaps = gaps_of(places_of(start), vertices)
        turned = [gaps[i:] + gaps[:i] for i in range(robots)]
        kept.setdefault(min(turned + [each[::-1] for each in turned]), start)
    return [start for _, start in sorted(kept.items())]


def is_periodic(start: Sequence[int], vertices: int) -> bool:
    """Whether the gaps of a start on a ring are the same after a turn."""
    gaps = gaps_of(places_of(start), vertices)
    return any(gaps[i:] + gaps[:i] == gaps for i in range(1, len(gaps)))


def named(text: str) -> Model:
    """The built-in model of this name."""
    return named_model(text).model


def searches(
    maps: Sequence[CombinatorialMap], model: Model, team: Sequence[Any], scheduler: Any
) -> Iterator[SearchOutcome]:
    """The search of each start of each map."""
    for map_ in maps:
        for start in model.starts(map_, len(team)):
            yield search(map_, start, model, team, scheduler)


def steps_by(program: Automaton) -> Callable[[tuple[int, ...]], tuple[int, ...]]:
    """The rule of an oblivious program as ``check.py`` has it: the steps ahead for what is seen."""

    def rule(ahead: tuple[int, ...]) -> tuple[int, ...]:
        behind = (ahead[0], *ahead[:0:-1])
        lesser, greater = sorted((ahead, behind))
        _, action = program.step(None, [[[*lesser]], [[*greater]]])
        if not isinstance(action, Do):
            return (0,)
        if ahead == behind or action.value == "either":
            return 1, -1
        first = action.value in ("first", 0)
        return (1,) if first == (ahead == lesser) else (-1,)

    return rule
