"""How a published S lies in the world, if it is the one before and some more.

An S that has been embedded is remembered; of the next one only what is new is looked at.  Whatever
is not as Algorithm 1 would have it (other names, several vertices at a time, a dart that has
another partner than before) is left to the general way (:mod:`allworlds.kernel.invariants`), which
also says what is wrong.
"""

from __future__ import annotations

from allworlds.kernel.bits import lowest, size
from allworlds.kernel.calls import entry_of
from allworlds.kernel.compiling import inlined, inner


@inner
def remember(judged, published, explored, taken):
    """The S that is embedded by ``judged.to``: every partner in it has it as its partner."""
    judged.known, judged.explored, judged.taken = published.darts, explored, taken
    for d in range(published.darts):
        judged.sigma[d], judged.alpha[d] = (
            entry_of(published.sigma, d),
            entry_of(published.alpha, d),
        )


@inner
def grown(judged, published, world, dart, walked):
    """Whether it is the S that is remembered and more, and embedded too; then it is remembered.

    Else nothing is known of it, and nothing remembered.

    The arguments are as for :func:`allworlds.kernel.invariants.look_at`; if anything is remembered,
    ``judged.to`` is as it was then.
    """
    known, darts, here = judged.known, published.darts, published.here
    judged.known = 0
    if known == 0 or darts < known or darts > world.darts or here < 0 or here >= darts:
        return False
    changed = 0
    for d in range(known):
        if entry_of(published.sigma, d) != judged.sigma[d]:
            return False
        e = entry_of(published.alpha, d)
        if e != judged.alpha[d]:
            if judged.alpha[d] != d:
                return False
            judged.alpha[d] = e
            changed |= 1 << d
    met, entries = 0, changed
    while darts > known + met and entries:
        d = lowest(entries)
        entries &= entries - 1
        if judged.alpha[d] >= known:
            met += _new_vertex(judged, published, world, judged.alpha[d], d)
    if darts != known + met:
        return False
    for d in range(known, darts):
        judged.alpha[d] = entry_of(published.alpha, d)
        changed |= (judged.alpha[d] != d) << d
    judged.explored += size(changed)
    while changed:
        d = lowest(changed)
        changed &= changed - 1
        e, true = judged.alpha[d], judged.to[d]
        if e < 0 or e >= darts or e == d or judged.alpha[e] != d:
            return False
        if judged.to[e] != world.alpha[true] or not walked >> true & 1:
            return False
    if judged.to[here] != dart:
        return False
    judged.known = darts
    return True


@inlined
def _new_vertex(judged, published, world, first, behind):
    """How many darts are at a vertex that is new, and that this dart of it was discovered by.

    They are embedded; more than there are if that is not possible.
    """
    if first >= published.darts:
        return published.darts
    d, true, met = first, world.alpha[judged.to[behind]], 0
    while True:
        if judged.taken >> true & 1:
            return published.darts
        judged.taken |= 1 << true
        judged.to[d] = true
        e = entry_of(published.sigma, d)
        judged.sigma[d] = e
        met += 1
        true = world.sigma[true]
        if e == first:
            break
        # Its darts stand one after the other.
        if e != d + 1 or e >= published.darts:
            return published.darts
        d = e
    return met if true == judged.to[first] else published.darts
