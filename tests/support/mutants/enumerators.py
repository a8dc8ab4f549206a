"""Broken enumerators, whose levels of rooted maps are wrong."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from msgspec import Struct

from allworlds.maps import CombinatorialMap, rooted_code, rooted_maps

Enumerator = Callable[[int], Iterator[CombinatorialMap]]


def map_dropped(edges: int) -> Iterator[CombinatorialMap]:
    """The last map of every level is missing."""
    previous = None
    for map_ in rooted_maps(edges):
        if previous is not None:
            yield previous
        previous = map_


def map_doubled(edges: int) -> Iterator[CombinatorialMap]:
    """The first map of every level comes twice."""
    for i, map_ in enumerate(rooted_maps(edges)):
        yield map_
        if i == 0:
            yield map_


def map_replaced(edges: int) -> Iterator[CombinatorialMap]:
    """One map comes again in the place of the next one with as many vertices."""
    previous, replaced = None, False
    for map_ in rooted_maps(edges):
        if previous and not replaced and previous.vertex_count == map_.vertex_count:
            replaced = True
            yield previous
        else:
            yield map_
        previous = map_


def mirror_images_merged(edges: int) -> Iterator[CombinatorialMap]:
    """Of a rooted map and its mirror image only one comes."""
    for map_ in rooted_maps(edges):
        mirrored = map_.mirrored()
        if rooted_code(map_.sigma, map_.alpha, 0) <= rooted_code(mirrored.sigma, mirrored.alpha, 0):
            yield map_


def loops_left_out(edges: int) -> Iterator[CombinatorialMap]:
    """Maps with a loop are missing."""
    return (map_ for map_ in rooted_maps(edges) if not map_.loop_count)


def handles_left_out(edges: int) -> Iterator[CombinatorialMap]:
    """Only maps in the plane come."""
    return (map_ for map_ in rooted_maps(edges) if map_.is_planar)


class BrokenEnumerator(Struct, frozen=True):
    """An enumerator of the class ``maps`` that is wrong."""

    enumerate: Enumerator

    @property
    def name(self) -> str:
        """Name in the kill matrix."""
        return self.enumerate.__name__.replace("_", "-")

    @property
    def breaks(self) -> str:
        """The fault of the enumerator, in words."""
        return (self.enumerate.__doc__ or "").strip()


BROKEN_ENUMERATORS = tuple(
    map(
        BrokenEnumerator,
        (
            map_dropped,
            map_doubled,
            map_replaced,
            mirror_images_merged,
            loops_left_out,
            handles_left_out,
        ),
    )
)
"""The enumerators that must be caught."""
