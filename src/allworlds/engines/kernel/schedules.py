"""The worst and the best cost of Algorithm 1 in each world, over every schedule.

A pass explores one edge.  Between two passes the robot's knowledge is a pair: the set of the
explored edges, and the robot's vertex.  This vertex is v0, or it has just been added and has one
explored edge.  The costs of rejected hypotheses add up, and depend neither on their order nor on
the robot's vertex.  So the cost of the tests of a pass is computed once for each set of explored
edges and each dart to cross.

A test walks to v0 on a simple path, and a schedule may choose any such path.  So the search tries
each test on every simple path to v0, and finds its least and its largest cost.  It also counts the
tests that confirm a false hypothesis; by the theory there are none.

The start is a dart of v0.  Every choice of a dart is tried, so the costs do not depend on which of
these darts is the start.  Rooted maps with the same map and the same v0 therefore have equal costs,
and only one of them is searched: the one with the least code.  The code of a rooted map is its
sigma and alpha, with the darts renumbered from the root, which is the start.

The maps are made as in :mod:`allworlds.engines.kernel.worlds`: a list of decisions makes a map, and
``viable`` is the table that says which unfinished maps are legal.

Some arguments have the same meaning in all functions.  ``job`` is an array ``SCHEDULES``, the state
of the search, with the present world.  ``explored`` is a set of edges, those of S. ``known`` is the
set of the vertices of S: v0 and all vertices of these edges.  ``worst`` and ``best`` hold the costs
that remain: the entry ``[explored, v]`` is for the robot at vertex v when the edges ``explored``
are explored.

Source: Algorithm 1, Section IV.
"""

from collections.abc import Sequence
from typing import Any, NamedTuple

from numpy import array, int64, zeros

from allworlds.engines.kernel.arrays import SCHEDULES, new
from allworlds.engines.kernel.code import encode, keep_least
from allworlds.engines.kernel.compiling import entry, inner, lowest, neighbours
from allworlds.engines.kernel.worlds import advance, gluing_rule, rule_address, settle

SHORTEST, SIMPLE = range(2)
TRANSITS = {"shortest": SHORTEST, "simple": SIMPLE}

ROOTED, WORST, BEST, TESTS, WRONG = range(5)
COLUMNS = 5
"""The number of columns of results, which are named above.

They are: the number of rooted maps; the largest worst cost and the largest best cost of a map; the
number of tests in the searched maps; the number of tests that confirmed a false hypothesis.
"""

_FAR = 1 << 30


class Rooms(NamedTuple):
    """The arrays of a search: the tables of the present world, and the results of all worlds.

    ``worst``, ``best`` and ``reached`` are the tables; they are computed anew in each world.
    """

    # The worst and best costs by set of edges and vertex; the reached vertices by set of edges.
    worst: Any
    best: Any
    reached: Any
    # The outcome by vertices.
    counts: Any
    # By vertices: their number (0: none yet), then the least code of a world with the worst cost;
    # two further such rows.
    least: Any
    row: Any
    other: Any


@entry
def search(job, prefix, viable, rooms, halt):
    """Search all schedules in every map whose first decisions are ``prefix``.

    ``job`` is a new array ``SCHEDULES`` with the request filled in.  ``viable`` is the table of
    :func:`gluing_rule`.  The results are written to ``rooms``.  The search is given up once
    ``halt[0]`` is not 0.
    """
    while not halt[0] and advance(job.gluing, prefix, viable):
        settle(job.world, job.gluing)
        rooms.counts[job.world.vertices, ROOTED] += 1
        if _is_least(job.world, rooms.row, rooms.other):
            _solve(job, rooms.worst, rooms.best, rooms.reached)
            _keep(job, rooms)


@inner
def _is_least(world, row, other):
    """Whether no other root at v0 gives a smaller code than the root of the world, dart 0.

    The number of vertices is written to ``row[0]``, and the code of the world to ``row[1:]``.
    ``other`` is room for the code from another root.
    """
    row[0] = world.vertices
    encode(world, 0, row, 1)
    for root in range(1, world.degree[0]):
        encode(world, root, other, 1)
        for i in range(1, len(row)):
            if other[i] != row[i]:
                if other[i] < row[i]:
                    return False
                break
    return True


@inner
def _keep(job, rooms):
    """Add the results of the present world to ``rooms``, in the row of its number of vertices.

    Of the worlds of a row the one with the largest worst cost so far is kept; of several such
    worlds, the one with the least code.
    """
    n, counts, least, worst = job.world.vertices, rooms.counts, rooms.least, rooms.worst[0, 0]
    counts[n, TESTS] += job.tests
    counts[n, WRONG] += job.wrong
    counts[n, BEST] = max(counts[n, BEST], rooms.best[0, 0])
    if worst > counts[n, WORST] or least[n, 0] == 0:
        counts[n, WORST] = worst
        least[n, 0] = 0
    elif worst < counts[n, WORST]:
        return
    keep_least(least[n : n + 1], rooms.row)


@inner
def _solve(job, worst, best, reached):
    """Compute ``worst`` and ``best`` for the present world.

    The entries ``[0, 0]`` are then the worst and the best cost of a whole run: no edge is explored,
    and the robot is at v0.  ``reached`` is room for :func:`_begin`.
    """
    world = job.world
    _begin(job, reached)
    every = (1 << (world.darts // 2)) - 1
    for v in range(world.vertices):
        worst[every, v] = best[every, v] = 0
    for explored in range(every - 1, -1, -1):
        known = reached[explored]
        if known:
            for v in range(world.vertices):
                job.adjacent[v] = 0
                worst[explored, v] = 0
                best[explored, v] = _FAR
            for d in range(world.darts):
                u, v = world.owner[d], world.owner[world.alpha[d]]
                if u != v and explored >> job.edge_of[d] & 1:
                    job.adjacent[u] |= 1 << v
            _pass(job, explored, known, worst, best)
            _ways(job, explored, known, worst, best)


@inner
def _begin(job, reached):
    """Number the edges, and find the sets of edges that a sequence of passes can explore.

    The index of an entry of ``reached`` is a set of edges.  The entry is 0 if no sequence of passes
    explores just this set; else it is the set of the vertices of these edges, with v0.
    """
    world = job.world
    job.tests = job.wrong = 0
    edge = 0
    for dart in range(world.darts):
        if dart < world.alpha[dart]:
            job.edge_of[dart] = job.edge_of[world.alpha[dart]] = edge
            edge += 1
    every = (1 << edge) - 1
    for explored in range(every + 1):
        reached[explored] = 0
    reached[0] = 1
    for explored in range(every):
        known = reached[explored]
        if known:
            for d in range(world.darts):
                if known >> world.owner[d] & 1 and not explored >> job.edge_of[d] & 1:
                    after = explored | 1 << job.edge_of[d]
                    reached[after] = known | 1 << world.owner[world.alpha[d]]


@inner
def _pass(job, explored, known, worst, best):
    """Find for each dart e in U the costs from crossing e to the answer: the largest and the least.

    The costs include the crossing.  They are written to ``job.most[e]`` and ``job.least[e]``.  If e
    is not in U, ``job.most[e]`` becomes -1, and ``job.least[e]`` has no meaning.

    S has the edges ``explored`` and the vertices ``known``; U holds the other darts of these
    vertices.  The costs that remain after the pass are read from ``worst[after, v]`` and
    ``best[after, v]``: here ``after`` is the set ``explored`` with the edge of e, and v is the
    vertex at which the pass ends.
    """
    world = job.world
    _shortest(job, 0, job.near)
    _longest(job, 0, job.far)
    for e in range(world.darts):
        job.most[e] = -1
        if not known >> world.owner[e] & 1 or explored >> job.edge_of[e] & 1:
            continue
        entered = world.alpha[e]
        u = world.owner[entered]
        after = explored | 1 << job.edge_of[e]
        most = least = 0
        if u:
            for h in range(world.darts):
                v = world.owner[h]
                if (
                    h != e
                    and h != entered
                    and v != 0
                    and world.degree[h] == world.degree[entered]
                    and known >> v & 1
                    and not explored >> job.edge_of[h] & 1
                ):
                    _test(job, explored, h, entered)
                    most += 2 * job.longest
                    least += 2 * job.shortest
        arrives = u
        if known >> u & 1:
            # The true hypothesis comes last in the worst case, and first in the best case.
            most += job.far[u]
            least = job.near[u]
            arrives = 0
        job.most[e] = 1 + most + worst[after, arrives]
        job.least[e] = 1 + least + best[after, arrives]


@inner
def _ways(job, explored, known, worst, best):
    """Find the worst and the best cost that remain when the edges ``explored`` are explored.

    For each vertex v at which the robot can be between two passes, the costs are written to
    ``worst[explored, v]`` and ``best[explored, v]``.
    """
    world = job.world
    for v in range(world.vertices):
        if not known >> v & 1 or (v and job.adjacent[v] & (job.adjacent[v] - 1)):
            continue
        if v:
            _shortest(job, v, job.near)
            if job.transit == SIMPLE:
                _longest(job, v, job.far)
        for e in range(world.darts):
            if job.most[e] >= 0:
                u = world.owner[e]
                longest = job.far[u] if job.transit == SIMPLE else job.near[u]
                worst[explored, v] = max(worst[explored, v], longest + job.most[e])
                best[explored, v] = min(best[explored, v], job.near[u] + job.least[e])


@inner
def _test(job, explored, hypothesis, entered):
    """Test a false hypothesis on every simple path in S to v0.

    By the hypothesis the robot has arrived by the dart ``hypothesis``; in truth it has arrived by
    the dart ``entered``.  The least and the greatest number of steps up to a mismatch are written
    to ``job.shortest`` and ``job.longest``.  All tests are counted in ``job.tests``, and the tests
    without a mismatch in ``job.wrong``.
    """
    world = job.world
    job.shortest, job.longest = _FAR, 0
    job.at[0], job.robot[0], job.turned[0] = hypothesis, entered, 0
    job.visited[0] = 1 << world.owner[hypothesis]
    depth = 0
    while depth >= 0:
        at, robot, turn = job.at[depth], job.robot[depth], job.turned[depth]
        if turn == world.degree[at]:
            depth -= 1
            continue
        job.turned[depth] += 1
        p = _turned(world, at, turn)
        arrives = world.alpha[p]
        w = world.owner[arrives]
        if not explored >> job.edge_of[p] & 1 or job.visited[depth] >> w & 1:
            continue
        if w and not _joined(job, w, job.visited[depth]):
            continue
        z = world.alpha[_turned(world, robot, turn)]
        if w == 0:
            matches = z == arrives
        else:
            matches = world.owner[z] != 0 and world.degree[z] == world.degree[arrives]
        if matches and w:
            depth += 1
            job.at[depth], job.robot[depth], job.turned[depth] = arrives, z, 0
            job.visited[depth] = job.visited[depth - 1] | 1 << w
            continue
        job.tests += 1
        job.wrong += matches
        job.shortest = min(job.shortest, depth + 1)
        job.longest = max(job.longest, depth + 1)


@inner
def _turned(world, dart, turn):
    """The dart ``sigma^turn(dart)``; ``turn`` is less than the degree of the dart's vertex."""
    dart += turn
    if dart >= world.first[dart - turn] + world.degree[dart - turn]:
        dart -= world.degree[dart - turn]
    return dart


@inner
def _joined(job, start, avoiding):
    """Whether a walk in S leads from ``start`` to v0 without a vertex of the set ``avoiding``."""
    reached = front = 1 << start
    while front:
        front = neighbours(job, front) & ~reached & ~avoiding
        reached |= front
    return reached & 1


@inner
def _shortest(job, start, length):
    """Find for each vertex of S the length of a shortest path from the vertex ``start``.

    The lengths are written to ``length``.
    """
    reached = front = 1 << start
    length[start] = steps = 0
    while front:
        steps += 1
        front = neighbours(job, front) & ~reached
        reached |= front
        rest = front
        while rest:
            length[lowest(rest)] = steps
            rest &= rest - 1


@inner
def _longest(job, start, length):
    """Find for each vertex of S the length of a longest simple path from the vertex ``start``.

    The lengths are written to ``length``.
    """
    for v in range(job.world.vertices):
        length[v] = 0
    visited = 1 << start
    job.at[0] = start
    job.turned[0] = job.adjacent[start] & ~visited
    depth = 0
    while depth >= 0:
        if job.turned[depth]:
            v = lowest(job.turned[depth])
            job.turned[depth] &= job.turned[depth] - 1
            depth += 1
            job.at[depth] = v
            visited |= 1 << v
            job.turned[depth] = job.adjacent[v] & ~visited
            length[v] = max(length[v], depth)
        else:
            visited ^= 1 << job.at[depth]
            depth -= 1


class ScheduleCosts(NamedTuple):
    """The costs over all schedules in the maps with one number of vertices.

    In each map one schedule is the most expensive, and one is the cheapest.

    Attributes:
        vertices: n.
        rooted: the number of rooted maps.
        worst: the cost of the most expensive schedule in a map; of all maps, the largest such cost.
        best: the cost of the cheapest schedule in a map; of all maps, the largest such cost.
        tests: the number of tests, on all simple paths. Tests are made only in the searched maps:
            of rooted maps that differ only in the start at v0, one is searched.
        wrong: the number of tests that confirmed a false hypothesis.
        sigma, alpha: the map in which a schedule has the cost ``worst``; of several such maps the
            one with the least code. This map has nothing to do with ``best``.
    """

    vertices: int
    rooted: int
    worst: int
    best: int
    tests: int
    wrong: int
    sigma: tuple[int, ...]
    alpha: tuple[int, ...]


def schedule_costs_of_unit(
    edges: int,
    limit: int,
    prefix: Sequence[int],
    transit: str,
    halt: Any,
    *,
    simple: bool = False,
    planar: bool = False,
) -> list[ScheduleCosts]:
    """The costs over all schedules, in the maps of a class whose first decisions are ``prefix``.

    The result has one item for each number of vertices that occurs.

    Args:
        edges: m.
        limit: the largest number of vertices.
        prefix: the first decisions, at least one, by which these maps are made.
        transit: the paths to the next dart that are tried: ``shortest`` or ``simple``.
        halt: an array of one number; once this number is not 0, the work is given up, and the
            result is void.
        simple: whether the maps of the class have no loops and no parallel edges.
        planar: whether the maps of the class have genus 0.
    """
    job = new(SCHEDULES)
    job.transit = TRANSITS[transit]
    gluing = job.gluing
    gluing.edges, gluing.limit, gluing.simple, gluing.planar = edges, limit, simple, planar
    gluing.rule = rule_address() if simple or planar else 0
    sets, width = 1 << edges, 1 + 4 * edges
    costs, counts, least = (sets, edges + 1), (edges + 2, COLUMNS), (edges + 2, width)
    shapes: tuple[Any, ...] = (costs, costs, sets, counts, least, width, width)
    rooms = Rooms(*(zeros(shape, int64) for shape in shapes))
    search(job, array(prefix, int64), gluing_rule(edges), rooms, halt)
    codes = (code if known else () for known, *code in rooms.least.tolist())
    return [
        ScheduleCosts._make((n, *counted, tuple(code[: 2 * edges]), tuple(code[2 * edges :])))
        for n, (counted, code) in enumerate(zip(rooms.counts.tolist(), codes, strict=True))
        if counted[ROOTED]
    ]
