"""Explorers: generator functions that are written against the protocol alone.

A new built-in explorer is a module of this package and an entry of :data:`BUILT_IN`.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from allworlds.explorers.algorithm1 import algorithm1


@dataclass(frozen=True, slots=True)
class BuiltIn:
    """An explorer that ships with the package.

    Attributes:
        explore: the generator function; it takes ``choices`` and ``notice``.
        lighthouse: the kind it is written for.
        witnesses: the events that a complete check must have seen, each with the least
            number of edges from which on every policy meets it, for classes with loops and
            parallel edges and for simple classes.  An event met later, or never, would mean
            that a branch of the algorithm has not been tried.
    """

    explore: Callable[..., Any]
    lighthouse: str
    witnesses: Mapping[str, tuple[int, int]] = field(default_factory=dict)


BUILT_IN: dict[str, BuiltIn] = {
    "algorithm1": BuiltIn(
        algorithm1,
        "directional",
        {
            "case-1": (4, 6),
            "case-2": (3, 4),
            "case-3": (1, 3),
            "empty-H": (1, 1),
            "loop": (1, 3),
            "non-loop": (1, 1),
            "v0-hypothesis": (1, 3),
        },
    ),
}
"""The built-in explorers by the names they have on the command line."""

__all__ = ["BUILT_IN", "BuiltIn", "algorithm1"]
