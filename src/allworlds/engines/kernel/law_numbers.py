"""The laws by number, in their order of precedence."""

from allworlds.judging import PRECEDENCE

LAWS = ("", *PRECEDENCE)
"""The laws by their numbers; 0: none is broken."""

ILLEGAL_ACTION = LAWS.index("illegal-action")
NO_ESTIMATE = LAWS.index("no-estimate")
BUDGET = LAWS.index("budget")
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
