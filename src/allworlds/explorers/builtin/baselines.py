"""Two explorers for comparison: depth-first search of numbered vertices, and one movable marker.

The second is that of Dudek, Jenkin, Milios, Wilkes 1991: the marker has no direction, and the
worlds are simple.  Each pass explores one dart.  At the unknown end of the dart the robot drops the
marker, and comes back.  Then it visits the vertices of S that may be the unknown end, and looks for
the marker there (place validation).  If the marker is at none of them, the unknown end is a new
vertex.  Otherwise one of the open darts of the vertex with the marker belongs to the explored edge.
To find it, the robot carries the marker to the known end of the dart, goes back, and tries these
open darts until one leads to the marker (back-link validation).

In a simple world the answer is right.  With parallel edges, or two loops at a vertex, back-link
validation can find a wrong dart.  A better explorer would not help: markers without a direction,
however many the robot can drop, do not show the order in which the four darts of two loops lie
round a vertex.

The source leaves three decisions open.  First: the dart that a pass explores is a choice
(``edge``).  Second: the vertices that may be the unknown end are visited in the order of a
depth-first walk along a spanning tree of S, so that the cost is at most that in the docstring of
:func:`dudek91`.  Third: the open darts of the vertex with the marker are tried clockwise, from the
dart by which the robot has come back there.
"""

from collections.abc import Callable

from allworlds.explorers.builtin.algorithm1 import PartialMap, Stage, bearing_of, nobody, walks
from allworlds.protocol.actions import Drop, Estimate, Move, Percept, Pick
from allworlds.protocol.choices import Choices


def dfs(
    first: Percept, *, choices: Choices | None = None, notice: Callable[[str], None] = nobody
) -> Stage[Estimate]:
    """Explore depth first under the lighthouse ``labels``.

    Each vertex shows its number, and the bearing of its reference dart.  The number identifies the
    vertex, and the bearing identifies the dart by which the robot arrived.

    Args:
        first: the percept at the start.
        choices: the object that makes the choices (default: first in, first out).  Each choice is
            of the kind ``edge``: the open dart by which the robot leaves a vertex.
        notice: the function that gets an event after each traversal of an open dart: ``known`` or
            ``unknown``, which tells whether the vertex at its other end was known before.

    Cost: at most 2m traversals: each edge is walked once, and at most once back.
    """
    choices = choices or Choices()
    s, here = PartialMap(first), 0
    # The number of each vertex, and its reference dart.
    reference = {first.marks: s.turn(0, bearing_of(first))}
    way: list[int] = []  # the darts that lead back to the first vertex
    while s.unexplored:
        at = s.first[s.vertex[here]]
        around = range(at, at + s.expected[at].degree)
        options = [dart for dart in around if s.alpha[dart] == dart]
        if not options:
            back = way.pop()
            yield Move(s.offset(here, back))
            here = s.alpha[back]
            continue
        cost = walks(s, s.vertex[here], options)
        dart = choices.pick(options, of="edge", cost=cost)
        seen = yield Move(s.offset(here, dart))
        if seen.marks in reference:
            notice("known")
            entry = s.turn(reference[seen.marks], -bearing_of(seen))
            s.add_loop(dart, entry)
            if s.vertex[entry] == s.vertex[dart]:
                here = entry
            elif s.unexplored:
                yield Move(0)
                here = dart
            else:
                here = entry
        else:
            notice("unknown")
            here = s.add_vertex(dart, seen)
            reference[seen.marks] = s.turn(here, bearing_of(seen))
            way.append(here)
        yield s.checkpoint(here)
    return s.estimate(here)


def dudek91(
    first: Percept, *, choices: Choices | None = None, notice: Callable[[str], None] = nobody
) -> Stage[Estimate]:
    """Explore a simple world with one marker, which the robot can drop and take up again.

    Args:
        first: the percept at the start.
        choices: the object that makes the choices of the kind ``edge``, see the docstring of this
            module (default: first in, first out).
        notice: the function that gets an event in each pass: ``new-vertex`` if the unknown end is a
            new vertex, ``back-link`` if it is a vertex of S.

    Cost in a simple world: a pass that finds a new vertex costs at most ``3s`` traversals, if s
    vertices were known before.  Any other pass costs at most ``5n + 2D - 4`` traversals, where D is
    the largest degree.  The sum is O(mn).
    """
    return (yield from _Dudek(first, choices or Choices(), notice).explore())


class _Dudek:
    """One exploration by :func:`dudek91`, with its state.

    Attributes:
        s: the map S with its open darts U.
        here: the robot's dart in S.
        seen: the percept at the start, later the percept after the robot's newest motion; it has a
            mark if the marker lay at the robot's vertex.  One kind of motion leaves ``seen`` as it
            is: the way back from a dart by which :meth:`close` has not come to the marker.
        choices, notice: as in :func:`dudek91`.
    """

    def __init__(self, first: Percept, choices: Choices, notice: Callable[[str], None]) -> None:
        self.s = PartialMap(first)
        self.here, self.seen = 0, first
        self.choices = choices
        self.notice = notice

    def explore(self) -> Stage[Estimate]:
        s = self.s
        while s.unexplored:
            cost = walks(s, s.vertex[self.here], s.unexplored)
            dart = self.choices.pick(s.unexplored, of="edge", cost=cost)
            yield from self.go(s.vertex[dart])
            yield from self.leave_by(dart)
            beyond = self.seen
            yield Drop()
            self.seen = yield Move(0)
            self.here = dart
            for vertex in self.candidates(dart, beyond):
                yield from self.go(vertex)
                if self.seen.marks:
                    self.notice("back-link")
                    yield from self.close(dart)
                    break
            else:
                self.notice("new-vertex")
                yield from self.go(s.vertex[dart])
                yield from self.leave_by(dart)
                yield Pick()
                self.here = s.add_vertex(dart, beyond)
            yield s.checkpoint(self.here)
        return s.estimate(self.here)

    def go(self, goal: int) -> Stage[None]:
        """Walk to the vertex ``goal`` by a shortest way in S."""
        s = self.s
        lengths = s.distances(goal)
        while (vertex := s.vertex[self.here]) != goal:
            nearer = lengths[vertex] - 1
            dart = next(dart for dart, other in s.ways(vertex) if lengths[other] == nearer)
            yield from self.leave_by(dart)
            self.here = s.alpha[dart]

    def leave_by(self, dart: int) -> Stage[None]:
        """Leave by a dart of the robot's vertex; set ``seen``, but do not change ``here``."""
        self.seen = yield Move(self.s.offset(self.here, dart))

    def candidates(self, explored: int, beyond: Percept) -> list[int]:
        """The vertices of S that the unknown end of the dart ``explored`` could be.

        Each of these vertices has an open dart other than ``explored``, and the degree of
        ``beyond``, which is the percept at the unknown end.  The vertices are in the order of a
        depth-first search in S that begins at the vertex of ``explored``.
        """
        s = self.s
        possible = {
            s.vertex[dart]
            for dart in s.unexplored
            if dart != explored and s.expected[dart].degree == beyond.degree
        }
        order: list[int] = []
        waiting = [s.vertex[explored]]
        while waiting:
            vertex = waiting.pop()
            if vertex not in order:
                order.append(vertex)
                waiting += [other for _, other in s.ways(vertex)]
        return [vertex for vertex in order if vertex in possible]

    def close(self, dart: int) -> Stage[None]:
        """Find the other dart of the edge of ``dart`` by back-link validation, and join both darts.

        ``dart`` is the dart that this pass explores.  The robot stands at the other end of its
        edge, where it has found the marker.  It takes the marker, drops it at the known end of
        ``dart``, and walks back to the other end.  There it tries the open darts: it leaves by an
        open dart, and comes back if the marker is not at its end.  The first dart that leads to the
        marker is joined to ``dart``.  In a simple world one of the open darts must lead to the
        marker; so the last one is joined to ``dart`` without looking for the marker.
        """
        s = self.s
        vertex = s.vertex[self.here]
        yield Pick()
        yield from self.go(s.vertex[dart])
        yield Drop()
        yield from self.go(vertex)
        entry = self.here
        around = [s.turn(entry, k) for k in range(s.expected[entry].degree)]
        partners = [other for other in around if s.alpha[other] == other and other != dart]
        for partner in partners:
            yield from self.leave_by(partner)
            # In a simple world it must be the last remaining one.
            if self.seen.marks or partner == partners[-1]:
                yield Pick()
                s.add_loop(dart, partner)
                self.here = dart
                return
            yield Move(0)
            self.here = partner
