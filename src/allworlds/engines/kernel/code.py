"""Canonical codes and fingerprints of rooted maps; arrays that keep the first of many runs.

``world`` is an array ``WORLD``, or another one with the same fields.  A canonical order of the
darts begins with the root, and depends on the map alone, not on the numbers of the darts.  The
canonical code of a rooted map is its sigma and alpha, renumbered in this order.
"""

from allworlds.engines.kernel.arrays import NONE
from allworlds.engines.kernel.compiling import inlined, inner

FACTOR, LESS = 0x1E3779B97F4A7C15, (1 << 62) - 1
"""The factor and the mask of fingerprints; a sum of two fingerprints stays below 2^63."""


@inlined
def mixed(code, decision):
    """The fingerprint of a partial map after a decision; ``code`` is the fingerprint before it."""
    code = (code ^ decision) * FACTOR & LESS
    return code ^ code >> 31


@inner
def fingerprint(world, alpha):
    """The fingerprint of the rooted map, in which the darts of each vertex must be consecutive.

    ``alpha`` is the array that holds for each dart the other dart of its edge.

    The twin, Python code with the same results: :func:`allworlds.maps.enumeration.fingerprint`.
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
    """Write the darts in canonical order from the root to ``world.order``.

    The position of each dart in this order is written to ``world.number``.
    """
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
    """Write the canonical code of the map with this root to ``row[start:]``: sigma, then alpha."""
    number(world, root)
    for i in range(world.darts):
        row[start + i] = world.number[world.sigma[world.order[i]]]
        row[start + world.darts + i] = world.number[world.alpha[world.order[i]]]


@inner
def _encode_unrooted(world, row, start):
    """Write the least of the map's canonical codes, one for each root, to ``row[start:]``."""
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
    """Write a run to ``row``: n, the canonical code of the map, the place, and the law's number.

    The last part of the row, the code of the map without a root, is not written.
    """
    row[0] = world.vertices
    encode(world, 0, row, 1)
    row[1 + 2 * world.darts] = world.place
    row[2 + 2 * world.darts] = law


@inner
def blame(world, law, least, row):
    """Keep the present run, which breaks this law, if it is among the first of such runs.

    The kept runs are the rows of ``least``, sorted by number of vertices, code, place and law.  Of
    all runs that break the same law in the same map, with any root, only the first is kept.  The
    present run is written to ``row``, a further row, before it is compared.
    """
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
    """Whether the world's canonical code is less than the code in row ``spot`` of ``kept``.

    If that row is empty, the result is True.  Each number of the code is compared as soon as it is
    computed, because in most cases one of the first numbers differs.
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
    """Insert a row into the ascending rows of ``least``; the greatest row is dropped.

    A row begins with the number of vertices of its map; this number is 0 in an empty row.
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
    """Whether this row is lexicographically less than row ``spot``, or row ``spot`` is empty."""
    if least[spot, 0] == 0:
        return True
    for i in range(len(row)):
        if row[i] != least[spot, i]:
            return row[i] < least[spot, i]
    return False
