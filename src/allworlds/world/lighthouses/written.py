"""Room for numbers that the robot writes: on vertices, or on darts."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Annotated, Any, ClassVar, Self

from typing_extensions import override

from allworlds.document import about, narrowed
from allworlds.inputs import integer, show
from allworlds.maps import CombinatorialMap, Dart
from allworlds.protocol import Action, Write
from allworlds.world.lighthouses.base import InvalidWorld, PlacelessLighthouse
from allworlds.world.state import State

LEAST, MOST = 2, 2**31
"""The numbers of numbers that there can be room for."""


class _Written(PlacelessLighthouse):
    """A lighthouse under which ``Write(k)`` is legal, with k from 0 to states - 1.

    Attributes:
        states: how many numbers there are.
        usually: the same of a kind, where its name does not say.
    """

    states: int

    leaves_marks: ClassVar[bool] = True
    keys: ClassVar[tuple[str, ...]] = ("states",)
    usually: ClassVar[int] = LEAST

    @abstractmethod
    def place_of_number(self, map_: CombinatorialMap, dart: Dart) -> int:
        """Where a robot writes and reads that has arrived by this dart."""

    @classmethod
    def with_options(cls, options: Mapping[str, str]) -> type[_Written]:
        """The kind with ``states=K``."""
        states = cls.usually
        for key, value in options.items():
            if key != "states":
                raise InvalidWorld(
                    f"the {cls.kind} lighthouse has no option {show(key)}; legal is states"
                )
            number = int(value) if value.isascii() and value.isdecimal() else value
            states = _states("option states", number)
        return _kind_with(cls, states)

    @classmethod
    def with_its_options(cls) -> Self:
        """The lighthouse with the options of the kind."""
        made: Self = cls._of(cls.usually)
        return made

    @classmethod
    def _of(cls, states: object) -> Any:
        """The lighthouse with that many numbers; also of a kind that has another number."""
        plain = next(each for each in cls.__mro__ if "kind" in vars(each))
        return plain(states)

    def check(self, map_: CombinatorialMap, start: Dart) -> None:  # noqa: ARG002  # any map
        """At least two numbers; every map and every start will do."""
        _states("lighthouse.states", self.states)

    @override
    def refusal(self, action: Action, lying: int, hand: int) -> str:
        if type(action) is not Write:
            return "a Move or Write"
        return (
            "" if 0 <= action.k < self.states else f"a Write(k) with k from 0 to {self.states - 1}"
        )

    @override
    def acted(self, map_: CombinatorialMap, state: State, action: Action) -> State:
        assert type(action) is Write
        return state.with_number(self.place_of_number(map_, state.dart), action.k)

    @override
    def left_marks(self, map_: CombinatorialMap, state: State) -> int:
        return state.number_at(self.place_of_number(map_, state.dart))

    @property
    def written(self) -> str:
        """With the number of numbers."""
        return f"{self.kind}:states={self.states}"

    @classmethod
    @override
    def at(cls, **where: Any) -> Self:
        made: Self = cls._of(where["states"])
        return made


HowMany = Annotated[int, narrowed(minimum=LEAST), about("how many numbers there are")]


@dataclass(frozen=True, slots=True)
class Whiteboard(_Written):
    """At every vertex room for one number, which the robot writes there and reads there.

    Sensed at a vertex: the number that was last written there (0 at first) as marks, and the
    degree.  The option is ``states=K``: the numbers are 0 to K-1 (2).
    """

    states: HowMany = LEAST

    kind: ClassVar[str] = "whiteboard"

    @override
    def place_of_number(self, map_: CombinatorialMap, dart: Dart) -> int:
        return map_.vertex_of[dart]


@dataclass(frozen=True, slots=True)
class Ports(_Written):
    """At every dart room for one number, which the robot writes and reads when it comes by it.

    Sensed: the number that was last written on the dart by which the robot has arrived (0 at
    first) as marks, and the degree.  The option is ``states=K``: the numbers are 0 to K-1 (2).
    """

    states: HowMany = LEAST

    kind: ClassVar[str] = "ports"

    @override
    def place_of_number(self, map_: CombinatorialMap, dart: Dart) -> int:
        return dart


@cache
def _kind_with(kind: type[_Written], states: int) -> type[_Written]:
    """The kind whose usual lighthouse is this one."""
    if states == kind.usually:
        return kind
    return type(kind.__name__, (kind,), {"usually": states})


def _states(what: str, value: object) -> int:
    """The number of numbers; else raises InvalidWorld."""
    try:
        states = integer(value)
    except TypeError:
        raise InvalidWorld(f"{what} = {show(value)} is not an integer") from None
    if not LEAST <= states <= MOST:
        raise InvalidWorld(f"{what} = {show(states)} is none of {LEAST} to {MOST}")
    return states
