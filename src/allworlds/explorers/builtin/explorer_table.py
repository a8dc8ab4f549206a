"""**The** table of the built-in explorers: the lighthouse of each, its witnesses and its bound.

The modules:

``algorithm1``
    Algorithm 1 of the paper, and its variants without a direction;
``scanning``
    Algorithm 1 for a robot that senses at v0 only one letter, which depends on the bearing;
``folding``
    the folded log, which is one map of all percepts of a run; explorers that use this log alone;
    the shield, which makes any explorer right;
``quotient``
    an explorer whose marker at v0 has no direction; it learns the quotient by experiments;
``baselines``
    one movable marker; depth-first search with a number at each vertex;
``elsewhere``
    an explorer for robots that do not start at v0.
"""

from collections.abc import Callable, Mapping
from typing import Any, TypeAlias

from msgspec import Struct, field

from allworlds.explorers.builtin.algorithm1 import (
    algorithm1,
    algorithm1_cluster,
    algorithm1_natural,
)
from allworlds.explorers.builtin.baselines import dfs, dudek91
from allworlds.explorers.builtin.folding import folding, folding_oldest
from allworlds.explorers.builtin.quotient import quotient
from allworlds.explorers.builtin.scanning import algorithm1_door, algorithm1_word

Explore: TypeAlias = Callable[..., Any]

SizePair: TypeAlias = tuple[int, int]
"""The numbers of edges and of vertices."""


class BuiltIn(Struct, frozen=True):
    """An explorer that comes with the package.

    Attributes:
        explore: the generator function.  It takes the percept before any motion, and the keywords
            ``choices`` (default: first in, first out) and ``notice``, a function that gets events
            and has no influence.  It may also take ``told``.
        lighthouse: the explorer's kind of lighthouse, in the form ``KIND[:key=value,...]``.
        witnesses: the events that must occur in a complete check; if one does not, a branch of the
            algorithm has not been checked.  Each event has two entries.  The first is for classes
            of maps with loops and parallel edges, the second for simple classes.  An entry is a
            pair (m, n): under every policy the event occurs in a check of all worlds with at most m
            edges and at most n vertices.  It is the smallest pair that is known.  The second entry
            is None if in simple classes the event never occurs under some policy.
        bound: the name of the bound that the explorer keeps under its kind of lighthouse; None if
            this bound is the default bound of the lighthouse.
        step_budget: the explorer's own step budget, the number of traversals after which a run is
            cut off; None if the usual step budget is large enough.
        about: a description, for a sentence of the page on the protocol.
    """

    explore: Explore
    lighthouse: str
    witnesses: Mapping[str, tuple[SizePair, SizePair | None]] = field(default_factory=dict)
    bound: str | None = None
    step_budget: int | None = None
    about: str = ""


BUILT_IN: dict[str, BuiltIn] = {
    "algorithm1": BuiltIn(
        algorithm1,
        "directional",
        {
            "case-1": ((4, 3), (6, 4)),
            "case-2": ((3, 2), (5, 4)),
            "case-3": ((1, 1), (3, 3)),
            "empty-H": ((1, 2), (1, 2)),
            "loop": ((1, 1), (3, 3)),
            "non-loop": ((1, 2), (1, 2)),
            # First in, first out explores every dart of v0 before any other: without loops
            # no dart of v0 is open when the robot comes back to it.
            "v0-hypothesis": ((1, 1), None),
        },
        about="Algorithm 1 of the paper; the default",
    ),
    "algorithm1-cluster": BuiltIn(
        algorithm1_cluster,
        "cluster:single=true",
        {
            "case-1": ((5, 5), (8, 8)),
            "case-2": ((4, 3), (6, 5)),
            "case-3": ((2, 2), (3, 3)),
            "empty-H": ((1, 2), (1, 2)),
            "loop": ((2, 2), (3, 3)),
            "non-loop": ((1, 2), (1, 2)),
            "v0-hypothesis": ((2, 2), None),
        },
        "two-vertices",
        about="first it tries the darts of v0, there and back, until one leads to v1; a test that "
        "has come to v0 ends with a *query*: leave by the dart that should lead to v1, look, come "
        "back",
    ),
    "algorithm1-natural": BuiltIn(
        algorithm1_natural,
        "natural",
        # A rejected test cannot be required, since no world is known in which it is unavoidable.
        {
            "case-3": ((2, 2), (4, 4)),
            "empty-H": ((2, 2), (4, 4)),
            "loop": ((2, 2), (4, 4)),
            "non-loop": ((2, 2), (4, 4)),
            "v0-hypothesis": ((2, 2), None),
        },
        "two-vertices",
        about="as `algorithm1-cluster`, with the degrees of v0 and v1 for marks",
    ),
    "algorithm1-door": BuiltIn(
        algorithm1_door,
        "door",
        {
            "case-1": ((5, 5), (8, 8)),
            "case-2": ((3, 2), (5, 4)),
            "case-3": ((1, 1), (3, 3)),
            "empty-H": ((1, 2), (1, 2)),
            "loop": ((1, 1), (3, 3)),
            "non-loop": ((1, 2), (1, 2)),
            "v0-hypothesis": ((1, 1), (6, 4)),
        },
        "paper + 2*m*(m+1) + 2*(d0-1)",
        about="first it tries the darts of v0, there and back, until one is the door; a test that "
        "has come to v0 ends with a query: out by the door and back",
    ),
    "algorithm1-word": BuiltIn(
        algorithm1_word,
        "word:120*",
        {},
        "paper + 2*(d0-1)*(m*(m+1)+1)",
        about="as `algorithm1-door`, for whatever letters: it tries all darts of v0, and asks as "
        "many of them as tell that it is where it should be; right if no letters repeat a shorter "
        "word",
    ),
    "dudek91": BuiltIn(
        dudek91,
        "movable",
        {"new-vertex": ((1, 2), (1, 2)), "back-link": ((1, 1), (3, 3))},
        "3*n*(n-1)//2 + (m-n+1)*(5*n+2*D-4)",
        about="one marker that points nowhere, dropped and taken up again (Dudek, Jenkin, Milios, "
        "Wilkes 1991): right in simple worlds, and not where edges are parallel or a vertex has "
        "two loops",
    ),
    "dfs": BuiltIn(
        dfs,
        "labels",
        {"known": ((1, 1), (3, 3)), "unknown": ((1, 2), (1, 2))},
        "2*m",
        about="depth first, where every vertex has a number and a direction: the baseline of 2m",
    ),
    "folding": BuiltIn(
        folding,
        "directional",
        {"merged": ((1, 1), (3, 3))},
        "none",
        100_000,
        about="only folds its log, and stops where no dart of it is open: home to v0, then to the "
        "open dart that is nearest to v0",
    ),
    "folding-oldest": BuiltIn(
        folding_oldest,
        "directional",
        {"merged": ((1, 1), (3, 3))},
        "none",
        about="as `folding`, but a shortest way to the dart that is open for the longest time",
    ),
    "quotient": BuiltIn(
        quotient,
        "position",
        {"map": ((1, 1), (1, 2)), "ambiguous": ((2, 1), (6, 4))},
        step_budget=100_000,
        about="learns the quotient of its world by experiments that it can undo, and answers "
        "with a map where only one looks so, else with `Ambiguous`",
    ),
}
"""The built-in explorers by their names on the command line."""
