"""Controls of a formula without a model: a part of what it requires has one.

Where twins are ruled out, a contradiction anywhere in the formula would rule them out as well.
Without the requirement that the worlds differ there is a model, any world twice; without the one
that they look alike there is one, too, any two worlds.
"""

from __future__ import annotations

from pathlib import Path

from allworlds.studies.ambiguity.smt.formula import read_dimacs, write_dimacs
from allworlds.studies.ambiguity.smt.pair import ALIKE, DIFFERENT
from allworlds.studies.ambiguity.smt.solvers import Clock, solve_with_z3

REQUIREMENTS = (DIFFERENT, ALIKE)
"""The sections of a formula that only together can rule out a pair."""


def has_model_without(formula: Path, requirement: str) -> bool:
    """Whether z3 finds a model of a formula's file, one requirement left out.

    Raises:
        ValueError: if the formula has no such section.
    """
    variables, clauses = read_dimacs(formula, leave_out=requirement)
    weaker = formula.with_suffix(".control.cnf")
    write_dimacs(weaker, variables, clauses)
    try:
        return solve_with_z3(weaker, Clock(None)).status == "sat"
    finally:
        weaker.unlink()
