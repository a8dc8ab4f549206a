"""The interface of every lighthouse."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import islice
from typing import Annotated, Any, ClassVar, NamedTuple, Self, TypeAlias

from allworlds.document import about, plain
from allworlds.inputs import InputError, integer, show
from allworlds.maps import CombinatorialMap, Dart
from allworlds.protocol import Action, Percept, Told, UserCode
from allworlds.world.lighthouses.sensing import Sensing, Where
from allworlds.world.state import State

StandsAt: TypeAlias = Annotated[Dart, about("where it stands")]


class InvalidWorld(InputError):
    """A map, a start and a lighthouse that do not make a world."""


class WalkInAnswer(NamedTuple):
    """The walk of a robot in its own answer.

    Attributes:
        map: the answered map.
        trail: its darts there at the start and after each step.
        sensed: what it sensed there.
    """

    map: CombinatorialMap
    trail: Sequence[Dart]
    sensed: Sequence[Percept]


class Lighthouse(ABC):
    """A lighthouse that stands at a place of a map.

    A lighthouse of one's own is a frozen dataclass with this base: it says at which places of a
    map it can stand (:meth:`places`), and what is sensed of it there (:meth:`sensed`).  A field
    with the name ``dart`` holds a dart, one with the name ``darts`` a tuple of them; a class with
    darts in other fields says how they are renamed (:meth:`relabelled`).

    Attributes:
        kind: the name on the command line and in files.
        default_bound: the bound on the traversals that is checked unless another is named.
        folds: whether the log of a correct explorer determines the map (every arrival at v0
            tells where the robot is, and how it is turned).
        leaves_open: whether an explorer may answer with the rooted quotient, where several
            worlds look alike.
        gives_marks, gives_bearings: whether it can make a percept have them; of two that are put
            together only one may.
        leaves_marks: whether the robot can leave marks itself.
        keys: what its JSON may hold besides ``kind``.
        asked: the types of those that are no attributes: they say which place is meant.
        code: where the class comes from, if it is the user's.
        every_place_to: the largest number of edges of the maps in which :meth:`places` yields every
            place; None: in all maps.
        beyond: the places that it yields in larger ones, in words.
    """

    kind: ClassVar[str]
    default_bound: ClassVar[str] = "none"
    folds: ClassVar[bool] = False
    leaves_open: ClassVar[bool] = False
    gives_marks: ClassVar[bool] = True
    gives_bearings: ClassVar[bool] = True
    leaves_marks: ClassVar[bool] = False
    keys: ClassVar[tuple[str, ...]] = ("dart",)
    asked: ClassVar[Mapping[str, Any]] = {}
    code: ClassVar[UserCode | None] = None
    every_place_to: ClassVar[int | None] = None
    beyond: ClassVar[str] = ""

    @classmethod
    def tried_in_maps_of(cls, edges: int) -> str:
        """The places that are tried in maps of up to so many edges, in words; empty: every one."""
        if cls.every_place_to is None or edges <= cls.every_place_to:
            return ""
        return f"every place up to {cls.every_place_to} edges; beyond, {cls.beyond}"

    @property
    def written(self) -> str:
        """The name of its kind, as ``--lighthouse`` takes it."""
        return self.kind if self.code is None else self.code.name

    @classmethod
    def with_options(cls, options: Mapping[str, str]) -> type[Lighthouse]:
        """The kind with the options of ``KIND:key=value``; by default there are none.

        Raises:
            InvalidWorld: naming the option, or the value, that the kind does not have.
        """
        given = ",".join(f"{key}={value}" for key, value in options.items())
        raise InvalidWorld(f"the {cls.kind} lighthouse takes no options, not {show(given)}")

    @classmethod
    @abstractmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Lighthouse]:
        """Every place in the map rooted at ``start``, in an order that renaming darts keeps."""

    def check(self, map_: CombinatorialMap, start: Dart) -> None:
        """Raise InvalidWorld unless the lighthouse can stand there: at one of its places."""
        if self not in type(self).places(map_, start):
            raise InvalidWorld(
                f"the lighthouse {self.kind} cannot stand at {show(self)} in this map with start "
                f"{start}: it is none of its places there"
            )

    def sensed(self, map_: CombinatorialMap, here: Dart) -> Percept:
        """The percept of a robot that has arrived by the dart ``here``: the degree alone."""
        return Percept(map_.degree_at[here])

    def percepts(self, map_: CombinatorialMap) -> tuple[Percept, ...]:
        """For each dart the percept of a robot that has arrived by it."""
        return tuple(self.sensed(map_, here) for here in map_.darts)

    def relabelled(self, names: Sequence[Dart]) -> Self:
        """The lighthouse at this place after dart ``d`` has been renamed to ``names[d]``."""
        told = {key: getattr(self, key) for key in self.keys if hasattr(self, key)}
        renamed: dict[str, Any] = {}
        if "dart" in told:
            renamed["dart"] = names[told["dart"]]
        if "darts" in told:
            renamed["darts"] = tuple(names[dart] for dart in told["darts"])
        return replace(self, **renamed) if renamed else self  # type: ignore[type-var]

    def to_json(self) -> dict[str, Any]:
        """``{"kind": ...}`` and the place: the attributes among its keys."""
        told = {key: getattr(self, key) for key in self.keys if hasattr(self, key)}
        return {**self._named(), **{key: plain(value) for key, value in told.items()}}

    def _named(self) -> dict[str, Any]:
        """Its kind; of the user's, the options and by which content the class is known."""
        if self.code is None:
            return {"kind": self.kind}
        return {
            "kind": self.kind,
            "options": self.code.arguments,
            "digest": self.code.digest,
        }

    @classmethod
    def from_json(
        cls, document: Mapping[str, Any], map_: CombinatorialMap, start: Dart
    ) -> Lighthouse:
        """The lighthouse of :meth:`to_json`'s document, which may leave out the place."""
        where = {key: document[key] for key in cls.keys if key in document}
        return cls.at(**where) if where else cls.usual(map_, start)

    @classmethod
    def at(cls, **where: Any) -> Lighthouse:
        """The lighthouse at the place that a document names, by its fields."""
        frozen = {
            key: tuple(value) if isinstance(value, list) and key != "dart" else value
            for key, value in where.items()
        }
        return cls(**frozen)

    @classmethod
    def usual(cls, map_: CombinatorialMap, start: Dart) -> Lighthouse:
        """The lighthouse at its first place, for a document that names no place.

        Raises:
            InvalidWorld: if it has none.
        """
        for place in cls.places(map_, start):
            return place
        raise no_place(cls.kind, start)

    def number(self, map_: CombinatorialMap, start: Dart) -> int:
        """The number of this place among the places of the rooted map; 0 if it is none of them."""
        places = enumerate(type(self).places(map_, start))
        return next((i for i, place in places if place == self), 0)

    def believed(
        self, map_: CombinatorialMap, start: Dart, walk: WalkInAnswer
    ) -> Lighthouse | None:
        """The lighthouse as the robot must believe it: at the place of the same number.

        None if the answer has no such place.
        """
        places = type(self).places(walk.map, walk.trail[0])
        return next(islice(places, self.number(map_, start), None), None)

    @property
    def in_hand(self) -> int:
        """The number of markers in the robot's hand at the start."""
        return 0

    def refusal(self, action: Action, lying: int, hand: int) -> str:  # noqa: ARG002  # none
        """A sentence about the legal actions if this one is illegal; empty if it is legal.

        Args:
            action: what the robot wants to do.
            lying: the number of markers at its vertex that have been dropped there.
            hand: the number of markers in its hand.
        """
        return f"the {self.kind} lighthouse gives no markers"

    def acted(self, map_: CombinatorialMap, state: State, action: Action) -> State:  # noqa: ARG002
        """The state after an action that is no motion, and that is not refused."""
        return state

    def left_marks(self, map_: CombinatorialMap, state: State) -> int:  # noqa: ARG002
        """The marks that the robot senses of what it has left itself."""
        return 0

    def told(self, map_: CombinatorialMap) -> Told:  # noqa: ARG002  # for kinds that need it
        """The value that the explorer is told before the start; by default None."""
        return None


class ReferenceLighthouse(Lighthouse):
    """A lighthouse of which all that is sensed follows from some darts, its references.

    Attributes:
        sensing: the percepts of a robot near it.
    """

    sensing: ClassVar[Sensing]

    def __init_subclass__(cls) -> None:
        cls.gives_marks = cls.sensing.marks or cls.leaves_marks
        cls.gives_bearings = cls.sensing.bearing

    @abstractmethod
    def references(self, map_: CombinatorialMap) -> tuple[Dart, ...]:
        """One dart of each vertex at which more than the degree is sensed; v0's is the first."""

    def percepts(self, map_: CombinatorialMap) -> tuple[Percept, ...]:
        """For each dart the percept of a robot that has arrived by it."""
        return self.sensing.percepts(map_, self.references(map_))


class PlacelessLighthouse(ReferenceLighthouse):
    """A lighthouse of which nothing stands anywhere: any map and any start are one place."""

    sensing: ClassVar[Sensing] = Sensing(Where.NOWHERE, bearing=False)

    @classmethod
    @abstractmethod
    def with_its_options(cls) -> Lighthouse:
        """The lighthouse with the options of the kind."""

    @classmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Lighthouse]:  # noqa: ARG003
        """One place."""
        yield cls.with_its_options()

    def check(self, map_: CombinatorialMap, start: Dart) -> None:
        """Every map and every start will do."""

    def references(self, map_: CombinatorialMap) -> tuple[Dart, ...]:  # noqa: ARG002  # any map
        """The empty tuple: at the start no mark lies anywhere."""
        return ()

    def number(self, map_: CombinatorialMap, start: Dart) -> int:  # noqa: ARG002  # the only one
        """0."""
        return 0

    def believed(self, map_: CombinatorialMap, start: Dart, walk: WalkInAnswer) -> Lighthouse:  # noqa: ARG002
        """The lighthouse itself, as it stands nowhere."""
        return self


def refuse_other_keys(what: str, document: Mapping[str, Any], legal: Sequence[str]) -> None:
    """Raise InvalidWorld unless all keys are legal: a misspelt one would have no effect."""
    for key in document:
        if key not in legal:
            raise InvalidWorld(f"{show(key)} is no key of a {what}; legal are {', '.join(legal)}")


def check_at_start(what: str, dart: object, map_: CombinatorialMap, start: Dart) -> None:
    """Raise InvalidWorld unless ``dart`` is a dart of the start's vertex."""
    try:
        found = integer(dart)
    except TypeError:
        raise InvalidWorld(f"lighthouse.dart = {show(dart)} is not an integer") from None
    at_start = map_.vertices[map_.vertex_of[start]]
    if found not in at_start:
        raise InvalidWorld(
            f"the lighthouse {what} dart {show(found)}, which is not at the start's vertex; "
            f"legal are {', '.join(map(str, at_start))}"
        )


def check_leads_away(dart: object, map_: CombinatorialMap, start: Dart) -> None:
    """Raise InvalidWorld unless ``dart`` leads from the start's vertex to another vertex."""
    check_at_start("looks along", dart, map_, start)
    v0 = map_.vertex_of[start]
    if map_.vertex_of[map_.alpha[integer(dart)]] == v0:
        legal = [d for d in map_.vertices[v0] if map_.vertex_of[map_.alpha[d]] != v0]
        raise InvalidWorld(
            f"lighthouse.dart = {show(dart)} leads back to the start's vertex, not to another one; "
            f"legal are {', '.join(map(str, legal)) or 'none'}"
        )


def the_darts(values: object) -> tuple[Dart, ...]:
    """The integers of a list; raise InvalidWorld if it is none."""
    if not isinstance(values, list | tuple):
        raise InvalidWorld(f"lighthouse.darts must be a list of darts, not {show(values)}")
    found = []
    for i, value in enumerate(values):
        try:
            found.append(integer(value))
        except TypeError:
            raise InvalidWorld(f"lighthouse.darts[{i}] = {show(value)} is not an integer") from None
    return tuple(found)


def check_one_of_each_vertex(darts: Sequence[Dart], map_: CombinatorialMap) -> None:
    """Raise InvalidWorld unless these are darts, one of each vertex."""
    for dart in darts:
        if dart not in map_.darts:
            raise InvalidWorld(
                f"lighthouse.darts names {show(dart)}, which is no dart; "
                f"darts are 0..{len(map_.sigma) - 1}"
            )
    chosen = [map_.vertex_of[dart] for dart in darts]
    for v, vertex in enumerate(map_.vertices):
        if chosen.count(v) != 1:
            raise InvalidWorld(
                f"lighthouse.darts = {show(list(darts))} has {chosen.count(v)} darts of the "
                f"vertex {show(list(vertex))}; it must have one of each vertex"
            )


def no_place(name: str, start: Dart) -> InvalidWorld:
    """The error for a lighthouse without a named place in a map that has no place for it."""
    return InvalidWorld(f"the lighthouse {name} has no place in this map with start {start}")
