"""The view of a map with robots, from a dart; it does not depend on the numbers of the darts."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from functools import lru_cache
from typing import Any, NamedTuple, TypeAlias

from allworlds.maps.combinatorial import CombinatorialMap, Dart, Vertex


class ViewOrder(NamedTuple):
    """The order of vertices and darts in the view from a dart.

    Attributes:
        vertices: the vertices, in the order in which a depth-first walk reaches them.  The walk
            begins at the dart.  At each vertex it tries the darts in their order round the vertex,
            from the dart of arrival on.
        degrees: the degrees of these vertices.
        alpha: the other end of each dart; the darts are numbered vertex by vertex, in the order in
            which the walk tries them.
    """

    vertices: tuple[Vertex, ...]
    degrees: tuple[int, ...]
    alpha: tuple[int, ...]


Sight: TypeAlias = list[list[int]]
"""Three lists: the number of robots at each vertex, the degree of each vertex, and the other end of
each dart; see :class:`ViewOrder`."""


@lru_cache(maxsize=1 << 12)
def view_order(map_: CombinatorialMap, dart: Dart, clockwise: int) -> ViewOrder:
    """The order in the view from a dart: clockwise if ``clockwise`` is 1, anticlockwise if -1."""
    darts_at: dict[Vertex, list[Dart]] = {}
    stack = [dart]
    while stack:
        arrival = stack.pop()
        vertex = map_.vertex_of[arrival]
        if vertex not in darts_at:
            offsets = range(map_.degree_at[arrival])
            darts_at[vertex] = [map_.turn(arrival, clockwise * offset) for offset in offsets]
            stack += [map_.alpha[each] for each in reversed(darts_at[vertex])]
    order = [each for around in darts_at.values() for each in around]
    number = {each: index for index, each in enumerate(order)}
    alpha = tuple([number[map_.alpha[each]] for each in order])
    return ViewOrder(tuple(darts_at), tuple(map(len, darts_at.values())), alpha)


class Eyes(NamedTuple):
    """The limits of a robot's sight.

    Attributes:
        here: the largest number of robots that the robot can see at its own vertex; a larger number
            is seen as this number.
        elsewhere: the largest number of robots that the robot can see at any other vertex.
    """

    here: int
    elsewhere: int

    def view(
        self, map_: CombinatorialMap, darts: Sequence[Dart], dart: Dart, clockwise: int = 1
    ) -> Sight:
        """The view from ``dart``: three lists, see :data:`Sight`.

        ``darts`` has the dart of each robot.  The numbers of robots in the view are at most
        :attr:`here` and :attr:`elsewhere`.  The view is clockwise if ``clockwise`` is 1,
        anticlockwise if it is -1.
        """
        at = Counter(map_.vertex_of[each] for each in darts)
        vertices, degrees, alpha = view_order(map_, dart, clockwise)
        robots = [min(at[vertex], self.elsewhere) for vertex in vertices]
        robots[0] = min(at[vertices[0]], self.here)
        return [robots, [*degrees], [*alpha]]

    def views(self, map_: CombinatorialMap, darts: Sequence[Dart], dart: Dart) -> dict[Dart, Sight]:
        """For each dart of the vertex of ``dart`` the smaller one of its two views.

        The two views of a dart are the clockwise and the anticlockwise view; smaller is meant in
        Python's order of lists.  ``darts`` has the dart of each robot.
        """
        found = {}
        for each in map_.vertices[map_.vertex_of[dart]]:
            found[each] = min(self.view(map_, darts, each, way) for way in (1, -1))
        return found


def least(map_: CombinatorialMap, dart: Dart) -> Dart:
    """The least dart at the vertex of a dart; it stands for a robot there that has no heading."""
    return map_.vertices[map_.vertex_of[dart]][0]


def darts_of_view(views: dict[Dart, Any], index: int) -> list[Dart]:
    """The darts whose view equals the view with this index in the sorted list of all views."""
    wanted = sorted(views.values())[index]
    return [dart for dart, view in views.items() if view == wanted]
