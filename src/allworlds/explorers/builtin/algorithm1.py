"""Algorithm 1 of the paper, which maps with one directional lighthouse, and its partial map.

Each group of lines of the paper's Algorithm 1 is a function.  The docstrings keep the paper's
names: S and U are the explored part and its open darts; e is the dart of U that is explored now,
v_k its known end and v_u its unknown end; H holds the hypotheses, e' is one of them, at the vertex
v_k'; M are the motions of a test, P the percepts that the test expects.  In variants without a
direction a test ends with a *query* at v0: the robot goes out by one dart and straight back, to
learn by which dart it had come to v0.

Each decision that the paper leaves open is a choice.  A policy gets the options of the choice, and
for each option a *cost*, a walking distance: the policy ``nearest`` takes the dart with the
smallest cost.  The *order of S* is the order in which the darts came into S, which is also that of
their numbers.  The choices:

``edge``
    The dart that leaves U (line 3).  Options: U in the order of S; cost: the length of the shortest
    walk in S from the robot's vertex to the dart's vertex.
``transit``
    The next dart of the simple path in S to v_k (line 4).  Options and costs: see below.
``hypothesis``
    The hypothesis that leaves H (line 8).  Options: H in the order of S; cost: the length of
    the shortest path from the hypothesis to v0.
``path``
    The next dart of the simple path in S from v_k' to v0 (line 9).  Options and costs: see below.

A simple path enters no vertex twice.  For ``transit`` and ``path`` an option is a dart from which
the path can still go on to its goal; the cost of the option is the length of the shortest such way,
which begins with this dart.  The options are sorted by their costs; options with equal costs are in
the order of S.  So each simple path is one sequence of choices; if the first option is always
taken, the path is a shortest one.
"""

from collections.abc import Callable, Generator, Iterator, Sequence
from functools import cache, cached_property
from typing import Any, TypeAlias, TypeVar

from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.protocol.actions import Action, Checkpoint, Estimate, Move, Percept
from allworlds.protocol.choices import ChoiceKind, Choices


def bearing_of(percept: Percept) -> int:
    """The bearing of a percept; raise ValueError if the percept has none."""
    if percept.bearing is None:
        raise ValueError("this explorer needs a bearing here, and the lighthouse shows none")
    return percept.bearing


class PartialMap:
    """S with its open darts U, as Algorithm 1 builds it.

    The darts of a vertex are consecutive and clockwise.  Dart 0 is the dart that the robot faces at
    the start, and the first dart of each later vertex is the dart by which the robot discovered it.

    Attributes:
        sigma, alpha: the permutations so far; ``alpha[d] == d`` for an open dart.
        vertex: for each dart its vertex; vertex 0 is v0.
        first: for each vertex its first dart.
        expected: for each dart the percept of a robot that has arrived by it.
        unexplored: U, in the order in which its darts came into S.
    """

    def __init__(self, first: Percept) -> None:
        self.sigma: list[int] = []
        self.alpha: list[int] = []
        self.vertex: list[int] = []
        self.first: list[int] = []
        self.expected: list[Percept] = []
        self.unexplored: list[int] = []
        self._add_vertex(first)
        if (bearing := first.bearing) is not None:
            degree, marks = first.degree, first.marks
            self.expected = [Percept(degree, marks, (bearing - d) % degree) for d in range(degree)]

    def offset(self, start: int, end: int) -> int:
        """The ``k``, from 0 on, with ``sigma^k(start) == end``, for two darts of one vertex."""
        return (end - start) % self.expected[start].degree

    def turn(self, dart: int, offset: int) -> int:
        """The dart ``sigma^offset(dart)``."""
        first = self.first[self.vertex[dart]]
        return first + (dart - first + offset) % self.expected[dart].degree

    def add_vertex(self, dart: int, percept: Percept) -> int:
        """Lines 20-21: add a vertex at the unknown end of ``dart``; return its first dart.

        ``percept`` is the robot's percept at the new vertex.  ``dart`` and the first dart of the
        new vertex become one edge.  ``dart`` leaves U, and the other darts of the new vertex join
        U.
        """
        entry = self._add_vertex(percept)
        self.add_loop(dart, entry)
        return entry

    def add_loop(self, dart: int, partner: int) -> None:
        """Lines 18-19: join ``dart`` and ``partner`` to one edge; both darts leave U.

        Here *loop* means an edge that closes a cycle in S; its ends may be two different vertices.
        """
        self.alpha[dart], self.alpha[partner] = partner, dart
        self.unexplored.remove(dart)
        self.unexplored.remove(partner)

    def ways(self, vertex: int) -> Iterator[tuple[int, int]]:
        """Yield the darts of a vertex that are not open, clockwise, each with the vertex behind."""
        first = self.first[vertex]
        for dart in range(first, first + self.expected[first].degree):
            other = self.alpha[dart]
            if other != dart:
                yield dart, self.vertex[other]

    def distances(self, goal: int, avoiding: Sequence[int] = ()) -> dict[int, int]:
        """For each vertex the length of a shortest walk in S to ``goal``.

        The walks neither begin in nor enter the vertices of ``avoiding``.  A vertex from which no
        such walk leads to ``goal`` is missing in the result.
        Cost: O(m).
        """
        length = {goal: 0}
        for vertex in (queue := [goal]):
            for _, other in self.ways(vertex):
                if other not in length and other not in avoiding:
                    length[other] = length[vertex] + 1
                    queue.append(other)
        return length

    def checkpoint(self, here: int) -> Checkpoint:
        """The checkpoint that shows S, U and the robot's dart ``here``."""
        return Checkpoint(tuple(self.sigma), tuple(self.alpha), here)

    def estimate(self, here: int) -> Estimate:
        """The answer with the map S and the robot's dart ``here``; no dart of S may be open."""
        return Estimate(CombinatorialMap(self.sigma, self.alpha), here)

    def _add_vertex(self, percept: Percept) -> int:
        start, degree = len(self.sigma), percept.degree
        darts = range(start, start + degree)
        self.sigma.extend(darts[1:])
        self.sigma.append(start)
        self.alpha.extend(darts)
        self.vertex.extend([len(self.first)] * degree)
        self.first.append(start)
        self.expected.extend([percept] * degree)
        self.unexplored.extend(darts)
        return start


class Lazy(Sequence[int]):
    """A sequence of integers that is computed only when a policy reads it.

    Args:
        compute: the function that returns all integers of the sequence.
        first: the first integer, if it is known already; it is then read without ``compute``.
    """

    def __init__(self, compute: Callable[[], list[int]], first: int | None = None) -> None:
        self._compute, self._first = compute, first

    @cached_property
    def _values(self) -> list[int]:
        return self._compute()

    def __len__(self) -> int:
        return len(self._values)

    def __getitem__(self, index: Any) -> Any:
        if index == 0 and self._first is not None:
            return self._first
        return self._values[index]


def walks(s: PartialMap, start: int, darts: list[int]) -> Lazy:
    """For each of ``darts`` the length of a shortest walk in S from ``start`` to the dart's vertex.

    ``start`` is a vertex.
    """

    def compute() -> list[int]:
        lengths = s.distances(start)
        return [lengths[s.vertex[dart]] for dart in darts]

    return Lazy(compute)


def simple_path(
    s: PartialMap, start: int, goal: int, choices: Choices, kind: ChoiceKind
) -> Iterator[int]:
    """Yield the darts by which a simple path from ``start`` to ``goal`` leaves its vertices.

    ``start`` and ``goal`` are vertices of S.  Each dart is a choice of the kind ``kind``, which is
    ``transit`` or ``path``.
    """
    vertex = start
    visited: list[int] = []
    lengths = s.distances(goal) if start != goal else {}
    while vertex != goal:
        visited.append(vertex)
        options, costs = _next_darts(s, goal, visited, lengths)
        dart = choices.pick(options, of=kind, cost=costs)
        vertex = s.vertex[s.alpha[dart]]
        yield dart


def _next_darts(
    s: PartialMap, goal: int, visited: list[int], lengths: dict[int, int]
) -> tuple[Lazy, Lazy]:
    """The options for the next dart of a simple path, and the cost of each option.

    The options are the darts from which the path can go on to the vertex ``goal`` and enter no
    vertex of ``visited`` again.  The cost of a dart is the length of the shortest such way, which
    begins with the dart's own edge.

    Let the path so far be a part of a shortest path to ``goal``.  Then the first option is the
    first dart, clockwise, that leads nearer to ``goal``, and ``lengths`` suffices to find it.  The
    other options are computed only if a policy reads them.

    Args:
        s: the map S.
        goal: the vertex where the path ends.
        visited: the vertices of the path so far; the last one is the vertex that the path leaves
            next.
        lengths: for each vertex of S its distance to ``goal`` in the whole of S.
    """
    vertex = visited[-1]

    @cache
    def ranked() -> list[tuple[int, int]]:
        left = s.distances(goal, visited)
        return sorted((left[other] + 1, dart) for dart, other in s.ways(vertex) if other in left)

    first = None
    if lengths[vertex] + len(visited) - 1 == lengths[visited[0]]:
        first = next(d for d, other in s.ways(vertex) if lengths[other] == lengths[vertex] - 1)
    options = Lazy(lambda: [dart for _, dart in ranked()], first)
    return options, Lazy(lambda: [length for length, _ in ranked()])


R = TypeVar("R")
Stage: TypeAlias = Generator[Action | Checkpoint, Percept, R]
"""A part of the exploration that ends with a value of type R."""


def nobody(_event: str) -> None:
    """Ignore an event."""


def algorithm1(
    first: Percept, *, choices: Choices | None = None, notice: Callable[[str], None] = nobody
) -> Stage[Estimate]:
    """Explore from a directional lighthouse; return an estimate equal to the world, pose included.

    Args:
        first: the percept at v0 before any motion; it has a bearing.
        choices: the object that makes all choices that the docstring of this module lists (default:
            the first option, for ``edge`` the open dart that came into S first).
        notice: the function that gets the name of each event.  ``case-1``: a test fails before its
            last motion.  ``case-2``: a test fails after its last motion.  ``case-3``: a test
            succeeds.  ``v0-hypothesis``: a hypothesis at v0 is tested, so the path to v0 is empty.
            ``empty-H``: a pass has no hypothesis.  ``loop``: S has grown by an edge between two
            known vertices, or from a vertex to itself.  ``non-loop``: S has grown by a vertex.  The
            function has no influence on the walk.

    Cost: at most (1) + (2) traversals, by the formulas (1) and (2) of the paper's Section VI.
    Source: Algorithm 1, Section IV.
    """
    return (yield from Algorithm1(first, choices or Choices(), notice).explore())


class Algorithm1:
    """One exploration.  Methods are groups of lines of Algorithm 1, which a variant can override.

    Attributes:
        s: the map S with its open darts U.
        here: the robot's dart in S; only meaningful between two passes.
        turned: a correction for the next motion.  Motions are planned for a robot that stands at
            the dart by which it came in.  But the robot sometimes goes out and comes back, and then
            stands at the dart by which it went out: at v_u after a rejected test, and at v0 after a
            query (in a variant).  Then ``turned`` is the number of darts, clockwise, from the dart
            by which the robot came in to the dart where it stands, and a planned motion ``k`` is
            made by ``Move(k - turned)``.  Otherwise ``turned`` is 0.  It is meaningful from the
            first test of a pass to the end of the pass.

    Args:
        first: the percept at v0 before any motion.
        choices, notice: as in :func:`algorithm1`.
    """

    def __init__(
        self, first: Percept, choices: Choices, notice: Callable[[str], None] = nobody
    ) -> None:
        self.s = PartialMap(self.reads(first))  # line 1
        self.here = 0
        self.turned = 0
        self.choices = choices
        self.notice = notice

    def explore(self) -> Stage[Estimate]:
        """Lines 2-22: explore one dart of U in each pass, until U is empty."""
        while self.s.unexplored:
            goal = self.take_from_u()
            percept = self.reads((yield from self.follow(goal)))
            hypotheses = self.hypotheses(goal, percept)
            if not hypotheses:
                self.notice("empty-H")
            partner = yield from self.test_all(hypotheses)
            if partner is None:
                self.notice("non-loop")
                self.augment_by_vertex(goal, percept)
            else:
                self.notice("loop")
                self.augment_by_loop(goal, partner)
            yield self.s.checkpoint(self.here)
        return self.answer()

    def reads(self, percept: Percept) -> Percept:
        """The part of a percept that the algorithm compares: the whole percept."""
        return percept

    def take_from_u(self) -> int:
        """Line 3: the dart e of U that this pass explores."""
        s = self.s
        cost = walks(s, s.vertex[self.here], s.unexplored)
        return self.choices.pick(s.unexplored, of="edge", cost=cost)

    def follow(self, goal: int) -> Stage[Percept]:
        """Lines 4-5: walk through S to v_k, the known end of the dart ``goal``, and leave by it."""
        s, at = self.s, self.here
        for dart in simple_path(s, s.vertex[at], s.vertex[goal], self.choices, "transit"):
            yield Move(s.offset(at, dart))
            at = s.alpha[dart]
        return (yield Move(s.offset(at, goal)))

    def hypotheses(self, goal: int, percept: Percept) -> list[int]:
        """Line 6: H, the darts of U, except e, by which a robot arrives with this percept.

        ``goal`` is the dart e, and ``percept`` is the robot's percept at v_u.  At v0 a percept
        includes the bearing, so a hypothesis at v0 needs no further test.
        """
        s = self.s
        return [d for d in s.unexplored if d != goal and s.expected[d] == percept]

    def test_all(self, hypotheses: list[int]) -> Stage[int | None]:
        """Lines 7-17: test the hypotheses in turn; return the confirmed hypothesis e', or None.

        Tested hypotheses are removed from the list ``hypotheses``.
        """
        self.turned = 0
        while hypotheses:
            cost = walks(self.s, 0, hypotheses)
            partner = self.choices.pick(hypotheses, of="hypothesis", cost=cost)
            hypotheses.remove(partner)  # line 8
            path = self.path_to_v0(partner)
            if not path:
                self.notice("v0-hypothesis")
            motions, matched = yield from self.try_path(partner, path)
            if matched:  # case (3)
                self.notice("case-3")
                self.here = self.confirmed_at(partner, path)
                return partner
            self.notice("case-2" if len(motions) == len(path) else "case-1")
            yield from self.retrace(motions)
        return None

    def confirmed_at(self, partner: int, path: list[int]) -> int:
        """The robot's dart in S, a dart of v0, after a test that has confirmed a hypothesis.

        This is case (3) of the paper: each percept of the test was the expected one.

        Args:
            partner: the confirmed hypothesis e', the dart by which the robot came to v_u.
            path: the darts by which the test left its vertices, see :meth:`path_to_v0`; empty if
                e' is a dart of v0.
        """
        return self.s.alpha[path[-1]] if path else partner

    def path_to_v0(self, partner: int) -> list[int]:
        """Line 9: the darts by which a simple path in S from v_k' to v0 leaves its vertices.

        v_k' is the vertex of the hypothesis ``partner``; if v_k' is v0, the list is empty.
        """
        return list(simple_path(self.s, self.s.vertex[partner], 0, self.choices, "path"))

    def try_path(self, partner: int, path: list[int]) -> Stage[tuple[list[int], bool]]:
        """Lines 10-13: execute the motions M as long as each percept is the expected one of P.

        Args:
            partner: the tested hypothesis: the motions M are right if the robot has come to v_u by
                this dart.
            path: the darts of S by which M leads from v_k' to v0, see :meth:`path_to_v0`.

        Returns:
            The executed motions, each counted from the dart of entry at the vertex that the motion
            leaves, and whether each percept was the expected one.
        """
        s, at = self.s, partner
        motions: list[int] = []
        for dart in path:
            motion = s.offset(at, dart)
            seen = yield Move(motion - self.turned)
            self.turned = 0
            motions.append(motion)
            at = s.alpha[dart]
            if self.reads(seen) != s.expected[at]:
                return motions, False
        return motions, True

    def retrace(self, motions: list[int]) -> Stage[None]:
        """Line 15: undo the motions ``k1..kr`` of a rejected test; the robot is then back at v_u.

        The robot goes back by ``Move(-turned)``, ``Move(-kr)``, ..., ``Move(-k2)``.  Each of these
        motions goes back along one edge.  The first one is ``Move(0)``, except after a query (in a
        variant), which leaves ``turned`` at another value than 0.

        No motion undoes the rotation ``k1``: at v_u the robot stands at the dart by which the test
        left, ``k1`` darts clockwise from the dart by which the robot had come to v_u.  So the
        attribute ``turned`` becomes ``k1``.  If ``motions`` is empty, nothing changes.
        """
        back = -self.turned
        for motion in reversed(motions):
            yield Move(back)
            back = -motion
        self.turned = -back

    def augment_by_vertex(self, goal: int, percept: Percept) -> None:
        """Lines 20-21: add v_u to S as a new vertex, whose first dart is the dart of entry.

        ``goal`` is the dart e, which leads to v_u, and ``percept`` is the percept at v_u.
        """
        entry = self.s.add_vertex(goal, percept)
        self.here = self.s.turn(entry, self.turned)

    def augment_by_loop(self, goal: int, partner: int) -> None:
        """Lines 18-19: join e (``goal``) and e' (``partner``) to one edge; both leave U."""
        self.s.add_loop(goal, partner)

    def answer(self) -> Estimate:
        """Line 22: the estimate with the map S and the robot's dart in S."""
        return self.s.estimate(self.here)


# ---------------------------------------------------------------- without a direction
#
# Two vertices can be recognised, v0 and v1, and one edge joins them; the dart of v0 that leads to
# v1 stands for the pointed dart of a directional lighthouse.  It is searched first.  Instead of
# comparing a bearing at the end of a test that has come to v0, the robot leaves by the dart that
# should lead to v1, senses, and comes back: the *query*, two traversals.  A hypothesis at v0 is
# tested by the query alone.
#
# Source: Sections IV and VIII of the paper; that it is right if exactly one edge joins v0 and v1
# is proved in proofs/coq (TwoVertices).

Recognised: TypeAlias = Callable[[Percept], bool]
"""A function that tells whether a percept is one of a certain vertex, such as v1."""


def algorithm1_cluster(
    first: Percept, *, choices: Choices | None = None, notice: Callable[[str], None] = nobody
) -> Stage[Estimate]:
    """Explore from a marker cluster: one marker lies at v0, two at its neighbour v1.

    The arguments, choices and events are those of :func:`algorithm1`.

    Cost: at most (1) + (2) traversals (see :func:`algorithm1`), 2 more for each test, and 2 deg(v0)
    more for the search of v1.
    """
    is_v0, is_v1 = (lambda seen: seen.marks == 1), (lambda seen: seen.marks == 2)
    explorer = TwoVertices(first, is_v0, is_v1, choices or Choices(), notice)
    return (yield from explorer.explore())


def algorithm1_natural(
    first: Percept,
    *,
    choices: Choices | None = None,
    told: int | None = None,
    notice: Callable[[str], None] = nobody,
) -> Stage[Estimate]:
    """Explore from a natural lighthouse: v0 and v1 have two degrees that no other vertex has.

    ``told`` is the degree of v1, which the explorer learns before the start; it is not the degree
    of v0.  The other arguments, the choices and the events are those of :func:`algorithm1`.

    Cost: the same as that of :func:`algorithm1_cluster`.
    """
    is_v0, is_v1 = (lambda seen: seen.degree == first.degree), (lambda seen: seen.degree == told)
    explorer = TwoVertices(first, is_v0, is_v1, choices or Choices(), notice)
    return (yield from explorer.explore())


class TwoVertices(Algorithm1):
    """An exploration from v0, whose neighbour v1 can also be recognised.

    Attributes:
        is_v0, is_v1: the functions that recognise percepts of v0, and of v1.
        pointed: the dart of S that leads from v0 to v1; known after :meth:`search`.
    """

    def __init__(
        self,
        first: Percept,
        is_v0: Recognised,
        is_v1: Recognised,
        choices: Choices,
        notice: Callable[[str], None] = nobody,
    ) -> None:
        self.is_v0, self.is_v1 = is_v0, is_v1
        super().__init__(first, choices, notice)
        self.pointed = 0

    def explore(self) -> Stage[Estimate]:
        """Search the dart that leads from v0 to v1, then explore by Algorithm 1."""
        yield from self.search()
        return (yield from super().explore())

    def search(self) -> Stage[None]:
        """Try the darts of v0, clockwise from the dart faced at the start, until one leads to v1.

        If no dart leads to v1, the lighthouse has broken its promise.  Then the explorer takes the
        last dart for the one to v1, and every test fails, because its query at v0 (see
        :meth:`try_path`) does not reach v1.
        """
        for dart in list(self.s.unexplored):
            seen = yield Move(dart - self.here)
            yield Move(0)
            self.here = self.pointed = dart
            if self.is_v1(seen):
                return

    def reads(self, percept: Percept) -> Percept:
        """The part of a percept that tests compare: its degree, and whether it is that of v0.

        The result has one mark for a percept of v0, no mark for other percepts, and no bearing.
        """
        return Percept(percept.degree, int(self.is_v0(percept)))

    def try_path(self, partner: int, path: list[int]) -> Stage[tuple[list[int], bool]]:
        """Lines 10-13, and then the *query* at v0: leave by the dart that should lead to v1.

        At the other end of this dart the robot senses whether it is at v1.  Then it comes back to
        v0, where it stands at the dart by which it had left.  The arguments are those of
        :meth:`Algorithm1.try_path`.

        Returns:
            The executed motions without those of the query, and whether each percept was the
            expected one, including the percept of the query.
        """
        motions, matched = yield from super().try_path(partner, path)
        if matched:
            towards = self.s.offset(super().confirmed_at(partner, path), self.pointed)
            seen = yield Move(towards - self.turned)
            yield Move(0)
            self.turned = towards
            matched = self.is_v1(seen)
        return motions, matched

    def confirmed_at(self, partner: int, path: list[int]) -> int:  # noqa: ARG002  # any path
        """The robot's dart in S after a test that has confirmed a hypothesis.

        Such a test ends with the query, see :meth:`try_path`: the robot went from v0 to v1 and
        back.  So the result is the dart of v0 that leads to v1, for any ``partner`` and ``path``.
        """
        return self.pointed
