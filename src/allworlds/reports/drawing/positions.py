"""Layouts at given positions of the vertices.

Edges are straight; only loops and parallel edges are bent.  If the edges then leave a vertex in
another order than the map's, the positions are ignored, and the map is drawn by ``layout``.
"""

from cmath import phase, rect
from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import chain, pairwise
from math import isclose, tau

from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.reports.drawing.layout import DISC, STUB, WIDEST, Layout, layout
from allworlds.reports.parts import Scene
from allworlds.world.labels import PlanePoint

SHORTEST = 3 * STUB
"""In pixels: the least length of an edge, and how far a loop reaches."""

APART = 0.5
"""The largest angle between neighbouring parallel edges, in radians."""

WIDE = 0.35 * tau
"""The largest angle between the ends of a loop, since a wider loop would run over its vertex."""


def laid_out(scene: Scene) -> Layout:
    """The drawing with the vertices at the scene's positions.

    Without positions, or if they do not fit the map, it is the drawing of :func:`layout`.
    """
    placed = at_positions(scene.map, scene.positions) if scene.positions else None
    return placed or layout(scene.map, scene.root)


@lru_cache(maxsize=256)
def at_positions(map_: CombinatorialMap, positions: Sequence[PlanePoint]) -> Layout | None:
    """The drawing with each vertex at its position; parallel edges and loops are bent.

    None if the edges leave a vertex in another order than the map's, if there is not enough room,
    or if the map has fewer than three vertices.

    Cost: O(n m).
    """
    points, owner = [complex(x, -y) for x, y in positions], map_.vertex_of
    lines = [(owner[a], owner[b]) for a, b in map_.edges if owner[a] != owner[b]]
    least = min((abs(points[u] - points[v]) for u, v in lines), default=0.0)
    if not least or map_.vertex_count < 3:
        return None
    across = (max(xs) - min(xs) for xs in zip(*positions, strict=True))
    scale = min(2 * SHORTEST / least, WIDEST / max(across))
    centres = [(point - points[0]) * scale for point in points]
    near = (
        _distance(centre, centres[u], centres[v]) < 3 * DISC
        for u, v in lines
        for w, centre in enumerate(centres)
        if w not in (u, v)
    )
    if least * scale < SHORTEST or any(near):
        return None
    angles = dict(chain.from_iterable(_angles(map_, vertex, centres) for vertex in map_.vertices))
    if len(angles) < len(map_.sigma):
        return None
    ways = []
    for dart, other in enumerate(map_.alpha):
        start, end = centres[owner[dart]], centres[owner[other]]
        if start == end and abs(phase(rect(1, angles[dart] - angles[other]))) > WIDE:
            return None
        reach = abs(end - start) / 3 or SHORTEST
        middle = (start + rect(reach, angles[dart]), end + rect(reach, angles[other]))
        ways.append((start, *middle, end))
    return Layout(tuple(centres), tuple(ways))


def _distance(point: complex, start: complex, end: complex) -> float:
    """The distance of a point from the nearest point of the line from ``start`` to ``end``."""
    along = (point - start) / (end - start)
    return abs(along - min(max(along.real, 0), 1)) * abs(end - start)


def _angles(
    map_: CombinatorialMap, around: Sequence[Dart], centres: Sequence[complex]
) -> Iterator[tuple[Dart, float]]:
    """Yield the darts of a vertex, each with the angle at which the dart leaves the vertex.

    A dart leaves towards the position of the vertex at its other end.  Parallel edges to the same
    vertex leave side by side.  A loop leaves next to the dart before it, clockwise, that is no
    loop.

    Nothing is yielded if the positions contradict the map: if the other vertices stand round this
    vertex in another order than ``around`` has them.

    Args:
        map_: a map with at least two vertices, so that each vertex has a dart that is no loop.
        around: the darts of the vertex, clockwise as in the map; clockwise, angles grow.
        centres: the positions of all vertices.
    """
    owner, alpha = map_.vertex_of, map_.alpha
    here, ends = owner[around[0]], {dart: owner[alpha[dart]] for dart in around}
    towards = {d: centres[end] - centres[here] for d, end in ends.items() if end != here}
    lines = [*towards]
    # The first of a bundle of parallel edges; where all are one, its last at the other end.
    firsts = (b for a, b in pairwise([lines[-1], *lines]) if ends[a] != ends[b])
    lasts = (d for d in lines if owner[alpha[map_.sigma[alpha[d]]]] != here)
    at = around.index(next(chain(firsts, lasts)))
    groups = list[list[Dart]]()
    for dart in chain(around[at:], around[:at]):
        if dart in towards and (not groups or ends[dart] != ends[groups[-1][0]]):
            groups.append([])
        groups[-1].append(dart)
    ways = [towards[darts[0]] for darts in groups]
    gaps = [phase(b / a) % tau for a, b in pairwise([*ways, ways[0]])] if len(ways) > 1 else [tau]
    if not isclose(sum(gaps), tau):
        return
    for darts, way, before, after in zip(groups, ways, [gaps[-1], *gaps], gaps, strict=False):
        straight = [i for i, dart in enumerate(darts) if dart in towards]
        middle = (straight[0] + straight[-1]) / 2
        outermost = max(middle, len(darts) - 1 - middle, 0.5)
        apart = min(APART, 0.4 * min(before, after) / outermost)
        for i, dart in enumerate(darts):
            yield dart, phase(way) + apart * (i - middle)
