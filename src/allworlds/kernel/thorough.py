"""Every finished map, one after the other: Algorithm 1 walked in it, the walk judged.

Nothing is shared with the demand-driven walk but the canonical code and the names of the
counts: no bit masks, no packed numbers, no decision while the robot walks, and each path is
searched for anew.  What the robot has done is only a log of motions and percepts and the S
that it has shown after each pass; the judge walks the log again, from the start.

Laws: the log is true; the final S is the map, pose included; I-1, I-2 and the variant at
every checkpoint; the folded log has no open dart; the bound.
Source: Algorithm 1, Sections IV to VI.
"""

from __future__ import annotations

from numba import njit
from numpy import empty, int64, zeros

from allworlds.kernel.code import encode, keep_least, rotation
from allworlds.kernel.gluing import VERTICES, advance
from allworlds.kernel.names import (
    AT_V0,
    BROKEN,
    CASE_1,
    CASE_2,
    COLUMNS,
    EMPTY_H,
    FAILED,
    FIFO,
    LARGEST,
    LIFO,
    LOOP_EDGE,
    PARALLEL_EDGE,
    TRAVERSALS,
    WORLDS,
)

UNMARKED = -1


# The robot.  A partial map is a tuple: alpha (-1: open), vertex and expected percept of each
# dart, first dart and degree of each vertex, and the sizes: darts, vertices.


@njit(cache=True, nogil=True)
def _lengths(s, goal, length, queue):
    """For each vertex of S the length of a shortest walk to the goal."""
    alpha, owner, _, _, first, degree, _ = s
    length[:] = -1
    length[goal] = 0
    queue[0] = goal
    known = 1
    taken = 0
    while taken < known:
        v = queue[taken]
        taken += 1
        for dart in range(first[v], first[v] + degree[v]):
            if alpha[dart] >= 0 and length[owner[alpha[dart]]] < 0:
                length[owner[alpha[dart]]] = length[v] + 1
                queue[known] = owner[alpha[dart]]
                known += 1


@njit(cache=True, nogil=True)
def _shortest(s, start, goal, length, queue, path):
    """The darts of the first shortest path, in ``path``; their number."""
    alpha, owner, _, _, first, _, _ = s
    _lengths(s, goal, length, queue)
    steps = 0
    v = start
    while v != goal:
        dart = first[v]
        while alpha[dart] < 0 or length[owner[alpha[dart]]] != length[v] - 1:
            dart += 1
        path[steps] = dart
        steps += 1
        v = owner[alpha[dart]]
    return steps


@njit(cache=True, nogil=True)
def _move(world, state, motion, log):
    """The dart arrived by; motion and percept are logged while there is room."""
    sigma, alpha, sensed, bearing = world
    motions, degrees, bearings, length = log
    dart = state
    for _ in range(motion % sensed[state]):
        dart = sigma[dart]
    arrived = alpha[dart]
    if length[0] < len(motions):
        motions[length[0]] = motion
        degrees[length[0]] = sensed[arrived]
        bearings[length[0]] = bearing[arrived]
    length[0] += 1
    return arrived


@njit(cache=True, nogil=True)
def _explore(world, policy, s, log, shown, events):
    """Algorithm 1 from dart 0; the number of passes, or -1 where S outgrows its room.

    ``shown`` gets, after each pass: steps so far, the robot's dart in S, the darts of S,
    then alpha.  ``s[6]`` counts darts and vertices of S.
    """
    _, _, sensed, bearing = world
    alpha, owner, expected_degree, expected_bearing, first, degree, sizes = s
    length, queue = empty(len(first), int64), empty(len(first), int64)
    path, motions = empty(len(first), int64), empty(len(first), int64)
    room = len(alpha)
    unexplored, hypotheses = empty(room, int64), empty(room, int64)
    state = here = 0
    alpha[:] = -1
    first[0], degree[0] = 0, sensed[0]
    sizes[0], sizes[1] = sensed[0], 1
    known = sensed[0]
    for dart in range(known):
        unexplored[dart] = dart
        owner[dart] = 0
        expected_degree[dart] = known
        expected_bearing[dart] = (bearing[0] - dart) % known
    passes = 0
    while known:
        # Lines 3-5.
        taken = 0
        if policy == LIFO:
            taken = known - 1
        elif policy != FIFO:
            _lengths(s, owner[here], length, queue)
            for i in range(1, known):
                if length[owner[unexplored[i]]] < length[owner[unexplored[taken]]]:
                    taken = i
        e = unexplored[taken]
        for i in range(_shortest(s, owner[here], owner[e], length, queue, path)):
            state = _move(world, state, path[i] - here, log)
            here = alpha[path[i]]
        state = _move(world, state, e - here, log)
        # Line 6.
        seen_degree, seen_bearing = sensed[state], bearing[state]
        alike = 0
        for i in range(known):
            d = unexplored[i]
            if d != e and expected_degree[d] == seen_degree and expected_bearing[d] == seen_bearing:
                hypotheses[alike] = d
                alike += 1
        if alike == 0:
            events[EMPTY_H] += 1
        # Lines 7-17.
        confirmed = -1
        turned = 0
        for i in range(alike):
            at = hypotheses[i]
            steps = _shortest(s, owner[at], 0, length, queue, path)
            if steps == 0:
                events[AT_V0] += 1
            done = 0
            matches = True
            while matches and done < steps:
                motions[done] = path[done] - at
                state = _move(world, state, motions[done] - turned, log)
                turned = 0
                at = alpha[path[done]]
                done += 1
                matches = (
                    sensed[state] == expected_degree[at] and bearing[state] == expected_bearing[at]
                )
            if matches:
                confirmed = hypotheses[i]
                here = at
                break
            events[CASE_2 if done == steps else CASE_1] += 1
            back = 0
            for j in range(done - 1, -1, -1):
                state = _move(world, state, back, log)
                back = -motions[j]
            turned = motions[0]
        # Lines 18-21.
        if confirmed < 0:
            v, confirmed = sizes[1], sizes[0]
            if confirmed + seen_degree > room:
                return -1
            first[v], degree[v] = confirmed, seen_degree
            for dart in range(confirmed, confirmed + seen_degree):
                owner[dart] = v
                expected_degree[dart] = seen_degree
                expected_bearing[dart] = seen_bearing
                unexplored[known] = dart
                known += 1
            sizes[0] += seen_degree
            sizes[1] += 1
            here = confirmed + turned % seen_degree
        alpha[e], alpha[confirmed] = confirmed, e
        left = 0
        for i in range(known):
            if unexplored[i] != e and unexplored[i] != confirmed:
                unexplored[left] = unexplored[i]
                left += 1
        known = left
        if passes == len(shown):
            return -1
        shown[passes, 0], shown[passes, 1], shown[passes, 2] = log[3][0], here, sizes[0]
        shown[passes, 3:] = alpha
        passes += 1
    return passes


# The judge.


@njit(cache=True, nogil=True)
def _embeds(size, s_sigma, s_alpha, here, dart, world, to, back):
    """Whether S lies in the world, one to one, with ``here`` on ``dart``; ``to`` is how."""
    sigma, alpha, _, _ = world
    to[:] = -1
    back[:] = -1
    to[here] = dart
    back[dart] = here
    queue = empty(size, int64)
    queue[0] = here
    known = 1
    taken = 0
    while taken < known:
        x = queue[taken]
        taken += 1
        for way in range(2):
            if way == 0:
                y, true = s_sigma[x], sigma[to[x]]
            else:
                y, true = s_alpha[x], alpha[to[x]]
            if y < 0:
                continue
            if to[y] < 0 and back[true] < 0:
                to[y], back[true] = true, y
                queue[known] = y
                known += 1
            elif to[y] != true:
                return False
    return known == size


@njit(cache=True, nogil=True)
def _judge(world, passes, s, log, shown, trail, fold):
    """Whether every law holds, but for the bound."""
    sigma, alpha, sensed, bearing = world
    motions, degrees, bearings, length = log
    cost, darts = length[0], len(sigma)
    if cost > len(motions) or passes == 0:
        return False
    state = 0
    trail[0] = 0
    for i in range(cost):
        dart = state
        for _ in range(motions[i] % sensed[state]):
            dart = sigma[dart]
        state = alpha[dart]
        trail[i + 1] = state
        if degrees[i] != sensed[state] or bearings[i] != bearing[state]:
            return False
    s_sigma = empty(len(s[0]), int64)
    rotation(s[6][1], s[5], s_sigma)
    to, back = empty(len(s[0]), int64), empty(darts, int64)
    walked = zeros(darts, int64)
    step = 0
    edges = 0
    for i in range(passes):
        steps, here, size = shown[i, 0], shown[i, 1], shown[i, 2]
        s_alpha = shown[i, 3:]
        while step < steps:
            step += 1
            walked[trail[step]] = walked[alpha[trail[step]]] = 1
        if not _embeds(size, s_sigma, s_alpha, here, trail[steps], world, to, back):
            return False
        explored = 0
        for d in range(size):
            if s_alpha[d] >= 0:
                # I-1: its edge has been walked.  I-2: its partner is not in U.
                if not walked[to[d]] or s_alpha[s_alpha[d]] != d:
                    return False
                explored += 1
        if explored <= 2 * edges:
            return False
        edges = explored // 2
    here, size = shown[passes - 1, 1], shown[passes - 1, 2]
    if 2 * edges != darts or size != darts or s[6][0] != darts or shown[passes - 1, 0] != cost:
        return False
    if not _embeds(darts, s_sigma, s[0], here, trail[cost], world, to, back):
        return False
    return _folds(world, log, fold)


@njit(cache=True, nogil=True)
def _folds(world, log, fold):
    """Whether the log alone determines the map: merged at v0 and closed, it has no open dart."""
    _, _, sensed, bearing = world
    motions, degrees, bearings, length = log
    node, link, first, degree, parent, shift, todo = fold
    home, home_bearing = sensed[0], bearing[0]
    nodes, darts = 1, home
    first[0], degree[0], parent[0], shift[0] = 0, home, 0, 0
    for i in range(home):
        node[i], link[i] = 0, -1
    dart = 0
    for step in range(length[0]):
        dart = _root(dart, fold)
        start, d = first[node[dart]], degree[node[dart]]
        leaving = start + (dart - start + motions[step]) % d
        if link[leaving] < 0:
            first[nodes], degree[nodes], parent[nodes] = darts, degrees[step], nodes
            shift[nodes] = 0
            for i in range(darts, darts + degrees[step]):
                node[i], link[i] = nodes, -1
            link[leaving], link[darts] = darts, leaving
            nodes += 1
            darts += degrees[step]
        dart = link[leaving]
        if bearings[step] != UNMARKED:
            todo[0], todo[1] = dart, (home_bearing - bearings[step]) % home
            waiting = 1
            while waiting:
                waiting -= 1
                a, b = _root(todo[2 * waiting], fold), _root(todo[2 * waiting + 1], fold)
                if a == b:
                    continue
                v, w = node[a], node[b]
                if v == w or degree[v] != degree[w]:
                    return False
                if v < w:
                    a, b, v, w = b, a, w, v
                parent[v] = w
                shift[v] = ((b - first[w]) - (a - first[v])) % degree[v]
                for i in range(degree[v]):
                    x = first[v] + i
                    y = _root(x, fold)
                    if link[x] >= 0 and link[y] < 0:
                        link[y] = link[x]
                    elif link[x] >= 0:
                        todo[2 * waiting], todo[2 * waiting + 1] = link[x], link[y]
                        waiting += 1
    for v in range(nodes):
        if parent[v] == v:
            for x in range(first[v], first[v] + degree[v]):
                if link[x] < 0:
                    return False
    return True


@njit(cache=True, nogil=True)
def _root(dart, fold):
    node, _, first, degree, parent, shift, _ = fold
    v = node[dart]
    while parent[v] != v:
        w = parent[v]
        dart = first[w] + (dart - first[v] + shift[v]) % degree[v]
        v = w
    return dart


# All maps.


@njit(cache=True, nogil=True)
def examine(
    edges,
    limit,
    policy,
    prefix,
    tables,
    halt,
    counts,
    least,
    listed,
):
    """As :func:`allworlds.kernel.walk.explore`, each world finished before it is walked."""
    bound, viable, sensed_as, fuel, _ = tables
    darts = 2 * edges
    room = 2 * darts + 2
    sigma, alpha = zeros(darts, int64), zeros(darts, int64)
    degree = zeros(edges + 2, int64)
    world = (sigma, alpha, zeros(darts, int64), zeros(darts, int64))
    s = (
        zeros(room, int64),
        zeros(room, int64),
        zeros(room, int64),
        zeros(room, int64),
        zeros(room, int64),
        zeros(room, int64),
        zeros(2, int64),
    )
    log = (empty(fuel, int64), empty(fuel, int64), empty(fuel, int64), empty(1, int64))
    shown = empty((edges + 1, 3 + room), int64)
    trail = empty(fuel + 1, int64)
    most = (fuel + 1) * darts
    fold = (
        empty(most, int64),
        empty(most, int64),
        empty(fuel + 1, int64),
        empty(fuel + 1, int64),
        empty(fuel + 1, int64),
        empty(fuel + 1, int64),
        empty(2 * most, int64),
    )
    events = zeros(COLUMNS, int64)
    row = zeros(1 + 2 * darts, int64)
    decision, place = zeros(darts + 1, int64), zeros(darts + 1, int64)
    state = zeros(3, int64)
    worlds = 0
    alpha[:] = -1
    while not halt[0] and advance(
        edges, limit, prefix, viable, alpha, degree, decision, place, state
    ):
        w_vertices = state[VERTICES]
        rotation(w_vertices, degree, sigma)
        dart = 0
        for v in range(w_vertices):
            for i in range(degree[v]):
                world[2][dart] = sensed_as[degree[v]]
                world[3][dart] = UNMARKED if v else (-i) % degree[0]
                dart += 1
        worlds += 1
        events[:] = 0
        log[3][0] = 0
        passes = _explore(world, policy, s, log, shown, events)
        cost = log[3][0]
        n = w_vertices
        counts[n, WORLDS] += 1
        holds = passes >= 0 and _judge(world, passes, s, log, shown, trail, fold)
        if cost > bound[n] or not holds:
            counts[n, BROKEN] += 1
            row[0] = n
            encode(darts, sigma, alpha, 0, row[1:])
            keep_least(least, row)
        if not holds:
            counts[n, FAILED] += 1
            continue
        counts[n, TRAVERSALS] += cost
        counts[n, LARGEST] = max(counts[n, LARGEST], cost)
        for event in (CASE_1, CASE_2, AT_V0, EMPTY_H):
            counts[n, event] += events[event]
        loops, parallel = _doubled(w_vertices, degree, alpha)
        counts[n, LOOP_EDGE] += loops
        counts[n, PARALLEL_EDGE] += parallel
        if worlds <= listed.shape[0]:
            listed[worlds - 1, 0], listed[worlds - 1, 1] = cost, n
            listed[worlds - 1, 2 : 2 + n] = degree[:n]
            listed[worlds - 1, 2 + n : 2 + n + darts] = alpha
    return worlds


@njit(cache=True, nogil=True)
def _doubled(vertices, degree, alpha):
    """Whether the map has a loop, and whether it has two edges with the same two ends."""
    owner = empty(len(alpha), int64)
    dart = 0
    for v in range(vertices):
        for _ in range(degree[v]):
            owner[dart] = v
            dart += 1
    joined = zeros((vertices, vertices), int64)
    loop = parallel = 0
    for d in range(len(alpha)):
        if d < alpha[d]:
            u, v = owner[d], owner[alpha[d]]
            if u == v:
                loop = 1
            elif joined[u, v]:
                parallel = 1
            joined[u, v] = joined[v, u] = 1
    return loop, parallel
