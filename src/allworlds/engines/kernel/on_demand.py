"""A world that is decided on demand: where the robot is about to cross an open dart.

The world is a partial map, as in :mod:`allworlds.engines.kernel.gluing`.  An open dart that the
robot leaves by is decided in every way in turn: it is glued to another open dart, partners
ascending, or to the first dart of a new vertex, degrees ascending.  Only ways are taken from
which the map can be finished; in the classes smaller than ``maps`` a way may turn out to have no
end.  So each finished map is met exactly once, whatever the robot does: each decision splits the
maps that are left.

The robot's percepts are those of its vertex alone, so the kinds of lighthouses are those that
need nothing else to be known.  The twin is :mod:`allworlds.engines.python.partial_world`.
"""

from __future__ import annotations

from numpy import int64

from allworlds.engines.kernel.bits import lowest, size
from allworlds.engines.kernel.calls import call_with
from allworlds.engines.kernel.compiling import inlined, inner
from allworlds.engines.kernel.gluing import take_back
from allworlds.engines.kernel.records import NONE

DARK, MARKED, POINTED = range(3)
"""Nothing at v0; a mark; a mark that points to the dart whose number is that of the place."""

KINDS = {"none": DARK, "position": MARKED, "directional": POINTED}
"""The lighthouses of these kinds."""

NOWHERE, ONE_WAY, SEVERAL = range(3)
"""How a dart has been decided: in no way; in the only one; in the first of several."""


@inner
def begin(d, prefix, budgets):
    """Begin a run at the place: the robot stands at dart 0, the decisions of the prefix are taken.

    Args:
        d: the world that is decided on demand.
        prefix: decisions about the oldest open dart, from which a map can be finished.
        budgets: the largest number of traversals, by vertices; behind it that which is legal for so
            many vertices and for all larger numbers.
    """
    g, world = d.gluing, d.world
    g.open = g.darts = g.vertices = g.depth = 0
    d.depth = d.ways = d.cost = d.shown = 0
    _add_vertex(d, -prefix[0])
    _light(d)
    for i in range(1, len(prefix)):
        y, z, added = lowest(g.open), prefix[i], int64(0)
        if z < 0:
            z, added = g.darts, -prefix[i]
            _add_vertex(d, added)
        _join(d, y, z, added)
        g.depth += g.rule != 0
    world.start, world.told, world.place = 0, NONE, d.place
    _weigh(d, budgets)


@inner
def places(d, prefix):
    """The number of places of the lighthouse."""
    return -prefix[0] if d.kind == POINTED else int64(1)


@inlined
def _light(d):
    """Mark v0, the only vertex so far."""
    world = d.world
    degree = world.degree[0]
    for dart in range(degree):
        world.marks[dart] = d.kind != DARK
        if d.kind == POINTED:
            bearing = d.place - dart
            world.bearing[dart] = bearing + degree if bearing < 0 else bearing


@inner
def _add_vertex(d, degree):
    """Add a vertex whose darts are open."""
    g, world = d.gluing, d.world
    v, first = g.vertices, g.darts
    g.first[v], g.degree[v], world.root[v] = first, degree, first
    for dart in range(first, first + degree):
        g.owner[dart] = world.owner[dart] = v
        world.spot[dart] = world.ring[dart] = dart
        world.first[dart], world.degree[dart] = first, degree
        world.sigma[dart] = dart + 1
        world.marks[dart], world.bearing[dart] = 0, NONE
        g.alpha[dart] = NONE
    world.sigma[first + degree - 1] = first
    g.vertices += 1
    g.darts += degree
    g.open |= (1 << g.darts) - (1 << first)


@inlined
def _join(d, y, z, added):
    """Join two open darts; the second one may be of a vertex with ``added`` darts that is new."""
    g, world = d.gluing, d.world
    world.alpha[y], world.alpha[z] = z, y
    g.open &= ~(1 << y | 1 << z)
    if g.rule:
        depth = g.depth
        g.alpha[y], g.alpha[z] = z, y
        g.place[depth], g.partner[depth], g.added[depth] = y, z, added


@inlined
def _weigh(d, budgets):
    """Note the budget, and whether all of the world is decided."""
    d.whole = d.gluing.open == 0
    d.budget = budgets[0 if d.whole else 1, d.gluing.vertices]


@inner
def decide(d, y, viable, budgets):
    """Decide an open dart in the first way; return NOWHERE, ONE_WAY or SEVERAL.

    If there are more ways, they are kept, and :func:`decide_again` takes them.  Where there are
    several, as many ways from the start as ``d.given`` are those of ``d.path``.
    """
    g = d.gluing
    branch = d.branches[d.depth]
    branch.y, branch.ways = y, d.ways
    branch.open, branch.darts, branch.vertices = g.open, g.darts, g.vertices
    branch.decisions, branch.cost, branch.shown = g.depth, d.cost, d.shown
    others = g.open ^ 1 << y
    if not others or not viable[2 * g.edges - g.darts, size(others) - 1]:
        others = int64(0)
    branch.untried, branch.degree = others, 1
    several = _ways_left(g, branch, viable) > 1
    if several and d.ways < d.given:
        _skip(branch, d.path[d.ways])
    if not _take(d, branch, viable):
        _restore(d, branch)
        return NOWHERE
    _weigh(d, budgets)
    if not several:
        return ONE_WAY
    return _kept(d, branch, viable)


@inner
def decide_again(d, viable, budgets):
    """Decide the dart of the last branch in the next way; return as :func:`decide` does.

    The branch is dropped unless the result is SEVERAL.
    """
    d.depth -= 1
    branch = d.branches[d.depth]
    _restore(d, branch)
    if not _take(d, branch, viable):
        _restore(d, branch)
        return NOWHERE
    _weigh(d, budgets)
    return _kept(d, branch, viable)


@inlined
def _kept(d, branch, viable):
    """Note the way that was taken; keep the branch if it has ways left."""
    d.path[branch.ways] = branch.way
    d.ways = branch.ways + 1
    if not _ways_left(d.gluing, branch, viable):
        return ONE_WAY
    d.depth += 1
    return SEVERAL


@inlined
def _skip(branch, way):
    """Drop the ways before this one."""
    if way >= 0:
        branch.untried &= -1 << way
    else:
        branch.untried, branch.degree = 0, -way


@inlined
def _ways_left(g, branch, viable):
    """The number of ways that are left; 2 stands for more, too."""
    partners = size(branch.untried)
    if partners > 1:
        return int64(2)
    degree = _next_degree(g, branch, viable, branch.degree)
    if not degree or partners:
        return int64(partners + (degree > 0))
    return int64(1 + (_next_degree(g, branch, viable, degree + 1) > 0))


@inlined
def _next_degree(g, branch, viable, degree):
    """The least degree from this one on that a new vertex can have; 0 if there is none."""
    owed, others = 2 * g.edges - branch.darts, size(branch.open) - 1
    if branch.vertices >= g.limit:
        return int64(0)
    if branch.vertices + 1 == g.limit:
        degree = max(degree, owed)
    while degree <= owed and not viable[owed - degree, others + degree - 1]:
        degree += 1
    return degree if degree <= owed else int64(0)


@inlined
def _take(d, branch, viable):
    """Take the next way; return whether there was one that stays in the class."""
    g = d.gluing
    while True:
        if branch.untried:
            z, added = lowest(branch.untried), int64(0)
            branch.untried &= branch.untried - 1
            branch.way = z
        else:
            added = _next_degree(g, branch, viable, branch.degree)
            if not added:
                return False
            branch.degree, branch.way = added + 1, -added
            z = g.darts
            _add_vertex(d, added)
        _join(d, branch.y, z, added)
        if not g.rule:
            return True
        g.possible = 1
        call_with(g.rule, g)
        if g.possible:
            g.depth += 1
            return True
        take_back(g)


@inlined
def _restore(d, branch):
    """Undo all decisions from that of the branch on, and what the robot did since."""
    g = d.gluing
    while g.depth > branch.decisions:
        g.depth -= 1
        take_back(g)
    g.open, g.darts, g.vertices = branch.open, branch.darts, branch.vertices
    d.ways, d.cost, d.shown = branch.ways, branch.cost, branch.shown
