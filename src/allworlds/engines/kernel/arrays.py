"""The requests to the engines and their results, and the structured arrays of compiled code.

Requests and results are plain numbers.  In this package a *structured array* is one record of
numpy, which is like a struct of C: its fields have names, and lie in memory one after the other.
Compiled code reaches a field by its name, and a C function gets a pointer to the record.  In every
map that the kernel enumerates the darts of a vertex are consecutive, and the root is dart 0.
"""

from __future__ import annotations

from array import array
from mmap import MAP_PRIVATE, mmap
from typing import TYPE_CHECKING, Any, NamedTuple

from msgspec import Struct
from numpy import dtype, frombuffer, int32, int64, recarray, uint8, zeros

from allworlds.engines.kernel.capabilities import LONG

if TYPE_CHECKING:
    from allworlds.engines.players import Logs


class Level(Struct, frozen=True, eq=False):
    """The request to the kernel for the units of a level: sizes, explorer, lighthouse and rules.

    All units of the level have the same request.  The kernel makes each map by a list of decisions,
    its *gluing*. The first decision is the degree of the root's vertex; each later one joins the
    oldest open dart to another open dart, or to a new vertex.  A unit is all maps whose first
    decisions are the same; these decisions are an argument of their own beside the request.

    Attributes:
        edges: m, at most MOST_EDGES.
        limit: the largest number of vertices, at most m + 1.
        simple, planar: whether only simple maps belong to the class, and whether only planar maps
            do.
        explorer: a name in :data:`allworlds.engines.kernel.capabilities.EXPLORERS`.
        lighthouse: a name in :data:`allworlds.engines.kernel.capabilities.LIGHTHOUSES`.
        policy: ``fifo``, ``lifo`` or ``nearest``.
        laws: the laws that are checked besides ``illegal-action``, ``no-estimate`` and ``budget``,
            which the kernel always checks.
        bounds: the largest legal cost, indexed by the number of vertices, the degree of v0 and the
            largest degree; if the bound does not depend on one of these degrees, the index for this
            degree is always 0.
        budgets: the largest number of traversals of a run, indexed by the number of vertices; at
            most MOST_BUDGET.
    """

    edges: int
    limit: int
    simple: bool
    planar: bool
    explorer: str
    lighthouse: str
    policy: str
    laws: tuple[str, ...]
    bounds: list[list[list[int]]]
    budgets: tuple[int, ...]


class Counts(Struct, frozen=True):
    """The counts of those worlds of a unit, or of a batch, that have the same number of vertices.

    Attributes:
        vertices: this number.
        worlds: the number of rooted maps.
        runs: the number of pairs of a rooted map and a place of the lighthouse in it.
        traversals: the traversals, summed over the runs.
        traversals_rooted: the traversals, summed over one run of each rooted map: the run with the
            first place of the lighthouse.
        largest: the largest cost of a run.
        checkpoints: the number of checkpoints that the explorer has shown.
        left_out: the number of rooted maps without a place for the lighthouse.
        loops, parallels: the number of rooted maps with a loop, and of those with parallel edges.
        fingerprint: the sum of the fingerprints of the rooted maps, modulo 2^62.
    """

    vertices: int
    worlds: int
    runs: int
    traversals: int
    traversals_rooted: int
    largest: int
    checkpoints: int
    left_out: int
    loops: int
    parallels: int
    fingerprint: int


class At(NamedTuple):
    """A run: its place, and the map of its world in canonical numbering.

    Attributes:
        vertices: the number of vertices of the map.
        sigma, alpha: the map, rooted at dart 0.
        place: the number of the lighthouse's place.
    """

    vertices: int
    sigma: tuple[int, ...]
    alpha: tuple[int, ...]
    place: int


class BrokenRun(Struct, frozen=True):
    """A run that breaks a law.

    Attributes:
        vertices, sigma, alpha: the map of the run's world, as in :class:`At`.
        place: the number of the lighthouse's place; None if the kernel has walked the map once for
            all places, so that the law is broken at each of them.
        law: the name of the broken law; empty if the kernel does not know which law it is, because
            it has checked several laws together.
    """

    vertices: int
    sigma: tuple[int, ...]
    alpha: tuple[int, ...]
    place: int | None
    law: str


class Sums(Struct, frozen=True):
    """The results of all runs of a unit, or of a batch, summed up.

    Attributes:
        counts: the counts for each number of vertices that occurs.
        events: the number of occurrences of each event of Algorithm 1, such as ``case-1``.
        met: the triples (n, d0, D) that occur: the number of vertices, the degree of v0 and the
            largest degree, with 0 for a degree on which the bound does not depend.
        most_expensive: for each number of vertices the run with the largest cost; of several such
            runs the run with the least canonical code.
        broken: runs that break a law, ascending by number of vertices, canonical code, place and
            law; if there are more such runs than may be kept, only the first of them in this order.
    """

    counts: tuple[Counts, ...]
    events: dict[str, int]
    met: tuple[tuple[int, int, int], ...]
    most_expensive: tuple[At, ...]
    broken: tuple[BrokenRun, ...]


DARTS = 32
"""The length of arrays with an item for each dart or each vertex of a world.

No world of the kernel has more darts, or more vertices.
"""

DEPTHS = 16
"""A number that is larger than the number of decisions by which a map is made.

There is a decision for each edge, and one for the degree of the root's vertex.
"""

FOLDED = LONG // 16
"""The largest number of nodes that a log can have before it is folded.

A log has a node for the start, and at most one for each traversal.  The constant is larger than the
number of traversals that any budget allows.
"""

NONE = -1
"""The entry that stands for no dart, for no bearing, or for no number told to the explorer."""


def _record(*fields: tuple[Any, ...]) -> Any:
    """The type of a structured array.

    Each argument describes some fields: their type, their names in one text, and, if each field is
    an array, its shape.
    """
    every = ((names.split(), kind, shape) for kind, names, *shape in fields)
    return dtype([(name, kind, *of) for names, kind, of in every for name in names], align=True)


GLUING = _record(
    # The request; the address of the class's rule, or 0; whether the latest decision is possible.
    (int64, "edges limit simple planar rule possible"),
    # The partial map: partner (NONE: open) and vertex of each dart, first darts and degrees.
    (int64, "alpha owner first degree", DARTS),
    (int64, "open darts vertices depth"),
    # By depth: the oldest open dart, its partner, the degree of an added vertex, and the choices
    # that are left: a set of partners, then a range of degrees.
    (int64, "oldest partner added untried degree_next degree_last", DEPTHS),
    # For the rule, by vertices: the set of neighbours, and the number of open darts.
    (int64, "neighbours unmatched", DARTS),
)
"""The state of the enumeration: a partial map, which grows by decisions.

To go on to the next map, the latest decisions are undone, and other decisions are taken.
"""

WORLD = _record(
    # The lighthouse: the number of its place, its dart at v0, what it tells.
    (int64, "darts vertices place pointed told"),
    # By darts: the first dart of the vertex, the dart after the vertex's last dart, the vertex, its
    # degree, sigma, alpha, and the percept on arriving.  By vertices (root): the first dart.
    (int64, "first end owner degree sigma alpha marks bearing root", DARTS),
    # The canonical order of the darts, and the position of each dart in it.  For the compass: the
    # vertices in canonical order, and for each vertex the number of its chosen dart.
    (int64, "order number met choice", DARTS),
)
"""A map with a lighthouse in it."""

PERCEPT = _record((int32, "degree marks bearing"))
ACTION = _record((int32, "kind motion"))
"""``struct allworlds_percept`` and ``allworlds_action`` of the C header."""

ANSWER = _record(
    # Addresses of 32-bit integers.
    (int64, "sigma alpha"),
    (int32, "darts here"),
)
"""An answer, or the S of a checkpoint."""

EXPLORER = _record(
    # The addresses of its functions, and of its state.
    (int64, "start step answer state"),
    # The values that are exchanged with it.
    (PERCEPT, "percept"),
    (ACTION, "action"),
)
"""An explorer with the functions start, step and answer, as a user's explorer in C has them."""

ROBOT = _record(
    # The policy of choices; whether v0 and v1 are distinguished by their degrees.
    (int64, "policy natural"),
    # Its S: sigma, alpha (itself: open), vertex and expected percept of each dart; first
    # dart of each vertex, and the first of its darts that leads nearer to v0.
    (int32, "sigma alpha", LONG),
    (int64, "owner degree marks bearing first home", LONG),
    (int64, "darts vertices"),
    # Its U, in the order in which darts came into S, and its H.
    (int64, "unexplored", LONG),
    (int64, "known"),
    (int64, "hypotheses", LONG),
    (int64, "alike"),
    # Its dart in S, and its turn from the dart of entry.  Its work: the phase, the dart e, the
    # hypothesis under test, a path and the number of its steps that are done, the percept behind e,
    # and the dart that stands for the pointed one.
    (int64, "here turned phase goal partner tried"),
    (int64, "path motions", LONG),
    (int64, "steps done seen_degree seen_marks seen_bearing"),
    (int64, "pointed matched degree_of_v0 degree_of_v1"),
    # Room for walks through S.
    (int64, "length queue", LONG),
    # The number of occurrences of each event, in all episodes.
    (int64, "events", 8),
)
"""The state of Algorithm 1 in a run."""

LOG = _record(
    # The robot's true dart at the end, and the darts of the edges walked, as a set.
    (int64, "checkpoints dart walked cost"),
    # The dart of arrival after each motion.
    (int64, "arrived", LONG),
    # The answer, or the S of a checkpoint.
    (ANSWER, "published"),
)
"""The record of a run: the darts of arrival, and the map that the explorer has shown last."""

FOLD = _record(
    # The number of darts that lead nowhere so far, the robot's node, and the number of nodes.
    (int64, "open node nodes"),
    # By nodes: the set of darts that lead to a node, and the node into which it was merged.
    (int64, "linked parent", FOLDED),
    # By darts, ``DARTS`` for each node: the node to which a dart of that set leads.
    (int64, "link", FOLDED * DARTS),
    (int64, "todo", 2 * LONG),
)
"""The state of a log that is being folded."""

JUDGED = _record(
    # For the checkpoints so far: the set of the laws that they break, whether there was any, and
    # t, the number of unexplored edges, at the latest checkpoint.
    (int64, "broken shown t"),
    # Room for images, for a queue of darts, and for claims.
    (int64, "to queue", LONG),
    (int64, "claim", DARTS),
)
"""The judge's state in a run."""

JOB = _record(
    # The request: the address of the lighthouse, and the set of the checked laws.
    (int64, "lighthouse laws"),
    # The number of the next run, the number from which no world is begun, and whether a bound
    # has no value.
    (int64, "number until undefined"),
    (GLUING, "gluing"),
    (WORLD, "world"),
    (EXPLORER, "explorer"),
    (LOG, "log"),
    (JUDGED, "judged"),
    (FOLD, "fold"),
)
"""The state of the work on a unit, from run to run."""

LIBRARY = _record(
    # The addresses of its functions, its state, the exchanged values, the function for choices.
    (int64, "start step answer choose state percept action here pick"),
    # The addresses of sigma and alpha, and the number of darts for which they have room.
    (int64, "sigma alpha room"),
    # The policy of choices, and whether a choice was illegal.
    (int64, "policy wrong"),
)
"""An explorer in a shared library, with the values that a player exchanges with it."""

READER = _record(
    # The address of the logs, their size, and the beginnings of the runs' logs; the same for the
    # percepts, which are written; the next run, and the number of logs that are not judged here.
    (int64, "logs size begins percepts noted starts run strange"),
    # Room for an answer, or the S of a checkpoint.
    (int32, "sigma alpha", 256),
)
"""A reader of the logs of a batch, which the judge follows instead of calling an explorer."""

WALKED = 80
"""The length of arrays with an item for each dart, vertex or degree, in the demand-driven check.

It is larger than the number of darts of any world, so that a wrong robot stays within the arrays.
"""

NOW = _record(
    # The phase of the walk, and the dart that it is about to cross.
    (uint8, "stage y"),
    # The world W: the set of its open darts, and its numbers of darts and vertices.
    (int64, "open"),
    (uint8, "darts vertices"),
    # The robot's S: its numbers of darts and vertices, U, the set of the vertices of W in it, and
    # packed for each vertex its distance to v0 and the first dart that leads nearer.
    (uint8, "s_darts s_vertices"),
    (int64, "unexplored in_s level parent"),
    (uint8, "position passes"),
    # The pass: the dart e, the dart of W to which e led, the hypotheses that are left, the
    # hypothesis under test, the steps of the test, and the dart in which the next step should end.
    (uint8, "e x"),
    (int64, "hypotheses"),
    (uint8, "candidate steps t"),
    # The cost and the counters of the walk, packed.
    (int64, "total"),
    # Under fifo the fingerprint of S so far, which at the end is the fingerprint of W.
    (int64, "code"),
)
"""The state to which a walk goes back when it decides a dart in another way."""

CHOICE = _record((int64, "untried degree"), (NOW, "now"))
"""A dart that must be decided: the partners and degrees not tried yet, and the walk so far."""

WALK = _record(
    (NOW, "now"),
    (int64, "edges limit policy fuel"),
    (int64, "bound", DARTS),
    (uint8, "viable", (DARTS, 2 * DARTS)),
    # The counts, by vertices.
    (int64, "counts", (DARTS, DEPTHS)),
    # W, by darts: the partner, the vertex, its degree, and the dart after the vertex's last dart.
    (uint8, "partner owner degree end", WALKED),
    # The canonical order of its darts, and the position of each in it.
    (uint8, "order number", WALKED),
    # S, by darts: the partner, the vertex, the expected degree, the image in W.  By vertices: the
    # sets of their darts and of their neighbours.  By degrees: the sets of darts.
    (uint8, "s_partner s_owner s_degree image", WALKED),
    (int64, "own of_degree adjacent", WALKED),
    # The two darts of the edge that each pass has added to S.
    (uint8, "one_end other_end", WALKED),
    # The decisions with choices that are left.
    (int64, "depth"),
    (CHOICE, "choices", WALKED),
    # Room for a world that breaks a law.
    (WORLD, "world"),
)
"""The state of the demand-driven check, with the walk of Algorithm 1 in the current world."""

SCHEDULES = _record(
    (GLUING, "gluing"),
    (WORLD, "world"),
    (int64, "transit"),
    # By darts: the number of the edge, and the largest and the least cost of going on there.
    (int64, "edge_of most least", DARTS),
    # By vertices: the set of neighbours in S, and lengths of paths.  By steps: a path so far.
    (int64, "adjacent near far at robot turned visited", DARTS),
    # Steps until a mismatch; the number of tests, and of those in which a false hypothesis matched.
    (int64, "shortest longest tests wrong"),
)
"""The state of a search of all schedules, which goes from world to world."""


class Kept(NamedTuple):
    """The most expensive runs, and some runs that break a law, each as a row of numbers.

    A row holds in this order: the number of vertices; the canonical code of the rooted map; the
    place; the law's number; and the code of the map without a root, which is the least of its codes
    over all roots.  Rows are compared number by number; the less row comes first.

    ``most_expensive`` has a row for each number of vertices, without the last entry.  ``least`` has
    the first runs that break a law, ascending.  ``row`` has room for one more row.
    """

    # By n, the least of the most expensive runs, without unrooted codes.
    most_expensive: Any
    # The least runs that break a law, ascending; and room for one more row.
    least: Any
    row: Any


def new(kind: Any) -> Any:
    """A new structured array of the type ``kind``, with the value 0 in all fields.

    A page of the array takes memory only once something is written to the page.
    """
    memory = mmap(-1, kind.itemsize, MAP_PRIVATE)
    return frombuffer(memory, kind).view(recarray)[0]


# The columns of the head of a run: its budget, the number that is told, its number in its unit, the
# number of its place, and of a play by percepts the number of motions.
RUN_BUDGET, RUN_TOLD, RUN_NUMBER, RUN_PLACE, RUN_MOTIONS = range(5)
HEAD = 5

# The columns of a laid-out world, for each dart: the first dart of its vertex, its partner, and the
# percept on arriving by it.
FIRST, PARTNER, DEGREE, MARKS, BEARING = range(5)
WIDE = 5

MOST_PLACES = 64
"""A number larger than the number of places of any lighthouse in one map."""

LONGEST_STRETCH = 2048
"""The largest number of runs in a batch, without the runs of its last world."""

MOST_RUNS = LONGEST_STRETCH + MOST_PLACES
"""The largest number of runs in a batch, with the runs of its last world."""

LOG_BYTES = 1 << 20
"""The number of bytes for the logs of a batch, and for its percepts: some 512 bytes a run."""


class Stretch(NamedTuple):
    """Arrays with room for a batch of runs: for their worlds, percepts and logs.

    ``heads`` has the head of each run, and ``worlds`` its world, dart by dart (unused in plays by
    percepts).  ``percepts`` has the percepts of all runs, three bytes each; in ``starts`` is the
    index of the first byte of each run.  ``logs`` has the logs of all runs, and ``begins`` the
    index of the first byte of each log.
    """

    # The head of each run.
    heads: Any
    # The world of each run, dart by dart; unused in plays by percepts.
    worlds: Any
    # The percepts, three bytes each, and the index of the first byte of each run's percepts.
    percepts: Any
    starts: Any
    # The logs, and the index of the first byte of each run's log.
    logs: Any
    begins: Any

    @classmethod
    def of(cls, edges: int) -> Stretch:
        """New arrays for a batch of runs in worlds with this number of edges."""
        heads, worlds = zeros((MOST_RUNS, HEAD), int32), zeros((MOST_RUNS, WIDE * 2 * edges), uint8)
        percepts, logs = (zeros(LOG_BYTES, uint8) for _ in range(2))
        starts, begins = (zeros(MOST_RUNS + 1, int32) for _ in range(2))
        return cls(heads, worlds, percepts, starts, logs, begins)

    def put(self, logs: Logs) -> int:
        """Write logs to the array :attr:`logs`, one after the other; return their size in bytes.

        If the array has no room for the logs, write nothing, and return -1.
        """
        runs, begin = len(logs), logs.starts[0]
        size = len(logs.message) - begin
        if size > LOG_BYTES:
            return -1
        self.begins[:runs] = array("i", logs.starts[:runs])
        self.begins[:runs] -= begin
        self.logs[:size] = memoryview(logs.message)[begin:]
        return size
