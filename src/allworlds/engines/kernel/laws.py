"""The laws, by number: published maps against the world, the answer, and the folded log.

A published S is embedded into the world: its ``here`` goes to the robot's true dart, and all else
follows along sigma and the explored edges.  An embedded S is remembered; of the next one only the
new part is checked, or if Algorithm 1 would not publish it, it is embedded anew, which also names
the broken law.

For the folded log a tree of fresh nodes is walked as the log says; on each arrival at v0 the node
is merged with v0, aligned by the bearing, and merging goes on where one dart would lead to two
places.  Each node is a copy of a vertex of the true map, and its darts have that vertex's names.
Dart d of node v is the number ``v << NODE | d``.

The twins are :mod:`allworlds.judging.laws` and
:class:`allworlds.maps.combinatorial.CombinatorialMap`.
"""

from __future__ import annotations

from numpy import int64

from allworlds.engines.kernel.capabilities import LONG
from allworlds.engines.kernel.compiling import inlined, inner
from allworlds.engines.kernel.instructions import (
    address_of,
    byte_of,
    copy_bytes,
    entry_of,
    lowest,
    moved,
    narrow_map,
    put_entry,
    size as size_of,
    unlike,
)
from allworlds.engines.kernel.records import DARTS, NONE
from allworlds.judging.laws.law_table import PRECEDENCE

LAWS = ("", *PRECEDENCE)
"""The laws by their numbers, in their order of precedence; 0: none is broken."""

ILLEGAL_ACTION = LAWS.index("illegal-action")
NO_ESTIMATE = LAWS.index("no-estimate")
BUDGET = LAWS.index("budget")
POSE = LAWS.index("pose")
MAP = LAWS.index("map")
INVARIANT_1 = LAWS.index("invariant-1")
INVARIANT_2 = LAWS.index("invariant-2")
VARIANT = LAWS.index("variant")
FOLDING = LAWS.index("folding")
BOUND = LAWS.index("bound")

NODE = DARTS.bit_length() - 1
"""The bits of a dart's number within its node."""


@inner
def look_at(judged, published, world, dart, walked):
    """Note which of the laws this checkpoint breaks; ``alpha[d] == d`` is an open dart of S.

    The robot is truly at the dart, and the darts of the edges walked so far are a set.
    """
    if _grown(judged, published, world, dart, walked):
        explored = judged.explored
    else:
        _spell_out(published)
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
            judged.known, judged.explored, judged.taken = darts, explored, taken
            for d in range(darts):
                judged.sigma[d], judged.alpha[d] = entry_of(published.sigma, d), entry_of(alpha, d)
    return explored


@inner
def answer_law(published, world, dart, judged):
    """The law that the answer breaks (no-estimate, map or pose), or 0."""
    size, here = int64(published.darts), int64(published.here)
    fits = size == world.darts and 0 <= here < size
    if fits and _grown(judged, published, world, dart, -1) and judged.explored == size:
        return 0  # the last published S has become the whole world
    _spell_out(published)
    if here < 0 or here >= size or not _is_map(published, judged):
        return NO_ESTIMATE
    if fits:
        if _explored_part(judged, published, world, dart, -1):
            return 0
        for other in range(world.darts):
            if _explored_part(judged, published, world, other, -1):
                return POSE
    return MAP


@inner
def _spell_out(published):
    """Write the integers of a published S, if it was published as bytes."""
    if published.bytes:
        darts = int64(published.darts)
        for d in range(darts):
            put_entry(published.sigma, d, byte_of(published.bytes, d))
            put_entry(published.alpha, d, byte_of(published.bytes, darts + d))


@inlined
def _bytes_of(judged, published):
    """The address of its sigma as bytes, with alpha behind it; 0 if that is not possible."""
    if published.bytes:
        return published.bytes
    sigma = address_of(judged.bytes)
    odd = narrow_map(sigma, published.sigma, published.alpha, int64(published.darts))
    return int64(0) if odd else sigma


@inner
def _grown(judged, published, world, dart, walked):
    """Whether it extends the remembered S and is embedded, too; then it is remembered.

    Else it is unknown whether it is embedded, and no S is remembered.

    If anything is remembered, ``judged.to`` is as it was then.
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
    judged.explored += size_of(changed)
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


@inner
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


@inner
def _is_map(published, judged):
    """Whether it is a map: two permutations, an involution without fixed points, connected."""
    size, sigma, alpha = published.darts, published.sigma, published.alpha
    if size <= 0 or size % 2 or size > LONG:
        return False
    for d in range(size):
        judged.to[d] = 0
    for d in range(size):
        x, y = entry_of(sigma, d), entry_of(alpha, d)
        if x < 0 or x >= size or y < 0 or y >= size:
            return False
        if judged.to[x] or y == d or entry_of(alpha, y) != d:
            return False
        judged.to[x] = 1
    judged.queue[0] = 0
    judged.to[0] = 0
    known, done = 1, 0
    while done < known:
        x = judged.queue[done]
        done += 1
        y = entry_of(sigma, x)
        for _ in range(2):
            if judged.to[y]:
                judged.to[y] = 0
                judged.queue[known] = y
                known += 1
            y = entry_of(alpha, x)
    return known == size


@inner
def folds(world, log, fold):
    """Whether no dart of the folded log is open; the log is that of a directional lighthouse."""
    fold.parent[0] = fold.linked[0] = fold.node = 0
    fold.open = world.degree[0]
    fold.nodes = 1
    for step in range(log.cost):
        _step(world, fold, log.arrived[step])
        if fold.open == 0:
            return True
    return False


@inlined
def _step(world, fold, entered):
    """Fold one step more: the robot arrives by the dart, along an edge that has been decided.

    There must be an open dart; else all is known, and a log is not folded any further.
    """
    leaving, at = world.alpha[entered], fold.node
    if fold.linked[at] >> leaving & 1:
        to = _root(fold, fold.link[at << NODE | leaving])
        if to and world.marks[entered]:
            _merge(world, fold, to, 0)
            to = 0
    elif not world.marks[entered]:
        to = fold.nodes
        fold.nodes += 1
        fold.parent[to], fold.linked[to] = to, 0
        fold.open += world.degree[entered]
        _lead(fold, at, leaving, to, entered)
    else:
        to = 0
        if fold.linked[0] >> entered & 1:
            fold.link[at << NODE | leaving] = 0
            fold.linked[at] |= 1 << leaving
            fold.open -= 1
            _merge(world, fold, at, fold.link[entered])
        else:
            _lead(fold, at, leaving, 0, entered)
    fold.node = to


@inlined
def _lead(fold, v, leaving, w, entered):
    """Join two darts whose other ends were unknown."""
    fold.link[v << NODE | leaving], fold.link[w << NODE | entered] = w, v
    fold.linked[v] |= 1 << leaving
    fold.linked[w] |= 1 << entered
    fold.open -= 2


@inlined
def _root(fold, v):
    """The node that this one has become a part of."""
    while fold.parent[v] != v:
        v = fold.parent[v]
    return v


@inner
def _merge(world, fold, v, w):
    """Merge two nodes, and the nodes behind equal darts."""
    waiting = 0
    while True:
        v, w = _root(fold, v), _root(fold, w)
        if v < w:
            # The older node stays, so that v0 is always a root.
            v, w = w, v
        if v != w:
            fold.parent[v] = w
            both = fold.linked[v] & fold.linked[w]
            more = fold.linked[v] & ~both
            fold.open -= world.degree[lowest(fold.linked[v])] - size_of(both)
            fold.linked[w] |= more
            while more:
                dart = lowest(more)
                more &= more - 1
                fold.link[w << NODE | dart] = fold.link[v << NODE | dart]
            while both:
                dart = lowest(both)
                both &= both - 1
                fold.todo[2 * waiting] = fold.link[v << NODE | dart]
                fold.todo[2 * waiting + 1] = fold.link[w << NODE | dart]
                waiting += 1
        if waiting == 0:
            return
        waiting -= 1
        v, w = fold.todo[2 * waiting], fold.todo[2 * waiting + 1]
