"""Regular drawings: of lattices, in the plane and on a torus, of wheels and of rings."""

from cmath import rect
from heapq import heappop, heappush
from math import cos, pi, sin, tau
from string import ascii_lowercase
from typing import TypeAlias

from allworlds.maps.combinatorial import CombinatorialMap, Dart

Ways: TypeAlias = list[list[complex]]
"""For each dart the control points of its edge, as in ``Layout``; edges are about 1 long."""


def wheel(map_: CombinatorialMap) -> Ways:
    """The drawing of a star, or of a ring with or without a hub; empty for other maps.

    Cost: O(m log m).
    """
    alpha, (*others, most) = map_.alpha, sorted(map_.degrees)
    hub, ahead = max(map_.vertices, key=len), list[Dart]()
    if {most, *others} == {2}:
        hub, ahead = (), [*map_.faces[0]]
    elif most != len(others) or {*others} not in ({1}, {3}):
        return []
    elif others[0] == 3:
        ahead = [map_.turn(alpha[dart], -1) for dart in hub]
        behind = [map_.turn(alpha[dart], 1) for dart in (*hub[1:], hub[0])]
        if [alpha[dart] for dart in ahead] != behind:
            return []
    count = len(hub or ahead)
    radius = max((0.5 if ahead else 0.25) / sin(pi / max(count, 2)), 1 if hub else 0)
    bends = min(6, 6 // count + 1)
    step, part = tau / count, tau / count / bends
    spots = [rect(radius, step * k) for k in range(count)]
    ways = {dart: _straight(0j, spot) for dart, spot in zip(hub, spots, strict=False)}
    for k, dart in enumerate(ahead):
        outside = [step * k + part * (bend + 0.5) for bend in range(bends)]
        arc = [rect(radius / cos(part / 2), angle) for angle in outside]
        ways[dart] = [spots[k], *arc, spots[(k + 1) % count]]
    ways |= {alpha[dart]: way[::-1] for dart, way in ways.items()}
    return [ways[dart] for dart in map_.darts]


def lattice(map_: CombinatorialMap, root: Dart) -> tuple[Ways, dict[Dart, str]]:
    """The drawing of a lattice, in the plane or on a torus, with level and upright edges only.

    The first result holds the control points, the second one the letters at cut edges.  Both are
    empty if the map cannot be drawn so.

    The drawing begins at the dart ``root``, which points to the right.  The directions of other
    darts follow by these rules.  First: the two darts of an edge have opposite directions.  Second:
    two neighbouring darts of a vertex are a quarter turn apart if the face between them is a
    square, or if the vertex has four darts.  Third: if a vertex has two darts, and the first two
    rules give a direction to only one of them, the other dart gets the opposite direction.  By the
    third rule, paths are drawn, too, and some lattices with holes.

    A lattice on a torus, where all vertices and faces have degree 4, is drawn in rows.  The edges
    that would lead from one side of the drawing to the opposite side are cut.  Each dart of a cut
    edge has its own half of the edge, and a letter, the same as the other dart.

    Cost: O(m log m).
    """
    found, alpha = _walked(map_, root), map_.alpha
    if not found:
        return [], {}
    cut = {d for d, (at, k) in found.items() if found[alpha[d]] != (at + 1j**k, (k + 2) % 4)}
    torus = all(len(cycle) == 4 for cycle in (*map_.vertices, *map_.faces))
    if cut and (map_.vertex_count == 1 or not torus):
        return [], {}
    ends = [d for side in (2, 3) for d, (_, k) in found.items() if k == side and d in cut]
    letters: dict[Dart, str] = {}
    for k, dart in enumerate(ends):
        letters[dart] = letters[alpha[dart]] = ascii_lowercase[k % 26] * (k // 26 + 1)
    ways = [_straight(at, at + 1j**k) for at, k in map(found.__getitem__, map_.darts)]
    return [way[: 3 if dart in letters else 4] for dart, way in enumerate(ways)], letters


def _walked(map_: CombinatorialMap, root: Dart) -> dict[Dart, tuple[complex, int]]:
    """The point of each dart's vertex, and the dart's direction.

    The direction is a number of quarter turns clockwise from the direction to the right.  The
    vertex of ``root`` has the point 0, and ``root`` points to the right.  The result is empty
    unless all vertices have different points, and the darts round each vertex have the map's order.
    """
    sigma = map_.sigma
    square = {dart for dart in map_.darts if map_.degree_at[dart] == 4}
    square.update(*(face for face in map_.faces if len(face) == 4))
    found: dict[Dart, tuple[complex, int]] = {}
    queue: list[tuple[int, bool, int, bool, int, Dart, int]] = []

    def put(late: int, at: complex, dart: Dart, turns: int) -> None:
        # To the right before to the left, and then down: so a torus is cut into rows.
        x, y = int(at.real), int(at.imag)
        heappush(queue, (late, y < 0, y, x < 0, x, dart, turns % 4))

    put(0, 0j, root, 0)
    while queue:
        _, _, y, _, x, dart, turns = heappop(queue)
        if dart in found:
            continue
        here, _ = found[dart] = complex(x, y), turns
        put(1, here + 1j**turns, map_.alpha[dart], turns + 2)
        if sigma[dart] in square:
            put(0, here, sigma[dart], turns + 1)
        if dart in square:
            put(0, here, map_.turn(dart, -1), turns + 3)
        if map_.degree_at[dart] == 2:
            put(2, here, sigma[dart], turns + 2)
    spots = {(map_.vertex_of[dart], here) for dart, (here, _) in found.items()}
    fits = len(found) == len(sigma) and all(
        sum((found[sigma[d]][1] - found[d][1] - 1) % 4 + 1 for d in vertex) == 4
        for vertex in map_.vertices
    )
    own = len(spots) == len({here for _, here in spots}) == map_.vertex_count
    return found if fits and own else {}


def _straight(here: complex, there: complex) -> list[complex]:
    first = 0.4 * (there - here) / abs(there - here)
    return [here, here + first, there - first, there]
