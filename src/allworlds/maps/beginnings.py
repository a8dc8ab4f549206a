"""Beginnings of maps: whether a partial gluing can still become a map with some property.

A rule may say True of a beginning that comes to nothing, but False only where no map of the
property begins so.  The enumeration asks after each decision, so that it makes few maps in vain;
whether a finished map has the property is looked at besides.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, TypeAlias

if TYPE_CHECKING:
    from allworlds.maps.enumeration import Gluing

OPEN = -1

Beginning: TypeAlias = "Callable[[Gluing, int], bool]"
"""Of a partial gluing and the number of the condition: whether a map of it may begin so."""


def any_map(_gluing: Gluing, _number: int) -> bool:
    """True: nothing is known of the beginnings."""
    return True


def regular(gluing: Gluing, degree: int) -> bool:
    """Every vertex so far has this degree, and the owed darts make vertices of it."""
    room = gluing.limit - len(gluing.degrees)
    return (
        all(met == degree for met in gluing.degrees)
        and gluing.owed % degree == 0
        and gluing.owed <= room * degree
    )


def even(gluing: Gluing, _number: int) -> bool:
    """Every vertex so far has an even degree."""
    return not any(degree % 2 for degree in gluing.degrees)


def tree(gluing: Gluing, _number: int) -> bool:
    """Each edge so far has led to a new vertex, and each open dart can, too."""
    open_darts = sum(map(len, gluing.faces))
    edges = (len(gluing.alpha) - open_darts) // 2
    return (
        edges == len(gluing.degrees) - 1
        and open_darts <= gluing.owed
        and gluing.limit == gluing.edges + 1
    )


def girth_at_least(gluing: Gluing, least: int) -> bool:
    """The cycle that the newest edge closes, if it closes one, has at least this length."""
    dart = gluing.newest
    if dart == OPEN:
        return True
    u, v = gluing.vertex[dart], gluing.vertex[gluing.alpha[dart]]
    between = _neighbours_but(gluing, dart)
    ring, met = {u}, {u}
    for length in range(1, least):
        if v in ring:
            return False
        ring = {w for x in ring for w in between[x]} - met
        met |= ring
        if not ring or length + 1 == least:
            break
    return True


def _neighbours_but(gluing: Gluing, dart: int) -> list[set[int]]:
    """The vertices next to each vertex, by another edge than that of the dart."""
    found: list[set[int]] = [set() for _ in gluing.degrees]
    for d, e in enumerate(gluing.alpha):
        if e != OPEN and d not in (dart, gluing.alpha[dart]):
            found[gluing.vertex[d]].add(gluing.vertex[e])
    return found


def genus_exactly(gluing: Gluing, genus: int) -> bool:
    """The surface so far has no more handles, and enough cycles to get as many are to come.

    Closed edges alone make a surface whose handles stay; of a finished map with n vertices and one
    face at least, ``2g <= m - n + 1``.
    """
    vertices = len(gluing.degrees)
    most = (gluing.edges - vertices - (gluing.owed > 0) + 1) // 2
    if genus > most:
        return False
    closed = [d for d, e in enumerate(gluing.alpha) if e != OPEN]
    if not closed:
        return True
    faces = _faces_of_closed(gluing, closed)
    return 2 - vertices + len(closed) // 2 - faces <= 2 * genus


def _faces_of_closed(gluing: Gluing, closed: list[int]) -> int:
    """The number of faces round the closed edges, as if there were no open darts."""
    at: dict[int, list[int]] = {}
    for dart in closed:
        at.setdefault(gluing.vertex[dart], []).append(dart)
    following = {
        dart: after
        for darts in at.values()
        for dart, after in zip(darts, [*darts[1:], darts[0]], strict=True)
    }
    left, faces = set(closed), 0
    while left:
        faces += 1
        dart = start = left.pop()
        while (dart := following[gluing.alpha[dart]]) != start:
            left.remove(dart)
    return faces
