"""The records of a tree of runs: of a world that is decided on demand, and of the judge."""

from __future__ import annotations

from numpy import dtype, int64, uint8

from allworlds.engines.kernel.records import DARTS, DEPTHS, FOLD, GLUING, JUDGED, WORLD

BRANCHES = DEPTHS + 1
"""Room for the darts that can be decided in several ways: fewer than there are edges."""

PATH_BYTES = 1 << 16
"""Room for the log of one run."""

BRANCH = dtype(
    [
        # The dart that is decided, and the ways that are left: partners as a set, then degrees.
        ("y", int64),
        ("untried", int64),
        ("degree", int64),
        # The way that is taken, as a decision of the enumeration.
        ("way", int64),
        # The world before: its open darts, how many darts, vertices, decisions and branches.
        ("open", int64),
        ("darts", int64),
        ("vertices", int64),
        ("decisions", int64),
        ("ways", int64),
        # The run up to there: traversals and checkpoints.
        ("cost", int64),
        ("shown", int64),
    ],
    align=True,
)
"""A dart that can still be decided in another way."""

DEMAND = dtype(
    [
        ("gluing", GLUING),
        ("world", WORLD),
        # The kind of the lighthouse, one of those of ``on_demand``, and the number of its place.
        ("kind", int64),
        ("place", int64),
        # The largest number of traversals that is legal however the world is decided, and whether
        # all of it has been.
        ("budget", int64),
        ("whole", int64),
        # The run on its way: traversals and checkpoints.
        ("cost", int64),
        ("shown", int64),
        # The branches that have ways left.
        ("depth", int64),
        ("branches", BRANCH, BRANCHES),
        # The way taken at each branch from the start on, as decisions of the enumeration; and how
        # many ways from the start are given.
        ("ways", int64),
        ("path", int64, BRANCHES),
        ("given", int64),
    ],
    align=True,
)
"""A world that is decided where the robot looks."""

HEARD = dtype(
    [
        # The robot's dart, and the darts of the edges walked, as a set.
        ("dart", int64),
        ("walked", int64),
        # The folded log: open darts, the robot's node, nodes and changes.
        ("open", int64),
        ("node", int64),
        ("nodes", int64),
        ("changes", int64),
        # The checkpoints so far; see JUDGED.
        ("broken", int64),
        ("shown", int64),
        ("t", int64),
        ("anew", int64),
        ("known", int64),
        ("explored", int64),
        ("taken", int64),
        ("alpha", uint8, DARTS),
        # The segment that ends there.
        ("segment", int64),
    ],
    align=True,
)
"""A run up to a branch, as its judge knows it."""

HEARING = dtype(
    [
        ("demand", DEMAND),
        ("branches", HEARD, BRANCHES),
        ("judged", JUDGED),
        ("fold", FOLD),
        # The run on its way, as above.
        ("dart", int64),
        ("walked", int64),
        ("segment", int64),
        # The parts of its log in that of the chunk: from the start to the first branch, and so on.
        ("begins", int64, BRANCHES + 1),
        ("ends", int64, BRANCHES + 1),
        # Its log in one piece, where that is needed.
        ("bytes", int64),
        ("log", uint8, PATH_BYTES),
        # Of the chunk: runs, segments, bytes of percepts, and trees of segments; whether
        # it cannot be judged here, and whether a run has a bound without a value.
        ("runs", int64),
        ("segments", int64),
        ("noted", int64),
        ("rooted", int64),
        ("strange", int64),
        ("undefined", int64),
        # The first segments of these trees.
        ("roots", int64, DARTS),
        # State of the generator from which the order of segments is drawn.
        ("random", int64),
    ],
    align=True,
)
"""The judge of a tree of runs, on its way."""
