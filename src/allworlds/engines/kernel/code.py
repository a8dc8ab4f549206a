"""Canonical codes and fingerprints of rooted maps, and lists of the least of them."""

from allworlds.engines.kernel.arrays import NONE
from allworlds.engines.kernel.compiling import inlined, inner

FACTOR, LESS = 0x1E3779B97F4A7C15, (1 << 62) - 1
"""The factor and the mask of fingerprints; a sum of two fingerprints stays below 2^63."""


@inlined
def mixed(code, decision):
    """The code of a history after one more decision."""
    code = (code ^ decision) * FACTOR & LESS
    return code ^ code >> 31


@inner
def fingerprint(world, alpha):
    """The fingerprint of the rooted map, if the darts of each vertex are consecutive.

    The twin is :func:`allworlds.maps.enumeration.fingerprint`.
    """
    number, order = world.number, world.order
    code = met = known = taken = dart = 0
    while True:
        v = world.owner[dart]
        if not met >> v & 1:
            met |= 1 << v
            degree, end = world.degree[dart], world.end[dart]
            code = mixed(code, 0 - degree)
            for x in range(dart, end):
                number[x], order[known] = known, x
                known += 1
            for x in range(end - degree, dart):
                number[x], order[known] = known, x
                known += 1
        elif number[dart] >= taken:
            code = mixed(code, number[dart])
        if taken == known:
            return code
        dart = alpha[order[taken]]
        taken += 1


@inner
def number(world, root):
    """Number the darts in canonical order from the root, in ``world.order``."""
    for dart in range(world.darts):
        world.number[dart] = NONE
    world.number[root] = 0
    world.order[0] = root
    known, taken = 1, 0
    while taken < known:
        x = world.order[taken]
        taken += 1
        for y in (world.sigma[x], world.alpha[x]):
            if world.number[y] == NONE:
                world.number[y] = known
                world.order[known] = y
                known += 1


@inlined
def encode(world, root, row, start):
    """Write the canonical code, sigma then alpha, to ``row[start:]``."""
    number(world, root)
    for i in range(world.darts):
        row[start + i] = world.number[world.sigma[world.order[i]]]
        row[start + world.darts + i] = world.number[world.alpha[world.order[i]]]


@inner
def _encode_unrooted(world, row, start):
    """Write the least of the canonical codes from all roots to ``row[start:]``."""
    encode(world, 0, row, start)
    darts = world.darts
    for root in range(1, darts):
        number(world, root)
        smaller = False
        for i in range(2 * darts):
            end = world.sigma[world.order[i]] if i < darts else world.alpha[world.order[i - darts]]
            value = world.number[end]
            if not smaller and value > row[start + i]:
                break
            smaller = smaller or value < row[start + i]
            if smaller:
                row[start + i] = value


@inner
def note(world, law, row):
    """Write a run as a row, except for the unrooted code of its map."""
    row[0] = world.vertices
    encode(world, 0, row, 1)
    row[1 + 2 * world.darts] = world.place
    row[2 + 2 * world.darts] = law


@inner
def blame(world, law, least, row):
    """Keep a run that breaks a law if it is among the least; keep one run of each law and map."""
    note(world, law, row)
    if not _before(row, least, least.shape[0] - 1):
        return
    kind = 2 + 2 * world.darts
    _encode_unrooted(world, row, kind + 1)
    for spot in range(least.shape[0]):
        alike = least[spot, 0] != 0
        for i in range(kind, len(row)):
            alike = alike and row[i] == least[spot, i]
        if alike:
            keep_least(least[: spot + 1], row)
            return
    keep_least(least, row)


@inner
def is_less(world, kept, spot):
    """Whether the canonical code of the world is less than the code of a row, or the row is empty.

    The code is not written, because the first difference decides, and is early in most cases.
    """
    if kept[spot, 0] == 0:
        return True
    number, order = world.number, world.order
    number[0] = order[0] = 0
    known, seen = 1, 1
    for i in range(world.darts):
        x = order[i]
        for y in (world.sigma[x], world.alpha[x]):
            if not seen >> y & 1:
                seen |= 1 << y
                number[y], order[known] = known, y
                known += 1
        y = number[world.sigma[x]]
        if y != kept[spot, 1 + i]:
            return y < kept[spot, 1 + i]
    for i in range(world.darts):
        y = number[world.alpha[order[i]]]
        if y != kept[spot, 1 + world.darts + i]:
            return y < kept[spot, 1 + world.darts + i]
    return False


@inner
def keep_least(least, row):
    """Sort a row into the ascending rows of ``least``; the greatest falls out.

    A row begins with its number of vertices; 0 there marks an empty row.
    """
    spot = least.shape[0]
    while spot > 0 and _before(row, least, spot - 1):
        if spot < least.shape[0]:
            for i in range(len(row)):
                least[spot, i] = least[spot - 1, i]
        spot -= 1
    if spot < least.shape[0]:
        for i in range(len(row)):
            least[spot, i] = row[i]


@inlined
def _before(row, least, spot):
    """Whether the row is lexicographically less than the row at this spot, or that row is empty."""
    if least[spot, 0] == 0:
        return True
    for i in range(len(row)):
        if row[i] != least[spot, i]:
            return row[i] < least[spot, i]
    return False
