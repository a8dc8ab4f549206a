"""Worlds in which one edge may be missing in each round."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any, ClassVar, NamedTuple

from typing_extensions import override

from allworlds.maps.combinatorial import CombinatorialMap, Dart, Vertex
from allworlds.protocol.actions import IllegalAction, Move
from allworlds.robots.model import Places, Scheduler, joined
from allworlds.robots.models.goals import Apart
from allworlds.words import plural


class RoundState(NamedTuple):
    """A state of a world in which one edge may be missing in each round.

    Attributes:
        darts: the dart of each robot.
        moved: for each robot whether its last motion succeeded.
        held: for each robot whether it waits on the port of an edge that was missing.  The port is
            the point at the vertex from which a robot crosses the edge.
        visited: the vertices that any robot has visited.
    """

    darts: tuple[Dart, ...]
    moved: tuple[bool, ...]
    held: tuple[bool, ...]
    visited: frozenset[Vertex]


@dataclass(frozen=True)
class OneInterval(Apart):
    """Robots that must visit all vertices, in a world in which one edge may be missing each round.

    To move, a robot first goes to the port of the edge, which is a point at its vertex.  From the
    port it crosses the edge; if the edge is missing, the robot is held on the port.

    A robot is told the number of vertices.  Its percept is ``[degree, moved, held, others]``: the
    degree; whether its last motion succeeded; whether it is on a port whose edge was missing; and
    for each other robot here, sorted, whether that robot is held.  A robot that waits or is not
    activated stays where it is, also on a port.

    Attributes:
        ends: whether the run ends when all vertices are visited; else the programs must end.
        exclusive: whether, of several robots that want to go to one port in a round, only one goes
            there; the adversary chooses this robot, and the motions of the others fail.
        one_face: whether all robots start at darts of one face; on a ring all robots then have the
            same orientation.
    """

    ends: bool = False
    exclusive: bool = True
    one_face: bool = False
    schedulers: ClassVar[tuple[Scheduler, ...]] = "fsync", "ssync"

    @override
    def starts(self, map_: CombinatorialMap, robots: int) -> Iterator[tuple[Dart, ...]]:
        for start in super().starts(map_, robots):
            if not self.one_face or any({*start} <= {*face} for face in map_.faces):
                yield start

    @override
    def told(self, map_: CombinatorialMap, robot: int) -> int:
        return map_.vertex_count

    @override
    def initial(self, map_: CombinatorialMap, starts: Sequence[Dart]) -> Iterator[RoundState]:
        robots = len(starts)
        visited = frozenset(map_.vertex_of[dart] for dart in starts)
        yield RoundState(tuple(starts), (True,) * robots, (False,) * robots, visited)

    @override
    def sensed(self, map_: CombinatorialMap, state: RoundState, robot: int) -> list[Any]:
        here = map_.vertex_of[state.darts[robot]]
        at = [map_.vertex_of[dart] for dart in state.darts]
        others = [held for r, held in enumerate(state.held) if r != robot and at[r] == here]
        degree = map_.degree_at[state.darts[robot]]
        return [degree, state.moved[robot], state.held[robot], sorted(others)]

    @override
    def step(
        self, map_: CombinatorialMap, state: RoundState, acts: Mapping[int, Any]
    ) -> Iterator[tuple[RoundState, str]]:
        leave = {robot: _leaving(map_, state.darts[robot], act) for robot, act in acts.items()}
        ports: dict[Dart, list[int]] = {}
        for robot, dart in leave.items():
            ports.setdefault(dart, []).append(robot)
        firsts = product(*ports.values()) if self.exclusive else [tuple(leave)]
        edges = sorted({min(dart, map_.alpha[dart]) for dart in ports})
        for first, missing in product(firsts, (None, *edges)):
            darts, moved, held = [*state.darts], [*state.moved], [*state.held]
            for robot, dart in leave.items():
                held[robot] = robot in first and min(dart, map_.alpha[dart]) == missing
                moved[robot] = robot in first and not held[robot]
                darts[robot] = map_.alpha[dart] if moved[robot] else darts[robot]
            visited = state.visited | {map_.vertex_of[dart] for dart in darts}
            after = RoundState(tuple(darts), tuple(moved), tuple(held), visited)
            words = "" if missing is None else f"edge {missing} is missing"
            ports_of = f"on their ports are {[*first]}" if len(first) < len(leave) else ""
            yield after, joined(words, ports_of)

    @override
    def over(self, map_: CombinatorialMap, state: RoundState) -> bool:
        return self.ends and len(state.visited) == map_.vertex_count

    @override
    def flaw(self, map_: CombinatorialMap, state: RoundState, answers: Sequence[Any]) -> str:
        left = map_.vertex_count - len(state.visited)
        return f"{plural(left, 'vertex', 'vertices')} not visited" if left else ""

    @override
    def places(self, map_: CombinatorialMap, state: RoundState) -> Places:
        return Places(state.darts, dict.fromkeys(state.visited, "visited"))


def _leaving(map_: CombinatorialMap, dart: Dart, action: Any) -> Dart:
    if type(action) is not Move:
        raise IllegalAction(f"legal is a Move, not {action}")
    return map_.turn(dart, action.k)
