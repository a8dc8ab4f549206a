"""A map as a polygon whose sides are glued in pairs: the surface, cut open along edges.

The faces are merged into one by not cutting along a tree of edges between them; these edges lie
inside.  Along every other edge the surface is cut, so each of these is two sides of the polygon.
"""

from __future__ import annotations

from cmath import phase, rect
from collections.abc import Sequence
from math import pi, sqrt, tau

from msgspec import Struct

from allworlds.maps import CombinatorialMap, Dart, numbering

SIDE, SMALLEST = 74.0, 120.0
"""In pixels: the length of a side, and the radius of the polygon, at least."""

INNER = 0.62
"""The circle to which edges inside go straight from their corners, as a part of the polygon's."""


class Polygon(Struct, frozen=True):
    """The surface cut open, in pixels, y downwards.

    Attributes:
        sides: the darts whose edges are cut, as a walk round the polygon meets them: with the
            inside to its left, it leaves by the dart, and comes to the dart's other end.
        corners: where each side begins.
        within: for each corner the darts that lead inside from it, clockwise.
        ways: for each dart that leads inside the points that its edge is drawn towards, as in a
            layout.
    """

    sides: tuple[Dart, ...]
    corners: tuple[complex, ...]
    within: tuple[tuple[Dart, ...], ...]
    ways: dict[Dart, tuple[complex, ...]]

    @property
    def radius(self) -> float:
        """Distance of the corners from the middle, which is 0."""
        return abs(self.corners[0])

    def side(self, place: int) -> tuple[complex, complex]:
        """The ends of a side, by its place in ``sides``."""
        return self.corners[place], self.corners[(place + 1) % len(self.corners)]


def polygon(map_: CombinatorialMap, root: Dart) -> Polygon:
    """The map cut open; the root's side, or the first one after it, begins to the left.

    It is the same for the same rooted map, whatever its darts are called.

    Raises:
        ValueError: for a map with one vertex on the sphere, where no edge is to be cut along.

    Cost: O(m^2).
    """
    order = numbering(map_.sigma, map_.alpha, root)
    inside = _between_faces(map_, order)
    cut = [dart for dart in order if dart not in inside]
    if not cut:
        raise ValueError("a map with one vertex on the sphere has no edge to be cut along")
    sides, within = [cut[0]], list[tuple[Dart, ...]]()
    while True:
        corner, dart = [], map_.sigma[map_.alpha[sides[-1]]]
        while dart in inside:
            corner.append(dart)
            dart = map_.sigma[dart]
        within.append(tuple(corner))
        if dart == sides[0]:
            break
        sides.append(dart)
    within = [within[-1], *within[:-1]]
    count = len(sides)
    radius = max(SMALLEST, SIDE * count / tau)
    # The inside is to the left: the walk goes counterclockwise, against growing angles.
    corners = tuple(rect(radius, pi - tau * k / count) for k in range(count))
    return Polygon(tuple(sides), corners, tuple(within), _ways(map_, corners, within, radius))


def _between_faces(map_: CombinatorialMap, order: Sequence[Dart]) -> set[Dart]:
    """The darts of a tree of edges that join all faces, and cut none from itself."""
    face_of = {dart: i for i, face in enumerate(map_.faces) for dart in face}
    joined, inside = {face_of[order[0]]}, set[Dart]()
    while len(joined) < len(map_.faces):
        dart = next(
            d for d in order if face_of[d] in joined and face_of[map_.alpha[d]] not in joined
        )
        joined.add(face_of[map_.alpha[dart]])
        inside |= {dart, map_.alpha[dart]}
    return inside


def _ways(
    map_: CombinatorialMap,
    corners: Sequence[complex],
    within: Sequence[Sequence[Dart]],
    radius: float,
) -> dict[Dart, tuple[complex, ...]]:
    """Points that the edges inside are drawn towards. These edges do not cross.

    Each has a point of its own on a circle, in the order of the corners, and between two of
    these it is bent inwards, as a straight line of the hyperbolic plane is.
    """
    # A walk round the circle as the corners go meets the darts of a corner counterclockwise.
    ends = [(k, dart) for k, darts in enumerate(within) for dart in darts]
    if not ends:
        return {}
    count, inner = len(corners), INNER * radius
    leave, entry = dict[Dart, complex](), dict[Dart, complex]()
    for k, darts in enumerate(within):
        back, ahead = corners[k - 1] - corners[k], corners[(k + 1) % count] - corners[k]
        angle, reach = phase(ahead / back) % tau, min(0.48, 0.3 * radius / abs(back))
        for place, dart in enumerate(darts, 1):
            # Clockwise from the side before to the side after; less far than half a side, and
            # than the circle.
            part = place / (len(darts) + 1)
            leave[dart] = corners[k] + reach * back * rect(1, part * angle)
            entry[dart] = rect(inner, pi - tau * (k + 0.8 * (part - 0.5)) / count)
    ways: dict[Dart, tuple[complex, ...]] = {}
    for k, dart in ends:
        other = map_.alpha[dart]
        far = next(i for i, end in ends if end == other)
        a, b = entry[dart], entry[other]
        middle = (a + b) / 2
        bend = middle * _bent(abs(middle) / inner)
        ways[dart] = (corners[k], leave[dart], a, bend, b, leave[other], corners[far])
    return ways


def _bent(near: float) -> float:
    """The nearest point of a line of the hyperbolic plane to the centre of the unit circle.

    The middle of its two ends is at the distance ``near`` from the centre; the result is a factor
    of this distance.
    """
    return (1 - sqrt(1 - near**2)) / near**2 if near > 1e-6 else 0.5
