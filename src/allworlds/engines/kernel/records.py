"""The records of the compiled judge in memory, field by field.

Every record is one structured array; compiled code reaches its fields by name, and gets a
pointer where a function takes one.  Darts of a vertex are consecutive in a map that has been
glued, and its root is dart 0.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from numpy import dtype, int32, int64, recarray, uint8, zeros

from allworlds.engines.kernel.capabilities import LONG

DARTS = 32
"""Room for the darts of a world, and for its vertices."""

DEPTHS = 16
"""Room for the decisions of a gluing: one for each edge, and the root's degree."""

FOLDED = LONG // 16
"""Room for the nodes of an unfolded log: more than the traversals of the largest budget."""

NONE = -1
"""The entry for no dart, no bearing, no number told."""


def _fields(kind: type, *names: str, of: int | tuple[int, int] = 1) -> list[Any]:
    """Fields of one kind, each so many numbers."""
    return [(name, kind) if of == 1 else (name, kind, of) for name in names]


GLUING = dtype(
    [
        # What is asked for.
        *_fields(int64, "edges", "limit", "simple", "planar"),
        # The address of the class's rule, or 0; what it says of the latest decision.
        *_fields(int64, "rule", "possible"),
        # The partial map: partners (NONE: open), vertices of darts, first darts and degrees.
        *_fields(int64, "alpha", "owner", "first", "degree", of=DARTS),
        *_fields(int64, "open", "darts", "vertices"),
        # By depth: the dart decided about, its partner, the degree of a vertex added, and what
        # is still to be tried: partners as a set, then degrees.
        ("depth", int64),
        *_fields(
            int64, "place", "partner", "added", "untried", "degree_next", "degree_last", of=DEPTHS
        ),
        # Of the rule: by vertices, those joined to each, and its open darts.
        *_fields(int64, "neighbours", "unmatched", of=DARTS),
    ]
)
"""The enumeration: a partial map that grows by decisions and takes them back."""

COUNTING = dtype(
    [
        *_fields(int64, "edges", "limit"),
        # By depth: how many vertices, darts, and faces that have closed; the open darts; what
        # is to be tried: partners as a set, then degrees.
        *_fields(int64, "vertices", "darts", "faces", "opened", "untried", "degrees", of=DEPTHS),
        # By depth: the open darts behind and before each one round its face.
        *_fields(uint8, "after", "before", of=(DEPTHS, DARTS)),
    ]
)
"""A count: the boundaries of a partial map."""

WORLD = dtype(
    [
        *_fields(int64, "darts", "vertices"),
        # The lighthouse: the number of its place, its dart at v0, what it tells.
        *_fields(int64, "place", "pointed", "told"),
        # The first dart of a dart's vertex, the vertex, and the degree there.
        *_fields(int64, "first", "owner", "degree", "sigma", "alpha", of=DARTS),
        # What is sensed on arriving by a dart.
        *_fields(int64, "marks", "bearing", of=DARTS),
        # By vertices: the first dart.
        ("root", int64, DARTS),
        # The canonical order of the darts, and the place of each in it.
        *_fields(int64, "order", "number", of=DARTS),
        # Of the compass: the vertices in that order, and the number of the dart of each.
        *_fields(int64, "met", "choice", of=DARTS),
    ]
)
"""A map with a lighthouse in it."""

PERCEPT = dtype([("degree", int32), ("marks", int32), ("bearing", int32)])
ACTION = dtype([("kind", int32), ("motion", int32)])
"""``struct allworlds_percept`` and ``allworlds_action`` of the C header."""

ANSWER = dtype(
    [
        # Addresses of 32-bit integers.
        *_fields(int64, "sigma", "alpha"),
        *_fields(int32, "darts", "here"),
        # The same as bytes: the address of sigma, and behind it alpha; 0 if there are none.  If
        # there are, the integers need not have been written yet.
        ("bytes", int64),
    ]
)
"""An answer, or the S that is shown."""

EXPLORER = dtype(
    [
        # Addresses: of its functions and of its state.
        *_fields(int64, "start", "step", "answer", "state"),
        # What is handed to and fro.
        ("percept", PERCEPT),
        ("action", ACTION),
    ],
    align=True,
)
"""An explorer behind its C interface."""

ROBOT = dtype(
    [
        # How choices are answered; whether v0 and v1 are told apart by their degrees.
        *_fields(int64, "policy", "natural"),
        # Its S: sigma, alpha (itself: open), vertex and expected percept of each dart; first
        # dart of each vertex, and the first of its darts that leads nearer to v0.
        *_fields(int32, "sigma", "alpha", of=LONG),
        *_fields(int64, "owner", "degree", "marks", "bearing", "first", "home", of=LONG),
        *_fields(int64, "darts", "vertices"),
        # Its U, in the order in which darts came into S, and its H.
        ("unexplored", int64, LONG),
        ("known", int64),
        ("hypotheses", int64, LONG),
        ("alike", int64),
        # Where it stands in S, and how far from the dart of entry it is turned.
        *_fields(int64, "here", "turned"),
        # What it is doing: the dart e explored, the hypothesis tested, a path and how much of
        # it is done, what was sensed behind e, and what stands for the pointed dart.
        *_fields(int64, "phase", "goal", "partner", "tried"),
        *_fields(int64, "path", "motions", of=LONG),
        *_fields(
            int64,
            "steps",
            "done",
            "seen_degree",
            "seen_marks",
            "seen_bearing",
            "pointed",
            "matched",
            "degree_of_v0",
            "degree_of_v1",
        ),
        # Room for walks through S.
        *_fields(int64, "length", "queue", of=LONG),
        # How often each event has occurred, in all episodes.
        ("events", int64, 8),
    ],
    align=True,
)
"""Algorithm 1 on its way."""

LOG = dtype(
    [
        # Whether the checkpoints of this episode are looked at.
        *_fields(int64, "watched", "checkpoints"),
        # The robot's true dart at the end, and the darts of the edges walked, as a set.
        *_fields(int64, "dart", "walked"),
        # The dart arrived by after each motion.
        ("cost", int64),
        ("arrived", int64, LONG),
        # The answer, or the S that is shown.
        ("published", ANSWER),
    ],
    align=True,
)
"""A transcript."""

FOLD = dtype(
    [
        # How many darts lead nowhere; the robot's node, and how many nodes there are.
        *_fields(int64, "open", "node", "nodes"),
        # By nodes: the set of darts that lead somewhere, and the node that it has been merged with.
        *_fields(int64, "linked", "parent", of=FOLDED),
        # By darts, ``DARTS`` for each node: the node that one of that set leads to.
        ("link", int64, FOLDED * DARTS),
        ("todo", int64, 2 * LONG),
    ]
)
"""A log that is being folded."""

JUDGED = dtype(
    [
        # Of the checkpoints so far: the laws that they break, as a set; whether there was one,
        # and t at the last.
        *_fields(int64, "broken", "shown", "t"),
        # The S that was shown last, if it is known how it is embedded: its darts (0: it is not),
        # how many of them lead somewhere, sigma and alpha, and the darts of the world, as a set.
        # The embedding stands in ``to``.
        *_fields(int64, "known", "explored"),
        *_fields(uint8, "sigma", "alpha", of=DARTS),
        ("taken", int64),
        # Room for one that is shown as integers.
        ("bytes", uint8, 3 * DARTS),
        # Room for images, for what is still to be looked at, and for claims.
        *_fields(int64, "to", "queue", of=LONG),
        ("claim", int64, DARTS),
    ]
)
"""The judge's memory of a run on its way."""

JOB = dtype(
    [
        # What is asked for: the address of the lighthouse, and the laws that are checked, as a set.
        *_fields(int64, "lighthouse", "laws"),
        # The number of the next run, and that from which on no other world is begun; whether a run
        # has a bound without a value.
        *_fields(int64, "number", "until", "undefined"),
        ("gluing", GLUING),
        ("world", WORLD),
        ("explorer", EXPLORER),
        ("log", LOG),
        ("judged", JUDGED),
        ("fold", FOLD),
    ],
    align=True,
)
"""A unit of work on its way."""

ASKED = dtype([("policy", int64), ("wrong", int64), ("room", int64)], align=True)
"""How a native explorer's choices are answered, whether one was illegal; darts of its sigma."""

READER = dtype(
    [
        # The logs: where they are, how long they are, and where that of each run begins.
        *_fields(int64, "logs", "size", "begins"),
        # Where the percepts of each run are to be noted: in bytes, and where they begin; and
        # where it is to be noted how far the log of each run goes.
        *_fields(int64, "percepts", "room", "noted", "starts", "ends"),
        # The next run, and how many logs are not to be judged here.
        *_fields(int64, "run", "strange"),
        # Room for an answer, or the S that is shown.
        *_fields(int32, "sigma", "alpha", of=256),
    ],
    align=True,
)
"""An explorer that repeats the logs of another one."""

WALKED = 80
"""Room for more than the darts of a world, so that a robot that errs stays in its buffers."""

NOW = dtype(
    [
        # Where the walk stands, and the dart that it is about to cross.
        *_fields(uint8, "stage", "y"),
        # The world W: its open darts, and how many darts and vertices there are.
        ("open", int64),
        *_fields(uint8, "darts", "vertices"),
        # The robot's S: how many darts and vertices; its U; which vertices of W are in it; for
        # each vertex its distance to v0 and the first dart that leads nearer, packed.
        *_fields(uint8, "s_darts", "s_vertices"),
        *_fields(int64, "unexplored", "in_s", "level", "parent"),
        *_fields(uint8, "position", "passes"),
        # The pass: the dart e, what it led to, the hypotheses left, the one tested, the steps
        # of the test, and the dart in which the next one should end.
        *_fields(uint8, "e", "x"),
        ("hypotheses", int64),
        *_fields(uint8, "candidate", "steps", "t"),
        # The cost and the counters of the walk, packed.
        ("total", int64),
    ],
    align=True,
)
"""The state to which a walk goes back to decide a dart in another way."""

CHOICE = dtype([("untried", int64), ("degree", int64), ("now", NOW)], align=True)
"""A dart that must be decided: partners and degrees to be tried, and the walk up to there."""

WALK = dtype(
    [
        ("now", NOW),
        *_fields(int64, "edges", "limit", "policy", "fuel", "back_weight"),
        ("bound", int64, DARTS),
        ("viable", uint8, (DARTS, 2 * DARTS)),
        ("sensed", uint8, DARTS),
        # What has been met: worlds, and by vertices what they have shown.
        ("worlds", int64),
        ("counts", int64, (DARTS, DEPTHS)),
        # W, by darts: the partner, the vertex, the degree there as it is and as it is sensed,
        # and the dart behind the last one of the vertex.  The degrees of the vertices.
        *_fields(uint8, "partner", "owner", "degree", "felt", "end", "degrees", of=WALKED),
        # S, by darts: the partner, the vertex, the degree that is expected there, the image in
        # W.  By vertices: the darts, and the vertices joined to each.  By degrees: the darts.
        *_fields(uint8, "s_partner", "s_owner", "s_degree", "image", of=WALKED),
        *_fields(int64, "own", "of_degree", "adjacent", of=WALKED),
        # The two ends of the edge that each pass has added to S.
        *_fields(uint8, "one_end", "other_end", of=WALKED),
        # The decisions that can still be taken otherwise.
        ("depth", int64),
        ("choices", CHOICE, WALKED),
        # Room for a world that is to be blamed.
        ("world", WORLD),
    ],
    align=True,
)
"""Algorithm 1 on its way through all worlds at once."""

SCHEDULES = dtype(
    [
        ("gluing", GLUING),
        ("world", WORLD),
        ("transit", int64),
        # By darts: the number of the edge; the most expensive and the cheapest way to go on.
        *_fields(int64, "edge_of", "most", "least", of=DARTS),
        # By vertices: those joined in S, and lengths of paths.
        *_fields(int64, "adjacent", "near", "far", of=DARTS),
        # A path on its way, and its ends: steps until a mismatch.
        *_fields(int64, "at", "robot", "turned", "visited", of=DARTS),
        *_fields(int64, "shortest", "longest"),
        # Different tests, and those of a false hypothesis that matched.
        *_fields(int64, "tests", "wrong"),
    ],
    align=True,
)
"""All schedules in one world after the other."""


class Kept(NamedTuple):
    """Runs that are kept, as rows: n, the code, the place, the law's number, the unrooted code.

    Attributes:
        most_expensive: by n, the least of the runs that cost most; without an unrooted code.
        least: the least runs that break a law, ascending.
        row: room for one of these.
        listed: room for something about each run, as far as it goes.
    """

    most_expensive: Any
    least: Any
    row: Any
    listed: Any


def new(kind: Any) -> Any:
    """A record of the kind, all zero."""
    return zeros(1, kind).view(recarray)[0]
