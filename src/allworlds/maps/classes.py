"""**The** table of the classes of maps, and the extent that makes one of them finite."""

from __future__ import annotations

from collections.abc import Callable
from enum import StrEnum
from typing import Annotated

from msgspec import Struct
from msgspec.structs import force_setattr

from allworlds.document.struct import Bounded, about
from allworlds.inputs.checks import (
    LARGEST_SIZE,
    InputError,
    an_integer,
    at_most,
    integer_of,
    one_of,
    show,
)
from allworlds.inputs.requests import SCOPE, Option, Request, Taken
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.conditions import Condition

DEFAULT_EDGES = 5
"""The number of edges up to which a check takes seconds."""


class MapClass(StrEnum):
    """A class of maps; the value is its name on the command line."""

    MAPS = "maps"
    SIMPLE = "simple"
    PLANAR = "planar"
    PLANAR_SIMPLE = "planar-simple"

    @classmethod
    def named(cls, text: object) -> MapClass:
        """Return the class of that name.

        Raises:
            InputError: naming those that there are.
        """
        if not isinstance(text, str) or text not in list(cls):
            raise InputError(f"class {show(text)} is not one of {', '.join(cls)}")
        return cls(text)

    @property
    def summary(self) -> str:
        """A description of these maps in a few words."""
        return _KINDS[self].summary

    @property
    def simple(self) -> bool:
        """Whether loops and parallel edges are excluded."""
        return _KINDS[self].simple

    @property
    def planar(self) -> bool:
        """Whether the genus of every map is 0."""
        return _KINDS[self].planar

    @property
    def promises(self) -> bool:
        """Whether a promise of the class can make an explorer right without folding its log."""
        return self.planar or not self.plain

    @property
    def plain(self) -> bool:
        """Whether ``simple`` and ``planar`` alone define it, as compiled code assumes."""
        return _KINDS[self].further is None

    def includes(self, map_: CombinatorialMap) -> bool:
        """Whether a map belongs to the class, by the map's own derived properties."""
        further = _KINDS[self].further
        return (
            (not self.simple or map_.is_simple)
            and (not self.planar or map_.is_planar)
            and (further is None or further(map_))
        )


class _Kind(Struct, frozen=True):
    """The properties of a class.

    Attributes:
        summary: a description of these maps in a few words.
        simple, planar: whether all of them are.
        further: what else is true of exactly these.
    """

    summary: str
    simple: bool = False
    planar: bool = False
    further: Callable[[CombinatorialMap], bool] | None = None


_KINDS = {
    MapClass.MAPS: _Kind("loops and parallel edges are allowed, and any genus"),
    MapClass.SIMPLE: _Kind("no loop, no two edges with the same ends", simple=True),
    MapClass.PLANAR: _Kind("of genus 0", planar=True),
    MapClass.PLANAR_SIMPLE: _Kind(
        "of genus 0, no loop, no two edges with the same ends", simple=True, planar=True
    ),
}


class Extent(Struct, frozen=True):
    """At most ``edges`` edges and at most ``vertices`` vertices of one class.

    Attributes:
        map_class: the class.
        edges: M, or None where only the vertices are bounded (simple classes).
        vertices: N, or None where only the edges are bounded.
        where: what besides is true of the maps, or None.

    Raises:
        InputError: naming the offending bound and what would be legal.
    """

    map_class: MapClass
    edges: int | None
    vertices: int | None = None
    where: Condition | None = None

    def __post_init__(self) -> None:
        for name in ("edges", "vertices"):
            if (value := getattr(self, name)) is not None:
                force_setattr(self, name, an_integer(name, value))
                at_most(name, value, LARGEST_SIZE)
        if self.edges is not None and self.edges < 1:
            raise InputError(f"edges = {show(self.edges)}, but a map has at least 1 edge")
        least = 1 + self.map_class.simple
        if self.vertices is not None and self.vertices < least:
            raise InputError(
                f"vertices = {show(self.vertices)}, but a map of the class {self.map_class} has at "
                f"least {least}"
            )
        if self.edges is None and self.vertices is None:
            raise InputError("a class needs a bound: edges, or vertices for the simple classes")
        if self.edges is None and not self.map_class.simple:
            raise InputError(
                f"vertices = {show(self.vertices)} alone bounds no class with loops or parallel "
                "edges; give edges too, or the class simple or planar-simple instead of "
                f"{self.map_class}"
            )

    @property
    def levels(self) -> range:
        """The numbers of edges m that are to be visited, ascending."""
        if self.edges is not None:
            return range(1, self.edges + 1)
        assert self.vertices is not None
        return range(1, self.vertices * (self.vertices - 1) // 2 + 1)

    def vertex_limit(self, edges: int) -> int:
        """The largest number of vertices that a map of the level can have within the bounds."""
        return edges + 1 if self.vertices is None else min(edges + 1, self.vertices)

    def include(self, map_: CombinatorialMap) -> bool:
        """Whether a map belongs to the class and is within the bounds."""
        edges, vertices = map_.edge_count, map_.vertex_count
        within = edges in self.levels and vertices <= self.vertex_limit(edges)
        return within and self.map_class.includes(map_) and self.admits(map_)

    def admits(self, map_: CombinatorialMap) -> bool:
        """Whether the condition holds of a map, if there is one."""
        return self.where is None or self.where.holds(map_)


# ---------------------------------------------------------------- as requests ask for it


class AskedClass(Request):
    """The part of a request that names a class of maps."""

    map_class: Annotated[
        Taken[str, MapClass],
        Option(
            SCOPE,
            "CLASS",
            f"{one_of(MapClass)}.",
            "class",
            told=Annotated[MapClass, about("the class of maps")],
        ),
    ] = Taken(MapClass.named, MapClass.MAPS.value)


class AskedSize(Request):
    """The part of a request that bounds the size of maps."""

    edges: Annotated[
        int | None, Option(SCOPE, "M", "At most M edges.", parse=integer_of, told=Bounded)
    ] = None
    vertices: Annotated[
        int | None,
        Option(
            SCOPE,
            "N",
            "At most N vertices (alone: simple classes only; default: any).",
            parse=integer_of,
            told=Bounded,
        ),
    ] = None


class AskedExtent(AskedClass, AskedSize):
    """The part of a request that names a class of maps and bounds their size."""

    @property
    def extent(self) -> Extent:
        """The class and the bounds.

        Raises:
            InputError: naming the offending bound and what would be legal.
        """
        return Extent(self.map_class, self.edges, self.vertices, self.condition)

    @property
    def condition(self) -> Condition | None:
        """The further condition on the maps; by default there is none."""
        return None
