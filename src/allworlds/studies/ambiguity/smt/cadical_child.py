"""A process of its own for python-sat's CaDiCaL, because that one cannot be interrupted.

``python -m allworlds.studies.ambiguity.smt.cadical_child FORMULA PROOF`` prints ``s SATISFIABLE``
and the model, or ``s UNSATISFIABLE`` after writing the DRAT proof.
"""

from __future__ import annotations

import sys
from pathlib import Path


def main(formula: str, proof: str) -> None:
    """Solve the DIMACS file and print the verdict as solvers do."""
    from pysat.formula import CNF
    from pysat.solvers import Cadical153

    with Cadical153(bootstrap_with=CNF(from_file=formula).clauses, with_proof=True) as solver:
        if solver.solve():
            sys.stdout.write(f"s SATISFIABLE\nv {' '.join(map(str, solver.get_model()))} 0\n")
        else:
            lines = "".join(line + "\n" for line in solver.get_proof())
            Path(proof).write_text(lines, encoding="ascii")
            sys.stdout.write("s UNSATISFIABLE\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
