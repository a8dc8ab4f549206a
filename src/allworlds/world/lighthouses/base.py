"""What every lighthouse must be able to say."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, ClassVar

from allworlds.errors import InputError, show
from allworlds.maps.combinatorial import CombinatorialMap, Dart, integer
from allworlds.protocol import Percept
from allworlds.world.lighthouses.sensing import Sensing


class InvalidWorld(InputError):
    """A map, a start and a lighthouse that do not make a world."""


class Lighthouse(ABC):
    """A lighthouse that stands at a place of a map.

    Attributes:
        kind: the name on the command line and in files.
        sensing: what a robot senses of it.
        default_bound: the bound on the traversals that is checked unless another is named.
        folds: whether the log of a correct explorer determines the map (every arrival at v0
            tells where the robot is, and how it is turned).
    """

    kind: ClassVar[str]
    sensing: ClassVar[Sensing]
    default_bound: ClassVar[str]
    folds: ClassVar[bool]

    @classmethod
    @abstractmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Lighthouse]:
        """Every place in the map rooted at ``start``, in an order that renaming darts keeps."""

    @abstractmethod
    def check(self, map_: CombinatorialMap, start: Dart) -> None:
        """Nothing, if the lighthouse can stand there; else raises InvalidWorld."""

    @property
    @abstractmethod
    def references(self) -> tuple[Dart, ...]:
        """One dart of each vertex at which more than the degree is sensed."""

    def percepts(self, map_: CombinatorialMap) -> tuple[Percept, ...]:
        """For each dart what is sensed by a robot that has arrived by it."""
        return self.sensing.percepts(map_, self.references)

    @abstractmethod
    def relabelled(self, names: Sequence[Dart]) -> Lighthouse:
        """The same place after dart ``d`` has been renamed to ``names[d]``."""

    @abstractmethod
    def to_json(self) -> dict[str, Any]:
        """``{"kind": ...}`` and where it stands."""

    @classmethod
    @abstractmethod
    def from_json(
        cls, document: Mapping[str, Any], map_: CombinatorialMap, start: Dart
    ) -> Lighthouse:
        """The lighthouse of :meth:`to_json`'s document; it may leave out where it stands."""

    def told(self, _map: CombinatorialMap) -> int | None:
        """What the explorer is told before the start; nothing, unless a kind says otherwise."""
        return None


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
