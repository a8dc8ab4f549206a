"""Solvers of formulas, all with a time limit.  No other module imports z3 or pysat.

A *deadline* is a time on the monotonic clock; None stands for no time limit.
``python -m allworlds.studies.ambiguity.solvers FORMULA PROOF`` runs python-sat's CaDiCaL in a
process of its own, since a call of CaDiCaL cannot be interrupted.
"""

import re
import subprocess
import sys
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from time import monotonic
from typing import Literal, TypeAlias

from msgspec import Struct

from allworlds.inputs.checks import InputError, show
from allworlds.studies.ambiguity.clauses import dimacs, read_dimacs
from allworlds.studies.ambiguity.formulas import ALIKE, DIFFERENT

REQUIREMENTS = (DIFFERENT, ALIKE)
"""Two sections of the formula of a search: the two worlds differ; the two worlds look alike.

A formula without a model says something about worlds only if both requirements are needed: there
should be a model as soon as one of these sections is left out.
"""

Status: TypeAlias = Literal["sat", "unsat", "unknown"]

OLDEST = 2
"""The first major version of CaDiCaL that writes proofs as LRAT."""

LONGEST_WAIT = 10**6
"""The most seconds of waiting for a solver.

Solvers count milliseconds in 32 bits.
"""


class SolverAnswer(Struct, frozen=True):
    """A solver's answer; ``model`` holds the true variables of a model, if there is one."""

    status: Status
    model: frozenset[int] = frozenset()


UNKNOWN = SolverAnswer("unknown")


def has_model_without(formula: Path, requirement: str) -> bool:
    """Whether a formula in a file has a model if the clauses of one section are left out.

    ``requirement`` is the text of the section.  z3 decides.

    Raises:
        ValueError: if the formula has no such section.
    """
    import z3

    solver = z3.Solver()
    solver.from_string("\n".join(dimacs(*read_dimacs(formula, leave_out=requirement))))
    found: bool = solver.check() == z3.sat
    return found


def solve_with_z3(formula: Path, deadline: float | None) -> SolverAnswer:
    """The answer of z3 to the formula in a file; ``unknown`` after the deadline."""
    import z3

    left = _seconds_left(deadline)
    if left == 0:
        return UNKNOWN
    solver = z3.Solver()
    if left is not None:
        solver.set("timeout", max(int(left * 1000), 1))
    solver.from_file(str(formula))
    verdict = solver.check()
    if verdict == z3.unsat:
        return SolverAnswer("unsat")
    if verdict == z3.unknown:
        return UNKNOWN
    model = solver.model()
    # The variable 17 of the file is called k!17; one without a value may have any.
    true = (int(d.name().removeprefix("k!")) for d in model.decls() if z3.is_true(model[d]))
    return SolverAnswer("sat", frozenset(true))


def python_sat_is_installed() -> bool:
    """Whether python-sat, of the extra ``proofs``, is installed."""
    return find_spec("pysat") is not None


def solve_with_python_sat(formula: Path, proof: Path, deadline: float | None) -> SolverAnswer:
    """The answer of python-sat's CaDiCaL; ``unknown`` after the deadline.

    If the formula has no model, a DRAT proof is written to the file ``proof``.
    """
    return _solve_with_process([sys.executable, "-m", __name__], formula, proof, deadline)


def solve_here(formula: str, proof: str) -> None:
    """Solve the formula in a DIMACS file by python-sat; print the answer as SAT solvers print it.

    The printed line is ``s SATISFIABLE``, followed by a line ``v ...`` with the literals that are
    true in a model; or it is ``s UNSATISFIABLE``.  If the formula has no model, a DRAT proof is
    written to the file ``proof``.
    """
    from pysat.formula import CNF
    from pysat.solvers import Cadical153

    with Cadical153(bootstrap_with=CNF(from_file=formula).clauses, with_proof=True) as solver:
        if solver.solve():
            sys.stdout.write(f"s SATISFIABLE\nv {' '.join(map(str, solver.get_model()))} 0\n")
        else:
            lines = "".join(line + "\n" for line in solver.get_proof())
            Path(proof).write_text(lines, encoding="ascii")
            sys.stdout.write("s UNSATISFIABLE\n")


class ExternalSolver(Struct, frozen=True):
    """A program that the user names: CaDiCaL, version 2 or later, which writes proofs as LRAT.

    Raises:
        InputError: if the file cannot be run, is another program, or an older version.
    """

    path: str

    def __post_init__(self) -> None:
        try:
            said = subprocess.run(  # noqa: S603  # the user names the program
                [self.path, "--version"], capture_output=True, text=True, timeout=10, check=False
            ).stdout.strip()
        except (OSError, subprocess.TimeoutExpired, UnicodeDecodeError) as error:
            reason = getattr(error, "strerror", None) or type(error).__name__
            raise InputError(f"solver {show(self.path)} cannot be run: {reason}") from None
        version = re.match(r"([0-9]+)\.", said)
        if version is None or int(version[1]) < OLDEST:
            raise InputError(
                f"solver {show(self.path)} calls itself {said.splitlines()[:1] or 'nothing'}; "
                f"legal is CaDiCaL {OLDEST} or later"
            )

    def solve(self, formula: Path, proof: Path, deadline: float | None) -> SolverAnswer:
        """The program's answer; ``unknown`` after the deadline.

        If the formula has no model, an LRAT proof is written to the file ``proof``.
        """
        command = [self.path, "-q", "--lrat", "--no-binary"]
        return _solve_with_process(command, formula, proof, deadline)


def _solve_with_process(
    command: Sequence[str], formula: Path, proof: Path, deadline: float | None
) -> SolverAnswer:
    """The answer that a solver prints, with the model if there is one.

    The arguments of the solver are those in ``command``, then the files of the formula and of the
    proof.  The answer is ``unknown`` after the deadline.

    Raises:
        RuntimeError: if the solver prints no answer.
    """
    left = _seconds_left(deadline)
    if left == 0:
        return UNKNOWN
    try:
        ran = subprocess.run(  # noqa: S603  # as above
            [*command, str(formula), str(proof)],
            capture_output=True,
            text=True,
            timeout=left,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return UNKNOWN
    lines = ran.stdout.splitlines()
    if "s UNSATISFIABLE" in lines:
        return SolverAnswer("unsat")
    if "s SATISFIABLE" in lines:
        values = (int(word) for line in lines if line[:1] == "v" for word in line[1:].split())
        return SolverAnswer("sat", frozenset(value for value in values if value > 0))
    if "s UNKNOWN" in lines or "c UNKNOWN" in lines:
        return UNKNOWN
    raise RuntimeError(f"{command[0]} printed no verdict: {(ran.stderr or ran.stdout)[-500:]}")


def _seconds_left(deadline: float | None) -> float | None:
    """The seconds until the deadline, at least 0; None without a deadline."""
    return None if deadline is None else max(deadline - monotonic(), 0.0)


if __name__ == "__main__":
    solve_here(*sys.argv[1:])
