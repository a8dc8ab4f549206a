"""Shrinking a large refuting world until no small change makes it smaller."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

from allworlds.engines import GivenWorlds, Scope
from allworlds.judging import Finding
from allworlds.maps import Code, CombinatorialMap, Extent, contracted, deleted, moved, rooted_code
from allworlds.world import World

Refute = Callable[[Sequence[GivenWorlds]], Finding | None]
"""The smallest finding among these worlds, or None."""

CHUNK = 50
"""The worlds that one worker tries at a time."""

WAVE = 8
"""The chunks that are tried before the next, larger worlds are begun."""


def shrink(finding: Finding, scope: Scope, refute: Refute) -> Iterator[Finding]:
    """Yield ever smaller refuting worlds, until no neighbour in the size order refutes.

    First an edge is deleted or contracted as long as that is possible; then, with as many
    edges, a dart may move and the start and the marker may turn, towards fewer vertices and
    the smaller code.  Every neighbour is rooted everywhere and lit from every place, and the
    smallest refuting one is taken, so the result depends on nothing but the finding.

    Cost: O(m^3) runs for each step with fewer edges.
    """
    smaller: Finding | None = finding
    while smaller:
        finding, map_ = smaller, smaller.world.map
        smaller = _smallest(refute, _picked(scope, finding, _fewer_edges(map_)))
        if smaller is None:
            smaller = _smallest(refute, _picked(scope, finding, [map_, *moved(map_)]))
        if smaller:
            yield smaller


def _smallest(refute: Refute, picked: Sequence[GivenWorlds]) -> Finding | None:
    """The smallest finding among worlds in ascending order; larger ones are not tried."""
    waves = (refute(picked[i : i + WAVE]) for i in range(0, len(picked), WAVE))
    return next((found for found in waves if found), None)


def _fewer_edges(map_: CombinatorialMap) -> Iterator[CombinatorialMap]:
    for dart, _ in map_.edges:
        for other in (deleted(map_, dart), contracted(map_, dart)):
            if other is not None:
                yield other


def _picked(scope: Scope, finding: Finding, maps: Iterable[CombinatorialMap]) -> list[GivenWorlds]:
    """Rootings and places of these maps that are smaller than the finding, ascending."""
    kind, size = scope.rules.kind, finding.key[:4]
    ordered = []
    for key in rootings(maps, scope.extent):
        if key > size[:3]:
            break
        map_ = CombinatorialMap.trusted(*key[2])
        for place, lighthouse in enumerate(kind.places(map_, 0)):
            if (*key, place) < size:
                ordered.append((World(map_, lighthouse), place))
    return in_chunks(ordered)


def rootings(maps: Iterable[CombinatorialMap], extent: Extent) -> list[tuple[int, int, Code]]:
    """Rootings of these maps of the class, each once; ordered by edges, vertices and code.

    A condition of the extent must be true of them; its bounds do not matter.
    """
    return sorted(
        {
            (map_.edge_count, map_.vertex_count, rooted_code(map_.sigma, map_.alpha, start))
            for map_ in maps
            if extent.map_class.includes(map_) and extent.admits(map_)
            for start in map_.darts
        }
    )


def in_chunks(worlds: Sequence[tuple[World, int]]) -> list[GivenWorlds]:
    """Worlds with the numbers of their places, in pieces that one worker tries at a time."""
    return [GivenWorlds(tuple(worlds[i : i + CHUNK])) for i in range(0, len(worlds), CHUNK)]
