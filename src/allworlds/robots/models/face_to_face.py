"""Robots that see and hear each other at a vertex."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from msgspec.json import decode, encode
from typing_extensions import override

from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol.actions import Do, IllegalAction, Move
from allworlds.robots.model import Model, every_start
from allworlds.robots.models.goals import map_flaw, replaced


class FaceToFaceState(NamedTuple):
    """A state of a world in which robots see and hear each other.

    Attributes:
        darts: the dart of each robot.
        words: the value that each robot says, as canonical JSON; null if it says nothing.
    """

    darts: tuple[Dart, ...]
    words: tuple[bytes, ...]


@dataclass(frozen=True)
class FaceToFace(Model):
    """Robots that see and hear each other at a vertex; robot 0 must answer a map.

    Each robot is told its number.

    A percept is ``[degree, others]``.  ``others`` is a sorted list with a pair ``[k, value]`` for
    each other robot at the vertex.  The dart of the other robot is k darts clockwise from the dart
    of the robot that looks.  ``value`` is what the other robot says, at first null.  After
    ``Do(value)`` a robot says the value until its next motion; ``Move(k)`` moves.

    Attributes:
        together: whether all robots start at one dart.
    """

    together: bool = True

    @override
    def starts(self, map_: CombinatorialMap, robots: int) -> Iterator[tuple[Dart, ...]]:
        return iter([(0,) * robots]) if self.together else every_start(map_, robots)

    @override
    def told(self, map_: CombinatorialMap, robot: int) -> int:
        return robot

    @override
    def initial(self, map_: CombinatorialMap, starts: Sequence[Dart]) -> Iterator[FaceToFaceState]:
        yield FaceToFaceState(tuple(starts), (b"null",) * len(starts))

    @override
    def sensed(self, map_: CombinatorialMap, state: FaceToFaceState, robot: int) -> Any:
        mine, others = state.darts[robot], []
        for other, (dart, words) in enumerate(zip(*state, strict=True)):
            if other != robot and map_.vertex_of[dart] == map_.vertex_of[mine]:
                others.append((map_.offset(mine, dart), words))
        return map_.degree_at[mine], [(k, decode(words)) for k, words in sorted(others)]

    @override
    def step(
        self, map_: CombinatorialMap, state: FaceToFaceState, acts: Mapping[int, Any]
    ) -> Iterator[tuple[FaceToFaceState, str]]:
        darts, words = state
        for robot, action in acts.items():
            match action:
                case Move(k):
                    darts = replaced(darts, robot, map_.move(darts[robot], k))
                    words = replaced(words, robot, b"null")
                case Do(value):
                    words = replaced(words, robot, encode(value, order="deterministic"))
                case _:
                    raise IllegalAction(f"legal are Move and Do, not {action}")
        yield FaceToFaceState(darts, words), ""

    @override
    def flaw(self, map_: CombinatorialMap, state: FaceToFaceState, answers: Sequence[Any]) -> str:
        return map_flaw(map_, state.darts[0], answers[0])
