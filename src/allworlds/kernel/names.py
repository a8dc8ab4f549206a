"""The names of small numbers that several engines use."""

FIFO, LIFO, NEAREST = range(3)

POLICIES = {"fifo": FIFO, "lifo": LIFO, "nearest": NEAREST}

# The columns of the counts by vertices.
(
    WORLDS,
    TRAVERSALS,
    LARGEST,
    CASE_1,
    CASE_2,
    AT_V0,
    EMPTY_H,
    LOOP_EDGE,
    PARALLEL_EDGE,
    BROKEN,
    FAILED,
) = range(11)
COLUMNS = 11
