"""Every schedule of Algorithm 1 in one world.

A pass is one turn of the loop of Algorithm 1: the robot walks to an open dart e of the explored
part S, traverses e, and tests hypotheses until it knows where it is.  U is the set of open darts.

The worst and the best cost are found by dynamic programming, backwards from the completely explored
world.  This is possible for two reasons.  First: between two passes, all that matters for the later
costs is the set of explored edges, which determines S, and the vertex where the robot stands.
Second: the cost of a test does not depend on the tests before it.  So the most expensive order
tests all false hypotheses first; the cheapest order tests the true hypothesis first, if there is
one.

By the paper's invariant I-1, S is a part of the world.  So this module uses the names of the
world's darts for the darts of S, too.

Source: Algorithm 1, Section IV.
"""

from collections.abc import Iterator, Sequence
from functools import cache
from operator import attrgetter
from typing import Literal, TypeAlias, TypeVar

from msgspec import Struct

from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.outcome import Disagreement
from allworlds.protocol.choices import ChoiceKind, Choices

T = TypeVar("T")
_cost = attrgetter("cost")

Transit: TypeAlias = Literal["shortest", "simple"]
"""Readings of line 4 of Algorithm 1: the robot takes a shortest path in S, or any simple path."""

Explored: TypeAlias = frozenset[Dart]
"""The darts of the explored edges, two for each edge."""

Path: TypeAlias = tuple[Dart, ...]
"""The darts by which the robot leaves the vertices of a simple path in S."""


class WrongTest(Disagreement):
    """Raised if a test was wrong: it confirmed a false hypothesis, or rejected a true one.

    A wrong test would refute Algorithm 1.
    """


class TestCost(Struct, frozen=True):
    """A hypothesis, the path on which it is tested, and the cost of the test."""

    hypothesis: Dart
    path: Path
    cost: int


class PassCosts(Struct, frozen=True):
    """The tests of one pass, in its worst and in its best case, and the state after it.

    In a pass Algorithm 1 chooses the order of the hypotheses, and for each test a path to v0.  The
    other costs of a pass, which are not here, are the way to the dart e and one traversal of e.

    Attributes:
        dart: the dart e that the pass takes from U.
        worst: the tests that are made if Algorithm 1 chooses so that the tests cost the most.
        best: the tests that are made if Algorithm 1 chooses so that the tests cost the least.
        explored: the explored darts after the pass.
        robot: the robot's vertex after the pass.
    """

    dart: Dart
    worst: tuple[TestCost, ...]
    best: tuple[TestCost, ...]
    explored: Explored
    robot: int


class PassCost(Struct, frozen=True):
    """The largest cost of a pass that begins in one state and explores one dart of U.

    Attributes:
        vertices, explored: the numbers of vertices of S and of explored edges before the pass.
        cost: the number of traversals of the pass, including those on the way to its dart.
    """

    vertices: int
    explored: int
    cost: int


class EverySchedule:
    """All schedules of Algorithm 1 from one vertex of a map.

    Args:
        map_: the map of the world.
        start: the dart that the robot faces at the start; the costs depend on its vertex alone.
        transit: the paths on which the robot may walk to the next dart (line 4 of Algorithm 1):
            ``simple``, any simple path, or ``shortest``, a shortest path only.
    """

    def __init__(self, map_: CombinatorialMap, start: Dart, transit: Transit = "simple") -> None:
        self._map, self._start, self._transit = map_, start, transit
        self._owner, self._v0 = map_.vertex_of, map_.vertex_of[start]
        self._passes = cache(self._find_passes)
        self._worst = cache(self._find_worst)
        self._best = cache(self._find_best)

    @property
    def worst(self) -> int:
        """The number of traversals of the most expensive schedule.

        Raises:
            WrongTest: if a test can confirm a false hypothesis, or reject a true one.
        """
        return self._worst(frozenset(), self._v0)

    @property
    def best(self) -> int:
        """The number of traversals of the cheapest schedule.

        Raises:
            WrongTest: if a test can confirm a false hypothesis, or reject a true one.
        """
        return self._best(frozenset(), self._v0)

    def most_expensive_picks(self) -> list[int]:
        """All choices of a most expensive schedule, in their order; each choice is a dart of S.

        The choices of a pass are: the dart e; each dart of the path to e; and for each test the
        hypothesis, and each dart of the path to v0.  The numbers of the darts are those in S, not
        those in the world; see :meth:`_number`.
        """
        numbers: dict[Dart, int] = {}
        self._number(numbers, self._start)
        explored, robot = Explored(), self._v0
        picks: list[Dart] = []
        while len(explored) < len(self._map.sigma):
            chosen = max(self._passes(explored), key=lambda p: self._onward(explored, robot, p))
            picks.append(numbers[chosen.dart])
            goal = self._owner[chosen.dart]
            picks += [numbers[d] for d in self._transits(explored, robot, goal)[-1]]
            for test in chosen.worst:
                picks += [numbers[d] for d in (test.hypothesis, *test.path)]
            entry = self._map.alpha[chosen.dart]
            if entry not in numbers:
                self._number(numbers, entry)
            explored, robot = chosen.explored, chosen.robot
        return picks

    def most_expensive_passes(self) -> Iterator[PassCost]:
        """Yield the largest cost of a pass for each state that can be reached and each dart of U.

        Raises:
            WrongTest: if a test can confirm a false hypothesis, or reject a true one.
        """
        queue: list[tuple[Explored, int]] = [(Explored(), self._v0)]
        met = set(queue)
        for explored, robot in queue:
            vertices = len({self._v0} | {self._owner[d] for d in explored})
            for chosen in self._passes(explored):
                yield PassCost(vertices, len(explored) // 2, self._most(explored, robot, chosen))
                following = (chosen.explored, chosen.robot)
                if following not in met:
                    met.add(following)
                    queue.append(following)

    def _number(self, numbers: dict[Dart, int], first: Dart) -> None:
        """Add to ``numbers`` the darts of a vertex, each with its number in S.

        ``first`` is the dart by which the vertex was discovered.  The darts get the next free
        numbers, clockwise from ``first`` on.
        """
        for i in range(self._map.degree_at[first]):
            numbers[self._map.turn(first, i)] = len(numbers)

    def _find_worst(self, explored: Explored, robot: int) -> int:
        return max((self._onward(explored, robot, p) for p in self._passes(explored)), default=0)

    def _onward(self, explored: Explored, robot: int, chosen: PassCosts) -> int:
        """The largest cost of the rest of a run whose next pass is ``chosen``.

        The rest consists of the way to the dart e of this pass, the pass itself, and all later
        passes.  It begins at the vertex ``robot``; the darts ``explored`` are explored before.
        """
        return self._most(explored, robot, chosen) + self._worst(chosen.explored, chosen.robot)

    def _most(self, explored: Explored, robot: int, chosen: PassCosts) -> int:
        """The largest cost of the pass ``chosen``, with the way to the dart that the pass takes.

        Before this pass, the darts ``explored`` are explored, and the robot is at the vertex
        ``robot``.
        """
        transit = self._transits(explored, robot, self._owner[chosen.dart])[-1]
        return len(transit) + 1 + sum(test.cost for test in chosen.worst)

    def _find_best(self, explored: Explored, robot: int) -> int:
        costs = (
            len(self._transits(explored, robot, self._owner[p.dart])[0])
            + 1
            + sum(test.cost for test in p.best)
            + self._best(p.explored, p.robot)
            for p in self._passes(explored)
        )
        return min(costs, default=0)

    def _transits(self, explored: Explored, robot: int, goal: int) -> Sequence[Path]:
        """The paths that line 4 of Algorithm 1 allows, ascending by length.

        The paths lead from the vertex ``robot`` to the vertex ``goal``, on the edges of the darts
        ``explored``.
        """
        ways = sorted(self._simple_paths(explored, robot, goal), key=len)
        return ways if self._transit == "simple" else ways[:1]

    def _find_passes(self, explored: Explored) -> tuple[PassCosts, ...]:
        """The costs of the passes that can follow, one pass for each dart of U.

        ``explored`` are the darts of the edges that are explored before.
        """
        known = {self._v0} | {self._owner[d] for d in explored}
        unexplored = [d for d in self._map.darts if self._owner[d] in known and d not in explored]
        return tuple(self._pass(explored, known, unexplored, dart) for dart in unexplored)

    def _pass(
        self, explored: Explored, known: set[int], unexplored: list[Dart], e: Dart
    ) -> PassCosts:
        entry = self._map.alpha[e]
        vertex = self._owner[entry]
        after = explored | {e, entry}
        if vertex == self._v0:
            # The direction tells the dart: a test without a step.
            test = (TestCost(entry, (), 0),)
            return PassCosts(e, test, test, after, vertex)
        owner, degree_at = self._owner, self._map.degree_at
        alike = [h for h in unexplored if degree_at[h] == degree_at[entry]]
        rivals = [h for h in alike if h not in (e, entry) and owner[h] != self._v0]
        false = [self._tests(explored, h, entry) for h in rivals]
        most_expensive = tuple(max(tests, key=_cost) for tests in false)
        if vertex not in known:
            cheapest = tuple(min(tests, key=_cost) for tests in false)
            return PassCosts(e, most_expensive, cheapest, after, vertex)
        true = self._tests(explored, entry, entry)
        last, first = max(true, key=_cost), min(true, key=_cost)
        return PassCosts(e, (*most_expensive, last), (first,), after, self._v0)

    def _tests(self, explored: Explored, hypothesis: Dart, entry: Dart) -> list[TestCost]:
        """The tests of a hypothesis, one for each simple path to v0 on the explored edges.

        ``entry`` is the dart by which the robot has come in.  The hypothesis is that the robot has
        come in by the dart ``hypothesis``; each path begins at the vertex of this dart.

        Raises:
            WrongTest: if a test confirms a false hypothesis, or rejects a true one.
        """
        tests = []
        for path in self._simple_paths(explored, self._owner[hypothesis], self._v0):
            mismatch = self._mismatch(hypothesis, path, entry)
            if (mismatch is None) != (hypothesis == entry):
                raise WrongTest(f"hypothesis {hypothesis} for {entry} on the path {path}")
            tests.append(
                TestCost(hypothesis, path, len(path) if mismatch is None else 2 * mismatch)
            )
        return tests

    def _mismatch(self, hypothesis: Dart, path: Path, robot: Dart) -> int | None:
        """The number of steps until the robot's percept differs from the expected one.

        None if all percepts on the path are as expected.

        Args:
            hypothesis: the dart by which the robot has come in, if the tested hypothesis is true.
            path: a path from the vertex of ``hypothesis`` to v0.
            robot: the dart by which the robot has really come in.
        """
        alpha, at = self._map.alpha, hypothesis
        for steps, dart in enumerate(path, 1):
            motion = self._map.offset(at, dart)
            at, robot = alpha[dart], self._map.move(robot, motion)
            if self._sensed(at) != self._sensed(robot):
                return steps
        return None

    def _sensed(self, dart: Dart) -> tuple[int, Dart | None]:
        """The robot's percept when it arrives by a dart: the degree, and at v0 the dart itself.

        At v0 the robot knows the dart by the bearing; at other vertices None stands for the dart.
        """
        marked = self._owner[dart] == self._v0
        return self._map.degree_at[dart], dart if marked else None

    def _simple_paths(
        self, explored: Explored, start: int, goal: int, avoiding: frozenset[int] = frozenset()
    ) -> Iterator[Path]:
        if start == goal:
            yield ()
            return
        avoiding |= {start}
        for dart in self._map.vertices[start]:
            following = self._owner[self._map.alpha[dart]]
            if dart in explored and following not in avoiding:
                for rest in self._simple_paths(explored, following, goal, avoiding):
                    yield (dart, *rest)


class Planned(Choices):
    """Choices that were prepared before the run: a list of darts of S, one for each choice."""

    def __init__(self, darts: Sequence[Dart]) -> None:
        super().__init__()
        self._darts = iter(darts)

    def pick(self, options: Sequence[T], of: ChoiceKind, cost: Sequence[int] | None = None) -> T:  # noqa: ARG002
        """Return the next of the prepared darts, which must be one of the options.

        ``of``, the kind of the choice, and ``cost``, the costs of the options, have no effect.
        """
        index = list(options).index(next(self._darts))  # type: ignore[arg-type]  # S's darts
        self.record.append(index)
        return options[index]
