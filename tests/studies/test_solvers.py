"""Solvers and their time; controls of formulas: what is left without one of the requirements."""

import subprocess
from pathlib import Path
from time import monotonic

import pytest
import z3

from allworlds.maps import MapClass
from allworlds.studies.ambiguity import solvers
from allworlds.studies.ambiguity.clauses import read_dimacs
from allworlds.studies.ambiguity.formulas import DIFFERENT, pair_formula
from allworlds.studies.ambiguity.question import Question
from allworlds.studies.ambiguity.solvers import (
    REQUIREMENTS,
    UNKNOWN,
    has_model_without,
    solve_with_z3,
)


@pytest.fixture
def formula(tmp_path):
    question = Question("directional", MapClass.MAPS, 3, 2)
    *_, sizes = question.sizes()
    written, _ = pair_formula(question, sizes)
    written.write(tmp_path / "pair.cnf")
    return tmp_path / "pair.cnf"


def test_only_both_requirements_together_rule_out_a_pair(formula):
    assert solve_with_z3(formula, None).status == "unsat"
    assert all(has_model_without(formula, requirement) for requirement in REQUIREMENTS)
    assert [path.name for path in formula.parent.iterdir()] == ["pair.cnf"]


def test_a_contradiction_elsewhere_leaves_no_model(formula):
    lines = formula.read_text().splitlines()
    at = next(i for i, line in enumerate(lines) if line.startswith("c clauses"))
    formula.write_text("\n".join([*lines[:at], "1 0", "-1 0", *lines[at:]]))
    assert not any(has_model_without(formula, requirement) for requirement in REQUIREMENTS)


def test_a_section_that_there_is_not_is_no_requirement(formula):
    with pytest.raises(ValueError, match="has no section 'no such thing'"):
        has_model_without(formula, "no such thing")


def test_the_clauses_of_a_section_are_left_out_and_no_others(formula):
    variables, every = read_dimacs(formula)
    comment = next(line for line in formula.read_text().splitlines() if line.endswith(DIFFERENT))
    first, last = map(int, comment.removeprefix("c clauses ").partition(":")[0].split(".."))
    assert read_dimacs(formula, leave_out=DIFFERENT) == (
        variables,
        [*every[: first - 1], *every[last:]],
    )


def test_z3_gets_the_time_that_is_left_in_milliseconds(formula, monkeypatch):
    told = []

    class Told(z3.Solver):
        def set(self, *option):
            told.append(option)
            super().set(*option)

    monkeypatch.setattr(z3, "Solver", Told)
    monkeypatch.setattr(solvers, "_seconds_left", lambda deadline: deadline)
    for left in (90.0, 60.0005, None):
        assert solve_with_z3(formula, left).status == "unsat"
    assert told == [("timeout", 90_000), ("timeout", 60_000)]


def test_the_least_time_of_z3_is_a_millisecond(formula, monkeypatch):
    told = []

    class Undecided(z3.Solver):
        def set(self, *option):
            told.append(option)

        def check(self):
            return z3.unknown

    monkeypatch.setattr(z3, "Solver", Undecided)
    monkeypatch.setattr(solvers, "_seconds_left", lambda deadline: deadline)
    assert solve_with_z3(formula, 1e-9) == UNKNOWN
    assert told == [("timeout", 1)]


def test_after_the_deadline_no_solver_is_started(monkeypatch):
    monkeypatch.setattr(z3, "Solver", None)
    monkeypatch.setattr(subprocess, "run", None)
    none, past = Path("no.cnf"), monotonic() - 1
    assert solve_with_z3(none, past) == UNKNOWN
    assert solvers.solve_with_python_sat(none, none, past) == UNKNOWN


def test_a_solver_that_is_stopped_does_not_know(monkeypatch):
    def stopped(command, *, timeout, **_):
        raise subprocess.TimeoutExpired(command, timeout)

    monkeypatch.setattr(subprocess, "run", stopped)
    none = Path("no.cnf")
    assert solvers.solve_with_python_sat(none, none, monotonic() + 1000) == UNKNOWN
