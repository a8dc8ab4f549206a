"""The requests to the engines and their results, and the structured arrays of compiled code.

Requests and results are plain numbers.  A structured array lies in memory field by field, beside
the memory of a batch of runs.  Compiled code reaches its fields by name, and gets a pointer to it
where a function takes one.  In a map that has been glued the darts of a vertex are consecutive, and
the root is dart 0.
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
    """The common data of all units of a level.

    Attributes:
        edges: m, at most MOST_EDGES.
        limit: the largest number of vertices, at most m + 1.
        simple, planar: the class.
        explorer: one of :data:`allworlds.engines.kernel.capabilities.EXPLORERS`.
        lighthouse: one of :data:`allworlds.engines.kernel.capabilities.LIGHTHOUSES`.
        policy: ``fifo``, ``lifo`` or ``nearest``.
        laws: the checked ones; those before ``map`` always are.
        bounds: the largest legal costs by vertices, degree of v0 and largest degree; the latter two
            have one entry where the bound does not depend on them.
        budgets: the largest number of traversals, by vertices from 0 on; at most MOST_BUDGET.
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
    """The counts of the worlds of one size.

    Attributes:
        vertices: n.
        worlds: rooted maps.
        runs: worlds x places.
        traversals: summed over the runs.
        traversals_rooted: summed over the first place of each rooted map only.
        largest: the largest cost of a run.
        checkpoints: the number of published ones.
        left_out: worlds without a place for the lighthouse.
        loops, parallels: worlds with a loop, and with two edges that have the same two ends.
        fingerprint: those of the worlds, summed modulo 2^62.
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
    """A run, in canonical numbering.

    Attributes:
        vertices: n.
        sigma, alpha: the map, rooted at dart 0.
        place: the number of the lighthouse's place.
    """

    vertices: int
    sigma: tuple[int, ...]
    alpha: tuple[int, ...]
    place: int


class BrokenRun(Struct, frozen=True):
    """A run that breaks a law, in canonical numbering, as :class:`At`.

    Attributes:
        place: None for every place.
        law: the law's name; empty if the engine does not tell laws apart.
    """

    vertices: int
    sigma: tuple[int, ...]
    alpha: tuple[int, ...]
    place: int | None
    law: str


class Sums(Struct, frozen=True):
    """The outcome of a piece of work.

    Attributes:
        counts: for each number of vertices that occurs.
        events: the number of occurrences of each event of Algorithm 1.
        met: (n, d0, D) for all runs, with 0 for numbers on which the bound does not depend.
        most_expensive: for each number of vertices the least of the runs that cost most.
        broken: the least runs that break a law, ascending.
    """

    counts: tuple[Counts, ...]
    events: dict[str, int]
    met: tuple[tuple[int, int, int], ...]
    most_expensive: tuple[At, ...]
    broken: tuple[BrokenRun, ...]


DARTS = 32
"""Room for the darts of a world, and for its vertices."""

DEPTHS = 16
"""Room for the decisions of a gluing: one for each edge, and the root's degree."""

FOLDED = LONG // 16
"""Room for the nodes of an unfolded log: more than the traversals of the largest budget."""

NONE = -1
"""The entry for no dart, no bearing, no number told."""


def _record(*fields: tuple[Any, ...]) -> Any:
    """The record of these fields: of each group the kind, its names, and perhaps the shape."""
    every = ((names.split(), kind, shape) for kind, names, *shape in fields)
    return dtype([(name, kind, *of) for names, kind, of in every for name in names], align=True)


GLUING = _record(
    # What is asked for; the address of the class's rule, or 0; what that says of the last decision.
    (int64, "edges limit simple planar rule possible"),
    # The partial map: partners (NONE: open), vertices of darts, first darts and degrees.
    (int64, "alpha owner first degree", DARTS),
    (int64, "open darts vertices depth"),
    # By depth: the dart decided about, its partner, the degree of a vertex added, and what
    # is still to be tried: partners as a set, then degrees.
    (int64, "oldest partner added untried degree_next degree_last", DEPTHS),
    # Of the rule: by vertices, those joined to each, and its open darts.
    (int64, "neighbours unmatched", DARTS),
)
"""The enumeration: a partial map that grows by decisions and takes them back."""

WORLD = _record(
    # The lighthouse: the number of its place, its dart at v0, what it tells.
    (int64, "darts vertices place pointed told"),
    # By darts: the first dart of the vertex, the one behind its last, the vertex, and the degree
    # there; what is sensed on arriving.  By vertices: the first dart.
    (int64, "first end owner degree sigma alpha marks bearing root", DARTS),
    # The canonical order of the darts, and the place of each in it.  Of the compass: the vertices
    # in that order, and the number of the dart of each.
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
"""An answer, or the S that is shown."""

EXPLORER = _record(
    # Addresses: of its functions and of its state.
    (int64, "start step answer state"),
    # What is handed to and fro.
    (PERCEPT, "percept"),
    (ACTION, "action"),
)
"""An explorer behind its C interface."""

ROBOT = _record(
    # How choices are answered; whether v0 and v1 are told apart by their degrees.
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
    # Where it stands in S, and how far from the dart of entry it is turned.  What it is doing: the
    # dart e explored, the hypothesis tested, a path and how much of it is done, what was sensed
    # behind e, and what stands for the pointed dart.
    (int64, "here turned phase goal partner tried"),
    (int64, "path motions", LONG),
    (int64, "steps done seen_degree seen_marks seen_bearing"),
    (int64, "pointed matched degree_of_v0 degree_of_v1"),
    # Room for walks through S.
    (int64, "length queue", LONG),
    # How often each event has occurred, in all episodes.
    (int64, "events", 8),
)
"""Algorithm 1 on its way."""

LOG = _record(
    # The robot's true dart at the end, and the darts of the edges walked, as a set.
    (int64, "checkpoints dart walked cost"),
    # The dart arrived by after each motion.
    (int64, "arrived", LONG),
    # The answer, or the S that is shown.
    (ANSWER, "published"),
)
"""A transcript."""

FOLD = _record(
    # How many darts lead nowhere; the robot's node, and how many nodes there are.
    (int64, "open node nodes"),
    # By nodes: the set of darts that lead somewhere, and the node that it has been merged with.
    (int64, "linked parent", FOLDED),
    # By darts, ``DARTS`` for each node: the node that one of that set leads to.
    (int64, "link", FOLDED * DARTS),
    (int64, "todo", 2 * LONG),
)
"""A log that is being folded."""

JUDGED = _record(
    # Of the checkpoints so far: the laws that they break, as a set; whether there was one,
    # and t at the last.
    (int64, "broken shown t"),
    # Room for images, for what is still to be looked at, and for claims.
    (int64, "to queue", LONG),
    (int64, "claim", DARTS),
)
"""The judge's memory of a run on its way."""

JOB = _record(
    # What is asked for: the address of the lighthouse, and the laws that are checked, as a set.
    (int64, "lighthouse laws"),
    # The next run, the one from which on no world is begun; whether a bound has no value.
    (int64, "number until undefined"),
    (GLUING, "gluing"),
    (WORLD, "world"),
    (EXPLORER, "explorer"),
    (LOG, "log"),
    (JUDGED, "judged"),
    (FOLD, "fold"),
)
"""A unit of work on its way."""

LIBRARY = _record(
    # Addresses: of its functions, its state, what is exchanged, and what answers its choices.
    (int64, "start step answer choose state percept action here pick"),
    # Sigma and alpha, and how many darts they hold.
    (int64, "sigma alpha room"),
    # How choices are answered, and whether one was illegal.
    (int64, "policy wrong"),
)
"""A native explorer, as a player calls it."""

READER = _record(
    # Where the logs are, how many bytes, and where that of each run begins; the same of the
    # percepts, which are noted; the next run, and how many logs are not to be judged here.
    (int64, "logs size begins percepts noted starts run strange"),
    # Room for an answer, or the S that is shown.
    (int32, "sigma alpha", 256),
)
"""An explorer that repeats the logs of another one."""

WALKED = 80
"""Room for more than the darts of a world, so that a robot that errs stays in its buffers."""

NOW = _record(
    # Where the walk stands, and the dart that it is about to cross.
    (uint8, "stage y"),
    # The world W: its open darts, and how many darts and vertices there are.
    (int64, "open"),
    (uint8, "darts vertices"),
    # The robot's S: how many darts and vertices; its U; which vertices of W are in it; for
    # each vertex its distance to v0 and the first dart that leads nearer, packed.
    (uint8, "s_darts s_vertices"),
    (int64, "unexplored in_s level parent"),
    (uint8, "position passes"),
    # The pass: the dart e, what it led to, the hypotheses left, the one tested, the steps
    # of the test, and the dart in which the next one should end.
    (uint8, "e x"),
    (int64, "hypotheses"),
    (uint8, "candidate steps t"),
    # The cost and the counters of the walk, packed.
    (int64, "total"),
    # Under fifo the fingerprint of S, as far as it is known: at the end that of W.
    (int64, "code"),
)
"""The state to which a walk goes back to decide a dart in another way."""

CHOICE = _record((int64, "untried degree"), (NOW, "now"))
"""A dart that must be decided: partners and degrees to be tried, and the walk up to there."""

WALK = _record(
    (NOW, "now"),
    (int64, "edges limit policy fuel"),
    (int64, "bound", DARTS),
    (uint8, "viable", (DARTS, 2 * DARTS)),
    # What has been met, by vertices.
    (int64, "counts", (DARTS, DEPTHS)),
    # W, by darts: the partner, the vertex, the degree there, and the dart behind the last one of
    # the vertex.
    (uint8, "partner owner degree end", WALKED),
    # The canonical order of its darts, and the place of each in it.
    (uint8, "order number", WALKED),
    # S, by darts: the partner, the vertex, the degree that is expected there, the image in
    # W.  By vertices: the darts, and the vertices joined to each.  By degrees: the darts.
    (uint8, "s_partner s_owner s_degree image", WALKED),
    (int64, "own of_degree adjacent", WALKED),
    # The two ends of the edge that each pass has added to S.
    (uint8, "one_end other_end", WALKED),
    # The decisions that can still be taken otherwise.
    (int64, "depth"),
    (CHOICE, "choices", WALKED),
    # Room for a world that is to be blamed.
    (WORLD, "world"),
)
"""Algorithm 1 on its way through all worlds at once."""

SCHEDULES = _record(
    (GLUING, "gluing"),
    (WORLD, "world"),
    (int64, "transit"),
    # By darts: the number of the edge; the most expensive and the cheapest way to go on.
    (int64, "edge_of most least", DARTS),
    # By vertices: those joined in S, and lengths of paths.  A path on its way.
    (int64, "adjacent near far at robot turned visited", DARTS),
    # Steps until a mismatch; different tests, and those of a false hypothesis that matched.
    (int64, "shortest longest tests wrong"),
)
"""All schedules in one world after the other."""


class Kept(NamedTuple):
    """Runs that are kept, as rows: n, the code, the place, the law's number, the unrooted code."""

    # By n, the least of the runs that cost most; without an unrooted code.
    most_expensive: Any
    # The least runs that break a law, ascending; room for one of them.
    least: Any
    row: Any


def new(kind: Any) -> Any:
    """A structured array of this kind, all zero; only the pages that are written to take memory."""
    memory = mmap(-1, kind.itemsize, MAP_PRIVATE)
    return frombuffer(memory, kind).view(recarray)[0]


# The columns of the head of a run: its budget, the number that is told, its number in its unit, the
# number of its place, and of a play by percepts the number of motions.
RUN_BUDGET, RUN_TOLD, RUN_NUMBER, RUN_PLACE, RUN_MOTIONS = range(5)
HEAD = 5

# The columns of a laid-out world, for each dart: the first dart of its vertex, its partner, and
# what is sensed on arriving by it.
FIRST, PARTNER, DEGREE, MARKS, BEARING = range(5)
WIDE = 5

MOST_PLACES = 64
"""A number above that of a lighthouse's places in one map."""

LONGEST_STRETCH = 2048
"""The largest number of runs in a batch, but for those of its last world."""

MOST_RUNS = LONGEST_STRETCH + MOST_PLACES
"""Room for the runs of a batch, and of its last world."""

LOG_BYTES = 1 << 20
"""Room for the logs of a batch, and as much for its percepts: 512 bytes a run."""


class Stretch(NamedTuple):
    """Memory for a batch of runs."""

    # The head of each run.
    heads: Any
    # The world of each run, dart by dart; unused in plays by percepts.
    worlds: Any
    # The percepts, three bytes each, and the first byte of each run's.
    percepts: Any
    starts: Any
    # The logs, and the first byte of each run's.
    logs: Any
    begins: Any

    @classmethod
    def of(cls, edges: int) -> Stretch:
        """Memory for worlds with so many edges."""
        heads, worlds = zeros((MOST_RUNS, HEAD), int32), zeros((MOST_RUNS, WIDE * 2 * edges), uint8)
        percepts, logs = (zeros(LOG_BYTES, uint8) for _ in range(2))
        starts, begins = (zeros(MOST_RUNS + 1, int32) for _ in range(2))
        return cls(heads, worlds, percepts, starts, logs, begins)

    def put(self, logs: Logs) -> int:
        """Write logs, in one piece, here; return the number of bytes, or -1 if there is no room."""
        runs, begin = len(logs), logs.starts[0]
        size = len(logs.message) - begin
        if size > LOG_BYTES:
            return -1
        self.begins[:runs] = array("i", logs.starts[:runs])
        self.begins[:runs] -= begin
        self.logs[:size] = memoryview(logs.message)[begin:]
        return size
