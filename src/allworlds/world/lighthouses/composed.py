"""Several lighthouses in one world, and lighthouses that put no marker into the map.

If there are several lighthouses, a percept holds the marks and the bearing of all, and every
combination of their places is a place.  A lighthouse without a marker in the map shows nothing, or
tells the robot numbers before the start, or lets the robot leave marks.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache
from itertools import compress, product
from typing import Annotated, Any, ClassVar, Literal, TypeAlias

from msgspec import Meta
from typing_extensions import override

from allworlds.documents.document import Different, IfAny, Positive, about, narrowed
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol import actions
from allworlds.world.lighthouses import options
from allworlds.world.lighthouses.base import Lighthouse, PlacelessLighthouse, WalkInAnswer
from allworlds.world.state import State


@dataclass(frozen=True, slots=True)
class Nothing(PlacelessLighthouse):
    """No marker and no direction: only the degree is sensed.

    Source: Section III of the paper ('lacking any position and orientation information').
    """

    kind: ClassVar[str] = "none"


ToldName: TypeAlias = Literal["n", "m", "d", "g"]

TOLD: dict[ToldName, Callable[[CombinatorialMap], int]] = {
    "n": lambda map_: map_.vertex_count,
    "m": lambda map_: map_.edge_count,
    "d": lambda map_: map_.diameter,
    "g": lambda map_: map_.genus,
}
"""The numbers that can be told, by their names: vertices, edges, diameter, genus."""


@dataclass(frozen=True)
class Knowledge(PlacelessLighthouse):
    """No marker: before the start the robot is told some numbers of the world.

    Sensed: the degree alone.  The numbers that can be told are n (vertices), m (edges),
    d (diameter) and g (genus); if no number is chosen, n and m are told.
    """

    names: Annotated[
        Different[ToldName], narrowed(minItems=1), about("which numbers are told: n, m, d, g")
    ] = ("n", "m")

    kind: ClassVar[str] = "told"

    def told(self, map_: CombinatorialMap) -> dict[str, int]:
        """The numbers of the world that the robot is told, by their names."""
        return {name: TOLD[name](map_) for name in self.names}


@dataclass(frozen=True, slots=True)
class Movable(PlacelessLighthouse):
    """Markers that the robot carries: all are in its hand at the start.

    Sensed at a vertex: the number of markers that lie there, and the degree.  The markers point
    nowhere.  By default they look alike.  The options: ``markers=K``, the number of markers
    (default: 1); ``pick=false``, a dropped marker stays; ``distinct=true``, the robot tells the
    markers apart: the markers have the numbers 0, 1, 2, ..., marker i counts as 2^i marks, and the
    marker with the smallest number is dropped or taken up first.
    Source: Section II of the paper (in Dudek, Jenkin, Milios, Wilkes 1991 the robot has one marker,
    which it may take up again).
    """

    markers: Annotated[Positive, about("the number of markers in the hand at the start")] = 1
    pick: Annotated[bool, about("whether a dropped marker may be taken up again")] = True
    distinct: Annotated[IfAny[bool], about("whether markers are told apart; default: no")] = False

    kind: ClassVar[str] = "movable"
    leaves_marks: ClassVar[bool] = True

    @property
    def in_hand(self) -> int:
        """The number of markers in the robot's hand at the start: all markers."""
        return self.markers

    @override
    def refusal(self, action: actions.Action, lying: int, hand: int) -> str:
        if type(action) is actions.Drop:
            return "" if hand else "a Drop only with a marker in hand"
        if type(action) is not actions.Pick:
            return "a Move, Drop or Pick"
        if not self.pick:
            return "no Pick: under pick=false a marker stays where it was dropped"
        return "" if lying else "a Pick only where a marker lies"

    @override
    def acted(self, map_: CombinatorialMap, state: State, action: actions.Action) -> State:
        here, lying = map_.vertex_of[state.dart], [*state.lying]
        bits = state.number_at(here)
        if type(action) is actions.Drop:
            lying.append(here)
            dropped = sum(number for _, number in state.written)
            bits |= ~dropped & (dropped + 1)
        else:
            lying.remove(here)
            bits &= bits - 1
        after = state.with_number(here, bits) if self.distinct else state
        hand = state.hand + len(state.lying) - len(lying)
        return replace(after, lying=tuple(sorted(lying)), hand=hand)

    @override
    def left_marks(self, map_: CombinatorialMap, state: State) -> int:
        here = map_.vertex_of[state.dart]
        return state.number_at(here) if self.distinct else state.lying.count(here)


LEAST, MOST = 2, 2**31
"""The least and the largest legal value of the option ``states``."""


HowMany = Annotated[int, Meta(ge=LEAST, le=MOST), about("how many numbers there are")]


@dataclass(frozen=True, slots=True)
class Whiteboard(PlacelessLighthouse):
    """Room for one number at every vertex; the robot writes the number there and reads it there.

    Sensed at a vertex: the number that was last written there (0 at first) as marks, and the
    degree.  The option is ``states=K``, by default K = 2: the numbers are 0 to K - 1.
    """

    states: HowMany = LEAST

    kind: ClassVar[str] = "whiteboard"
    leaves_marks: ClassVar[bool] = True

    def place_of_number(self, map_: CombinatorialMap, dart: Dart) -> int:
        """The index of the vertex on which a robot at ``dart`` writes and reads its number.

        In the subclass :class:`Doormarks` the result is ``dart``: the robot writes on darts.
        """
        return map_.vertex_of[dart]

    @override
    def refusal(self, action: actions.Action, lying: int, hand: int) -> str:
        if type(action) is not actions.Write:
            return "a Move or Write"
        legal = 0 <= action.k < self.states
        return "" if legal else f"a Write(k) with k from 0 to {self.states - 1}"

    @override
    def acted(self, map_: CombinatorialMap, state: State, action: actions.Action) -> State:
        assert type(action) is actions.Write
        return state.with_number(self.place_of_number(map_, state.dart), action.k)

    @override
    def left_marks(self, map_: CombinatorialMap, state: State) -> int:
        return state.number_at(self.place_of_number(map_, state.dart))


@dataclass(frozen=True, slots=True)
class Doormarks(Whiteboard):
    """Room for one number at every dart; the robot writes and reads it when it comes by the dart.

    Sensed: the number that was last written on the dart by which the robot has arrived (0 at
    first) as marks, and the degree.  The option is ``states=K``, by default K = 2: the numbers are
    0 to K - 1.
    """

    kind: ClassVar[str] = "doormarks"

    @override
    def place_of_number(self, map_: CombinatorialMap, dart: Dart) -> int:
        return dart


PLUS = "+"
"""The text between the names of the parts in the name of a composed lighthouse."""


@dataclass(frozen=True, slots=True)
class Composed(Lighthouse):
    """Several lighthouses in one world.

    At most one of them gives marks, at most one gives bearings, and at most one tells the robot
    something before the start.

    Attributes:
        parts: the lighthouses, each at its place.
        kinds: the classes of the parts.  In this class the tuple is empty; :func:`composed` makes
            subclasses with other tuples.
    """

    parts: tuple[Lighthouse, ...]

    kinds: ClassVar[tuple[type[Lighthouse], ...]] = ()

    @property
    def kind(self) -> str:  # type: ignore[override]  # it is that of its parts
        """The kinds of the parts, with ``+`` between them."""
        return PLUS.join(part.kind for part in self.parts)

    @property
    def static(self) -> bool:  # type: ignore[override]  # so is this
        """Whether no action changes a percept of any part."""
        return all(part.static for part in self.parts)

    @property
    def written(self) -> str:
        """The names of the parts with their options, with ``+`` between them."""
        return PLUS.join(part.written for part in self.parts)

    @property
    def as_kind(self) -> type[Composed]:
        """The kind that consists of the kinds of the parts."""
        names, kinds = zip(*((part.written, part.as_kind) for part in self.parts), strict=True)
        return composed(names, kinds)

    @property
    def _marking(self) -> Lighthouse:
        """The part that gives marks; actions besides motions are left to it.

        If no part gives marks, the result is the first part: then any part will do, since no marker
        is in the robot's hand, and every action besides a motion is refused.
        """
        return next((part for part in self.parts if part.gives_marks), self.parts[0])

    @classmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Composed]:
        """Yield all combinations of places of the parts; the last part's place changes first."""
        for parts in product(*(kind.places(map_, start) for kind in cls.kinds)):
            yield Composed(parts)

    @classmethod
    def usual(cls, map_: CombinatorialMap, start: Dart) -> Composed:
        """The parts, each at its default place."""
        return Composed(tuple(kind.usual(map_, start) for kind in cls.kinds))

    def check(self, map_: CombinatorialMap, start: Dart) -> None:
        """Raise InvalidWorld unless each part is legal in this map, and the parts fit together."""
        check_together([part.kind for part in self.parts], [*map(type, self.parts)])
        for part in self.parts:
            part.check(map_, start)

    def percepts(self, map_: CombinatorialMap) -> tuple[actions.Percept, ...]:
        """For each dart the percept, with the marks of one part and the bearing of one part."""
        marks, bearings = (
            next((part.percepts(map_) for part in self.parts if getattr(part, gives)), None)
            for gives in ("gives_marks", "gives_bearings")
        )
        return tuple(
            actions.Percept(
                map_.degree_at[dart],
                marks[dart].marks if marks else 0,
                bearings[dart].bearing if bearings else None,
            )
            for dart in map_.darts
        )

    def believed(self, map_: CombinatorialMap, start: Dart, walk: WalkInAnswer) -> Composed | None:
        """The lighthouse with each part at its place in the map of the robot's answer.

        The method ``believed`` of each part finds the place of this part; if the answer's map has
        no place for a part, the result is None.  The parameters are those of
        :meth:`Lighthouse.believed`.
        """
        parts = [part.believed(map_, start, walk) for part in self.parts]
        return None if None in parts else Composed(tuple(part for part in parts if part))

    @property
    def in_hand(self) -> int:
        """The number of markers in the robot's hand at the start.

        The part that gives marks determines this number.
        """
        return self._marking.in_hand

    @override
    def refusal(self, action: actions.Action, lying: int, hand: int) -> str:
        return self._marking.refusal(action, lying, hand)

    @override
    def acted(self, map_: CombinatorialMap, state: State, action: actions.Action) -> State:
        return self._marking.acted(map_, state, action)

    @override
    def left_marks(self, map_: CombinatorialMap, state: State) -> int:
        return self._marking.left_marks(map_, state)

    @override
    def told(self, map_: CombinatorialMap) -> actions.Told:
        heard = (part.told(map_) for part in self.parts)
        return next((each for each in heard if each is not None), None)

    @override
    def relabelled(self, names: Sequence[Dart]) -> Composed:
        return Composed(tuple(part.relabelled(names) for part in self.parts))


@cache
def composed(names: tuple[str, ...], kinds: tuple[type[Lighthouse], ...]) -> type[Composed]:
    """The kind of a lighthouse whose parts have these kinds.

    ``names`` holds the names of the kinds, with their options, for errors.

    Raises:
        InvalidWorld: if the parts do not fit together, with the reason.
    """
    check_together(names, kinds)
    marking = ("leaves_marks", "gives_marks", "gives_bearings")
    attributes: dict[str, Any] = {
        name: any(getattr(kind, name) for kind in kinds) for name in marking
    }
    # Worlds that look alike under a marker at one vertex have equal numbers of vertices and edges.
    attributes["leaves_open"] = any(kind.leaves_open for kind in kinds) and all(
        kind.leaves_open or _adds(kind) <= {"n", "m"} for kind in kinds
    )
    attributes["folds"] = any(
        kind.folds and not any(_adds(other) for other in kinds if other is not kind)
        for kind in kinds
    )
    for kind in kinds:
        if kind.every_place_to is not None:
            attributes |= {"every_place_to": kind.every_place_to, "beyond": kind.beyond}
    return type(Composed.__name__, (Composed,), {"kinds": kinds, **attributes})


def _adds(kind: type[Lighthouse]) -> set[str]:
    """The names of the facts that a robot gets besides degrees, such as ``marks`` or ``n``.

    ``kind`` is the kind of lighthouse.
    """
    found = {name for name in ("marks", "bearings") if getattr(kind, f"gives_{name}")}
    if issubclass(kind, Knowledge):
        return found | {*kind.names}
    return found | ({"something else"} if _tells(kind) else set())


def check_together(names: Sequence[str], kinds: Sequence[type[Lighthouse]]) -> None:
    """Raise InvalidWorld if two of these kinds cannot be parts of one lighthouse.

    ``names`` holds the names of the kinds for the error.
    """
    for number, kind in enumerate(kinds):
        if kind in kinds[:number]:
            raise options.InvalidWorld(f"the lighthouse {names[number]} stands there twice")
    for what, has in (
        ("have marks", [kind.gives_marks for kind in kinds]),
        ("have bearings", [kind.gives_bearings for kind in kinds]),
        ("tell something before the start", [_tells(kind) for kind in kinds]),
    ):
        if sum(has) > 1:
            one, other, *_ = compress(names, has)
            raise options.InvalidWorld(
                f"the lighthouses {one} and {other} both {what}, and a robot could not tell which "
                "is which; leave one out"
            )


def _tells(kind: type[Lighthouse]) -> bool:
    return kind.told is not Lighthouse.told
