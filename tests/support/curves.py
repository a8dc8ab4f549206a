"""The paths of a picture as polygons, and where these cross."""

import re
from cmath import phase
from math import degrees, pi

import numpy as np


def points(path):
    """The points of a path, controls included."""
    numbers = [float(x) for x in re.findall(r"-?[0-9.]+", path)]
    return [complex(x, y) for x, y in zip(numbers[::2], numbers[1::2], strict=True)]


def flat(way):
    """The curve as a polygon: straight, parabolas, straight.  No corner is where edges cross."""
    corners = [way[0], way[1]]
    for k in range(1, len(way) - 2, 2):
        a, b, c = way[k : k + 3]
        corners += [
            (1 - t) ** 2 * a + 2 * t * (1 - t) * b + t * t * c for t in (i / 7 for i in range(1, 8))
        ]
    return [*corners, way[-1]] if len(way) > 2 else corners


def crossings(ways):
    """Each crossing of two edges or of an edge with itself: where, and at what acute angle."""
    begin, end = (
        np.array([p for way in ways for p in part(way)])
        for part in (lambda way: way[:-1], lambda way: way[1:])
    )

    def side(p, q, r):
        # Rounded, for segments with a common end do not cross.
        return np.round(((q - p).conj() * (r - p)).imag, 6)

    a, b, c, d = begin[:, None], end[:, None], begin[None], end[None]
    here, there = side(c, d, a), side(c, d, b)
    meet = (side(a, b, c) * side(a, b, d) < 0) & (here * there < 0)
    for i, j in zip(*np.nonzero(np.triu(meet, 2)), strict=True):
        at = begin[i] + (end[i] - begin[i]) * here[i, j] / (here[i, j] - there[i, j])
        angle = abs(phase((end[i] - begin[i]) / (end[j] - begin[j])))
        yield at, degrees(min(angle, pi - angle))
