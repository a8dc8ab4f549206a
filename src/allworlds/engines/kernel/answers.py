"""The answer against the truth: whether it is a map, the same map, and the right dart of it.

The twins are :class:`allworlds.maps.combinatorial.CombinatorialMap` and
:mod:`allworlds.judging.laws.case`.
"""

from __future__ import annotations

from numpy import int64

from allworlds.engines.kernel.calls import entry_of
from allworlds.engines.kernel.capabilities import LONG
from allworlds.engines.kernel.compiling import inlined, inner
from allworlds.engines.kernel.embedding import grown, spell_out
from allworlds.engines.kernel.law_numbers import MAP, NO_ESTIMATE, POSE
from allworlds.engines.kernel.records import NONE


@inner
def answer_law(published, world, dart, scratch):
    """The law that the answer breaks (no-estimate, map or pose), or 0.

    Args:
        published: sigma, alpha and ``here``.
        world: the truth.
        dart: the robot's true dart.
        scratch: room.
    """
    size, here = int64(published.darts), int64(published.here)
    fits = size == world.darts and 0 <= here < size
    if fits and _goes_on(published, world, dart, scratch):
        return 0
    spell_out(published)
    if fits and _carries(published, world, dart, scratch):
        return 0
    if here < 0 or here >= size or not _is_map(published, scratch):
        return NO_ESTIMATE
    if fits:
        for other in range(world.darts):
            if _carries(published, world, other, scratch):
                return POSE
    return MAP


@inlined
def _goes_on(published, world, dart, judged):
    """Whether the last published S, whose embedding is known, has become the whole world."""
    return grown(judged, published, world, dart, -1) and judged.explored == world.darts


@inner
def _carries(published, world, dart, scratch):
    """Whether ``here`` going to the dart extends to an isomorphism; then it is a map, too."""
    size = world.darts
    for d in range(size):
        scratch.to[d] = NONE
    scratch.to[published.here] = dart
    scratch.queue[0] = published.here
    known, done = 1, 0
    while done < known:
        x = scratch.queue[done]
        done += 1
        y, true = entry_of(published.sigma, x), world.sigma[scratch.to[x]]
        for _ in range(2):
            if y < 0 or y >= size:
                return False
            if scratch.to[y] == NONE:
                scratch.to[y] = true
                scratch.queue[known] = y
                known += 1
            elif scratch.to[y] != true:
                return False
            y, true = entry_of(published.alpha, x), world.alpha[scratch.to[x]]
    # Onto, because the world is connected; so both are permutations as the world's are.
    return known == size


@inner
def _is_map(published, scratch):
    """Whether it is a map: two permutations, an involution without fixed points, connected."""
    size, sigma, alpha = published.darts, published.sigma, published.alpha
    if size <= 0 or size % 2 or size > LONG:
        return False
    for d in range(size):
        scratch.to[d] = 0
    for d in range(size):
        x, y = entry_of(sigma, d), entry_of(alpha, d)
        if x < 0 or x >= size or y < 0 or y >= size:
            return False
        if scratch.to[x] or y == d or entry_of(alpha, y) != d:
            return False
        scratch.to[x] = 1
    scratch.queue[0] = 0
    scratch.to[0] = 0
    known, done = 1, 0
    while done < known:
        x = scratch.queue[done]
        done += 1
        y = entry_of(sigma, x)
        for _ in range(2):
            if scratch.to[y]:
                scratch.to[y] = 0
                scratch.queue[known] = y
                known += 1
            y = entry_of(alpha, x)
    return known == size
