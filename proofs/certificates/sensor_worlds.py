"""Every small world under a sensor, and which of them look alike: counted from the definitions.

It shares ``maps.py`` and ``sensed.py`` with the checker of twins, and makes all worlds anew: every
rooted map of a scope, with the lighthouse at every place.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import combinations
from typing import Any

from lrat import Refused
from maps import Map, is_planar, is_simple, look, orbit, rooted_maps, vertex_count
from sensed import Lighthouse, features_in

FURTHEST = 4
"""The edges of the largest maps of which all are made: with 5 there are 50,000 places of a door."""
NO_BOUND = 10**6
"""In place of a number of edges, where a document has none."""
CLASSES = ("maps", "simple", "planar", "planar-simple")

Letters = tuple[int, ...]
"""A coarsening: for each feature its letter; letters are numbered as they come."""


@dataclass(frozen=True)
class Scope:
    """The worlds of which a document speaks.

    Attributes:
        edges, vertices: at most so many; no bound on vertices if None.
        map_class: their class.
        narrowed: whether its worlds are not made here: there is no bound on edges, or there are
            further conditions.
    """

    edges: int
    vertices: int | None
    map_class: str
    narrowed: bool

    @property
    def furthest(self) -> int:
        """The edges of the largest maps that are made; 0: none are."""
        return 0 if self.narrowed else min(self.edges, FURTHEST)

    @property
    def whole(self) -> bool:
        """Whether all maps of the scope are made."""
        return self.furthest == self.edges

    def require(self, map_: Map) -> None:
        """Raise Refused unless a map is in the scope, as far as it is known."""
        simple, planar = "simple" in self.map_class, "planar" in self.map_class
        if len(map_[0]) > 2 * self.edges or vertex_count(map_) > (self.vertices or len(map_[0])):
            raise Refused("a world is larger than the scope allows")
        if (simple and not is_simple(map_)) or (planar and not is_planar(map_)):
            raise Refused(f"a world is not in the class {self.map_class}")

    def maps(self) -> Iterator[Map]:
        """Every rooted map that is made, the smaller ones first; the root is dart 0."""
        simple, planar = "simple" in self.map_class, "planar" in self.map_class
        for edges in range(1, self.furthest + 1):
            for map_ in rooted_maps(edges, simple=simple, most=self.vertices):
                if not planar or is_planar(map_):
                    yield map_


def scope_of(document: Any, more: str = "") -> Scope:
    """The scope that a document names; ``more`` is a key of it that says something else.

    Raises:
        Refused: if it is none.
    """
    known = {"edges", "vertices", "class", *([more] if more else [])}
    if not isinstance(document, dict) or not known <= {*document}:
        raise Refused(f"the scope has not the keys {', '.join(sorted(known))}")
    edges, vertices = document["edges"], document["vertices"]
    for number in (edges, vertices):
        if number is not None and (type(number) is not int or number < 1):
            raise Refused(f"the scope has {number!r} edges or vertices")
    if document["class"] not in CLASSES:
        raise Refused(f"the scope has the class {document['class']!r}, not one of {CLASSES}")
    by_vertices = vertices is not None and "simple" in document["class"]
    if edges is None and not by_vertices and "given" not in document:
        raise Refused("the scope has no bound on edges")
    narrowed = edges is None or {*document} != known
    return Scope(NO_BOUND if edges is None else edges, vertices, document["class"], narrowed)


@dataclass
class Worlds:
    """All worlds under a sensor: for each its rooted map, its place, its look.

    Attributes:
        edges, roots: of each world, and the number of its rooted map.
        places: where the lighthouse stands.
        looks: equal exactly for worlds that no motion tells apart.
        sensed: for each dart of each world what is sensed there, and what is told.
    """

    edges: list[int] = field(default_factory=list)
    roots: list[int] = field(default_factory=list)
    places: list[Any] = field(default_factory=list)
    looks: list[Hashable] = field(default_factory=list)
    sensed: list[Hashable] = field(default_factory=list)

    @classmethod
    def under(cls, lighthouse: Lighthouse, scope: Scope) -> Worlds:
        """All worlds of a scope that are made, under a lighthouse."""
        found = cls()
        for root, map_ in enumerate(scope.maps()):
            for place in lighthouse.places(map_, 0):
                percepts, told = lighthouse.shown(map_, place)
                found.edges.append(len(map_[0]) // 2)
                found.roots.append(root)
                found.places.append((root, [each for each in place if each]))
                found.looks.append((look(map_, percepts, 0), told))
                found.sensed += [(each, told) for each in percepts]
        return found

    def alike(self) -> tuple[int | None, int]:
        """The edges of the first worlds that look alike, and how many rooted maps then do."""
        groups: dict[Hashable, set[int]] = {}
        for edges in sorted({*self.edges}):
            for i, size in enumerate(self.edges):
                if size == edges:
                    groups.setdefault(self.looks[i], set()).add(self.roots[i])
            if several := [roots for roots in groups.values() if len(roots) > 1]:
                return edges, len(set().union(*several))
        return None, 0


def follows(one: Sequence[Hashable], other: Sequence[Hashable]) -> bool:
    """Whether the first values are a function of the others."""
    return len({*zip(other, one, strict=True)}) == len({*other})


# ---- Coarsenings ----


def partitions(features: int) -> list[Letters]:
    """The ways to give letters to features: to each one of those before, or the next new one."""
    if not features:
        return [()]
    every = []
    for shorter in partitions(features - 1):
        every += [(*shorter, letter) for letter in range(len({*shorter}) + 1)]
    return sorted(every, key=lambda each: (len({*each}), each))


def joined(letters: Letters, one: int, other: int) -> Letters:
    """The coarsening in which two letters are one."""
    names: dict[int, int] = {}
    merged = [one if letter == other else letter for letter in letters]
    return tuple(names.setdefault(letter, len(names)) for letter in merged)


def lower_neighbours(letters: Letters) -> list[Letters]:
    """Those in which two letters are one, by the later letter, then by the other."""
    pairs = sorted(combinations(range(max(letters) + 1), 2), key=lambda two: two[::-1])
    return [joined(letters, one, other) for one, other in pairs]


def is_coarser(one: Letters, other: Letters) -> bool:
    """Whether the letters of one follow from those of the other; each does from itself."""
    return follows(one, other)


class FinestWorlds:
    """All worlds of a scope that are made, with the feature of each dart.

    A coarsening is tried in the worlds that refuted earlier ones first.
    """

    def __init__(self, features: Sequence[str], scope: Scope) -> None:
        self.worlds: list[tuple[int, Map, list[int], list[int]]] = []
        self.refuting: dict[int, None] = {}
        for root, map_ in enumerate(scope.maps()):
            degrees = [len(orbit(map_[0], dart)) for dart in range(len(map_[0]))]
            for door in orbit(map_[0], 0):
                found = features_in(map_, door, features)
                self.worlds.append((root, map_, degrees, found))

    def suffices(self, letters: Letters) -> bool:
        """Whether no two worlds look alike: their rooted maps would be different."""
        return not (self._alike(letters, self.refuting) or self._alike(letters, self._every()))

    def _every(self) -> Sequence[int]:
        return range(len(self.worlds))

    def _alike(self, letters: Letters, some: Sequence[int] | dict[int, None]) -> bool:
        first: dict[Hashable, int] = {}
        for number in some:
            root, map_, degrees, features = self.worlds[number]
            sensed = [(d, letters[f]) for d, f in zip(degrees, features, strict=True)]
            other = first.setdefault(look(map_, sensed, 0), number)
            if self.worlds[other][0] != root:
                self.refuting |= {other: None, number: None}
                return True
        return False
