"""Algorithm 1 as an object that can be copied.

    allworlds check examples/python/stepping.py --edges 5

Between two calls of ``step`` all that the robot knows stands in attributes, so that ``copy`` is
short.  A generator keeps a part of it in its frame, and cannot be copied.
"""

from __future__ import annotations

from allworlds import Checkpoint, CombinatorialMap, Estimate, Move, Percept


class Stepping:
    """The robot: its S is a list of darts; those of a vertex are consecutive and clockwise."""

    def __init__(self) -> None:
        self.sigma, self.alpha = [], []  # alpha[d] == d: nobody knows yet where d leads
        self.expected = []  # what a robot senses that arrives by a dart
        self.here = self.turned = 0  # its dart, and how far it is turned from the dart of entry
        self.goal, self.seen = None, None  # the dart that is explored, and what is sensed behind it
        self.hypotheses, self.partner, self.undo = [], None, []
        self.then = self.begin  # what is done next

    def copy(self) -> Stepping:
        """A robot that goes on by itself."""
        twin = object.__new__(Stepping)
        twin.__dict__ |= self.__dict__
        for name in ("sigma", "alpha", "expected", "hypotheses", "undo"):
            setattr(twin, name, getattr(self, name)[:])
        twin.then = getattr(twin, self.then.__name__)
        return twin

    def step(self, percept: Percept) -> Move | Checkpoint | Estimate:
        """The next action, or the answer."""
        return self.then(percept)

    def begin(self, percept: Percept) -> Move | Checkpoint | Estimate:
        """v0, with the darts in all directions of the lighthouse."""
        self.add_vertex(percept)
        if percept.bearing is not None:
            for d in range(percept.degree):
                bearing = (percept.bearing - d) % percept.degree
                self.expected[d] = Percept(percept.degree, percept.marks, bearing)
        return self.next_pass(percept)

    def next_pass(self, percept: Percept) -> Move | Checkpoint | Estimate:
        """Lines 2-5: the oldest dart of U is explored next."""
        open_ = [d for d, e in enumerate(self.alpha) if d == e]
        if not open_:
            return Estimate(CombinatorialMap(self.sigma, self.alpha), self.here)
        self.goal = open_[0]
        return self.follow(percept)

    def follow(self, _percept: Percept) -> Move:
        """Towards the dart that is explored, and along it."""
        if self.goal in self.ring(self.here):
            self.then = self.arrive
            return self.leave_by(self.goal)
        self.then = self.follow
        return self.leave_by(self.nearer(self.here, self.goal))

    def arrive(self, percept: Percept) -> Move | Checkpoint:
        """Line 6: the hypotheses, darts of U behind which one would sense this."""
        self.seen, self.turned = percept, 0
        self.hypotheses = [
            d
            for d, e in enumerate(self.alpha)
            if d == e != self.goal and self.expected[d] == percept
        ]
        return self.next_hypothesis()

    def next_hypothesis(self) -> Move | Checkpoint:
        """Lines 7-9; where none is left, lines 20-21: a new vertex."""
        if self.hypotheses:
            self.partner = self.here = self.hypotheses.pop(0)
            self.undo = []
            return self.test()
        entry = len(self.alpha)
        self.add_vertex(self.seen)
        self.alpha[self.goal], self.alpha[entry] = entry, self.goal
        self.here = entry + self.turned % self.seen.degree
        return self.shown()

    def test(self) -> Move | Checkpoint:
        """Lines 10-13: the next step of the way home; at v0 lines 18-19: a loop is closed."""
        if 0 in self.ring(self.here):
            self.alpha[self.goal], self.alpha[self.partner] = self.partner, self.goal
            return self.shown()
        dart = self.nearer(self.here, 0)
        self.undo.append(dart - self.here)
        self.then = self.compare
        move = self.leave_by(dart)
        turned, self.turned = self.turned, 0
        return Move(move.k - turned)

    def compare(self, percept: Percept) -> Move | Checkpoint:
        """Lines 14-15: whether this is sensed as it should be, or the hypothesis was wrong."""
        if self.expected[self.here] == percept:
            return self.test()
        self.turned = 0
        return self.retrace(percept)

    def retrace(self, _percept: Percept) -> Move | Checkpoint:
        """Undo the last motion that has not been undone."""
        if not self.undo:
            self.turned = -self.turned
            return self.next_hypothesis()
        self.then = self.retrace
        move, self.turned = Move(self.turned), -self.undo.pop()
        return move

    def shown(self) -> Checkpoint:
        """S and U after a pass."""
        self.then = self.next_pass
        return Checkpoint(tuple(self.sigma), tuple(self.alpha), self.here)

    def add_vertex(self, percept: Percept) -> None:
        """A vertex whose darts are open."""
        first = len(self.alpha)
        darts = range(first, first + percept.degree)
        self.sigma += [*darts[1:], first]
        self.alpha += darts
        self.expected += [Percept(percept.degree, percept.marks, percept.bearing)] * len(darts)

    def ring(self, dart: int) -> list[int]:
        """The darts of a vertex, clockwise."""
        ring = [dart]
        while self.sigma[ring[-1]] != dart:
            ring.append(self.sigma[ring[-1]])
        return ring

    def nearer(self, dart: int, goal: int) -> int:
        """The first dart beside this one that leads one step nearer to the vertex of the goal."""
        steps, queue = dict.fromkeys(self.ring(goal), 0), [goal]
        for at in queue:
            for d in self.ring(at):
                if (e := self.alpha[d]) not in steps:
                    steps |= dict.fromkeys(self.ring(e), steps[d] + 1)
                    queue.append(e)
        return min(d for d in self.ring(dart) if steps[self.alpha[d]] == steps[d] - 1)

    def leave_by(self, dart: int) -> Move:
        """The motion by a dart of the vertex where the robot stands in S; it is behind it then."""
        ring = self.ring(self.here)
        motion = ring.index(dart)
        self.here = self.alpha[dart]
        return Move(motion)
