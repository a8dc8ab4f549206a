"""The worst and the best cost of Algorithm 1 in each world, over every schedule.

In a fixed world S is determined by the set of explored edges, so the robot's knowledge
between two passes is a pair (explored edges, robot's vertex), and the robot stands at v0 or
at the vertex that it has just added, which has one explored edge.  Rejected hypotheses add
up, whatever their order and wherever the robot was before the pass: what the tests of a pass
cost is found once for each set and dart, and only the way to the dart depends on the robot.

On the way every test on every simple path is carried out: a false hypothesis must be
rejected.  A true one walks in the world the path that it walks in S, so it always matches.

Since every choice of dart is tried, it makes no difference which dart of v0 the robot faces:
only the rooted map with the least code among the rootings at v0 is worked on.

Source: Algorithm 1, Section IV.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from numba import njit
from numpy import array, empty, int64, zeros

from allworlds.kernel.bits import lowest
from allworlds.kernel.code import encode, keep_least, rotation
from allworlds.kernel.gluing import VERTICES, advance
from allworlds.kernel.tables import tables

SHORTEST, SIMPLE = range(2)

ROOTED, WORST, BEST, TESTS, WRONG = range(5)
COLUMNS = 5
"""The columns of the outcome by vertices: rooted maps, worst and best cost, tests carried
out in the maps worked on, and false hypotheses that were confirmed."""

_FAR = 1 << 30
_ROOM = 32


@njit(cache=True, nogil=True)
def _joined(adjacent, start, goal, avoiding):
    """Whether a walk in S leads from start to goal without the vertices to be avoided."""
    reached = front = 1 << start
    while front:
        after = 0
        while front:
            after |= adjacent[lowest(front)]
            front &= front - 1
        front = after & ~reached & ~avoiding
        reached |= front
    return reached >> goal & 1


@njit(cache=True, nogil=True)
def _shortest(adjacent, start, length):
    """For each vertex of S the length of a shortest path from start."""
    reached = front = 1 << start
    length[start] = steps = 0
    while front:
        steps += 1
        after = 0
        while front:
            after |= adjacent[lowest(front)]
            front &= front - 1
        front = after & ~reached
        reached |= front
        rest = front
        while rest:
            length[lowest(rest)] = steps
            rest &= rest - 1


@njit(cache=True, nogil=True)
def _longest(adjacent, vertices, start, length, stack, untried):
    """For each vertex of S the length of a longest simple path from start."""
    for v in range(vertices):
        length[v] = 0
    visited = 1 << start
    stack[0] = start
    untried[0] = adjacent[start] & ~visited
    depth = 0
    while depth >= 0:
        if untried[depth]:
            v = lowest(untried[depth])
            untried[depth] &= untried[depth] - 1
            depth += 1
            stack[depth] = v
            visited |= 1 << v
            untried[depth] = adjacent[v] & ~visited
            length[v] = max(length[v], depth)
        else:
            visited ^= 1 << stack[depth]
            depth -= 1


@njit(cache=True, nogil=True)
def _test(world, explored, adjacent, hypothesis, entry, stacks, outcome):
    """Tests a false hypothesis on every simple path in S.

    ``outcome`` gets the least and the greatest number of steps until a mismatch, how many
    different tests there are, and is added the number of those that match to the end.
    """
    alpha, owner, first, degree, edge_of = world
    at, robot, turned, visited = stacks
    outcome[0], outcome[1] = _FAR, 0
    at[0], robot[0], turned[0], visited[0] = hypothesis, entry, 0, 1 << owner[hypothesis]
    depth = 0
    while depth >= 0:
        v = owner[at[depth]]
        turn = turned[depth]
        if turn == degree[v]:
            depth -= 1
            continue
        turned[depth] += 1
        p = first[v] + (at[depth] - first[v] + turn) % degree[v]
        arrives = alpha[p]
        w = owner[arrives]
        if not explored >> edge_of[p] & 1 or visited[depth] >> w & 1:
            continue
        if w and not _joined(adjacent, w, 0, visited[depth]):
            continue
        u = owner[robot[depth]]
        z = alpha[first[u] + (robot[depth] - first[u] + turn) % degree[u]]
        if w == 0:
            matches = z == arrives
        else:
            matches = owner[z] != 0 and degree[owner[z]] == degree[w]
        if matches and w:
            depth += 1
            at[depth], robot[depth], turned[depth] = arrives, z, 0
            visited[depth] = visited[depth - 1] | 1 << w
            continue
        outcome[2] += 1
        if matches:
            outcome[3] += 1
        outcome[0] = min(outcome[0], depth + 1)
        outcome[1] = max(outcome[1], depth + 1)


@njit(cache=True, nogil=True)
def solve(edges, vertices, alpha, degree, transit, buffers, result):
    """The worst and the best cost in the world from vertex 0, in ``result[WORST:]``.

    ``result[TESTS]`` and ``result[WRONG]`` are added to.  The darts of a vertex are
    consecutive and clockwise.
    """
    worst, best, reached, owner, first, edge_of, adjacent, near, far, way, stacks, outcome = buffers
    darts = 2 * edges
    dart = edge = 0
    for v in range(vertices):
        first[v] = dart
        for _ in range(degree[v]):
            owner[dart] = v
            if dart < alpha[dart]:
                edge_of[dart] = edge_of[alpha[dart]] = edge
                edge += 1
            dart += 1
    world = (alpha, owner, first, degree, edge_of)
    every = (1 << edges) - 1
    # Which sets can be reached: ascending, since passes add edges.
    for explored in range(every + 1):
        reached[explored] = 0
    reached[0] = 1
    for explored in range(every):
        known = reached[explored]
        if known:
            for d in range(darts):
                if known >> owner[d] & 1 and not explored >> edge_of[d] & 1:
                    reached[explored | 1 << edge_of[d]] = known | 1 << owner[alpha[d]]
    outcome[2] = outcome[3] = 0
    for v in range(vertices):
        worst[every, v] = best[every, v] = 0
    for explored in range(every - 1, -1, -1):
        known = reached[explored]
        if not known:
            continue
        for v in range(vertices):
            adjacent[v] = 0
            worst[explored, v] = 0
            best[explored, v] = _FAR
        for d in range(darts):
            if explored >> edge_of[d] & 1 and owner[d] != owner[alpha[d]]:
                adjacent[owner[d]] |= 1 << owner[alpha[d]]
        _shortest(adjacent, 0, near)
        _longest(adjacent, vertices, 0, far, stacks[0], stacks[1])
        # The dearest and the cheapest way to go on from each dart, but for the transit.
        for e in range(darts):
            way[e, 0] = -1
            if not known >> owner[e] & 1 or explored >> edge_of[e] & 1:
                continue
            entry = alpha[e]
            u = owner[entry]
            after = explored | 1 << edge_of[e]
            most = least = 0
            if u:
                for h in range(darts):
                    if (
                        h == e
                        or h == entry
                        or degree[owner[h]] != degree[u]
                        or owner[h] == 0
                        or not known >> owner[h] & 1
                        or explored >> edge_of[h] & 1
                    ):
                        continue
                    _test(world, explored, adjacent, h, entry, stacks, outcome)
                    most += 2 * outcome[1]
                    least += 2 * outcome[0]
            arrives = u
            if known >> u & 1:
                # The true hypothesis: last at worst, first at best.
                most += far[u]
                least = near[u]
                arrives = 0
            way[e, 0] = 1 + most + worst[after, arrives]
            way[e, 1] = 1 + least + best[after, arrives]
        for v in range(vertices):
            if not known >> v & 1 or (v and adjacent[v] & (adjacent[v] - 1)):
                continue
            if v:
                _shortest(adjacent, v, near)
                if transit == SIMPLE:
                    _longest(adjacent, vertices, v, far, stacks[0], stacks[1])
            for e in range(darts):
                if way[e, 0] >= 0:
                    u = owner[e]
                    longest = far[u] if transit == SIMPLE else near[u]
                    worst[explored, v] = max(worst[explored, v], longest + way[e, 0])
                    best[explored, v] = min(best[explored, v], near[u] + way[e, 1])
    result[WORST], result[BEST] = worst[0, 0], best[0, 0]
    result[TESTS] += outcome[2]
    result[WRONG] += outcome[3]


@njit(cache=True, nogil=True)
def buffers_for(edges):
    """The room that ``solve`` works in, for maps with so many edges."""
    states = 1 << edges
    return (
        empty((states, edges + 1), int64),
        empty((states, edges + 1), int64),
        empty(states, int64),
        empty(_ROOM, int64),
        empty(_ROOM, int64),
        empty(_ROOM, int64),
        empty(_ROOM, int64),
        empty(_ROOM, int64),
        empty(_ROOM, int64),
        empty((_ROOM, 2), int64),
        (empty(_ROOM, int64), empty(_ROOM, int64), empty(_ROOM, int64), empty(_ROOM, int64)),
        zeros(4, int64),
    )


@njit(cache=True, nogil=True)
def _take(edges, vertices, alpha, degree, transit, buffers, sigma, result, counts, rows):
    """Solve a world, unless another rooting at v0 has a smaller code; keep the dearest."""
    darts = 2 * edges
    code, other = empty(2 * darts, int64), empty(2 * darts, int64)
    counts[vertices, ROOTED] += 1
    rotation(vertices, degree, sigma)
    encode(darts, sigma, alpha, 0, code)
    for root in range(1, degree[0]):
        encode(darts, sigma, alpha, root, other)
        for i in range(2 * darts):
            if other[i] != code[i]:
                if other[i] < code[i]:
                    return
                break
    result[TESTS] = result[WRONG] = 0
    solve(edges, vertices, alpha, degree, transit, buffers, result)
    counts[vertices, TESTS] += result[TESTS]
    counts[vertices, WRONG] += result[WRONG]
    counts[vertices, BEST] = max(counts[vertices, BEST], result[BEST])
    dearest = counts[vertices, WORST]
    if result[WORST] > dearest or rows[vertices, 0, 0] == 0:
        counts[vertices, WORST] = result[WORST]
        rows[vertices, 0, 0] = 0
    elif result[WORST] < dearest:
        return
    row = empty(1 + 2 * darts, int64)
    row[0] = vertices
    row[1:] = code
    keep_least(rows[vertices], row)


@njit(cache=True, nogil=True)
def search(edges, limit, prefix, viable, transit, halt, counts, rows):
    """Every map of the class ``maps`` whose gluing begins with ``prefix``.

    Args:
        edges: m.
        limit: the largest number of vertices.
        prefix: the first decisions.
        viable: the gluing rule.
        transit: SHORTEST or SIMPLE.
        halt: ``halt[0]`` is not 0 once the work is to be given up.
        counts: by vertices; sums are added to, maxima raised.
        rows: ``rows[vertices, 0]``: vertices, then the least code of a world that attains
            the worst cost; 0 for none yet.
    """
    darts = 2 * edges
    alpha, degree = empty(darts, int64), zeros(edges + 2, int64)
    sigma, result = empty(darts, int64), zeros(COLUMNS, int64)
    decision, place = zeros(darts + 1, int64), zeros(darts + 1, int64)
    state = zeros(3, int64)
    buffers = buffers_for(edges)
    alpha[:] = -1
    while not halt[0] and advance(
        edges, limit, prefix, viable, alpha, degree, decision, place, state
    ):
        _take(edges, state[VERTICES], alpha, degree, transit, buffers, sigma, result, counts, rows)


@njit(cache=True, nogil=True)
def take(edges, vertices, alpha, degree, transit, counts, rows):
    """One map, as :func:`search` takes each of its own."""
    sigma, result = empty(2 * edges, int64), zeros(COLUMNS, int64)
    _take(edges, vertices, alpha, degree, transit, buffers_for(edges), sigma, result, counts, rows)


@dataclass(frozen=True, slots=True)
class Dearest:
    """What every schedule can cost in the maps of one size.

    Attributes:
        vertices: n.
        rooted: rooted maps.
        worst: the largest cost of a schedule.
        best: the largest, over the worlds, of the cost of the cheapest schedule.
        tests: different tests, on every simple path, in the worlds worked on.
        wrong: how many of them confirmed a false hypothesis.
        sigma, alpha: the least code of a world that attains the worst cost.
    """

    vertices: int
    rooted: int
    worst: int
    best: int
    tests: int
    wrong: int
    sigma: tuple[int, ...]
    alpha: tuple[int, ...]


def dearest_of_unit(
    edges: int, limit: int, prefix: Sequence[int], transit: str, halt: Any
) -> list[Dearest]:
    """Every map of the class ``maps`` whose gluing begins with ``prefix``.

    Args:
        edges: m.
        limit: the largest number of vertices.
        prefix: the first decisions, at least one.
        transit: ``shortest`` or ``simple``.
        halt: an array; once its entry 0 is not 0 the work is given up, and means nothing.
    """
    counts, rows = _outcome(edges)
    viable = tables(edges, 0).viable
    search(edges, limit, array(prefix, int64), viable, _TRANSITS[transit], halt, counts, rows)
    return _dearest(edges, counts, rows)


def dearest_of_maps(
    edges: int, maps: Iterable[tuple[Sequence[int], Sequence[int]]], transit: str
) -> list[Dearest]:
    """Every map given by its degrees and partners; all its rootings at v0 must be given."""
    counts, rows = _outcome(edges)
    for degrees, partners in maps:
        alpha, degree = array(partners, int64), array(degrees, int64)
        take(edges, len(degrees), alpha, degree, _TRANSITS[transit], counts, rows)
    return _dearest(edges, counts, rows)


_TRANSITS = {"shortest": SHORTEST, "simple": SIMPLE}


def _outcome(edges: int) -> tuple[Any, Any]:
    return zeros((edges + 2, COLUMNS), int64), zeros((edges + 2, 1, 1 + 4 * edges), int64)


def _dearest(edges: int, counts: Any, rows: Any) -> list[Dearest]:
    found = []
    for n, (rooted, worst, best, tests, wrong) in enumerate(counts.tolist()):
        code = rows[n, 0].tolist()
        if rooted:
            sigma, alpha = code[1 : 1 + 2 * edges], code[1 + 2 * edges :]
            has_world = code[0] > 0
            found.append(
                Dearest(
                    n,
                    rooted,
                    worst,
                    best,
                    tests,
                    wrong,
                    tuple(sigma) if has_world else (),
                    tuple(alpha) if has_world else (),
                )
            )
    return found
