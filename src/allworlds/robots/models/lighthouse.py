"""The worlds that ``check`` tries, with one robot and a lighthouse, as a model."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, NamedTuple

from typing_extensions import override

from allworlds.inputs.checks import InputError
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol.actions import Percept
from allworlds.robots.model import Model
from allworlds.robots.models.goals import map_flaw
from allworlds.world.lighthouses.kinds import lighthouse_kind
from allworlds.world.state import State
from allworlds.world.world import World


class LighthouseState(NamedTuple):
    """A state of the model :class:`LighthouseModel`.

    Attributes:
        start: the dart of the robot at the start.
        place: the number of the lighthouse's place.
        state: what the robot's actions change: its dart, the markers that it has dropped, and the
            numbers that it has written.
    """

    start: Dart
    place: int
    state: State

    @property
    def darts(self) -> tuple[Dart, ...]:
        """The dart of the robot."""
        return (self.state.dart,)


@dataclass(frozen=True)
class LighthouseModel(Model):
    """A robot in a world with a lighthouse at any of its places; the robot must answer the map.

    The adversary chooses the place of the lighthouse.

    Attributes:
        kind: the name of the kind of lighthouse, with its options, as ``--lighthouse`` takes it.
    """

    kind: str = "directional"

    @override
    def initial(self, map_: CombinatorialMap, starts: Sequence[Dart]) -> Iterator[LighthouseState]:
        if len(starts) != 1:
            raise InputError(
                f"lighthouse:{self.kind} is a model of one robot, not of {len(starts)}"
            )
        for place, world in enumerate(_worlds(map_, self.kind, starts[0])):
            yield LighthouseState(starts[0], place, world.initial)

    @override
    def told(self, map_: CombinatorialMap, robot: int) -> Any:
        return _worlds(map_, self.kind, 0)[0].told

    @override
    def sensed(self, map_: CombinatorialMap, state: LighthouseState, robot: int) -> Percept:
        return _worlds(map_, self.kind, state.start)[state.place].sensed(state.state)

    @override
    def step(
        self, map_: CombinatorialMap, state: LighthouseState, acts: Mapping[int, Any]
    ) -> Iterator[tuple[LighthouseState, str]]:
        world = _worlds(map_, self.kind, state.start)[state.place]
        after = world.step(state.state, acts[0])[0] if acts else state.state
        yield state._replace(state=after), ""

    @override
    def flaw(self, map_: CombinatorialMap, state: LighthouseState, answers: Sequence[Any]) -> str:
        return map_flaw(map_, state.state.dart, answers[0])


@lru_cache(maxsize=1 << 8)
def _worlds(map_: CombinatorialMap, kind: str, start: Dart) -> list[World]:
    """The worlds of a map and a start, one for each place of the lighthouse."""
    places = lighthouse_kind(kind).as_class.places(map_, start)
    return [World(map_, place, start) for place in places]
