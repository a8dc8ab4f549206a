"""The names of small numbers that several engines use."""

FIFO, LIFO, NEAREST = range(3)

POLICIES = {"fifo": FIFO, "lifo": LIFO, "nearest": NEAREST}

# What an explorer does next; see allworlds.h.
MOVE, DROP, PICK, CHECKPOINT, ANSWER_READY, AMBIGUOUS = range(1, 7)

# The events of Algorithm 1, as an explorer counts them.
CASE_1, CASE_2, CASE_3, AT_V0, EMPTY_H, LOOP, NON_LOOP = range(7)
EVENTS = ("case-1", "case-2", "case-3", "v0-hypothesis", "empty-H", "loop", "non-loop")

LANES = 16
"""The number of entries that are turned into bytes, or back, at a time."""
