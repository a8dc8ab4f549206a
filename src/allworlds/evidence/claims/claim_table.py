"""**The** table of the functions that decide claims, by the ids of ``claims.toml``."""

from __future__ import annotations

from allworlds.evidence.claims import (
    algorithm,
    ambiguous,
    complexity,
    correctness,
    corridors,
    folds,
    lighthouses,
    limits,
    machine,
    measured,
    model,
    position,
)
from allworlds.evidence.claims.claim_types import Checks

CHECKS: Checks = {
    **model.CHECKS,
    **position.CHECKS,
    **algorithm.CHECKS,
    **correctness.CHECKS,
    **complexity.CHECKS,
    **measured.CHECKS,
    **lighthouses.CHECKS,
    **folds.CHECKS,
    **ambiguous.CHECKS,
    **limits.CHECKS,
    **corridors.CHECKS,
    **machine.CHECKS,
}
"""Each takes the means and the bounds of a scope, and says what it has found."""
