"""Controls of formulas: what is left of one when a requirement is left out."""

import pytest

from allworlds.maps import MapClass
from allworlds.studies.ambiguity.clauses import read_dimacs
from allworlds.studies.ambiguity.formulas import DIFFERENT, pair_formula
from allworlds.studies.ambiguity.question import Question
from allworlds.studies.ambiguity.solvers import (
    REQUIREMENTS,
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
