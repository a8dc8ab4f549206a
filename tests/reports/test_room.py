"""Room in the pictures, measured in the SVG: angles of crossings, and how near edges come.

Each number that is held is the least that was found, a little below it.
"""

from cmath import phase
from itertools import combinations, pairwise
from math import inf, pi
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from allworlds.maps import CombinatorialMap, family
from allworlds.reports.drawing.layout import spread
from allworlds.reports.drawing.svg import picture
from allworlds.reports.parts import Scene
from curves import crossings, flat, points

NS = "{http://www.w3.org/2000/svg}"
SQUARE = 75  # degrees: no crossing is more acute
ROUND_VERTEX, ROUND_CROSSING = 45, 35  # pixels: so near edges may meet, with a pixel's doubt
SMALL_APART, LARGE_APART = 16, 4  # pixels: no nearer come edges of maps up to 4, up to 14 edges


def curves(map_):
    """Each edge as a polygon, and the middles of the vertices."""
    svg = ET.fromstring(ET.tostring(picture(Scene(map_, 0, 0), "p", "a map")))
    ways, ends = [], []
    for path in svg.iter(f"{NS}path"):
        if "data-darts" in path.attrib:
            way = flat(points(path.get("d")))
            ways.append(way)
            ends += [way[0], way[-1]]
    return ways, ends


def apart(ways, ends, crossed):
    """How near two edges come, but for round vertices and crossings."""
    free = [
        np.array(
            [
                p
                for p in way
                if all(abs(p - end) > ROUND_VERTEX for end in ends)
                and all(abs(p - at) > ROUND_CROSSING for at in crossed)
            ]
        )
        for way in ways
    ]
    pairs = combinations([part for part in free if len(part)], 2)
    return min((np.abs(one[:, None] - other).min() for one, other in pairs), default=inf)


def held(map_, least):
    ways, ends = curves(map_)
    met = [*crossings(ways)]
    # Edges that are cut, in two ways each, cross no other.
    assert (len(met) == 0) == (map_.genus == 0 or len(ways) > map_.edge_count)
    assert min((angle for _, angle in met), default=90) >= SQUARE
    assert apart(ways, ends, [at for at, _ in met]) >= least
    return len(met)


@pytest.mark.parametrize(("edges", "seed"), [(9, 0)])
def test_and_those_of_larger_maps(edges, seed):
    assert held(family(f"random:{edges}", holes=0, seed=seed), LARGE_APART) >= 0


def test_the_same_map_is_drawn_the_same_whatever_its_darts_are_called():
    map_ = family("random:6", holes=0, seed=3)
    size = len(map_.sigma)
    names = [(5 * d + 3) % size for d in map_.darts]
    assert sorted(names) == [*map_.darts]
    sigma, alpha = [0] * size, [0] * size
    for d in map_.darts:
        sigma[names[d]], alpha[names[d]] = names[map_.sigma[d]], names[map_.alpha[d]]
    ways, _ = curves(map_)
    others, _ = curves(CombinatorialMap(sigma, alpha))
    lengths, theirs = (
        sorted(sum(abs(b - a) for a, b in pairwise(way)) for way in drawn)
        for drawn in (ways, others)
    )
    assert lengths == pytest.approx(theirs, abs=1)


def test_darts_that_lie_close_together_are_spread_in_their_order():
    close = [complex(10, 0), complex(10, 1), complex(10, 2), complex(-10, 0)]
    leave = spread(0j, close)
    angles = [phase(point) for point in leave]
    gaps = [(b - a) % (2 * pi) for a, b in zip(angles, [*angles[1:], angles[0]], strict=True)]
    assert sum(gaps) == pytest.approx(2 * pi)
    assert min(gaps) > 4 * phase(close[1])
    even = [1 + 0j, 1j, -1 + 0j, -1j]
    assert spread(0j, even) == pytest.approx([0.8 * point for point in even])
