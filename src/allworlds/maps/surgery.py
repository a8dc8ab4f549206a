"""Small changes to a map: the smaller neighbours that a shrinker tries.

Each result keeps the order of the darts that are left; None if no map would be left.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from allworlds.maps.combinatorial import CombinatorialMap, Dart, InvalidMap


def deleted(map_: CombinatorialMap, dart: Dart) -> CombinatorialMap | None:
    """The map without the edge of ``dart``; None if the rest is disconnected or empty.

    The end of a leaf goes with its edge.
    """
    gone = (dart, map_.alpha[dart])
    return _rebuilt(map_, [[d for d in vertex if d not in gone] for vertex in map_.vertices])


def contracted(map_: CombinatorialMap, dart: Dart) -> CombinatorialMap | None:
    """The map in which both ends of the edge of ``dart`` are one vertex; None for a loop.

    The rotation of one end takes the place that the edge had in the rotation of the other.
    """
    ends = [map_.vertex_of[d] for d in (dart, map_.alpha[dart])]
    if ends[0] == ends[1]:
        return None
    merged = [
        map_.turn(d, k) for d in (dart, map_.alpha[dart]) for k in range(1, map_.degree_at[d])
    ]
    others = [vertex for v, vertex in enumerate(map_.vertices) if v not in ends]
    return _rebuilt(map_, [merged, *others])


def moved(map_: CombinatorialMap) -> Iterator[CombinatorialMap]:
    """The maps with as many edges in which one dart stands at another place of a rotation."""
    for dart in map_.darts:
        without = [[d for d in vertex if d != dart] for vertex in map_.vertices]
        for v, vertex in enumerate(without):
            for place in range(len(vertex)):
                rotations = [*without[:v], [*vertex[:place], dart, *vertex[place:]]]
                other = _rebuilt(map_, [*rotations, *without[v + 1 :]])
                if other is not None:
                    yield other


def _rebuilt(
    map_: CombinatorialMap, rotations: Sequence[Sequence[Dart]]
) -> CombinatorialMap | None:
    """The map with these rotations on the edges that are left."""
    number = {d: i for i, d in enumerate(sorted(d for vertex in rotations for d in vertex))}
    sigma, alpha = [0] * len(number), [0] * len(number)
    for vertex in rotations:
        for d, following in zip(vertex, [*vertex[1:], *vertex[:1]], strict=True):
            sigma[number[d]] = number[following]
            alpha[number[d]] = number[map_.alpha[d]]
    try:
        return CombinatorialMap(sigma, alpha)
    except InvalidMap:
        return None
