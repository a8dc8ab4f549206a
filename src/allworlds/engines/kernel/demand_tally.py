"""The counts of a walk, packed, and the tally of worlds by vertices."""

from __future__ import annotations

from allworlds.engines.kernel.code import (
    encode,
    encode_unrooted,
    is_greater,
    is_less,
    keep_least_of_kind,
)
from allworlds.engines.kernel.compiling import inlined, inner

# One number holds the cost and the counters of a walk, so that a decision saves one number.
COST = 0xFFFFF
ONE_CASE_1 = 1 << 20
ONE_CASE_2 = 1 << 28
ONE_AT_V0 = 1 << 36
ONE_EMPTY_H = 1 << 44
ONE_LOOP = 1 << 52
ONE_PARALLEL = 1 << 53

EDGE, PATH, PICK, NEXT, ENDED, FAILED = range(6)
"""The phases of a walk: before crossing e; before a step of a path; before the choice of e; before
the choice of a hypothesis; ended; failed, so that only the worlds with the failure are left."""

# The columns of the tally, by vertices: worlds, the cost summed and the largest, events summed,
# worlds with a loop and with parallel edges, worlds that break a law, and walks that failed.
(
    WORLDS,
    TRAVERSALS,
    LARGEST,
    CASES_1,
    CASES_2,
    TESTS_AT_V0,
    EMPTY_HS,
    LOOP_EDGE,
    PARALLEL_EDGE,
    BROKEN,
    FAILURES,
) = range(11)
COLUMNS = 11
_FEW = 0xFF


@inlined
def tally(w, s, reached, most_expensive, least, row, listed):
    """Tally one world, and the walk in it."""
    n, cost = s.vertices, s.total & COST
    w.counts[n, WORLDS] += 1
    if s.stage == FAILED:
        w.counts[n, FAILURES] += 1
        _blame(w, s, least, row)
        return
    if cost >= reached[n]:
        _settle(w, s)
        if cost > reached[n] or is_less(w.world, most_expensive, n):
            reached[n] = cost
            _note(w, s, most_expensive[n])
    w.counts[n, TRAVERSALS] += cost
    w.counts[n, LARGEST] = max(w.counts[n, LARGEST], cost)
    w.counts[n, CASES_1] += s.total >> 20 & _FEW
    w.counts[n, CASES_2] += s.total >> 28 & _FEW
    w.counts[n, TESTS_AT_V0] += s.total >> 36 & _FEW
    w.counts[n, EMPTY_HS] += s.total >> 44 & _FEW
    w.counts[n, LOOP_EDGE] += s.total >> 52 & 1
    w.counts[n, PARALLEL_EDGE] += s.total >> 53 & 1
    if cost > w.bound[n]:
        _blame(w, s, least, row)
    if w.worlds <= listed.shape[0]:
        _list(w, s, listed, cost)


@inner
def _settle(w, s):
    """Complete the world from the walk."""
    world = w.world
    world.darts = s.darts
    for dart in range(s.darts):
        end = w.end[dart]
        world.sigma[dart] = dart + 1 if dart + 1 < end else end - w.degree[dart]
        world.alpha[dart] = w.partner[dart]


@inner
def _note(w, s, row):
    """Write the completed world as a row, but for its map's code without a root."""
    row[0] = s.vertices
    encode(w.world, 0, row, 1)


@inner
def _blame(w, s, least, row):
    w.counts[s.vertices, BROKEN] += 1
    _settle(w, s)
    _note(w, s, row)
    if not is_greater(least, row):
        encode_unrooted(w.world, row, 2 + 2 * s.darts)
        keep_least_of_kind(least, row, 2 + 2 * s.darts)


@inner
def _list(w, s, listed, cost):
    place, n = w.worlds - 1, s.vertices
    listed[place, 0], listed[place, 1] = cost, n
    for v in range(n):
        listed[place, 2 + v] = w.degrees[v]
    for dart in range(s.darts):
        listed[place, 2 + n + dart] = w.partner[dart]
