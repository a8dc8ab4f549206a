"""I-1, I-2 and the variant of Section V, checked whenever an explorer publishes S and U.

The published S is embedded into the world by its own data: its ``here`` goes to the
robot's true dart, and all else follows along sigma and the explored edges.  The twin is
:mod:`allworlds.judging.laws.invariants`.
"""

from __future__ import annotations

from allworlds.engines.kernel.calls import entry_of
from allworlds.engines.kernel.compiling import inlined, inner
from allworlds.engines.kernel.embedding import grown, remember, spell_out
from allworlds.engines.kernel.law_numbers import INVARIANT_1, INVARIANT_2, VARIANT
from allworlds.engines.kernel.records import NONE


@inner
def look_at(judged, published, world, dart, walked):
    """Note which of the laws this checkpoint breaks.

    Args:
        judged: the notes.
        published: sigma, alpha and the robot's dart; ``alpha[d] == d`` is an open dart.
        world: the truth.
        dart: the robot's true dart.
        walked: the darts of the edges walked so far, as a set.
    """
    if grown(judged, published, world, dart, walked):
        explored = judged.explored
    else:
        spell_out(published)
        explored = _look_anew(judged, published, world, dart, walked)
    t = world.darts // 2 - (explored + 1) // 2
    if judged.shown and t >= judged.t:
        judged.broken |= 1 << VARIANT
    judged.t, judged.shown = t, 1


@inner
def _look_anew(judged, published, world, dart, walked):
    """The number of explored darts; I-1 and I-2 are checked without an earlier S."""
    darts, alpha = published.darts, published.alpha
    explored, mutual = 0, True
    for d in range(darts):
        e = entry_of(alpha, d)
        if e != d:
            explored += 1
            if 0 <= e < darts and entry_of(alpha, e) == e:
                judged.broken |= 1 << INVARIANT_2
                mutual = False
    if not judged.broken >> INVARIANT_1 & 1:
        taken = _explored_part(judged, published, world, dart, walked)
        if taken == 0:
            judged.broken |= 1 << INVARIANT_1
        elif mutual:
            remember(judged, published, explored, taken)
    return explored


@inlined
def variant_at_the_end(judged):
    """Check that the variant has ended at 0, if S was ever published."""
    if judged.shown and judged.t != 0:
        judged.broken |= 1 << VARIANT


@inlined
def _explored_part(judged, published, world, dart, walked):
    """The darts of the world that are in S, as a set.

    The set is empty if S is no part of the world, in its cyclic orders, or an edge of S has not
    been walked.
    """
    size, here = published.darts, published.here
    if here < 0 or here >= size or size > world.darts:
        return 0
    sigma, alpha = published.sigma, published.alpha
    # A dart in U that another dart claims as its partner (the fault of I-2) goes with that one.
    for d in range(size):
        judged.to[d] = NONE
        judged.claim[d] = d
    for d in range(size):
        e = entry_of(alpha, d)
        if e != d and 0 <= e < size and entry_of(alpha, e) == e:
            judged.claim[e] = d
    taken = 1 << dart
    judged.to[here] = dart
    judged.queue[0] = here
    known, done = 1, 0
    while done < known:
        x = judged.queue[done]
        done += 1
        y, true = entry_of(sigma, x), world.sigma[judged.to[x]]
        for _ in range(2):
            if y < 0 or y >= size:
                return 0
            if judged.to[y] == NONE and not taken >> true & 1:
                judged.to[y] = true
                taken |= 1 << true
                judged.queue[known] = y
                known += 1
            elif judged.to[y] != true:
                return 0
            y = entry_of(alpha, x)
            if y == x:
                y = judged.claim[x]
            if y == x:
                break
            true = world.alpha[judged.to[x]]
    if known < size:
        return 0
    for d in range(size):
        if entry_of(alpha, d) != d and not walked >> judged.to[d] & 1:
            return 0
    return taken
