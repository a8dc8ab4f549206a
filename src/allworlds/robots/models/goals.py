"""Goals and conditions that several models share."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any, TypeVar

from typing_extensions import override

from allworlds.inputs.checks import InputError
from allworlds.maps.combinatorial import CombinatorialMap, Dart, rooted_code
from allworlds.protocol.actions import Estimate
from allworlds.robots.model import Liveness, Model, every_start

Part = TypeVar("Part")

MOST_ROBOTS = 8
"""The largest number of robots in a model with the goal that each robot visits every vertex."""


def are_together(map_: CombinatorialMap, darts: Sequence[Dart]) -> bool:
    """Whether all robots are at one vertex; ``darts`` has the dart of each robot."""
    return len({map_.vertex_of[dart] for dart in darts}) == 1


def are_apart(map_: CombinatorialMap, darts: Sequence[Dart]) -> bool:
    """Whether no two robots are at one vertex; ``darts`` has the dart of each robot."""
    return len({map_.vertex_of[dart] for dart in darts}) == len(darts)


def others_with(map_: CombinatorialMap, darts: Sequence[Dart], robot: int) -> int:
    """The number of other robots at the vertex of a robot; ``darts`` has each robot's dart."""
    return sum(map_.vertex_of[dart] == map_.vertex_of[darts[robot]] for dart in darts) - 1


@dataclass(frozen=True)
class Apart(Model):
    """The base of models in which robots start at different vertices by default.

    Attributes:
        apart: whether all robots start at different vertices.
    """

    apart: bool = True

    @override
    def starts(self, map_: CombinatorialMap, robots: int) -> Iterator[tuple[Dart, ...]]:
        for start in every_start(map_, robots):
            if not self.apart or are_apart(map_, start):
                yield start


def gathered(map_: CombinatorialMap) -> Liveness:
    """The condition that from some time on all robots are at one vertex."""
    return Liveness(
        "all robots at one vertex", forever=True, holds=lambda s: are_together(map_, s.darts)
    )


def each_everywhere(map_: CombinatorialMap) -> Iterator[Liveness]:
    """The conditions that each robot is at each vertex again and again.

    A model does not know the number of robots.  So there are conditions for :data:`MOST_ROBOTS`
    robots, and the condition of a robot that does not exist always holds.
    """
    for robot, vertex in product(range(MOST_ROBOTS), range(map_.vertex_count)):

        def there(state: Any, robot: int = robot, vertex: int = vertex) -> bool:
            absent = robot >= len(state.darts)
            return absent or map_.vertex_of[state.darts[robot]] == vertex

        yield Liveness(f"robot {robot} at vertex {vertex}", forever=False, holds=there)


def ensure_few(robots: int) -> None:
    """Raise InputError for more than :data:`MOST_ROBOTS` robots."""
    if robots > MOST_ROBOTS:
        raise InputError(f"robots = {robots} are more than {MOST_ROBOTS}, the most of this goal")


def map_flaw(map_: CombinatorialMap, dart: Dart, answer: Any) -> str:
    """The flaw, in words, of an answer that should be the map ``map_`` with the robot at ``dart``.

    The text is empty if the answer is right.
    """
    if not isinstance(answer, Estimate):
        return f"the answer is {'nothing' if answer is None else answer}, not an Estimate"
    given, true = answer.map, rooted_code(map_.sigma, map_.alpha, dart)
    if rooted_code(given.sigma, given.alpha, answer.here) == true:
        return ""
    wrong = any(rooted_code(given.sigma, given.alpha, each) == true for each in given.darts)
    return "the robot is not at the dart of the map that is answered" if wrong else "a wrong map"


def replaced(values: tuple[Part, ...], index: int, value: Part) -> tuple[Part, ...]:
    """A tuple like ``values``, but with this value at the index."""
    return (*values[:index], value, *values[index + 1 :])
