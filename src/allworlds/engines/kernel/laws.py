"""The laws, each with a number: they compare checkpoints, answers and folded logs with the world.

S is the explored part that a checkpoint shows, or the map of an answer.  S is embedded into the
world: its ``here`` is mapped to the robot's true dart, and the images of all other darts follow
along sigma and the explored edges.

To fold a log, the walk of the log is first made in a tree, in which each step leads to a new node.
Each node is a copy of a vertex of the true map, and its darts have the numbers of that vertex's
darts.  If a step arrives at v0, its node is merged with the first node, which stands for v0.  In a
merger the two darts with the same number become one dart; if this dart then leads to two nodes,
these two nodes are merged, too.  Dart d of node v is the number ``v << NODE | d``, where the
constant NODE is a number of bits.

Some arguments have the same meaning in all functions.  ``world`` is the true map with its
lighthouse.  ``published`` is S with its ``here``.  ``judged`` holds the laws that the checkpoints
of a run have broken so far, and room for the work of the functions.  ``fold`` is the state of a log
that is being folded.

The twins, Python code with the same results: :mod:`allworlds.judging.laws` and
:class:`allworlds.maps.combinatorial.CombinatorialMap`.
"""

from numpy import int64

from allworlds.engines.kernel.arrays import DARTS, NONE
from allworlds.engines.kernel.capabilities import LONG
from allworlds.engines.kernel.compiling import entry_of, inlined, inner, lowest, size as size_of
from allworlds.judging.laws.law_table import PRECEDENCE

LAWS = ("", *PRECEDENCE)
"""The laws by their numbers, in their order of precedence; 0 stands for no broken law."""

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
"""The number of bits that hold a dart's number within its node."""


@inner
def look_at(judged, published, world, dart, walked):
    """Note in ``judged.broken`` the laws that the checkpoint ``published`` breaks.

    In ``published`` an open dart d of S has ``alpha[d] == d``.  ``dart`` is the robot's true dart,
    and ``walked`` is the set of the darts of all edges that the robot has walked so far.
    """
    darts, alpha, explored = published.darts, published.alpha, 0
    for d in range(darts):
        e = entry_of(alpha, d)
        if e != d:
            explored += 1
            if 0 <= e < darts and entry_of(alpha, e) == e:
                judged.broken |= 1 << INVARIANT_2
    if not judged.broken >> INVARIANT_1 & 1 and not _is_part(
        judged, published, world, dart, walked
    ):
        judged.broken |= 1 << INVARIANT_1
    t = world.darts // 2 - (explored + 1) // 2
    if judged.shown and t >= judged.t:
        judged.broken |= 1 << VARIANT
    judged.t, judged.shown = t, 1


@inner
def answer_law(published, world, dart, judged):
    """The number of the law that an answer breaks (no-estimate, map or pose); 0 if it breaks none.

    ``published`` is the answer, and ``dart`` is the robot's true dart.  ``judged`` is only room for
    the work: the broken law is returned, and not noted there.
    """
    size, here = int64(published.darts), int64(published.here)
    if here < 0 or here >= size or not _is_map(published, judged):
        return NO_ESTIMATE
    if size == world.darts:
        if _is_part(judged, published, world, dart, -1):
            return 0
        for other in range(size):
            if _is_part(judged, published, world, other, -1):
                return POSE
    return MAP


@inner
def _is_part(judged, published, world, dart, walked):
    """Whether S, with its cyclic orders, is a part of the world, and all edges of S were walked.

    S is ``published``.  S is a part only if it can be embedded such that its ``here`` is mapped to
    ``dart``, a dart of the world.  ``walked`` is the set of the darts of walked edges; -1 is the
    set of all darts.  ``judged`` is only room for the work: no law is noted there.
    """
    size, here = published.darts, published.here
    if here < 0 or here >= size or size > world.darts:
        return False
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
                return False
            if judged.to[y] == NONE and not taken >> true & 1:
                judged.to[y] = true
                taken |= 1 << true
                judged.queue[known] = y
                known += 1
            elif judged.to[y] != true:
                return False
            y = entry_of(alpha, x)
            if y == x:
                y = judged.claim[x]
            if y == x:
                break
            true = world.alpha[judged.to[x]]
    if known < size:
        return False
    for d in range(size):
        if entry_of(alpha, d) != d and not walked >> judged.to[d] & 1:
            return False
    return True


@inner
def _is_map(published, judged):
    """Whether sigma and alpha of the answer ``published`` are a connected map.

    Both must be permutations, and alpha must pair each dart with another dart.  ``judged`` is only
    room for the work.
    """
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
    """Fold the log of a finished run; return whether no dart is open any more.

    The lighthouse of ``world`` must be directional.  ``fold`` is room for the work: its content
    before the call has no influence.
    """
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
    """Fold one more step of the log: the robot arrives by the dart ``entered`` of the world.

    Before this step some dart must be open.  Once no dart is open, the map is known, and no further
    step needs to be folded.
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
    """Join dart ``leaving`` of node v and dart ``entered`` of node w; before, both were open."""
    fold.link[v << NODE | leaving], fold.link[w << NODE | entered] = w, v
    fold.linked[v] |= 1 << leaving
    fold.linked[w] |= 1 << entered
    fold.open -= 2


@inlined
def _root(fold, v):
    """The node into which node v has been merged, perhaps in several steps; v if not merged."""
    while fold.parent[v] != v:
        v = fold.parent[v]
    return v


@inner
def _merge(world, fold, v, w):
    """Merge the nodes v and w, and then all pairs of nodes that must be merged because of them.

    If darts with the same number lead from both merged nodes, the two nodes behind these darts must
    be merged, too.
    """
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
