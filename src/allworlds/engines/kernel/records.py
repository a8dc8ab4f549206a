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

GLUING = dtype(
    [
        # What is asked for.
        ("edges", int64),
        ("limit", int64),
        ("simple", int64),
        ("planar", int64),
        # The address of the class's rule, or 0; what it says of the latest decision.
        ("rule", int64),
        ("possible", int64),
        # The partial map: partners (NONE: open), vertices of darts, first darts and degrees.
        ("alpha", int64, DARTS),
        ("owner", int64, DARTS),
        ("first", int64, DARTS),
        ("degree", int64, DARTS),
        ("open", int64),
        ("darts", int64),
        ("vertices", int64),
        # By depth: the dart decided about, its partner, the degree of a vertex added, and what
        # is still to be tried: partners as a set, then degrees.
        ("depth", int64),
        ("place", int64, DEPTHS),
        ("partner", int64, DEPTHS),
        ("added", int64, DEPTHS),
        ("untried", int64, DEPTHS),
        ("degree_next", int64, DEPTHS),
        ("degree_last", int64, DEPTHS),
        # Of the rule: by vertices, those joined to each, and its open darts.
        ("neighbours", int64, DARTS),
        ("unmatched", int64, DARTS),
    ]
)
"""The enumeration: a partial map that grows by decisions and takes them back."""

COUNTING = dtype(
    [
        ("edges", int64),
        ("limit", int64),
        # By depth: how many vertices, darts, and faces that have closed; the open darts; what
        # is to be tried: partners as a set, then degrees.
        ("vertices", int64, DEPTHS),
        ("darts", int64, DEPTHS),
        ("faces", int64, DEPTHS),
        ("opened", int64, DEPTHS),
        ("untried", int64, DEPTHS),
        ("degrees", int64, DEPTHS),
        # By depth: the open darts behind and before each one round its face.
        ("after", uint8, (DEPTHS, DARTS)),
        ("before", uint8, (DEPTHS, DARTS)),
    ]
)
"""A count: the boundaries of a partial map."""

WORLD = dtype(
    [
        ("darts", int64),
        ("vertices", int64),
        # The lighthouse: the number of its place, its dart at v0, what it tells.
        ("place", int64),
        ("pointed", int64),
        ("told", int64),
        # The first dart of a dart's vertex, the vertex, and the degree there.
        ("first", int64, DARTS),
        ("owner", int64, DARTS),
        ("degree", int64, DARTS),
        ("sigma", int64, DARTS),
        ("alpha", int64, DARTS),
        # What is sensed on arriving by a dart.
        ("marks", int64, DARTS),
        ("bearing", int64, DARTS),
        # By vertices: the first dart.
        ("root", int64, DARTS),
        # The canonical order of the darts, and the place of each in it.
        ("order", int64, DARTS),
        ("number", int64, DARTS),
        # Of the compass: the vertices in that order, and the number of the dart of each.
        ("met", int64, DARTS),
        ("choice", int64, DARTS),
    ]
)
"""A map with a lighthouse in it."""

PERCEPT = dtype([("degree", int32), ("marks", int32), ("bearing", int32)])
ACTION = dtype([("kind", int32), ("motion", int32)])
"""``struct allworlds_percept`` and ``allworlds_action`` of the C header."""

ANSWER = dtype(
    [
        # Addresses of 32-bit integers.
        ("sigma", int64),
        ("alpha", int64),
        ("darts", int32),
        ("here", int32),
        # The same as bytes: the address of sigma, and behind it alpha; 0 if there are none.  If
        # there are, the integers need not have been written yet.
        ("bytes", int64),
    ]
)
"""An answer, or the S that is shown."""

EXPLORER = dtype(
    [
        # Addresses: of its functions and of its state.
        ("start", int64),
        ("step", int64),
        ("answer", int64),
        ("state", int64),
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
        ("policy", int64),
        ("natural", int64),
        # Its S: sigma, alpha (itself: open), vertex and expected percept of each dart; first
        # dart of each vertex, and the first of its darts that leads nearer to v0.
        ("sigma", int32, LONG),
        ("alpha", int32, LONG),
        ("owner", int64, LONG),
        ("degree", int64, LONG),
        ("marks", int64, LONG),
        ("bearing", int64, LONG),
        ("first", int64, LONG),
        ("home", int64, LONG),
        ("darts", int64),
        ("vertices", int64),
        # Its U, in the order in which darts came into S, and its H.
        ("unexplored", int64, LONG),
        ("known", int64),
        ("hypotheses", int64, LONG),
        ("alike", int64),
        # Where it stands in S, and how far from the dart of entry it is turned.
        ("here", int64),
        ("turned", int64),
        # What it is doing: the dart e explored, the hypothesis tested, a path and how much of
        # it is done, what was sensed behind e, and what stands for the pointed dart.
        ("phase", int64),
        ("goal", int64),
        ("partner", int64),
        ("tried", int64),
        ("path", int64, LONG),
        ("motions", int64, LONG),
        ("steps", int64),
        ("done", int64),
        ("seen_degree", int64),
        ("seen_marks", int64),
        ("seen_bearing", int64),
        ("pointed", int64),
        ("matched", int64),
        ("degree_of_v0", int64),
        ("degree_of_v1", int64),
        # Room for walks through S.
        ("length", int64, LONG),
        ("queue", int64, LONG),
        # How often each event has occurred, in all episodes.
        ("events", int64, 8),
    ],
    align=True,
)
"""Algorithm 1 on its way."""

LOG = dtype(
    [
        # Whether the checkpoints of this episode are looked at.
        ("watched", int64),
        ("checkpoints", int64),
        # The robot's true dart at the end, and the darts of the edges walked, as a set.
        ("dart", int64),
        ("walked", int64),
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
        ("open", int64),
        ("node", int64),
        ("nodes", int64),
        # By nodes: the set of darts that lead somewhere, and the node that it has been merged with.
        ("linked", int64, FOLDED),
        ("parent", int64, FOLDED),
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
        ("broken", int64),
        ("shown", int64),
        ("t", int64),
        # The S that was shown last, if it is known how it is embedded: its darts (0: it is not),
        # how many of them lead somewhere, sigma and alpha, and the darts of the world, as a set.
        # The embedding stands in ``to``.
        ("known", int64),
        ("explored", int64),
        ("sigma", uint8, DARTS),
        ("alpha", uint8, DARTS),
        ("taken", int64),
        # Room for one that is shown as integers.
        ("bytes", uint8, 3 * DARTS),
        # Room for images, for what is still to be looked at, and for claims.
        ("to", int64, LONG),
        ("queue", int64, LONG),
        ("claim", int64, DARTS),
    ]
)
"""The judge's memory of a run on its way."""

JOB = dtype(
    [
        # What is asked for: the address of the lighthouse, and the laws that are checked, as a set.
        ("lighthouse", int64),
        ("laws", int64),
        # The number of the next run, and that from which on no other world is begun; whether a run
        # has a bound without a value.
        ("number", int64),
        ("until", int64),
        ("undefined", int64),
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
        ("logs", int64),
        ("size", int64),
        ("begins", int64),
        # Where the percepts of each run are to be noted: in bytes, and where they begin; and
        # where it is to be noted how far the log of each run goes.
        ("percepts", int64),
        ("room", int64),
        ("noted", int64),
        ("starts", int64),
        ("ends", int64),
        # The next run, and how many logs are not to be judged here.
        ("run", int64),
        ("strange", int64),
        # Room for an answer, or the S that is shown.
        ("sigma", int32, 256),
        ("alpha", int32, 256),
    ],
    align=True,
)
"""An explorer that repeats the logs of another one."""

WALKED = 80
"""Room for more than the darts of a world, so that a robot that errs stays in its buffers."""

NOW = dtype(
    [
        # Where the walk stands, and the dart that it is about to cross.
        ("stage", uint8),
        ("y", uint8),
        # The world W: its open darts, and how many darts and vertices there are.
        ("open", int64),
        ("darts", uint8),
        ("vertices", uint8),
        # The robot's S: how many darts and vertices; its U; which vertices of W are in it; for
        # each vertex its distance to v0 and the first dart that leads nearer, packed.
        ("s_darts", uint8),
        ("s_vertices", uint8),
        ("unexplored", int64),
        ("in_s", int64),
        ("level", int64),
        ("parent", int64),
        ("position", uint8),
        ("passes", uint8),
        # The pass: the dart e, what it led to, the hypotheses left, the one tested, the steps
        # of the test, and the dart in which the next one should end.
        ("e", uint8),
        ("x", uint8),
        ("hypotheses", int64),
        ("candidate", uint8),
        ("steps", uint8),
        ("t", uint8),
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
        ("edges", int64),
        ("limit", int64),
        ("policy", int64),
        ("fuel", int64),
        ("back_weight", int64),
        ("bound", int64, DARTS),
        ("viable", uint8, (DARTS, 2 * DARTS)),
        ("sensed", uint8, DARTS),
        # What has been met: worlds, and by vertices what they have shown.
        ("worlds", int64),
        ("counts", int64, (DARTS, DEPTHS)),
        # W, by darts: the partner, the vertex, the degree there as it is and as it is sensed,
        # and the dart behind the last one of the vertex.  The degrees of the vertices.
        ("partner", uint8, WALKED),
        ("owner", uint8, WALKED),
        ("degree", uint8, WALKED),
        ("felt", uint8, WALKED),
        ("end", uint8, WALKED),
        ("degrees", uint8, WALKED),
        # S, by darts: the partner, the vertex, the degree that is expected there, the image in
        # W.  By vertices: the darts, and the vertices joined to each.  By degrees: the darts.
        ("s_partner", uint8, WALKED),
        ("s_owner", uint8, WALKED),
        ("s_degree", uint8, WALKED),
        ("image", uint8, WALKED),
        ("own", int64, WALKED),
        ("of_degree", int64, WALKED),
        ("adjacent", int64, WALKED),
        # The two ends of the edge that each pass has added to S.
        ("one_end", uint8, WALKED),
        ("other_end", uint8, WALKED),
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
        ("edge_of", int64, DARTS),
        ("most", int64, DARTS),
        ("least", int64, DARTS),
        # By vertices: those joined in S, and lengths of paths.
        ("adjacent", int64, DARTS),
        ("near", int64, DARTS),
        ("far", int64, DARTS),
        # A path on its way, and its ends: steps until a mismatch.
        ("at", int64, DARTS),
        ("robot", int64, DARTS),
        ("turned", int64, DARTS),
        ("visited", int64, DARTS),
        ("shortest", int64),
        ("longest", int64),
        # Different tests, and those of a false hypothesis that matched.
        ("tests", int64),
        ("wrong", int64),
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
