"""The base class of all lighthouses, and the types of values that it uses."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from functools import cache
from itertools import islice
from types import MappingProxyType
from typing import Annotated, Any, ClassVar, NamedTuple, Self, TypeAlias

from allworlds.documents.document import about, plain
from allworlds.inputs.checks import show
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol import actions, user_code
from allworlds.world.lighthouses.options import (
    InvalidWorld,
    OptionValue,
    ensure_legal,
    kind_with,
    named_with,
    options_of,
    place_keys,
    values_in,
)
from allworlds.world.state import State


class Where(Enum):
    """The vertices at which the robot senses more than the degree."""

    NOWHERE = "nowhere"
    AT_V0 = "at the start's vertex"
    AT_V0_AND_V1 = "at the start's vertex and at a neighbour of it"
    EVERYWHERE = "everywhere"
    EVERYWHERE_NUMBERED = "everywhere, and each vertex has a number of its own"


@dataclass(frozen=True, slots=True)
class Sensing:
    """The marks and bearings that a robot senses in addition to the degree.

    Attributes:
        where: the vertices at which the robot senses them.
        bearing: whether the robot senses the bearing of a reference dart at these vertices.
    """

    where: Where
    bearing: bool

    @property
    def marks_v0(self) -> bool:
        """Whether a percept with one mark shows the robot that it is at v0.

        Then the robot senses one mark at v0; at every other vertex it senses no mark, or more than
        one.
        """
        return self.where in (Where.AT_V0, Where.AT_V0_AND_V1)

    @property
    def marks(self) -> bool:
        """Whether there are marks at all."""
        return self.marks_v0 or self.where is Where.EVERYWHERE_NUMBERED


@cache
def _percept(degree: int, marks: int = 0, bearing: int | None = None) -> actions.Percept:
    """A percept; calls with equal arguments return one and the same object."""
    return actions.Percept(degree, marks, bearing)


StandsAt: TypeAlias = Annotated[Dart, about("where it stands")]


class WalkInAnswer(NamedTuple):
    """The walk that a robot has made in the world, as a walk in the map of the robot's answer.

    Attributes:
        map: the map of the answer.
        trail: the robot's darts in this map, at the start and after each step.
        sensed: the percepts that the robot had in the world, in the same order.
    """

    map: CombinatorialMap
    trail: Sequence[Dart]
    sensed: Sequence[actions.Percept]


ACTING = ("acted", "in_hand", "left_marks", "refusal")
"""The names of the methods by which a robot's actions change percepts."""


class Lighthouse(ABC):
    """A lighthouse that stands at a place of a map.

    A user's lighthouse is a frozen dataclass with this base class.  The class defines the places of
    the lighthouse in a map (:meth:`places`), and the percept of a robot at each dart
    (:meth:`sensed`).  A field named ``dart`` holds a dart, and a field named ``darts`` a tuple of
    darts; a class with darts in other fields also defines their renaming (:meth:`relabelled`).

    A field whose default is an integer, a boolean or a text is an option: its value can be chosen
    on the command line.  In :meth:`places`, ``cls.size`` is the chosen value of an option ``size``,
    and ``cls(...)`` makes a lighthouse with this value in its field.  Do not read the value from
    ``dataclasses.fields(cls)``: the default in there is not changed by the user's choice.

    Attributes:
        kind: the name of the kind, on the command line and in files.
        default_bound: the bound on the traversals that is checked by default.
        folds: whether the robot knows its dart at each arrival at v0.  Then the log of a correct
            explorer determines the map, and the law ``folding`` applies.
        leaves_open: whether an explorer may answer without a map if several worlds look alike.  The
            answer is then the quotient that these worlds have in common, and the robot's dart in
            it.
        gives_marks: whether the lighthouse can put marks into percepts; in a composed lighthouse at
            most one part may do so.
        gives_bearings: whether the lighthouse can put a bearing into percepts; in a composed
            lighthouse at most one part may do so.
        leaves_marks: whether the robot can leave marks.
        static: whether the percepts stay the same whatever the robot does; by default true if the
            class defines none of the methods ``acted``, ``in_hand``, ``left_marks`` and
            ``refusal``.
        labels_vertices: whether the marks are the labels of vertices, not markers.
        code: the user's program with the class; None for a class of this program.
        chosen: the options that were given to the kind, with their values.
        every_place_to: the largest number of edges up to which :meth:`places` yields every place of
            a map; None if it does so in all maps.
        beyond: words about the places that :meth:`places` yields in larger maps.
    """

    kind: ClassVar[str]
    default_bound: ClassVar[str] = "none"
    folds: ClassVar[bool] = False
    leaves_open: ClassVar[bool] = False
    gives_marks: ClassVar[bool] = True
    gives_bearings: ClassVar[bool] = True
    leaves_marks: ClassVar[bool] = False
    static: ClassVar[bool] = True
    labels_vertices: ClassVar[bool] = False
    code: ClassVar[user_code.UserCode | None] = None
    chosen: ClassVar[Mapping[str, OptionValue]] = MappingProxyType({})
    every_place_to: ClassVar[int | None] = None
    beyond: ClassVar[str] = ""

    def __init_subclass__(cls) -> None:
        if "static" not in vars(cls):
            cls.static = all(getattr(cls, name) is getattr(Lighthouse, name) for name in ACTING)

    @classmethod
    def tried_in_maps_of(cls, edges: int) -> str:
        """Words about the places that are tried in maps with at most ``edges`` edges.

        The text is empty if every place is tried.
        """
        if cls.every_place_to is None or edges <= cls.every_place_to:
            return ""
        return f"every place up to {cls.every_place_to} edges; beyond, {cls.beyond}"

    @property
    def written(self) -> str:
        """The name of the lighthouse's kind with its options, as ``--lighthouse`` takes it."""
        return named_with(type(self), values_in(self))

    @property
    def as_kind(self) -> type[Lighthouse]:
        """The kind of the lighthouse: its class, with its options."""
        kind: type[Lighthouse] = kind_with(type(self), values_in(self))
        return kind

    @classmethod
    @abstractmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Lighthouse]:
        """Yield the lighthouse at each of its places in the map rooted at ``start``.

        If the darts are renamed, the order of the places must stay.
        """

    def check(self, map_: CombinatorialMap, start: Dart) -> None:
        """Raise InvalidWorld unless the lighthouse stands at a place of its kind in the map."""
        if self not in self.as_kind.places(map_, start):
            raise InvalidWorld(
                f"the lighthouse {self.kind} cannot stand at {show(self)} in this map with start "
                f"{start}: it is none of its places there"
            )

    def sensed(self, map_: CombinatorialMap, here: Dart) -> actions.Percept:
        """The percept of a robot that has come in by the dart ``here``; by default the degree."""
        return actions.Percept(map_.degree_at[here])

    def percepts(self, map_: CombinatorialMap) -> tuple[actions.Percept, ...]:
        """For each dart the percept of a robot that has arrived by it."""
        return tuple(self.sensed(map_, here) for here in map_.darts)

    def relabelled(self, names: Sequence[Dart]) -> Self:
        """This lighthouse in the same map, after each dart ``d`` is renamed ``names[d]``."""
        renamed: dict[str, Any] = {}
        if hasattr(self, "dart"):
            renamed["dart"] = names[self.dart]
        if hasattr(self, "darts"):
            renamed["darts"] = tuple(names[dart] for dart in self.darts)
        return replace(self, **renamed) if renamed else self  # type: ignore[type-var]

    def to_json(self) -> dict[str, Any]:
        """The lighthouse as a JSON object ``{"kind": ...}``, with its options and its place.

        For a user's class the options stand under the key ``options``; the key ``digest`` holds the
        digest of the user's program.
        """
        kind: Any = type(self)
        code = kind.code
        try:
            where = {key: plain(getattr(self, key)) for key in place_keys(kind)}
        except (AttributeError, TypeError):
            raise InvalidWorld(f"{show(self)} has a field that no document can hold") from None
        if code is not None:
            given = code.arguments or values_in(self)
            return {"kind": code.plain, "options": given, "digest": code.digest, **where}
        options = options_of(kind)
        usual = [key for key in options if where[key] == options[key].default]
        kept = [key for key in where if key not in usual or options[key].always]
        return {"kind": self.kind, **{key: where[key] for key in kept}}

    @classmethod
    def at(cls, **where: Any) -> Lighthouse:
        """The lighthouse at the place that a JSON document gives.

        ``where`` has the value of each field that holds the place; a list becomes a tuple.
        """
        return cls(
            **{
                key: tuple(value) if isinstance(value, list) and key != "dart" else value
                for key, value in where.items()
            }
        )

    @classmethod
    def usual(cls, map_: CombinatorialMap, start: Dart) -> Lighthouse:
        """The lighthouse at its first place, for a document that names no place.

        Raises:
            InvalidWorld: if this kind of lighthouse has no place in the map.
        """
        for placed in cls.places(map_, start):
            return placed
        name = named_with(cls, cls.chosen)
        raise InvalidWorld(f"the lighthouse {name} has no place in this map with start {start}")

    def number(self, map_: CombinatorialMap, start: Dart) -> int:
        """The number, from 0 on, of the lighthouse's place among all places in a rooted map.

        If the lighthouse stands at none of these places, the result is 0, as for the first place.

        Args:
            map_: the map.
            start: the root of the map.
        """
        places = enumerate(self.as_kind.places(map_, start))
        return next((i for i, placed in places if placed == self), 0)

    def believed(
        self, map_: CombinatorialMap, start: Dart, walk: WalkInAnswer
    ) -> Lighthouse | None:
        """The lighthouse at its place in the map of the robot's answer.

        The place determines the percepts that the answer predicts; the judge compares these
        percepts with those that the robot had.  By default the place in the answer's map has the
        same number as the lighthouse's place in the world; the answer's map is rooted at the first
        dart of ``walk``.  If the answer's map has no place with this number, the result is None.

        Args:
            map_: the map of the world, not of the answer.
            start: the robot's start in the world.
            walk: the robot's walk in the answer's map.  Some kinds, such as the compass, find the
                place by the percepts on this walk.
        """
        places = self.as_kind.places(walk.map, walk.trail[0])
        return next(islice(places, self.number(map_, start), None), None)

    @property
    def in_hand(self) -> int:
        """The number of markers in the robot's hand at the start."""
        return 0

    def refusal(self, action: actions.Action, lying: int, hand: int) -> str:  # noqa: ARG002  # none
        """A sentence about the legal actions if this action is illegal; empty if it is legal.

        Args:
            action: the robot's action, which is no motion.
            lying: the number of markers that lie at the robot's vertex.
            hand: the number of markers in the robot's hand.
        """
        lacks = "has no room for numbers" if type(action) is actions.Write else "gives no markers"
        return f"the {self.kind} lighthouse {lacks}"

    def acted(self, map_: CombinatorialMap, state: State, action: actions.Action) -> State:  # noqa: ARG002
        """The state after a legal action that is no motion; ``state`` is the state before.

        By default an action has no effect.
        """
        return state

    def left_marks(self, map_: CombinatorialMap, state: State) -> int:  # noqa: ARG002
        """The number of sensed marks that come from the robot's actions; by default 0.

        Dropped markers that lie at the robot's vertex count here; a number that the robot has
        written there counts as so many marks.
        """
        return 0

    def told(self, map_: CombinatorialMap) -> actions.Told:  # noqa: ARG002  # for kinds that need it
        """The value that the explorer is told before the start; by default None."""
        return None


class ReferenceLighthouse(Lighthouse):
    """A lighthouse whose percepts follow from certain darts, its references.

    Attributes:
        sensing: the marks and bearings that the robot senses in addition to the degree.
    """

    sensing: ClassVar[Sensing] = Sensing(Where.NOWHERE, bearing=False)

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        cls.gives_marks = cls.sensing.marks or cls.leaves_marks
        cls.gives_bearings = cls.sensing.bearing

    def references(self, map_: CombinatorialMap) -> Mapping[Dart, int]:  # noqa: ARG002  # none
        """The reference darts, each with the number of marks at its vertex.

        There is one reference dart for each vertex at which more than the degree is sensed; the
        reference dart of v0 comes first.
        """
        return {}

    def percepts(self, map_: CombinatorialMap) -> tuple[actions.Percept, ...]:
        """For each dart the percept of a robot that has arrived by it."""
        sensed = [_percept(degree) for degree in map_.degree_at]
        # The first one is set last: if a wrong answer confuses v1 with v0, the percept is v0's.
        for reference, marks in reversed([*self.references(map_).items()]):
            around = map_.vertices[map_.vertex_of[reference]]
            at, pointed = around.index(reference), self.sensing.bearing
            # sigma^back(d) is the reference dart for the dart d that lies back places before.
            for back in range(len(around)):
                bearing = back if pointed else None
                sensed[around[at - back]] = _percept(len(around), marks, bearing)
        return tuple(sensed)


class PlacelessLighthouse(ReferenceLighthouse):
    """A lighthouse that puts nothing into the map, and has one place in any map with any start."""

    @classmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Lighthouse]:  # noqa: ARG003
        """Yield the only place."""
        yield cls()

    def check(self, map_: CombinatorialMap, start: Dart) -> None:  # noqa: ARG002  # any
        """Raise InvalidWorld if an option is illegal; any map and any start is legal."""
        ensure_legal(self)
