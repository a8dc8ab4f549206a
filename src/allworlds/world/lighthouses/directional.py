"""The directional lighthouse of the paper."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol import Percept
from allworlds.world.lighthouses.base import Lighthouse, check_at_start, percept


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
        check_at_start("points to", self.dart, map_, start)

    def percepts(self, map_: CombinatorialMap) -> tuple[Percept, ...]:
        """One mark and the bearing at v0, nothing but the degree elsewhere."""
        sensed = [percept(degree) for degree in map_.degree_at]
        dart, degree = self.dart, map_.degree_at[self.dart]
        for back in range(degree):
            # sigma^b(d) is the pointed dart for the dart d that lies b places before it.
            sensed[map_.turn(dart, -back)] = percept(degree, 1, back)
        return tuple(sensed)

    def relabelled(self, names: Sequence[Dart]) -> Directional:
        """Pointing to the renamed dart."""
        return Directional(names[self.dart])

    def to_json(self) -> dict[str, Any]:
        """``{"kind": "directional", "dart": d}``."""
        return {"kind": self.kind, "dart": self.dart}

    @classmethod
    def from_json(
        cls,
        document: Mapping[str, Any],
        map_: CombinatorialMap,  # noqa: ARG003  # for kinds that need it
        start: Dart,
    ) -> Directional:
        """Pointing to ``dart``, or to the start where no dart is named."""
        return cls(document.get("dart", start))
