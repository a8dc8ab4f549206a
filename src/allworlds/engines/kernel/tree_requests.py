"""What a player is asked for that walks a tree of runs; nothing is loaded with it."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class TreeRequest:
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


@dataclass(frozen=True, slots=True)
class Chunk:
    """The beginning of a chunk.

    Attributes:
        place: the number of the lighthouse's place.
        path: the ways taken at the branches from the start on of the last run before, which is
            repeated; empty where the tree of the place begins.
    """

    place: int = 0
    path: tuple[int, ...] = ()
