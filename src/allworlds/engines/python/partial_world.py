"""A world that is decided on demand, in Python: the twin of the compiled one.

It decides darts in the order of :mod:`allworlds.engines.kernel.on_demand`, so that one judge
follows both.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from msgspec import Struct

from allworlds.maps import Dart, Decision, Gluing, MapClass
from allworlds.protocol import Percept

POINTED, MARKED = "directional", "position"


class PartialWorld(Struct, frozen=True):
    """A robot in a world of which a part is decided; a value.

    Attributes:
        gluing: the part of the map.
        dart: the robot's dart.
        place: the number of the lighthouse's place.
        lighthouse: ``none``, ``position`` or ``directional``.
        ways: how many darts have been decided that could be decided in several ways.
    """

    gluing: Gluing
    dart: Dart
    place: int
    lighthouse: str
    ways: int = 0

    @property
    def whole(self) -> bool:
        """Whether all of the world is decided."""
        return self.gluing.finished

    @property
    def vertices(self) -> int:
        """The number of vertices so far."""
        return len(self.gluing.degrees)

    @property
    def degree(self) -> int:
        """The degree of the robot's vertex."""
        return self.gluing.degrees[self.gluing.vertex[self.dart]]

    def percept(self) -> Percept:
        """The percept where the robot stands."""
        if self.gluing.vertex[self.dart] or self.lighthouse not in (POINTED, MARKED):
            return Percept(self.degree, 0, None)
        pointed = self.lighthouse == POINTED
        return Percept(self.degree, 1, (self.place - self.dart) % self.degree if pointed else None)

    def after(self, motion: int) -> Iterator[tuple[Decision | None, PartialWorld]]:
        """The worlds after a motion below the degree, each with the way in which a dart is decided.

        The way is None where there is nothing to decide, or one way alone.
        """
        gluing, vertex = self.gluing, self.gluing.vertex[self.dart]
        first = sum(gluing.degrees[:vertex])
        y = first + (self.dart - first + motion) % self.degree
        if gluing.alpha[y] >= 0:
            yield None, self._at(gluing, y, self.ways)
            return
        several = _ways(gluing) > 1
        for way, after in gluing.successors(y):
            yield (way if several else None), self._at(after, y, self.ways + several)

    def _at(self, gluing: Gluing, y: Dart, ways: int) -> PartialWorld:
        return PartialWorld(gluing, gluing.alpha[y], self.place, self.lighthouse, ways)


def _ways(gluing: Gluing) -> int:
    """The number of ways to decide an open dart, those that leave the class included."""
    owed, others = gluing.owed, sum(map(len, gluing.faces)) - 1
    partners = others if not owed or others > 1 else 0
    room = gluing.limit - len(gluing.degrees)
    if room <= 0 or not owed:
        return partners
    degrees = [owed] if room == 1 else range(1, owed + 1)
    return partners + sum(degree == owed or others + degree > 1 for degree in degrees)


def beginning(
    edges: int,
    map_class: MapClass,
    limit: int,
    prefix: Sequence[Decision],
    lighthouse: str,
    place: int,
) -> PartialWorld:
    """The world at the start of a run: only the decisions of the prefix have been taken."""
    gluing = Gluing(edges, map_class, limit)
    for decision in prefix:
        gluing.apply(decision)
    return PartialWorld(gluing, 0, place, lighthouse)


def places(prefix: Sequence[Decision], lighthouse: str) -> int:
    """The number of places of the lighthouse at a root of this degree."""
    return -prefix[0] if lighthouse == POINTED else 1
