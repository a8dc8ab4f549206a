"""The names and numbers that the kernel knows, and the largest sizes for which it has room.

This module loads no compiled code, so that a process can read the names without loading the kernel.
"""

EXPLORERS = ("algorithm1", "algorithm1-cluster", "algorithm1-natural")
"""The built-in explorers that are compiled."""

LIGHTHOUSES = frozenset(
    {"none", "position", "directional", "door", "compass", "cluster", "cluster-single", "natural"}
)
"""The names of the kinds of lighthouses.  A new kind needs an entry here and a function in
``worlds`` of the same name, with ``_`` for ``-``."""

CHECKED = frozenset({"map", "pose", "invariant-1", "invariant-2", "variant", "folding", "bound"})
"""The laws that a user can choose and that the compiled judge checks."""

FIFO, LIFO, NEAREST = range(3)

POLICIES = {"fifo": FIFO, "lifo": LIFO, "nearest": NEAREST}

# What an explorer does next; see allworlds.h.
MOVE, DROP, PICK, CHECKPOINT, ANSWER_READY, AMBIGUOUS = range(1, 7)

# The events of Algorithm 1, as an explorer counts them.
CASE_1, CASE_2, CASE_3, AT_V0, EMPTY_H, LOOP, NON_LOOP = range(7)
EVENTS = ("case-1", "case-2", "case-3", "v0-hypothesis", "empty-H", "loop", "non-loop")

MOST_EDGES = 12
"""The largest number of edges for which all packed numbers fit into their bits."""

LONG = 1 << 18
"""The length of each array that grows with a walk: of the darts of an explorer's map, or of a log
before it is folded.  So the number of a world's darts, times its budget, must be smaller."""

MOST_BUDGET = LONG // (2 * MOST_EDGES) - 2
"""The largest number of traversals for which a run has room."""

COMPILING = "compiling the kernel; this is done once and takes some seconds"
"""The notice to the user before the kernel is compiled for the first time."""
