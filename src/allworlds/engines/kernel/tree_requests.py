"""Requests to a player that walks a tree of runs, and the columns of its segments.

Nothing is loaded with it, so that a process that only plays starts fast.
"""

from __future__ import annotations

from msgspec import Struct

# The columns of a segment: where its bytes and its percepts stand, how many motions it has, the
# next segment behind the same branch, and the first one behind the branch at its end.  In place of
# the latter: NO_BRANCH for the end of a run, and of one that cannot go on in any world.
AT, PERCEPTS, MOTIONS, NEXT, INSIDE = range(5)
SEGMENT = 5
LAST, END_OF_RUN, DEAD_END = -1, -2, -3

PERCEPT = 3
"""The number of bytes of a percept."""


class TreeRequest(Struct, frozen=True):
    """The data of a unit's tree that a player needs.

    Attributes:
        edges, limit, simple, planar, lighthouse, policy, budgets: those of a
            :class:`~allworlds.engines.kernel.rows.Level`.
        prefix: the decisions with which each map of the unit begins.
    """

    edges: int
    limit: int
    simple: bool
    planar: bool
    lighthouse: str
    policy: str
    budgets: tuple[int, ...]
    prefix: tuple[int, ...]


class Chunk(Struct, frozen=True):
    """The beginning of a chunk.

    Attributes:
        place: the number of the lighthouse's place.
        path: the ways taken at the branches from the start on of the last run before, which is
            repeated; empty where the tree of the place begins.
    """

    place: int = 0
    path: tuple[int, ...] = ()
