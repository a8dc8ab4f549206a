"""The embedding of a published S in the world, if S extends the one before.

An embedded S is remembered; of the next one only the new part is checked.  An S that Algorithm 1
would not publish (other names, several vertices at a time, a dart with another partner than
before) is left to the general way (:mod:`allworlds.engines.kernel.invariants`), which also names
the broken law.
"""

from __future__ import annotations

from numpy import int64

from allworlds.engines.kernel.bits import lowest, size
from allworlds.engines.kernel.calls import (
    address_of,
    byte_of,
    copy_bytes,
    entry_of,
    moved,
    narrow,
    unlike,
    widen,
)
from allworlds.engines.kernel.compiling import inlined, inner
from allworlds.engines.kernel.names import LANES


@inner
def spell_out(published):
    """Write the integers of a published S, if it was published as bytes."""
    if published.bytes:
        darts = int64(published.darts)
        for dart in range(0, darts, LANES):
            widen(published.sigma + 4 * dart, published.bytes + dart)
            widen(published.alpha + 4 * dart, published.bytes + darts + dart)


@inlined
def _bytes_of(judged, published):
    """The address of its sigma as bytes, with alpha behind it; 0 if that is not possible."""
    if published.bytes:
        return published.bytes
    darts, odd, sigma = int64(published.darts), int64(0), address_of(judged.bytes)
    for dart in range(0, darts, LANES):
        odd |= narrow(sigma + dart, published.sigma + 4 * dart, darts - dart)
    for dart in range(0, darts, LANES):
        odd |= narrow(sigma + darts + dart, published.alpha + 4 * dart, darts - dart)
    return int64(0) if odd else sigma


@inner
def remember(judged, published, explored, taken):
    """Remember the S that is embedded by ``judged.to``; all its partners are mutual.

    Its integers have been written.
    """
    judged.known, judged.explored, judged.taken = published.darts, explored, taken
    for d in range(published.darts):
        judged.sigma[d], judged.alpha[d] = (
            entry_of(published.sigma, d),
            entry_of(published.alpha, d),
        )


@inner
def grown(judged, published, world, dart, walked):
    """Whether it extends the remembered S and is embedded, too; then it is remembered.

    Else it is unknown whether it is embedded, and no S is remembered.

    The arguments are as for :func:`allworlds.engines.kernel.invariants.look_at`; if anything is
    remembered,
    ``judged.to`` is as it was then.
    """
    known, darts, here = judged.known, int64(published.darts), int64(published.here)
    judged.known = 0
    if known == 0 or darts < known or darts > world.darts or here < 0 or here >= darts:
        return False
    sigma = _bytes_of(judged, published)
    if sigma == 0:
        return False
    alpha, before = sigma + darts, (1 << known) - 1
    changed = unlike(alpha, address_of(judged.alpha)) & before
    if unlike(sigma, address_of(judged.sigma)) & before or changed & moved(
        address_of(judged.alpha)
    ):
        return False
    met, entries = 0, changed
    while darts > known + met and entries:
        d = lowest(entries)
        entries &= entries - 1
        if byte_of(alpha, d) >= known:
            met += _new_vertex(judged, sigma, darts, world, byte_of(alpha, d), d)
    if darts != known + met:
        return False
    changed |= moved(alpha) & ((1 << darts) - 1) & ~before
    judged.explored += size(changed)
    copy_bytes(address_of(judged.sigma), sigma)
    copy_bytes(address_of(judged.alpha), alpha)
    while changed:
        d = lowest(changed)
        changed &= changed - 1
        e, true = byte_of(alpha, d), judged.to[d]
        if e >= darts or byte_of(alpha, e) != d:
            return False
        if judged.to[e] != world.alpha[true] or not walked >> true & 1:
            return False
    if judged.to[here] != dart:
        return False
    judged.known = darts
    return True


@inlined
def _new_vertex(judged, sigma, darts, world, first, behind):
    """The number of darts of a new vertex, which was discovered by this dart.

    The darts are embedded; if that is not possible, the number is too large on purpose.
    """
    if first >= darts:
        return darts
    d, true, met = first, world.alpha[judged.to[behind]], 0
    while True:
        if judged.taken >> true & 1:
            return darts
        judged.taken |= 1 << true
        judged.to[d] = true
        met += 1
        true = world.sigma[true]
        e = byte_of(sigma, d)
        if e == first:
            break
        # Its darts stand one after the other.
        if e != d + 1 or e >= darts:
            return darts
        d = e
    return met if true == judged.to[first] else darts
