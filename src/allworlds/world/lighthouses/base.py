"""What every lighthouse must be able to say."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from itertools import islice
from typing import Annotated, Any, ClassVar, NamedTuple, TypeAlias

from allworlds.document import about, plain
from allworlds.inputs import InputError, integer, show
from allworlds.maps import CombinatorialMap, Dart
from allworlds.protocol import Action, Percept
from allworlds.world.lighthouses.sensing import Sensing

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

    Attributes:
        kind: the name on the command line and in files.
        sensing: what a robot senses of it.
        default_bound: the bound on the traversals that is checked unless another is named.
        folds: whether the log of a correct explorer determines the map (every arrival at v0
            tells where the robot is, and how it is turned).
        leaves_open: whether an explorer may answer with the rooted quotient, where several
            worlds look alike.
        keys: what its JSON may hold besides ``kind``.
        asked: the types of those that are no attributes: they say which place is meant.
    """

    kind: ClassVar[str]
    sensing: ClassVar[Sensing]
    default_bound: ClassVar[str]
    folds: ClassVar[bool]
    leaves_open: ClassVar[bool] = False
    keys: ClassVar[tuple[str, ...]] = ("dart",)
    asked: ClassVar[Mapping[str, Any]] = {}

    @classmethod
    def with_options(cls, options: Mapping[str, str]) -> type[Lighthouse]:
        """The kind with the options of ``KIND:key=value``; it has none, unless it says otherwise.

        Raises:
            InvalidWorld: naming the option, or the value, that the kind does not have.
        """
        given = ",".join(f"{key}={value}" for key, value in options.items())
        raise InvalidWorld(f"the {cls.kind} lighthouse takes no options, not {show(given)}")

    @classmethod
    @abstractmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Lighthouse]:
        """Every place in the map rooted at ``start``, in an order that renaming darts keeps."""

    @abstractmethod
    def check(self, map_: CombinatorialMap, start: Dart) -> None:
        """Nothing, if the lighthouse can stand there; else raises InvalidWorld."""

    @abstractmethod
    def references(self, map_: CombinatorialMap) -> tuple[Dart, ...]:
        """One dart of each vertex at which more than the degree is sensed; v0's is the first."""

    def percepts(self, map_: CombinatorialMap) -> tuple[Percept, ...]:
        """For each dart what is sensed by a robot that has arrived by it."""
        return self.sensing.percepts(map_, self.references(map_))

    @abstractmethod
    def relabelled(self, names: Sequence[Dart]) -> Lighthouse:
        """The same place after dart ``d`` has been renamed to ``names[d]``."""

    def to_json(self) -> dict[str, Any]:
        """``{"kind": ...}`` and where it stands: the attributes among its keys."""
        told = {key: getattr(self, key) for key in self.keys if hasattr(self, key)}
        return {"kind": self.kind, **{key: plain(value) for key, value in told.items()}}

    @classmethod
    def from_json(
        cls, document: Mapping[str, Any], map_: CombinatorialMap, start: Dart
    ) -> Lighthouse:
        """The lighthouse of :meth:`to_json`'s document; it may leave out where it stands."""
        for key in cls.keys:
            if key in document:
                return cls.at(document[key])
        return cls.usual(map_, start)

    @classmethod
    def at(cls, where: Any) -> Lighthouse:
        """The lighthouse at the place that a document names."""
        return cls(where)  # type: ignore[call-arg]  # the field of its only key

    @classmethod
    def usual(cls, map_: CombinatorialMap, start: Dart) -> Lighthouse:
        """The lighthouse where no place is named: at its first one.

        Raises:
            InvalidWorld: if it has none.
        """
        for place in cls.places(map_, start):
            return place
        raise no_place(cls.kind, start)

    def number(self, map_: CombinatorialMap, start: Dart) -> int:
        """Its place's number among the places of the rooted map; 0 for one that is none of them."""
        places = enumerate(type(self).places(map_, start))
        return next((i for i, place in places if place == self), 0)

    def believed(
        self, map_: CombinatorialMap, start: Dart, walk: WalkInAnswer
    ) -> Lighthouse | None:
        """Where a robot must believe that it stands: at the place of the same number.

        None where the answer has no such place.
        """
        places = type(self).places(walk.map, walk.trail[0])
        return next(islice(places, self.number(map_, start), None), None)

    @property
    def in_hand(self) -> int:
        """The number of markers in the robot's hand at the start."""
        return 0

    def refusal(self, action: Action, lying: int, hand: int) -> str:  # noqa: ARG002  # none
        """What is legal where that action is not; empty where it is.

        Args:
            action: what the robot wants to do.
            lying: the number of markers at its vertex that have been dropped there.
            hand: the number of markers in its hand.
        """
        return f"the {self.kind} lighthouse gives no markers"

    def told(self, map_: CombinatorialMap) -> int | None:  # noqa: ARG002  # for kinds that need it
        """What the explorer is told before the start; nothing, unless a kind says otherwise."""
        return None


def refuse_other_keys(what: str, document: Mapping[str, Any], legal: Sequence[str]) -> None:
    """Nothing, if the document holds only these keys: a misspelt one would change nothing."""
    for key in document:
        if key not in legal:
            raise InvalidWorld(f"{show(key)} is no key of a {what}; legal are {', '.join(legal)}")


def check_at_start(what: str, dart: object, map_: CombinatorialMap, start: Dart) -> None:
    """Nothing, if ``dart`` is one of the start's vertex; else raises InvalidWorld."""
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
    """Nothing, if ``dart`` is one of the start's vertex and leads to another; else InvalidWorld."""
    check_at_start("looks along", dart, map_, start)
    v0 = map_.vertex_of[start]
    if map_.vertex_of[map_.alpha[integer(dart)]] == v0:
        legal = [d for d in map_.vertices[v0] if map_.vertex_of[map_.alpha[d]] != v0]
        raise InvalidWorld(
            f"lighthouse.dart = {show(dart)} leads back to the start's vertex, not to another one; "
            f"legal are {', '.join(map(str, legal)) or 'none'}"
        )


def the_darts(values: object) -> tuple[Dart, ...]:
    """The integers of a list; else raises InvalidWorld."""
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
    """Nothing, if these are darts, one of each vertex; else raises InvalidWorld."""
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
    """The error that a map has no place for a lighthouse which names none."""
    return InvalidWorld(f"the lighthouse {name} has no place in this map with start {start}")
