"""Maps that are drawn as what they are: lattices, in the plane and on a torus, wheels and rings."""

from __future__ import annotations

from cmath import rect
from math import cos, pi, sin, tau
from string import ascii_lowercase
from typing import TypeAlias

from allworlds.maps.combinatorial import CombinatorialMap, Dart

Ways: TypeAlias = list[list[complex]]
"""For each dart the points that its edge is drawn towards; edges are about 1 long."""


def wheel(map_: CombinatorialMap) -> Ways:
    """The drawing of a star, or of a ring, with or without a hub in its middle; else nothing.

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
    spots = [rect(radius, step * k) for k in range(count + 1)]
    ways = {dart: _straight(0j, spot) for dart, spot in zip(hub, spots, strict=False)}
    for k, dart in enumerate(ahead):
        outside = [step * k + part * (bend + 0.5) for bend in range(bends)]
        arc = [rect(radius / cos(part / 2), angle) for angle in outside]
        ways[dart] = [spots[k], *arc, spots[(k + 1) % count]]
    ways |= {alpha[dart]: way[::-1] for dart, way in ways.items()}
    return [ways[dart] for dart in map_.darts]


QUARTERS: dict[complex, int] = {1j: 1, -1: 2, -1j: 3, 1: 4}
"""The quarter turns clockwise from the direction 1; y is downwards."""


def lattice(map_: CombinatorialMap) -> Ways:
    """The drawing of a lattice in the plane, upright; else nothing.

    The direction of a dart follows from the other end of its edge, and from a dart beside it where
    a square lies between them, or where four darts meet.  One of two darts at a vertex leads
    straight on from the other if nothing else decides: so paths are drawn, too, and lattices with
    few holes.

    Cost: linear in the darts.
    """
    owner, alpha, sigma = map_.vertex_of, map_.alpha, map_.sigma
    square = {dart for dart in map_.darts if map_.degree_at[dart] == 4}
    for face in map_.faces:
        if len(face) == 4 == len({owner[dart] for dart in face}):
            square.update(face)
    found: dict[Dart, tuple[complex, complex]] = {}
    sure, perhaps = [(0, 0j, 1 + 0j)], list[tuple[Dart, complex, complex]]()
    while sure or perhaps:
        dart, here, ahead = (sure or perhaps).pop()
        if dart in found:
            continue
        found[dart] = here, ahead
        sure.append((alpha[dart], here + ahead, -ahead))
        if sigma[dart] in square:
            sure.append((sigma[dart], here, ahead * 1j))
        if dart in square:
            sure.append((map_.turn(dart, -1), here, ahead * -1j))
        if map_.degree_at[dart] == 2:
            perhaps.append((sigma[dart], here, -ahead))
    spots = {owner[dart]: here for dart, (here, _) in found.items()}
    fits = len({*spots.values()}) == map_.vertex_count and all(
        dart in found
        and found[dart][0] == spots[owner[dart]]
        and found[alpha[dart]] == (sum(found[dart]), -found[dart][1])
        for dart in map_.darts
    )
    if not fits or any(
        sum(QUARTERS[found[sigma[d]][1] / found[d][1]] for d in vertex) != 4
        for vertex in map_.vertices
    ):
        return []
    return [_straight(found[dart][0], sum(found[dart])) for dart in map_.darts]


def torus(map_: CombinatorialMap, root: Dart) -> tuple[Ways, dict[Dart, str]]:
    """The drawing of a lattice on a torus, cut into rows, the root's vertex first; else nothing.

    All vertices and faces have degree 4 in it, and it has more than one vertex.  The darts of an
    edge that is cut have each a way to its half alone, and a letter.

    Cost: linear in the darts.
    """
    cycles = (*map_.vertices, *map_.faces)
    if map_.vertex_count == 1 or any(len(cycle) != 4 for cycle in cycles):
        return [], {}
    rows = min(_rows(map_, root), _rows(map_, map_.turn(root, 1)))[-1]
    ends = [map_.turn(row[0], 2) for row in rows] + [map_.turn(dart, 3) for dart in rows[0]]
    letters = {}
    for k, dart in enumerate(ends):
        letters[dart] = letters[map_.alpha[dart]] = ascii_lowercase[k % 26] * (k // 26 + 1)
    ways = {
        map_.turn(dart, k): _straight(complex(x, y), complex(x, y) + 1j**k)
        for y, row in enumerate(rows)
        for x, dart in enumerate(row)
        for k in range(4)
    }
    return [ways[d][: 3 if d in letters else 4] for d in map_.darts], letters


def _rows(map_: CombinatorialMap, root: Dart) -> tuple[bool, bool, list[list[Dart]]]:
    """Whether columns do not close, whether there are more rows than columns, and the rows.

    A row consists of the darts that lead along it to the right, the first from the root's vertex.
    """
    rows, first, seen = list[list[Dart]](), root, set[int]()
    while map_.vertex_of[first] not in seen:
        row = [first]
        while (dart := map_.turn(map_.alpha[row[-1]], 2)) != first:
            row.append(dart)
        rows.append(row)
        seen.update(map_.vertex_of[dart] for dart in row)
        first = map_.turn(map_.alpha[map_.turn(first, 1)], 1)
    return first != root, len(rows) > len(rows[0]), rows


def _straight(here: complex, there: complex) -> list[complex]:
    first = 0.4 * (there - here) / abs(there - here)
    return [here, here + first, there - first, there]
