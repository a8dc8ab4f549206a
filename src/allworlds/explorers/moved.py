"""Modules of explorers that have moved: findings and users may still give the old names."""

from __future__ import annotations

_BUILT_IN = (
    *("algorithm1", "depth_first", "dudek91", "experiments", "folded_log", "folding", "greedy"),
    *("partial_map", "paths", "prudent", "quotient", "remembering", "undirected", "unforgetting"),
)

MOVED = {
    "allworlds.explorers": "allworlds.explorers.builtin.explorer_table",
    **{f"allworlds.explorers.{name}": f"allworlds.explorers.builtin.{name}" for name in _BUILT_IN},
    "allworlds.mutation.explorers": "allworlds.evidence.mutants.explorers",
    "allworlds.mutation.learners": "allworlds.evidence.mutants.learners",
    "allworlds.mutation.unfair": "allworlds.evidence.mutants.unfair",
}
"""The present modules of explorers by their names in version 0.1.0."""


def present_name(module: str) -> str:
    """Return the present name of a module."""
    return MOVED.get(module, module)
