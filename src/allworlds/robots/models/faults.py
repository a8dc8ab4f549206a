"""Models that wrap another model, and make robots or markers fail."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any, NamedTuple

from typing_extensions import override

from allworlds.inputs.checks import InputError, show
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol.actions import Percept
from allworlds.robots.model import Assumption, Liveness, Model, Places, Scheduler, joined


class FaultsState(NamedTuple):
    """A state of a model that wraps another model, and makes robots or markers fail.

    Attributes:
        inside: the state of the wrapped model.
        living: the robots that have not stopped.
        left: the number of faults that may still happen.
        blind: the robots from which the adversary hides the markers at their vertices.
    """

    inside: Any
    living: frozenset[int]
    left: int
    blind: frozenset[int] = frozenset()


@dataclass(frozen=True)
class Wrapper(Model):
    """The base of models that wrap another model; by default each method calls the wrapped model.

    Attributes:
        inside: the wrapped model.
        faults: the largest number of faults in a run.
    """

    inside: Model
    faults: int = 1

    @property
    def schedulers(self) -> tuple[Scheduler, ...]:  # type: ignore[override]  # of this instance
        """The schedulers of the wrapped model."""
        return self.inside.schedulers

    @property
    @override
    def says_progress(self) -> bool:
        return self.inside.says_progress

    @override
    def starts(self, map_: CombinatorialMap, robots: int) -> Iterable[tuple[Dart, ...]]:
        return self.inside.starts(map_, robots)

    @override
    def initial(self, map_: CombinatorialMap, starts: Sequence[Dart]) -> Iterator[FaultsState]:
        for state in self.inside.initial(map_, starts):
            yield FaultsState(state, frozenset(range(len(starts))), self.faults)

    @override
    def told(self, map_: CombinatorialMap, robot: int) -> Any:
        return self.inside.told(map_, robot)

    @override
    def sensed(self, map_: CombinatorialMap, state: FaultsState, robot: int) -> Any:
        return self.inside.sensed(map_, state.inside, robot)

    @override
    def looked(
        self, map_: CombinatorialMap, state: FaultsState, robot: int, action: Any
    ) -> Iterator[tuple[FaultsState, str]]:
        for after, words in self.inside.looked(map_, state.inside, robot, action):
            yield state._replace(inside=after), words

    @override
    def step(
        self, map_: CombinatorialMap, state: FaultsState, acts: Mapping[int, Any]
    ) -> Iterator[tuple[FaultsState, str]]:
        for after, words in self.inside.step(map_, state.inside, acts):
            yield state._replace(inside=after), words

    @override
    def bad(self, map_: CombinatorialMap, state: FaultsState) -> str:
        return self.inside.bad(map_, state.inside)

    @override
    def over(self, map_: CombinatorialMap, state: FaultsState) -> bool:
        return self.inside.over(map_, state.inside)

    @override
    def flaw(self, map_: CombinatorialMap, state: FaultsState, answers: Sequence[Any]) -> str:
        return self.inside.flaw(map_, state.inside, answers)

    @override
    def progress(self, map_: CombinatorialMap) -> Iterator[Liveness]:
        for name, forever, holds in self.inside.progress(map_):
            yield Liveness(name, forever, None if holds is None else _inside(holds))

    @override
    def assumes(self, map_: CombinatorialMap) -> Iterator[Assumption]:
        for name, holds in self.inside.assumes(map_):
            yield Assumption(name, _inside(holds))

    @override
    def places(self, map_: CombinatorialMap, state: FaultsState) -> Places:
        return self.inside.places(map_, state.inside)


def _inside(holds: Callable[..., bool]) -> Callable[..., bool]:
    """Return a function of states of the wrapper: it calls ``holds`` with the wrapped states."""
    return lambda *values: holds(*(v.inside if isinstance(v, FaultsState) else v for v in values))


@dataclass(frozen=True)
class Crash(Wrapper):
    """Robots that stop for ever at any moment; the adversary chooses the robots and the moments."""

    @override
    def initial(self, map_: CombinatorialMap, starts: Sequence[Dart]) -> Iterator[FaultsState]:
        for state in super().initial(map_, starts):
            yield from (after for after, _ in _stopping(state))

    @override
    def sensed(self, map_: CombinatorialMap, state: FaultsState, robot: int) -> Any:
        return super().sensed(map_, state, robot) if robot in state.living else None

    @override
    def looked(
        self, map_: CombinatorialMap, state: FaultsState, robot: int, action: Any
    ) -> Iterator[tuple[FaultsState, str]]:
        for after, words in super().looked(map_, state, robot, action):
            yield from ((each, joined(words, more)) for each, more in _stopping(after))

    @override
    def step(
        self, map_: CombinatorialMap, state: FaultsState, acts: Mapping[int, Any]
    ) -> Iterator[tuple[FaultsState, str]]:
        for after, words in super().step(map_, state, acts):
            yield from ((each, joined(words, more)) for each, more in _stopping(after))


def _stopping(state: FaultsState) -> Iterator[tuple[FaultsState, str]]:
    """Yield each state after any set of living robots has stopped, with the choice in words.

    The set may be empty; it has at most as many robots as faults are left.
    """
    for count in range(min(state.left, len(state.living)) + 1):
        for robots in combinations(sorted(state.living), count):
            words = ", ".join(f"robot {robot} stops" for robot in robots)
            living = state.living - {*robots}
            yield state._replace(living=living, left=state.left - count), words


@dataclass(frozen=True)
class Hidden(Wrapper):
    """Markers that the adversary hides from a robot after its action, until the robot acts again.

    The wrapped model must have percepts with marks.
    """

    @override
    def sensed(self, map_: CombinatorialMap, state: FaultsState, robot: int) -> Any:
        percept = super().sensed(map_, state, robot)
        if percept is not None and type(percept) is not Percept:
            raise InputError(
                f"hidden is of models with percepts that have marks, not {show(percept)}"
            )
        return Percept(percept.degree) if percept and robot in state.blind else percept

    @override
    def step(
        self, map_: CombinatorialMap, state: FaultsState, acts: Mapping[int, Any]
    ) -> Iterator[tuple[FaultsState, str]]:
        seeing = state._replace(blind=state.blind - {*acts})
        for after, words in super().step(map_, seeing, acts):
            sensed = [(robot, self.sensed(map_, after, robot)) for robot in acts]
            marked = [robot for robot, percept in sensed if percept and percept.marks]
            for count in range(min(state.left, len(marked)) + 1):
                for robots in combinations(marked, count):
                    more = ", ".join(f"the marker is hidden from robot {robot}" for robot in robots)
                    blind = after.blind | {*robots}
                    hidden = after._replace(blind=blind, left=after.left - count)
                    yield hidden, joined(words, more)
