"""The directions in which edges leave a point: crossings at a good angle, darts with room.

The points round a vertex or a crossing see it, with nothing between.  So the edges there may be
turned about it, each by more the nearer it comes, and still keep their cyclic order and meet
nowhere else.
"""

from __future__ import annotations

from cmath import exp, phase, rect
from collections.abc import Sequence
from itertools import pairwise
from math import pi, tau

SQUAREST = 0.42 * pi
"""The angle at which two edges cross, at least; wider ones stay as they are."""

STRAIGHT = 0.5
"""How far the straight piece at a crossing reaches, as a part of the shortest of the four."""

EVEN = 0.75
"""The angle between two darts at a vertex, at least, as a part of what it is on the average."""

BEND = pi / 3
"""The largest angle by which a dart is turned for that."""

REACH = 0.8
"""How far the straight beginnings of darts reach, as a part of the shortest of them."""


def straightened(centre: complex, round_it: Sequence[complex]) -> list[complex]:
    """The point towards which each of four pieces leaves a crossing, opposite ones in line.

    Args:
        centre: where the two edges cross.
        round_it: where the four pieces come from, clockwise; the first and the third are of one
            edge.
    """
    rays = [point - centre for point in round_it]
    first, second = (_line(rays[k], rays[k + 2]) for k in (0, 1))
    # The second edge's line is clockwise from that of the first, and by less than a half turn.
    angle = phase(second / first) % pi
    lacks = max(SQUAREST - angle, 0.0) - max(angle - (pi - SQUAREST), 0.0)
    first *= exp(-0.5j * lacks)
    second *= exp(0.5j * lacks)
    reach = STRAIGHT * min(map(abs, rays))
    return [centre + reach * line for line in (first, second, -first, -second)]


def _line(there: complex, back: complex) -> complex:
    """The direction between that of one piece and away from the other, of length 1."""
    line = there / abs(there) - back / abs(back)
    return line / abs(line)


def spread(centre: complex, round_it: Sequence[complex]) -> list[complex]:
    """The point towards which each dart leaves a vertex: evenly enough, and near where it lay.

    Args:
        centre: the vertex.
        round_it: where its darts lead to, clockwise.
    """
    rays = [point - centre for point in round_it]
    reach, count = REACH * min(map(abs, rays)), len(rays)
    first = phase(rays[0])
    angles = [first]
    for before, ray in pairwise(rays):
        angles.append(angles[-1] + phase(ray / before) % tau)
    least = min(b - a for a, b in pairwise([*angles, first + tau]))
    even = [tau * k / count for k in range(count)]
    middle = sum(a - b for a, b in zip(angles, even, strict=True)) / count
    lacks = [b + middle - a for a, b in zip(angles, even, strict=True)]
    part = max(0.0, (EVEN * tau / count - least) / max(tau / count - least, 1e-9))
    part = min(part, BEND / max(*map(abs, lacks), 1e-9))
    return [centre + rect(reach, a + part * lack) for a, lack in zip(angles, lacks, strict=True)]
