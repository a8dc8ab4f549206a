"""Solvers of formulas, each in a way that can be stopped."""

from __future__ import annotations

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
from allworlds.outcome import Disagreement
from allworlds.studies.ambiguity.smt.formula import read_dimacs, write_dimacs
from allworlds.studies.ambiguity.smt.pair import ALIKE, DIFFERENT

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


Status: TypeAlias = Literal["sat", "unsat", "unknown"]

OLDEST = 2
"""The first major version of CaDiCaL that writes LRAT."""

LONGEST_WAIT = 10**6
"""The most seconds that a solver can be waited for: both count milliseconds in 32 bits."""


class SolversDisagree(Disagreement):
    """Two solvers gave two answers to one formula: a fault of this program, or of theirs."""


class SolverAnswer(Struct, frozen=True):
    """A solver's answer; ``model`` holds the true variables, if the formula has a model."""

    status: Status
    model: frozenset[int] = frozenset()


UNKNOWN = SolverAnswer("unknown")


class Clock:
    """The time that is left; ``seconds`` None means any time."""

    def __init__(self, seconds: float | None) -> None:
        self._end = None if seconds is None else monotonic() + seconds

    @property
    def left(self) -> float | None:
        """Seconds until the time is over, at least 0; None without a limit."""
        return None if self._end is None else max(self._end - monotonic(), 0.0)

    @property
    def over(self) -> bool:
        """Whether no time is left."""
        return self.left == 0.0


def solve_with_z3(formula: Path, clock: Clock) -> SolverAnswer:
    """The answer of z3; unknown when the time is over."""
    import z3

    if clock.over:
        return UNKNOWN
    solver = z3.Solver()
    if clock.left is not None:
        solver.set("timeout", max(int(clock.left * 1000), 1))
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
    """Whether the extra ``proofs`` is installed."""
    return find_spec("pysat") is not None


def solve_with_python_sat(formula: Path, proof: Path, clock: Clock) -> SolverAnswer:
    """The answer of python-sat's CaDiCaL, with a DRAT proof in ``proof`` when unsat."""
    command = [
        sys.executable,
        "-m",
        "allworlds.studies.ambiguity.smt.cadical_child",
        str(formula),
        str(proof),
    ]
    return _solve_with_process(command, clock)


class ExternalSolver(Struct, frozen=True):
    """A CaDiCaL of version 2 or later, which writes LRAT.

    Raises:
        InputError: if the file cannot be run, or is another or an older program.
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

    def solve(self, formula: Path, proof: Path, clock: Clock) -> SolverAnswer:
        """The program's answer, with an LRAT proof in ``proof`` when unsat."""
        options = ["-q", "--lrat", "--no-binary"]
        return _solve_with_process([self.path, *options, str(formula), str(proof)], clock)


def _solve_with_process(command: Sequence[str], clock: Clock) -> SolverAnswer:
    """The verdict and the model that a solver prints.

    Raises:
        RuntimeError: if it prints no verdict.
    """
    if clock.over:
        return UNKNOWN
    try:
        ran = subprocess.run(  # noqa: S603  # as above
            command, capture_output=True, text=True, timeout=clock.left, check=False
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
