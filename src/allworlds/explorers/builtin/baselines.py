"""Two explorers for comparison: depth-first search of numbered vertices, and one movable marker.

The second is that of Dudek, Jenkin, Milios, Wilkes 1991: the marker has no direction, and the
worlds are simple.  Each pass explores one dart.  At the unknown end of the dart the robot drops the
marker, comes back, and looks for the marker at the vertices of S that this end could be (place
validation).  If the marker is at none of them, the end is a new vertex.  Otherwise the robot
carries the marker to the known end of the dart, and tries the open darts at the vertex where the
marker was until one leads to the marker (back-link validation).

In a simple world the answer is right.  With parallel edges, or two loops at a vertex, back-link
validation can find a wrong dart.  A better explorer would not help: markers without a direction,
however many the robot can drop, do not show how two loops at a vertex lie.

The source leaves three points open; this module decides them so.  The dart that the next pass
explores is a choice (``edge``).  The vertices that the unknown end could be are visited in the
order of a depth-first walk of a spanning tree of S: in another order the walk could be longer than
the cost that the docstring of :func:`dudek91` names.  The open darts of the vertex where the marker
was are tried clockwise from the dart by which the robot arrived there.
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

    Cost: in a simple world at most ``3s`` traversals for a vertex that is found when s vertices are
    known, and ``5n + 2D - 4`` for every other edge, where D is the largest degree: O(mn).
    """
    return (yield from _Dudek(first, choices or Choices(), notice).explore())


class _Dudek:
    """One exploration by :func:`dudek91`, with its state.

    Attributes:
        s: the map S with its open darts U.
        here: the robot's dart in S.
        seen: the percept after the robot's newest motion, at first that at the start; it has a
            mark if the marker lies at the robot's vertex.  The motions by which :meth:`close`
            comes back from a wrong dart do not change it.
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

        ``dart`` is the dart that this pass explores.  The robot stands at the vertex where it has
        found the marker.  It carries the marker to the known end of ``dart`` and goes back.  Then
        it leaves by one open dart of the vertex after the other, and comes back, until a dart leads
        to the marker.  This dart is joined to ``dart``.  If none of the open darts leads to the
        marker, the last one is joined to ``dart``.
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
