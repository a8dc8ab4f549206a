"""Two worlds in plain sight: do they look alike, and are they different?

This knows permutations and markers, and nothing of formulas: it is what a pair that a solver
has found must pass.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from allworlds.maps.canonical import numbering, rooted_code
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.world import LIGHTHOUSES, Sensing

if TYPE_CHECKING:
    from allworlds import documents


@dataclass(frozen=True, slots=True)
class MarkedMap:
    """A rooted map and its reference darts.

    Attributes:
        kind: the level of information: the name of a lighthouse.
        map: the map.
        start: the dart that the robot faces; where a vertex is marked, at that vertex.
        darts: the reference darts: one at every vertex (compass), the pointed dart
            (directional), any dart of v0 (position), or none.
    """

    kind: str
    map: CombinatorialMap
    start: int
    darts: tuple[int, ...]

    @property
    def sensing(self) -> Sensing:
        """What is sensed besides the degree."""
        return LIGHTHOUSES[self.kind].sensing

    def percept(self, dart: int) -> tuple[int, ...]:
        """Degree, marks, and the bearing where one is sensed, found by turning step by step."""
        sigma = self.map.sigma
        around = [dart]
        while sigma[around[-1]] != dart:
            around.append(sigma[around[-1]])
        here = [place for place, other in enumerate(around) if other in self.darts]
        marks = int(bool(here) and self.sensing.marks_v0)
        bearing = here if self.sensing.bearing else []
        return (len(around), marks, *bearing)

    def started_at(self, start: int) -> MarkedMap:
        """The same world entered at another dart."""
        return MarkedMap(self.kind, self.map, start, self.darts)

    @property
    def starts(self) -> list[int]:
        """The darts at which a robot can start: those of v0, or all."""
        if not self.sensing.marks_v0:
            return list(self.map.darts)
        owner = self.map.vertex_of
        return [dart for dart in self.map.darts if owner[dart] == owner[self.start]]

    @property
    def code(self) -> tuple[object, ...]:
        """Equal exactly for the same world with the same start."""
        code = rooted_code(self.map.sigma, self.map.alpha, self.start)
        order = numbering(self.map.sigma, self.map.alpha, self.start)
        pointed = self.darts if self.sensing.bearing else ()
        return (*code, tuple(sorted(order.index(dart) for dart in pointed)))

    def to_json(self) -> documents.World:
        """The WORLD document."""
        return {**self.map.to_json(), "start": self.start, "lighthouse": self._lighthouse()}

    def _lighthouse(self) -> documents.Lighthouse | documents.AtDart | documents.AtDarts:
        if self.kind == "compass":
            return {"kind": self.kind, "darts": list(self.darts)}
        if self.darts:
            return {"kind": self.kind, "dart": self.darts[0]}
        return {"kind": self.kind}

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> MarkedMap:
        """The world of :meth:`to_json`'s document."""
        lighthouse = document["lighthouse"]
        darts = lighthouse.get("darts", [lighthouse["dart"]] if "dart" in lighthouse else [])
        map_ = CombinatorialMap.from_json(document)
        return cls(lighthouse["kind"], map_, document["start"], tuple(darts))


def bisimulation(a: MarkedMap, b: MarkedMap) -> tuple[list[int], list[int]] | None:
    """The class of each dart of ``a`` and of ``b``; None if some motion tells them apart.

    Starts share a class, sigma and alpha take classes to classes, and the darts of a class
    sense the same.  Classes are numbered in the order of the darts of ``a``.
    """
    worlds = (a, b)
    pairs = {(a.start, b.start)}
    for x, y in (todo := list(pairs)):
        if a.percept(x) != b.percept(y):
            return None
        for pair in ((a.map.sigma[x], b.map.sigma[y]), (a.map.alpha[x], b.map.alpha[y])):
            if pair not in pairs:
                pairs.add(pair)
                todo.append(pair)
    label: list[list[int]] = [list(w.map.darts) for w in worlds]
    label[1] = [-1] * len(label[1])
    changed = True
    while changed:
        changed = False
        for x, y in sorted(pairs):
            least = min(label[0][x], label[1][y]) if label[1][y] >= 0 else label[0][x]
            if (label[0][x], label[1][y]) != (least, least):
                label[0][x] = label[1][y] = least
                changed = True
    names = {least: i for i, least in enumerate(sorted(set(label[0])))}
    return [names[x] for x in label[0]], [names[y] for y in label[1]]


def same_world_from(a: MarkedMap, b: MarkedMap) -> int | None:
    """The start at which ``b`` would be the same world as ``a``; None if the two differ."""
    if len(a.map.sigma) != len(b.map.sigma):
        return None
    return next((d for d in b.starts if b.started_at(d).code == a.code), None)


def senses(world: MarkedMap, motions: Sequence[int]) -> list[tuple[int, ...]]:
    """What is sensed after each motion of a walk from the start."""
    dart, seen = world.start, []
    for motion in motions:
        dart = world.map.alpha[world.map.turn(dart, motion)]
        seen.append(world.percept(dart))
    return seen
