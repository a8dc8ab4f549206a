"""z3 on the four conditions: each negation is unsatisfiable, and their hypotheses are not.

    python proofs/certificates/cycles/prove.py

The producer's side; ``checker.py`` beside it needs no solver.
"""

from __future__ import annotations

import sys
from pathlib import Path

import z3

HERE = Path(__file__).resolve().parent


def main() -> int:
    """One line a file; exit code 1 if a condition is not proved."""
    failed = False
    for path in sorted(HERE.glob("*.smt2")):
        goal = z3.Solver()
        goal.from_file(str(path))
        verdict = goal.check()
        hypotheses = z3.Solver()
        hypotheses.add(*list(goal.assertions())[:-1])
        possible = hypotheses.check()
        proved = verdict == z3.unsat and possible == z3.sat
        failed = failed or not proved
        print(f"{path.name}: negation {verdict}, hypotheses {possible}")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
