"""Robots that see the whole map from their own darts: Look, Compute, Move."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any, Literal, NamedTuple

from typing_extensions import override

from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol.actions import Do, IllegalAction
from allworlds.robots.model import Liveness
from allworlds.robots.models.goals import (
    MOST_ROBOTS,
    Apart,
    are_apart,
    each_everywhere,
    ensure_few,
    gathered,
    replaced,
)
from allworlds.robots.models.views import Eyes, darts_of_view, least

INDEX_OF_NAME = {"first": 0, "second": 1}
"""The indices, in the sorted list of views, of the two views that have names."""


class SnapshotState(NamedTuple):
    """A state of a world whose robots see the whole map.

    Attributes:
        darts: the heading of each robot, see :class:`Snapshot`; without chirality the least dart at
            the robot's vertex.
        due: for each robot the dart by which it will leave at its move, if it has looked and this
            dart is decided already; else None.
        crossed: whether two robots have just crossed on an edge; always False if crossing is legal.
    """

    darts: tuple[Dart, ...]
    due: tuple[Dart | None, ...]
    crossed: bool = False


@dataclass(frozen=True)
class Snapshot(Apart):
    """Robots that see the whole map from their own darts, with all robots in it.

    A view is ``[robots, degrees, alpha]``: the number of robots at each vertex, the degree of each
    vertex, and the other end of each dart.  The vertices and darts are numbered in the order of a
    walk through the map, see :class:`allworlds.robots.models.views.ViewOrder`.  The robot's own
    vertex comes first, and the robot itself is counted there.  On a ring ``robots`` has the numbers
    at successive vertices in one direction.

    **Without chirality** robots cannot tell clockwise from anticlockwise.  The percept is a sorted
    list with a view from each dart of the robot's vertex.  From each dart there is a clockwise and
    an anticlockwise view; the list has the smaller one, in Python's order of lists.  ``Do(k)``
    leaves by the dart of view k in the list, from 0 on; ``Do("first")`` is ``Do(0)``, and
    ``Do("second")`` is ``Do(1)``.  If several darts have this view, the adversary chooses one of
    these darts at each look.  ``Do("either")`` leaves by any dart that the adversary chooses.

    With chirality each robot has a heading, which is a dart of its vertex; at the start it is the
    robot's dart.  The percept is the clockwise view from the heading, and ``Do(k)`` leaves by the
    k-th dart clockwise from the heading.  The new heading is found from the dart of arrival: first
    one dart clockwise, then k darts anticlockwise.  On a ring ``Do(0)`` leaves by the heading, and
    ``Do(1)`` by the other dart; after either of these moves the heading points in the same
    direction round the ring as before.

    Attributes:
        goal: ``gather``: all robots must come to one vertex, and stay there; ``explore``: each
            robot must visit every vertex again and again.
        chirality: whether all robots know which direction is clockwise.
        exclusive: whether two robots must never be at one vertex.
        crossing: whether two robots may cross on an edge.
        multiplicity: ``none``: any number of robots is seen as 1; ``weak``: two or more are seen as
            2; ``strong``: the number is seen.
        local: whether ``multiplicity`` is about the robot's own vertex alone; elsewhere any number
            of robots is seen as 1.
    """

    goal: Literal["gather", "explore"] = "gather"
    chirality: bool = False
    exclusive: bool = False
    crossing: bool = True
    multiplicity: Literal["none", "weak", "strong"] = "weak"
    local: bool = False

    @override
    def starts(self, map_: CombinatorialMap, robots: int) -> Iterator[tuple[Dart, ...]]:
        for start in super().starts(map_, robots):
            if self.chirality or all(dart == least(map_, dart) for dart in start[1:]):
                yield start

    @override
    def initial(self, map_: CombinatorialMap, starts: Sequence[Dart]) -> Iterator[SnapshotState]:
        ensure_few(len(starts))
        darts = starts if self.chirality else [least(map_, dart) for dart in starts]
        yield SnapshotState(tuple(darts), (None,) * len(darts))

    @override
    def sensed(self, map_: CombinatorialMap, state: SnapshotState, robot: int) -> Any:
        dart = state.darts[robot]
        if self.chirality:
            return self._eyes.view(map_, state.darts, dart)
        return sorted(self._eyes.views(map_, state.darts, dart).values())

    @property
    def _eyes(self) -> Eyes:
        most = {"none": 1, "weak": 2, "strong": MOST_ROBOTS}[self.multiplicity]
        return Eyes(most, 1 if self.local else most)

    def _choices(
        self, map_: CombinatorialMap, state: SnapshotState, robot: int, action: Any
    ) -> list[Dart]:
        """The darts by which a robot may leave with this action; the adversary chooses one of them.

        Raises:
            IllegalAction: for an action that is no legal ``Do``.
        """
        if (due := state.due[robot]) is not None:
            return [due]
        dart = state.darts[robot]
        around = map_.vertices[map_.vertex_of[dart]]
        index = INDEX_OF_NAME.get(action.value, action.value) if type(action) is Do else None
        if index == "either" and not self.chirality:
            return [*around]
        if type(index) is not int or index not in range(len(around)):
            raise IllegalAction(f"legal is Do(k), and k from 0 to {len(around) - 1}, not {action}")
        if self.chirality:
            return [map_.turn(dart, index)]
        return darts_of_view(self._eyes.views(map_, state.darts, dart), index)

    @override
    def looked(
        self, map_: CombinatorialMap, state: SnapshotState, robot: int, action: Any
    ) -> Iterator[tuple[SnapshotState, str]]:
        darts = self._choices(map_, state, robot, action)
        for dart in darts:
            due = replaced(state.due, robot, dart)
            yield state._replace(due=due), _chosen(robot, dart, darts)

    @override
    def step(
        self, map_: CombinatorialMap, state: SnapshotState, acts: Mapping[int, Any]
    ) -> Iterator[tuple[SnapshotState, str]]:
        choices = [self._choices(map_, state, robot, action) for robot, action in acts.items()]
        for leave in product(*choices):
            darts, due = state.darts, state.due
            for robot, dart in zip(acts, leave, strict=True):
                darts = replaced(darts, robot, self._heading(map_, darts[robot], dart))
                due = replaced(due, robot, None)
            crossed = not self.crossing and any(map_.alpha[dart] in leave for dart in leave)
            words = [_chosen(*each) for each in zip(acts, leave, choices, strict=True)]
            yield SnapshotState(darts, due, crossed), "; ".join(filter(None, words))

    def _heading(self, map_: CombinatorialMap, before: Dart, leave: Dart) -> Dart:
        """The new heading of a robot with the heading ``before`` that leaves by dart ``leave``.

        A heading is an entry of :attr:`SnapshotState.darts`.  Without chirality it is the least
        dart at the new vertex.
        """
        arrival = map_.alpha[leave]
        if not self.chirality:
            return least(map_, arrival)
        return map_.turn(arrival, 1 - map_.offset(before, leave))

    @override
    def bad(self, map_: CombinatorialMap, state: SnapshotState) -> str:
        if self.exclusive and not are_apart(map_, state.darts):
            return "two are at one vertex"
        return "two cross on an edge" if state.crossed else ""

    @override
    def progress(self, map_: CombinatorialMap) -> Iterable[Liveness]:
        return [gathered(map_)] if self.goal == "gather" else each_everywhere(map_)


def _chosen(robot: int, dart: Dart, among: Sequence[Dart]) -> str:
    return f"robot {robot} leaves by dart {dart}" if len(among) > 1 else ""
