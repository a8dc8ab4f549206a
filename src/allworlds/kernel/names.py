"""The names of small numbers that several engines use."""

from allworlds.judge import PRECEDENCE

FIFO, LIFO, NEAREST = range(3)

POLICIES = {"fifo": FIFO, "lifo": LIFO, "nearest": NEAREST}

# What an explorer does next; see allworlds.h.
MOVE, DROP, PICK, CHECKPOINT, ANSWER_READY = range(1, 6)

# The events of Algorithm 1, as an explorer counts them.
CASE_1, CASE_2, CASE_3, AT_V0, EMPTY_H, LOOP, NON_LOOP = range(7)
EVENTS = ("case-1", "case-2", "case-3", "v0-hypothesis", "empty-H", "loop", "non-loop")

LAWS = ("", *PRECEDENCE)
"""The laws by their numbers; 0: none is broken."""

ILLEGAL_ACTION = LAWS.index("illegal-action")
NO_ESTIMATE = LAWS.index("no-estimate")
BUDGET = LAWS.index("budget")
NONDETERMINISTIC = LAWS.index("nondeterministic")
MAP = LAWS.index("map")
POSE = LAWS.index("pose")
INVARIANT_1 = LAWS.index("invariant-1")
INVARIANT_2 = LAWS.index("invariant-2")
VARIANT = LAWS.index("variant")
FOLDING = LAWS.index("folding")
BOUND = LAWS.index("bound")

CHECKED = frozenset(
    LAWS[law] for law in (MAP, POSE, INVARIANT_1, INVARIANT_2, VARIANT, FOLDING, BOUND)
)
"""The laws that can be chosen, and that the judge checks."""
