"""Canonical codes and fingerprints of rooted maps; arrays that keep a few of many runs.

``world`` is an array ``WORLD``, or another one with the same fields.  The canonical order of the
darts begins with the root, and depends only on the rooted map, not on the numbers of the darts.
The canonical code of a rooted map is its sigma and alpha after the darts are renumbered in this
order.

Kept runs are rows of numbers, as :class:`allworlds.engines.kernel.arrays.Kept` describes them.
"""

from allworlds.engines.kernel.arrays import NONE
from allworlds.engines.kernel.compiling import inlined, inner

FACTOR, LESS = 0x1E3779B97F4A7C15, (1 << 62) - 1
"""The factor and the mask of fingerprints; a sum of two fingerprints stays below 2^63."""


@inlined
def mixed(code, decision):
    """The fingerprint after one more decision of the enumeration.

    ``code`` is the fingerprint of the decisions before, and ``decision`` is the decision as a
    number.  The fingerprint of a map is that of all its decisions.
    """
    code = (code ^ decision) * FACTOR & LESS
    return code ^ code >> 31


@inner
def fingerprint(world, alpha):
    """The fingerprint of the map of ``world``, rooted at dart 0.

    The darts of each vertex must be consecutive.  ``alpha`` is the array that holds for each dart
    the other dart of its edge; not every kind of ``world`` has a field of this name.  The arrays
    ``world.number`` and ``world.order`` are overwritten.

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
    """Write the darts of the world to ``world.order``, in canonical order from the dart ``root``.

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
    """Write the present run to ``row``, as it stands in ``world``.

    The row gets the number of vertices, the canonical code of the rooted map, the place, and
    ``law``, the number of the broken law, or 0.  The rest of the row, the code of the map without a
    root, is not written.
    """
    row[0] = world.vertices
    encode(world, 0, row, 1)
    row[1 + 2 * world.darts] = world.place
    row[2 + 2 * world.darts] = law


@inner
def blame(world, law, least, row):
    """Write the present run, which breaks a law, to ``least`` if it is one of the first such runs.

    ``law`` is the number of the law.  ``least`` has one row for each run that is kept, ascending by
    number of vertices, canonical code, place and law.  If there are more runs than rows, the first
    ones are kept.  Runs that break the same law in the same map count as one, whatever their roots
    and places are: only the first of them is kept.  ``row`` is room for the present run as a row,
    to compare it with the rows of ``least``.
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
    """Insert ``row`` into the ascending rows of ``least``.

    The greatest of all these rows, which may be ``row`` itself, is dropped.  A row begins with the
    number of vertices of its map; this number is 0 in an empty row, and empty rows come last.
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
