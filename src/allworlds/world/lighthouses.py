"""Lighthouses: what is marked in a world, and what of it can be sensed.

A new lighthouse is a subclass of :class:`Lighthouse` and an entry of ``LIGHTHOUSES``.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any, ClassVar

from allworlds.errors import InputError, show
from allworlds.maps.combinatorial import CombinatorialMap, Dart, integer
from allworlds.protocol import Percept


class InvalidWorld(InputError):
    """A map, a start and a lighthouse that do not make a world."""


class Lighthouse(ABC):
    """A lighthouse that stands at a place of a map.

    Attributes:
        kind: the name on the command line and in files.
        default_bound: the bound on the traversals that is checked unless another is named.
        folds: whether the log of a correct explorer determines the map (every arrival at v0
            tells where the robot is, and how it is turned).
    """

    kind: ClassVar[str]
    default_bound: ClassVar[str]
    folds: ClassVar[bool]

    @classmethod
    @abstractmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Lighthouse]:
        """Every place in the map rooted at ``start``, in the fixed order."""

    @abstractmethod
    def check(self, map_: CombinatorialMap, start: Dart) -> None:
        """Nothing, if the lighthouse can stand there; else raises InvalidWorld."""

    @abstractmethod
    def percepts(self, map_: CombinatorialMap) -> tuple[Percept, ...]:
        """For each dart what is sensed by a robot that has arrived by it."""

    @abstractmethod
    def relabelled(self, names: Sequence[Dart]) -> Lighthouse:
        """The same place after dart ``d`` has been renamed to ``names[d]``."""

    @abstractmethod
    def to_json(self) -> dict[str, Any]:
        """``{"kind": ...}`` and where it stands."""

    @classmethod
    @abstractmethod
    def from_json(cls, document: Mapping[str, Any], start: Dart) -> Lighthouse:
        """The lighthouse of :meth:`to_json`'s document."""

    def told(self, _map: CombinatorialMap) -> int | None:
        """What the explorer is told before the start; nothing, unless a kind says otherwise."""
        return None


@dataclass(frozen=True, slots=True)
class Directional(Lighthouse):
    """One marker at the start vertex v0 that points to one of its darts.

    Sensed at v0: one mark, and the bearing of ``dart``; elsewhere only the degree.
    Source: Section IV of the paper.
    """

    dart: Dart

    kind: ClassVar[str] = "directional"
    default_bound: ClassVar[str] = "paper"
    folds: ClassVar[bool] = True

    @classmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Directional]:
        """One place for each bearing ``0..deg(v0)-1``."""
        for bearing in range(map_.degree_at[start]):
            yield cls(map_.turn(start, bearing))

    def check(self, map_: CombinatorialMap, start: Dart) -> None:
        """The pointed dart is one of the start's vertex."""
        try:
            dart = integer(self.dart)
        except TypeError:
            raise InvalidWorld(f"lighthouse.dart = {show(self.dart)} is not an integer") from None
        at_start = map_.vertices[map_.vertex_of[start]]
        if dart not in at_start:
            raise InvalidWorld(
                f"the lighthouse points to dart {show(dart)}, which is not at the start's vertex; "
                f"legal are {', '.join(map(str, at_start))}"
            )

    def percepts(self, map_: CombinatorialMap) -> tuple[Percept, ...]:
        """One mark and the bearing at v0, nothing but the degree elsewhere."""
        sensed = [_percept(degree, 0, None) for degree in map_.degree_at]
        dart, degree = self.dart, map_.degree_at[self.dart]
        for back in range(degree):
            # sigma^b(d) is the pointed dart for the dart d that lies b places before it.
            sensed[map_.turn(dart, -back)] = _percept(degree, 1, back)
        return tuple(sensed)

    def relabelled(self, names: Sequence[Dart]) -> Directional:
        """Pointing to the renamed dart."""
        return Directional(names[self.dart])

    def to_json(self) -> dict[str, Any]:
        """``{"kind": "directional", "dart": d}``."""
        return {"kind": self.kind, "dart": self.dart}

    @classmethod
    def from_json(cls, document: Mapping[str, Any], start: Dart) -> Directional:
        """Pointing to ``dart``, or to the start where no dart is named."""
        return cls(document.get("dart", start))


LIGHTHOUSES: dict[str, type[Lighthouse]] = {Directional.kind: Directional}
"""Every kind of lighthouse by its name."""


def lighthouse_named(text: str) -> type[Lighthouse]:
    """The kind of lighthouse of ``KIND[:key=value,...]``.

    Raises:
        InvalidWorld: naming the legal kinds, or the option that the kind does not have.
    """
    kind, _, options = text.partition(":")
    if kind not in LIGHTHOUSES:
        raise InvalidWorld(f"lighthouse {kind!r} is none of {', '.join(sorted(LIGHTHOUSES))}")
    if options:
        raise InvalidWorld(f"the {kind} lighthouse takes no options, not {options!r}")
    return LIGHTHOUSES[kind]


def lighthouse_from_json(document: object, start: Dart) -> Lighthouse:
    """The lighthouse of a world's JSON; a directional one at the start where it is missing."""
    if document is None:
        return Directional(start)
    if not isinstance(document, Mapping) or not isinstance(document.get("kind"), str):
        raise InvalidWorld(f"a lighthouse is an object with a 'kind', not {document!r}")
    return lighthouse_named(document["kind"]).from_json(document, start)


@cache
def _percept(degree: int, marks: int, bearing: int | None) -> Percept:
    return Percept(degree, marks, bearing)
