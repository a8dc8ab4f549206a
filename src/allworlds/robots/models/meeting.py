"""Gathering of any number of robots at one vertex; with two robots this is rendezvous."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

from typing_extensions import override

from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol.actions import IllegalAction, Move, Percept
from allworlds.robots.models.goals import Apart, are_together, others_with


class MeetingState(NamedTuple):
    """A state of a world in which robots must meet: the dart of each robot."""

    darts: tuple[Dart, ...]


@dataclass(frozen=True)
class Meeting(Apart):
    """Robots that must meet at one vertex.

    A robot senses the degree of its vertex; the marks tell it about the other robots there.

    Attributes:
        multiplicity: the meaning of the marks: always 0 (none), 1 if another robot is there (weak),
            or the number of other robots there (strong).
        labels: whether each robot is told its number; else all robots are anonymous.
    """

    multiplicity: Literal["none", "weak", "strong"] = "strong"
    labels: bool = False

    @override
    def initial(self, map_: CombinatorialMap, starts: Sequence[Dart]) -> Iterator[MeetingState]:
        yield MeetingState(tuple(starts))

    @override
    def told(self, map_: CombinatorialMap, robot: int) -> int | None:
        return robot if self.labels else None

    @override
    def sensed(self, map_: CombinatorialMap, state: MeetingState, robot: int) -> Percept:
        others = others_with(map_, state.darts, robot)
        most = {"none": 0, "weak": 1, "strong": others}[self.multiplicity]
        return Percept(map_.degree_at[state.darts[robot]], min(others, most))

    @override
    def step(
        self, map_: CombinatorialMap, state: MeetingState, acts: Mapping[int, Any]
    ) -> Iterator[tuple[MeetingState, str]]:
        darts = [*state.darts]
        for robot, action in acts.items():
            if type(action) is not Move:
                raise IllegalAction(f"legal is a Move, not {action}")
            darts[robot] = map_.move(darts[robot], action.k)
        yield MeetingState(tuple(darts)), ""

    @override
    def over(self, map_: CombinatorialMap, state: MeetingState) -> bool:
        return are_together(map_, state.darts)
