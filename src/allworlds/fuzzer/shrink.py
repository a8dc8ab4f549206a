"""From a large refuting world down to one that no small change makes smaller."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

from allworlds.checker.finding import Finding, canonical_world
from allworlds.checker.scope import Picked, Scope
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.surgery import contracted, deleted, moved
from allworlds.world import World

Refute = Callable[[Sequence[Picked]], Finding | None]
"""The smallest finding among these worlds, or None."""

CHUNK = 200
"""The worlds that are tried at a time, so that a large neighbourhood is shared by workers."""


def shrink(finding: Finding, scope: Scope, refute: Refute) -> Finding:
    """A refuting world from which no neighbour in the size order refutes.

    First an edge is deleted or contracted as long as that is possible; then, with as many
    edges, a dart may move and the start and the marker may turn, towards fewer vertices and
    the smaller code.  Every neighbour is rooted everywhere and lit from every place, and the
    smallest refuting one is taken, so the result depends on nothing but the finding.

    Cost: O(m^3) runs for each step with fewer edges.
    """
    while True:
        smaller = refute(_picked(scope, finding, _fewer_edges(finding.world.map)))
        if smaller is None:
            same = [finding.world.map, *moved(finding.world.map)]
            smaller = refute(_picked(scope, finding, same))
        if smaller is None:
            return finding
        finding = smaller


def _fewer_edges(map_: CombinatorialMap) -> Iterator[CombinatorialMap]:
    for dart, _ in map_.edges:
        for other in (deleted(map_, dart), contracted(map_, dart)):
            if other is not None:
                yield other


def _picked(scope: Scope, finding: Finding, maps: Iterable[CombinatorialMap]) -> list[Picked]:
    """Every rooting and place of these maps that is smaller than the finding, once each."""
    kind = scope.rules.kind
    size = finding.key[:4]
    worlds = {}
    for map_ in maps:
        if not scope.bounds.map_class.includes(map_):
            continue
        for start in map_.darts:
            for place, lighthouse in enumerate(kind.places(map_, start)):
                world = canonical_world(World(map_, lighthouse, start))
                code = (world.map.sigma, world.map.alpha)
                key = (map_.edge_count, map_.vertex_count, code, place)
                if key < size:
                    worlds[key] = (world, place)
    ordered = [worlds[key] for key in sorted(worlds)]
    return [Picked(tuple(ordered[i : i + CHUNK])) for i in range(0, len(ordered), CHUNK)]
