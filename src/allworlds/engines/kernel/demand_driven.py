"""The demand-driven check of Algorithm 1 in all rooted maps: crossing a dart decides that dart.

Two partial maps grow side by side: the world W, with decided and open darts, and the robot's S with
its open darts U.  ``image`` maps each dart of S to the dart of W for which it stands.  The robot
walks until it is about to cross an open dart of W.  Then each decision for that dart is tried in
turn: the dart is joined to another open dart, or to the first dart of a new vertex.  Only decisions
are tried after which W can still become a map with the wanted numbers of edges and vertices.  Each
finished walk belongs to one world, and each world to one finished walk.

In each pass of Algorithm 1 two conditions are checked.  First: if a vertex is added to S, no other
vertex of S stands for the same vertex of W.  Second: if two darts of U are joined in S, the darts
of W for which they stand are joined in W.  At the end of the walk a third condition is checked: S
is all of W.  A walk *fails* if a condition is not met, or if the walk costs more than the largest
step budget of all numbers of vertices.

The first two conditions imply three laws: S is the explored part of W (invariant-1), U holds its
unexplored darts (invariant-2), and S grows by an edge in each pass (variant).

The law folding is met, too.  This law demands that folding the log gives the whole map W.  Folding
begins with a map in which each step of the log leads to a new vertex.  Then each vertex at which
the robot has sensed v0 is merged with v0, and the bearing says which darts are merged.  If a dart
now leads to two vertices, these two are merged, too, and so on.

The proof: the robot joins two darts of U only after a test that has led to v0.  The hypothesis
names, for each vertex that the robot has passed in this test, a vertex of S.  The last vertex of
the test is v0, and is merged with v0.  The vertex before it and the vertex of S that the hypothesis
names for it are then behind the same dart of v0, so these two are merged.  In the same way each
earlier vertex of the test is merged with its vertex of S, back to the first vertex of the test.
Hence the folded log has every edge of S.  At the end of the walk S is all of W.

``w`` is the state of the check, an array ``WALK``.  ``s`` is the part of ``w`` that is copied
before each decision, so that the walk can go back to the decision.  ``w.choices`` is a stack of
``w.depth`` entries.  An entry stands for a dart of W for which some decisions have not been tried
yet; it holds these decisions, and the copy of ``s``.  ``kept`` is a :class:`Kept`: rows for the
most expensive runs, and for runs that break a law.

The docstrings name the lines and the cases of the paper's Algorithm 1, which
:mod:`allworlds.engines.kernel.algorithm1` lists; e is the dart of U that the present pass explores.

Source: Algorithm 1, Sections IV and V.
"""

from allworlds.engines.kernel.capabilities import FIFO, LIFO
from allworlds.engines.kernel.code import LESS, blame, fingerprint, is_less, mixed, note
from allworlds.engines.kernel.compiling import (
    copy,
    entry,
    highest,
    inlined,
    inner,
    lowest,
    neighbours,
    size,
)

# One number holds the cost and the counters of a walk, so that a decision saves one number.
COST = 0xFFFFF
ONE_CASE_1, ONE_CASE_2, ONE_AT_V0, ONE_EMPTY_H = (1 << bit for bit in (20, 28, 36, 44))
ONE_LOOP, ONE_PARALLEL = 1 << 52, 1 << 53

EDGE, PATH, PICK, NEXT, ENDED, FAILED = range(6)
"""The values of ``s.stage``, the phase of a walk: before the robot crosses the dart e; before a
step of a test; before the choice of e; before the choice of a hypothesis; ended; failed.

A walk can fail while darts of W are open; it then counts as failed in every world that W can
become.
"""

# The columns of the tally, by vertices: worlds, the cost summed and the largest, events summed,
# worlds with a loop and with parallel edges, their fingerprints, and walks that failed.
WORLDS, TRAVERSALS, LARGEST, CASES_1, CASES_2, TESTS_AT_V0, EMPTY_HS = range(7)
LOOP_EDGE, PARALLEL_EDGE, FINGERPRINT, FAILURES = range(7, 11)
_FEW = 0xFF


@entry
def explore(w, prefix, kept, halt):
    """Walk once in every rooted map whose first decisions are ``prefix``; count it in ``w.counts``.

    If a walk has failed, or costs more than the bound, a run with place 0 and law 0 is added to
    ``kept``.  Here this place and this law are no real ones: the run stands for all places of the
    lighthouse in the map, and for all laws.  The work is given up once ``halt[0]`` is not 0.
    """
    s = w.now
    _begin(w, s, prefix)
    while True:
        if s.stage != FAILED:
            _walk(w, s)
        if s.stage != ENDED and s.open:
            if s.stage == FAILED:
                s.y = lowest(s.open)
            others = s.open ^ 1 << s.y
            if s.darts == 2 * w.edges and others & (others - 1) == 0:
                _glue(w, s, lowest(others))
                continue
            choice = w.choices[w.depth]
            w.depth += 1
            if not others or not w.viable[2 * w.edges - s.darts, size(others) - 1]:
                others = 0
            choice.untried, choice.degree = others, 1
            copy(choice.now, s)
        else:
            _tally(w, s, kept)
            if w.depth == 0 or halt[0]:
                return
            _go_back(w, s)
        while not _choose(w, s):
            if w.depth == 0:
                return
            _go_back(w, s)


@inlined
def _begin(w, s, prefix):
    """Take the decisions ``prefix`` of W; let S be v0, with the robot at dart 0 of W and of S."""
    s.open = s.darts = s.vertices = 0
    _add_vertex(w, s, -prefix[0])
    for i in range(1, len(prefix)):
        s.y = lowest(s.open)
        z = prefix[i]
        if z < 0:
            z = s.darts
            _add_vertex(w, s, -prefix[i])
        _glue(w, s, z)
    degree = w.degree[0]
    for dart in range(degree):
        w.image[dart] = dart
        w.s_owner[dart], w.s_degree[dart] = 0, w.degree[0]
    for d in range(2 * w.edges + 1):
        w.of_degree[d] = 0
    w.adjacent[0] = 0
    w.own[0] = s.unexplored = (1 << degree) - 1
    s.s_darts, s.s_vertices, s.in_s = degree, 1, 1
    s.level = s.parent = s.position = s.passes = s.total = 0
    s.code = mixed(0, 0 - degree)
    s.stage = PICK
    w.depth = 0


@inner
def _add_vertex(w, s, degree):
    """Add a vertex of this degree to W; all its darts are open."""
    v, first = s.vertices, s.darts
    for dart in range(first, first + degree):
        w.owner[dart], w.end[dart], w.degree[dart] = v, first + degree, degree
    s.vertices += 1
    s.darts += degree
    s.open |= (1 << s.darts) - (1 << first)


@inlined
def _glue(w, s, z):
    """Join the darts ``s.y`` and ``z`` of W, which together become an edge."""
    w.partner[s.y], w.partner[z] = z, s.y
    s.open &= ~(1 << s.y | 1 << z)


@inlined
def _choose(w, s):
    """Take the next decision for the dart ``s.y`` of W; return whether a decision was left.

    The last entry of ``w.choices`` holds the decisions for this dart that have not been tried.  If
    none of them is legal, this entry is removed, and the result is False.
    """
    choice = w.choices[w.depth - 1]
    if choice.untried:
        z = lowest(choice.untried)
        choice.untried &= choice.untried - 1
        w.depth -= choice.untried == 0 and s.darts == 2 * w.edges
        _glue(w, s, z)
        return True
    owed, others = 2 * w.edges - s.darts, size(s.open) - 1
    degree = choice.degree
    if s.vertices + 1 == w.limit:
        degree = max(degree, owed)
    while degree <= owed and not w.viable[owed - degree, others + degree - 1]:
        degree += 1
    if degree > owed or s.vertices >= w.limit:
        w.depth -= 1
        return False
    choice.degree = degree + 1
    z = s.darts
    _add_vertex(w, s, degree)
    _glue(w, s, z)
    return True


@inlined
def _tally(w, s, kept):
    """Add the finished map W, in which the walk has ended or failed, to the counts ``w.counts``.

    After a walk has failed, the open darts of W are decided in every way, so that each finished map
    is counted.  The walk is also written to ``kept`` if it is the most expensive walk so far, or
    breaks a law.
    """
    n, cost = s.vertices, s.total & COST
    w.counts[n, WORLDS] += 1
    w.counts[n, FINGERPRINT] = (w.counts[n, FINGERPRINT] + _fingerprint(w, s)) & LESS
    if s.stage == FAILED:
        w.counts[n, FAILURES] += 1
        _blame(w, s, kept)
        return
    if cost >= w.counts[n, LARGEST]:
        _settle(w, s)
        if cost > w.counts[n, LARGEST] or is_less(w.world, kept.most_expensive, n):
            note(w.world, 0, kept.most_expensive[n])
    w.counts[n, TRAVERSALS] += cost
    w.counts[n, LARGEST] = max(w.counts[n, LARGEST], cost)
    for i in range(4):
        w.counts[n, CASES_1 + i] += s.total >> (20 + 8 * i) & _FEW
    w.counts[n, LOOP_EDGE] += s.total >> 52 & 1
    w.counts[n, PARALLEL_EDGE] += s.total >> 53 & 1
    if cost > w.bound[n]:
        _blame(w, s, kept)


@inlined
def _fingerprint(w, s):
    """The fingerprint of W, in which no dart is open.

    Under the policy fifo the robot explores the darts in the order in which the enumeration decides
    them.  So a walk that has ended has passed all decisions in this order, and has computed the
    fingerprint in ``s.code``.  Under another policy, or if the walk has failed, it is computed
    here.
    """
    if w.policy == FIFO and s.stage != FAILED:
        return s.code
    return fingerprint(w, w.partner)


@inner
def _settle(w, s):
    """Write W, in which no dart is open, to ``w.world``."""
    world = w.world
    world.darts, world.vertices = s.darts, s.vertices
    for dart in range(s.darts):
        end = w.end[dart]
        world.sigma[dart] = dart + 1 if dart + 1 < end else end - w.degree[dart]
        world.alpha[dart] = w.partner[dart]


@inner
def _blame(w, s, kept):
    """Write W, in which a law is broken, to the rows ``kept.least``.

    These rows hold the smallest worlds so far in which a law is broken: those with the fewest
    vertices, and of worlds with equally many vertices those with the least codes.  If all rows are
    in use, W replaces the largest of these worlds; but W is not written if W itself is larger.
    """
    _settle(w, s)
    blame(w.world, 0, kept.least, kept.row)


@inlined
def _go_back(w, s):
    """Go back to the last entry of ``w.choices``.

    Restore W, S and the walk as they were before the dart of this entry was decided.
    """
    now = w.choices[w.depth - 1].now
    while s.passes > now.passes:
        s.passes -= 1
        a, b = w.one_end[s.passes], w.other_end[s.passes]
        if a != b:
            w.adjacent[a] ^= 1 << b
            w.adjacent[b] ^= 1 << a
    while s.s_vertices > now.s_vertices:
        s.s_vertices -= 1
        own = w.own[s.s_vertices]
        w.of_degree[w.s_degree[lowest(own)]] &= ~own
    copy(s, now)


@inlined
def _walk(w, s):
    """Walk on until the walk has ended, has failed, or needs a decision.

    If the walk has ended or failed, ``s.stage`` is ENDED or FAILED.  If it needs a decision, the
    robot is about to cross the dart ``s.y`` of W, which is open and must be decided.
    """
    while True:
        if s.stage == PICK:
            _pick(w, s)
            if s.stage != EDGE:
                return
        if s.stage == EDGE:
            if s.open >> s.y & 1:
                return
            _arrive(w, s)
        if s.stage != PICK and not _test_all(w, s):
            return


@inlined
def _pick(w, s):
    """Choose the dart e of U, and add the cost of the way to e and across e (lines 2-5).

    Then ``s.stage`` is EDGE: the robot has not crossed e yet, although the cost is already counted;
    ``s.y`` is the dart of W for which e stands.  If U is empty, no dart is chosen, and
    ``s.stage`` is ENDED if S is all of W, and FAILED if not.  The walk also fails if it has cost
    more than the largest budget.
    """
    if s.total & COST > w.fuel:
        s.stage = FAILED
        return
    if not s.unexplored:
        darts = 2 * w.edges
        whole = s.open == 0 and s.s_darts == darts and s.darts == darts
        s.stage = ENDED if whole and s.s_vertices == s.vertices else FAILED
        return
    if w.policy == FIFO:
        e = lowest(s.unexplored)
    elif w.policy == LIFO:
        e = highest(s.unexplored)
    else:
        e = _nearest(w, s)
    s.e = e
    s.unexplored ^= 1 << e
    v = w.s_owner[e]
    s.total += 1
    if s.position == 0:
        s.total += s.level >> (4 * v) & 15
    elif v == 0:
        s.total += s.level >> (4 * s.position) & 15
    elif s.position != v:
        s.total += _distance(w, s.position, v)
    s.y = w.image[e]
    s.stage = EDGE


@inlined
def _arrive(w, s):
    """Collect in ``s.hypotheses`` the darts of U that may be the other end of e (line 6).

    The robot has just crossed e.  If it has come to v0, the bearing tells the dart of v0, so the
    edge is added to S at once (lines 18-19).
    """
    z = w.partner[s.y]
    if z < w.end[0]:
        # The direction tells the dart of v0, so this test needs no step.
        s.total += ONE_AT_V0
        s.candidate = z
        _augment_by_loop(w, s)
        return
    s.x = z
    s.hypotheses = s.unexplored & w.of_degree[w.degree[z]]
    if not s.hypotheses:
        s.total += ONE_EMPTY_H
    s.stage = NEXT


@inlined
def _test_all(w, s):
    """Test the hypotheses one after the other, and add the new edge to S (lines 7-21).

    The new edge leads to the dart of the hypothesis whose test succeeds, or to a new vertex if
    every test fails.  Return True if the edge was added.  Return False if the walk has failed
    (``s.stage`` is FAILED), or if a test is about to cross the open dart ``s.y`` of W; after a
    decision about this dart, the next call continues the test.
    """
    while s.stage != FAILED:
        if s.stage == NEXT:
            if s.total & COST > w.fuel:
                s.stage = FAILED
                return False
            if not s.hypotheses:
                _augment_by_vertex(w, s)
                return s.stage == PICK
            dart = lowest(s.hypotheses)
            s.hypotheses &= s.hypotheses - 1
            s.candidate = dart
            s.steps = 0
            s.stage = PATH
            _aim(w, s, dart, s.x)
        at_home = w.s_owner[s.t] == 0
        if s.open >> s.y & 1:
            if not at_home:
                return False
            # The last step would have to end in t, which already has a partner: the test cannot
            # match, wherever y leads.
            s.total += s.steps + 2 + ONE_CASE_2
            s.stage = NEXT
            continue
        z = w.partner[s.y]
        s.steps += 1
        s.total += 1
        if at_home:
            if z == s.t:
                _augment_by_loop(w, s)
                return s.stage == PICK
            s.total += s.steps + ONE_CASE_2
            s.stage = NEXT
        elif z < w.end[0] or w.degree[z] != w.s_degree[s.t]:
            s.total += s.steps + ONE_CASE_1
            s.stage = NEXT
        else:
            _aim(w, s, s.t, z)
    return False


@inlined
def _aim(w, s, dart, x):
    """Plan the next step of a test, on the way to v0.

    By the hypothesis the robot has come in by the dart ``dart`` of S; in truth it has come in by
    the dart ``x`` of W.  ``s.y`` becomes the dart of W that the robot crosses next, and ``s.t``
    the dart of S by which the robot then arrives if the hypothesis is true.
    """
    p = s.parent >> (5 * (w.s_owner[dart] - 1)) & 31
    turn = p - dart
    if turn < 0:
        turn += w.s_degree[dart]
    y = x + turn
    if y >= w.end[x]:
        y -= w.degree[x]
    s.y = y
    s.t = w.s_partner[p]


@inlined
def _augment_by_vertex(w, s):
    """Add a new vertex to S, at the other end of the dart e (lines 20-21).

    The walk fails if a vertex of S already stands for the vertex of W to which e has led.
    """
    u, x, end = w.owner[s.x], s.x, w.end[s.x]
    degree = w.degree[x]
    s.code = mixed(s.code, 0 - degree)
    if s.in_s >> u & 1 or s.s_darts + degree > 2 * w.edges:
        s.stage = FAILED
        return
    s.in_s |= 1 << u
    v, first = s.s_vertices, s.s_darts
    own = (1 << (first + degree)) - (1 << first)
    w.own[v] = own
    w.of_degree[degree] |= own
    for dart in range(first, first + degree):
        w.s_owner[dart], w.s_degree[dart] = v, degree
        w.image[dart] = x
        x += 1
        if x == end:
            x -= w.degree[s.x]
    a = w.s_owner[s.e]
    w.s_partner[s.e], w.s_partner[first] = first, s.e
    s.unexplored |= own & (own - 1)
    far, near = 4 * v, 5 * (v - 1)
    s.level = s.level & ~(15 << far) | ((s.level >> (4 * a) & 15) + 1) << far
    s.parent = s.parent & ~(31 << near) | first << near
    w.adjacent[a] |= 1 << v
    w.adjacent[v] = 1 << a
    w.one_end[s.passes], w.other_end[s.passes] = a, v
    s.passes += 1
    s.s_vertices += 1
    s.s_darts += degree
    s.position = v
    s.stage = PICK


@inlined
def _augment_by_loop(w, s):
    """Make an edge of S from the dart e and the dart of the confirmed hypothesis (lines 18-19).

    The walk fails if the dart of the hypothesis is not in U, or if the two darts stand for darts of
    W that are not joined.
    """
    e, dart = s.e, s.candidate
    if not s.unexplored >> dart & 1 or w.partner[w.image[e]] != w.image[dart]:
        s.stage = FAILED
        return
    s.unexplored ^= 1 << dart
    s.code = mixed(s.code, dart)
    w.s_partner[e], w.s_partner[dart] = dart, e
    a, b = w.s_owner[e], w.s_owner[dart]
    w.one_end[s.passes] = w.other_end[s.passes] = 0
    if a == b:
        s.total |= ONE_LOOP
    elif w.adjacent[a] >> b & 1:
        s.total |= ONE_PARALLEL
    else:
        w.one_end[s.passes], w.other_end[s.passes] = a, b
        w.adjacent[a] |= 1 << b
        w.adjacent[b] |= 1 << a
    s.passes += 1
    difference = (s.level >> (4 * a) & 15) - (s.level >> (4 * b) & 15)
    far, way = a, e
    if difference < 0:
        far, way, difference = b, dart, -difference
    if difference == 1:
        near = 5 * (far - 1)
        if way < s.parent >> near & 31:
            s.parent = s.parent & ~(31 << near) | way << near
    elif difference > 1:
        _ways_home(w, s)
    s.position = 0
    s.stage = PICK


@inner
def _distance(w, start, goal):
    """The length of a shortest walk in S from the vertex ``start`` to the vertex ``goal``."""
    reached = front = 1 << start
    steps = 0
    while not reached >> goal & 1:
        steps += 1
        front = neighbours(w, front) & ~reached
        if not front:
            return steps
        reached |= front
    return steps


@inner
def _ways_home(w, s):
    """Compute for each vertex of S its distance to v0, and its first dart that leads nearer to v0.

    The distances are packed into the number ``s.level``, 4 bits for each vertex; the darts into
    ``s.parent``, 5 bits for each vertex but v0.
    """
    level = parent = 0
    reached = front = 1
    steps = 0
    while front:
        steps += 1
        front = neighbours(w, front) & ~reached
        reached |= front
        rest = front
        while rest:
            level |= steps << (4 * lowest(rest))
            rest &= rest - 1
    explored = ((1 << s.s_darts) - 1) & ~s.unexplored
    for v in range(1, s.s_vertices):
        nearer = (level >> (4 * v) & 15) - 1
        ways = w.own[v] & explored
        while level >> (4 * w.s_owner[w.s_partner[lowest(ways)]]) & 15 != nearer:
            ways &= ways - 1
        parent |= lowest(ways) << (5 * (v - 1))
    s.level, s.parent = level, parent


@inner
def _nearest(w, s):
    """The dart of U whose vertex is nearest in S to the robot.

    Of several such darts, the result is the dart that was added to S first.
    """
    reached = front = 1 << s.position
    while front:
        after = darts = 0
        while front:
            v = lowest(front)
            front &= front - 1
            darts |= w.own[v]
            after |= w.adjacent[v]
        if darts & s.unexplored:
            return lowest(darts & s.unexplored)
        front = after & ~reached
        reached |= front
    return lowest(s.unexplored)
