"""The folded log, explorers that use it alone, and the shield.

All percepts of a robot with a directional lighthouse form one map, the folded log.  Each motion
through an open dart makes a new *node*, a copy of the vertex of arrival.  If an arrival at v0 shows
that two nodes are one vertex, the nodes are merged: each dart of one node becomes equal to a dart
of the other.  If two equal darts lead to two nodes, these nodes are one vertex, too, and are merged
in turn.  When two nodes are merged, one of them remains.  The other node, with its darts, becomes a
second name of the node that remains.  A node that has not been merged into another one, and each
dart of such a node, is called *canonical*.

Nodes are merged only if they are one vertex in every world that agrees with the log.  In such a
world each node is a copy of a vertex; several nodes can be copies of the same vertex.  If no dart
of the log is open, each vertex has the same number of nodes.  v0 has only one node, so each vertex
has one, and the log is the world.  An explorer that takes its answer from such a folded log is
right, whatever its walk.

An explorer by the folded log has a rule that chooses the next open dart.  The exploration ends if
the rule is fair, that is, if no dart stays open for ever.  Proof: let several nodes be copies of
one vertex.  In the world some path leads from this vertex to v0.  By a fair rule the log finally
holds this path from each of the nodes, with known ends of all its darts.  From each node the path
comes to the same dart of v0, so the nodes are merged.  The rule that always chooses the open dart
nearest to the robot is not fair: the robot can walk on for ever, from one copy of a vertex to the
next.

The *shield* makes any explorer right in every world under the directional lighthouse.  Inside the
shield two explorers, the *guests*, take turns: the user's explorer and Algorithm 1.  The turns have
the budgets 1, 2, 4, 8, ...: 1, 4, 16, ... for the user's explorer, 2, 8, 32, ... for Algorithm 1.
In its turn a guest goes on until its number of traversals, in all its turns together, is the
budget.  All percepts go into one folded log; as soon as no dart of the log is open, the map of the
log is the answer.  The guests' answers are never used.

In the known part of the log a guest walks without cost, and its percepts are read from the log.
When a guest goes through an open dart, the robot walks to this dart by a shortest way in the log,
and goes through it, too.

Cost: less than 9 min(X, (1) + (2)) traversals, where X is the number of traversals of the user's
explorer until its own log has no open dart, and (1) + (2) is the paper's bound on Algorithm 1.
Proof: let a guest need x traversals until its own log has no open dart, and let 2^k be the first
budget of this guest that is at least x.  The shield ends at the latest in the turn with this
budget.  In a turn with the budget b the robot could walk from v0 along the guest's whole walk, and
then back to v0, by at most 2b traversals; it takes shortest ways instead, which are not longer.  So
all turns before the last one cost at most 2 (1 + 2 + ... + 2^(k-1)) < 2 * 2^k traversals.  The
guest's earlier budget 2^(k-2) was less than x, so this is less than 8x.  The last turn costs at
most x traversals, without a way back: together less than 9x.  This holds for both guests.
"""

from bisect import insort
from collections.abc import Callable, Generator, Iterator, Sequence
from itertools import count
from typing import Any, TypeAlias

from allworlds.explorers.builtin.algorithm1 import Stage, algorithm1, bearing_of, nobody
from allworlds.inputs.checks import integer, let_users_interrupt, show
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.protocol.actions import Checkpoint, Estimate, ExplorerFault, Move, Percept
from allworlds.protocol.choices import Choices
from allworlds.protocol.importing import signature_of

OPEN = -1
"""The number that stands for the unknown other end of an open dart."""


class FoldedLog:
    """A folded log: nodes that are merged as soon as they must be one vertex.

    The darts of a node are consecutive and clockwise.  Node 0 is v0; the marker points to dart 0.
    The docstring of this module says what a *canonical* node or dart is.

    Attributes:
        node: for each dart the node with which the dart was made.
        base, degree: for each node its first dart, and its number of darts.
        stands: for each node a dart that is equal to the node's first dart.  For a canonical node
            it is the first dart itself; for another node it is a dart of a node into which this
            node was merged, which may itself have been merged later.  This is a union-find
            structure.
        known: for each canonical node its darts with a known other end, ascending; for other nodes
            an empty list.
        merges: the number of nodes that have been merged into other nodes.

    Args:
        first: the percept at the start.

    Cost: nearly constant for a step without a merge.  A merge also passes each known dart of the
    merged node on to the node that remains.
    """

    def __init__(self, first: Percept) -> None:
        self.node: list[int] = []
        self.base: list[int] = []
        self.degree: list[int] = []
        self.stands: list[int] = []
        self.known: list[list[int]] = []
        self.merges = 0
        self._link: list[int] = []
        self._add_node(first.degree)

    def _add_node(self, degree: int) -> int:
        """Add a node; return its first dart."""
        first = len(self.node)
        self.node.extend([len(self.base)] * degree)
        self.base.append(first)
        self.degree.append(degree)
        self.stands.append(first)
        self.known.append([])
        self._link.extend([OPEN] * degree)
        return first

    def canonical(self, dart: int) -> int:
        """The canonical dart that is equal to ``dart``; ``dart`` itself if it is canonical.

        A dart is canonical if its node has not been merged into another node.
        """
        base, stands = self.base, self.stands
        v = self.node[dart]
        while stands[v] != base[v]:
            w = self.node[stands[v]]
            if stands[w] != base[w]:  # path halving
                stands[v] = self.turn(stands[w], stands[v] - base[w])
            dart = self.turn(stands[v], dart - base[v])
            v = self.node[dart]
        return dart

    def turn(self, dart: int, offset: int) -> int:
        """The dart ``sigma^offset(dart)`` of the same node."""
        v = self.node[dart]
        first = self.base[v]
        return first + (dart - first + offset) % self.degree[v]

    def beyond(self, dart: int) -> int:
        """The other dart of the edge of ``dart``; :data:`OPEN` if ``dart`` is open.

        ``dart`` must be canonical, that is, its node has not been merged into another node; the
        other dart is canonical, too.
        """
        other = self._link[dart]
        if other == OPEN:
            return OPEN
        v = self.node[other]
        if self.stands[v] != self.base[v]:
            other = self._link[dart] = self.canonical(other)
        return other

    def arrive(self, dart: int, percept: Percept) -> int:
        """Note a motion in the log, and return the robot's dart of arrival.

        The robot has left by ``dart``, and then has sensed ``percept``.  ``dart`` must be canonical
        (its node has not been merged into another node); the dart of arrival is canonical, too.

        Raises:
            ValueError: if the percepts contradict each other, so that they fit no world.
        """
        other = self.beyond(dart)
        if other == OPEN:
            other = self._add_node(percept.degree)
            self._link[dart], self._link[other] = other, dart
            insort(self.known[self.node[dart]], dart)
            self.known[self.node[other]].append(other)
            if percept.marks and percept.bearing is not None:
                self._merge(0, self.turn(other, percept.bearing))
        return self.canonical(other)

    def _differ(self, _v: int, _w: int) -> bool:
        """Whether two nodes of the same degree are known to be copies of different vertices.

        The result is False here; a subclass may know more.
        """
        return False

    def _stays(self, v: int, w: int) -> bool:
        """Whether ``v`` remains when the nodes ``v`` and ``w`` are merged: the older node does."""
        return v < w

    def _merge(self, one: int, another: int) -> None:
        """Merge two darts with their nodes, and then all darts that must be equal, too.

        Raises:
            ValueError: if two nodes that would be merged cannot be one vertex.
        """
        node, base, degree, link = self.node, self.base, self.degree, self._link
        equal = [(one, another)]
        while equal:
            a, b = map(self.canonical, equal.pop())
            v, w = node[a], node[b]
            if v == w and a == b:
                continue
            if v == w or degree[v] != degree[w] or self._differ(v, w):
                raise ValueError("the percepts contradict each other: no world shows them all")
            if not self._stays(v, w):
                a, b, v, w = b, a, w, v
            self.merges += 1
            self.stands[w] = self.turn(a, base[w] - b)
            for x in self.known[w]:
                y = self.turn(a, x - b)
                if link[y] == OPEN:
                    link[y] = link[x]
                    insort(self.known[v], y)
                else:
                    equal.append((link[y], link[x]))
            self.known[w] = []


# ---------------------------------------------------------------- explorers

ToOpenDart: TypeAlias = Callable[[FoldedLog, int], list[int]]
"""A function that chooses the next walk: it takes a folded log and the robot's dart in the log, and
returns the darts by which the walk leaves its nodes; the last dart is open."""


def folding(
    first: Percept,
    *,
    choices: Choices | None = None,  # noqa: ARG001  # its way leaves none
    notice: Callable[[str], None] = nobody,
) -> Stage[Estimate]:
    """Explore by the folded log: go home to v0, then to the open dart nearest to v0, and so on.

    Args:
        first: the percept at the start.
        choices: not used, because the walk leaves no choice.
        notice: the function that gets the event ``merged`` after each arrival at v0 that merges
            nodes.

    Cost: the explorer always stops; no bound is known (up to 1,206 traversals for m = 5).
    """
    return (yield from explore_folding(first, by_home, notice))


def folding_oldest(
    first: Percept,
    *,
    choices: Choices | None = None,  # noqa: ARG001  # its way leaves none
    notice: Callable[[str], None] = nobody,
) -> Stage[Estimate]:
    """Explore by the folded log: go by a shortest way to the dart that has been open longest.

    The arguments and events are those of :func:`folding`.
    """
    return (yield from explore_folding(first, to_oldest, notice))


def by_home(log: FoldedLog, here: int) -> list[int]:
    """The darts by which a walk to v0, and on to the open dart nearest to v0, leaves its nodes.

    The last dart of the list is this open dart.  If several open darts are equally near to v0, the
    darts of v0 are tried clockwise, from the pointed dart.  ``here`` is the robot's dart in the
    log.
    """
    home = way(log, here, lambda dart: log.node[dart] == 0)
    return [*home[:-1], *way(log, 0, lambda dart: log.beyond(dart) == OPEN)]


def to_oldest(log: FoldedLog, here: int) -> list[int]:
    """The darts by which a shortest walk to the oldest open dart leaves its nodes.

    The oldest open dart is the one with the smallest number; ``here`` is the robot's dart.
    """
    oldest = next(dart for dart in _darts(log) if log.beyond(dart) == OPEN)
    return way(log, here, lambda dart: dart == oldest)


def explore_folding(
    first: Percept, next_way: ToOpenDart, hears: Callable[[str], None] = nobody
) -> Stage[Estimate]:
    """Explore by the folded log, until no dart is open.

    Args:
        first: the percept at the start.
        next_way: the function that chooses each walk to an open dart, from the log and the robot's
            dart in the log; it returns the darts by which the walk leaves its nodes.
        hears: the function that gets the event ``merged``, see :func:`folding`.
    """
    log, here = begun(first)
    while has_open_dart(log):
        for dart in next_way(log, here):
            seen = yield Move((dart - here) % log.degree[log.node[here]])
            merges = log.merges
            here = log.arrive(dart, seen)
            if log.merges > merges:
                hears("merged")
    return estimate(log, here)


def begun(first: Percept) -> tuple[FoldedLog, int]:
    """The folded log at the start, and the dart of the log that the robot faces.

    ``first`` is the percept at the start, which must have a bearing.
    """
    log = FoldedLog(first)
    return log, log.turn(0, -bearing_of(first))


def has_open_dart(log: FoldedLog) -> bool:
    """Whether a dart is open, so that the log does not determine the map."""
    return any(log.beyond(dart) == OPEN for dart in _darts(log))


def estimate(log: FoldedLog, here: int) -> Estimate:
    """The answer with the map of the folded log; no dart of the log may be open.

    ``here`` is the robot's dart in the log, which must be canonical.
    """
    darts = [*_darts(log)]
    number = {dart: i for i, dart in enumerate(darts)}
    sigma = [number[log.turn(dart, 1)] for dart in darts]
    alpha = [number[log.beyond(dart)] for dart in darts]
    return Estimate(CombinatorialMap(sigma, alpha), number[here])


def _darts(log: FoldedLog) -> Iterator[int]:
    """The darts of all nodes that have not been merged into another node, ascending."""
    for first, degree, stands in zip(log.base, log.degree, log.stands, strict=True):
        if stands == first:
            yield from range(first, first + degree)


def way(log: FoldedLog, start: int, is_goal: Callable[[int], bool]) -> list[int]:
    """The darts by which a shortest walk in the log leaves its nodes; the last dart is a goal.

    The walk begins at the dart ``start``.  A goal is a dart for which ``is_goal`` is true.  The
    search tries the darts of each node clockwise, from the dart by which the walk came there.
    """
    came: dict[int, list[int]] = {log.node[start]: []}
    queue = [start]
    for entry in queue:
        darts = [log.turn(entry, k) for k in range(log.degree[log.node[entry]])]
        leading = came[log.node[entry]]
        for dart in darts:
            if is_goal(dart):
                return [*leading, dart]
        for dart in darts:
            other = log.beyond(dart)
            if other != OPEN and log.node[other] not in came:
                came[log.node[other]] = [*leading, dart]
                queue.append(other)
    raise AssertionError("the folded log is connected")


MOST_CHECKPOINTS = 1000
"""The largest number of checkpoints that the explorer in a shield may show between two motions; if
it shows more, the shield lets the explorer make no further motion."""


class Shield:
    """An explorer with a shield: a generator function that takes the explorer's arguments.

    Attributes:
        explorer: the generator function of the explorer inside.
    """

    def __init__(self, explorer: Callable[..., Generator[Any, Any, Any]]) -> None:
        self.explorer = explorer
        self.__signature__ = signature_of(explorer)

    def __call__(self, first: Percept, **keywords: Any) -> Stage[Estimate]:
        """Explore from a directional lighthouse; return the true map, for any explorer inside.

        ``first`` is the percept at the start, and ``keywords`` are passed to the explorer inside.
        """
        log, here = begun(first)
        stranger = _Stranger(log, here, lambda seen: self.explorer(seen, **keywords))
        try:
            here = yield from _take_turns(log, here, (stranger, _Guest(log, here, algorithm1)))
        finally:
            stranger.dismiss()
        return estimate(log, here)


class _Guest:
    """An explorer inside the shield; it walks in the folded log.

    Attributes:
        here: the dart of the log by which the guest has arrived; at first the argument ``here``.
        steps: the number of the guest's traversals.
        out: true as soon as the guest has made its last motion, because it has ended or failed.

    Args:
        log: the folded log, which all guests share.
        here: the dart of the log that the robot faces at the start.
        explorer: the generator function of the explorer; its argument is the first percept.
    """

    def __init__(
        self, log: FoldedLog, here: int, explorer: Callable[[Percept], Generator[Any, Any, Any]]
    ) -> None:
        self.here, self.steps, self.out = here, 0, False
        self._log, self._explorer = log, explorer
        self._walk: Generator[Any, Any, Any] | None = None

    def next_dart(self) -> int | None:
        """The dart of the log by which the guest leaves next; None if it makes no further motion.

        The guest's checkpoints before this motion are dropped.

        Raises:
            ValueError: if the guest yields no motion, or more than :data:`MOST_CHECKPOINTS`
                checkpoints before it.
        """
        reply = None if self._walk is None else self._percept()
        self._walk = self._walk or self._explorer(self._percept())
        message = self._walk.send(reply)
        published = 0
        while type(message) is Checkpoint:
            published += 1
            if published > MOST_CHECKPOINTS:
                raise ValueError(f"{published} checkpoints between two motions")
            message = self._walk.send(None)
        if type(message) is not Move:
            raise ValueError(f"{show(message)} is no motion")
        return self._log.turn(self._log.canonical(self.here), integer(message.k))

    def _percept(self) -> Percept:
        """The percept that the guest has at its dart ``here``, by the log."""
        log = self._log
        dart = log.canonical(self.here)
        degree = log.degree[log.node[dart]]
        at_v0 = log.node[dart] == 0
        return Percept(degree, 1, -dart % degree) if at_v0 else Percept(degree)


class _Stranger(_Guest):
    """The user's explorer inside the shield, the guest whose faults the shield must survive.

    If the explorer ends, raises an error or yields an illegal value, the guest makes no further
    motions.
    """

    def next_dart(self) -> int | None:
        try:
            return super().next_dart()
        except ExplorerFault as fault:
            if fault.machine:
                raise
        except MemoryError:
            raise
        except BaseException as error:  # noqa: BLE001  # an explorer may raise anything
            let_users_interrupt(error)
        self.out = True
        return None

    def dismiss(self) -> None:
        """Close the guest's generator, and ignore each exception that it then raises."""
        try:
            if self._walk is not None:
                self._walk.close()
        except BaseException as error:  # noqa: BLE001  # the map is known all the same
            let_users_interrupt(error)


def _take_turns(log: FoldedLog, here: int, guests: Sequence[_Guest]) -> Stage[int]:
    """Let the guests walk in turn until no dart is open; return the robot's dart in the log.

    ``here`` is the robot's dart at the start.  If a guest makes no further motions, the others walk
    without a budget.
    """
    for turn in count():
        guest = guests[turn % len(guests)]
        while not guest.out and (guest.steps < 2**turn or any(other.out for other in guests)):
            dart = guest.next_dart()
            if dart is None:
                break
            if log.beyond(dart) == OPEN:
                for leaving in way(log, here, dart.__eq__):
                    seen = yield Move((leaving - here) % log.degree[log.node[here]])
                    here = log.arrive(leaving, seen)
                if not has_open_dart(log):
                    return here
            guest.here = log.beyond(log.canonical(dart))
            guest.steps += 1
    raise AssertionError("turns have no end")
