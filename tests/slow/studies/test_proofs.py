from random import Random

import pytest

from allworlds.studies.ambiguity.clauses import Formula
from allworlds.studies.ambiguity.proofs import ProofRefused, check_lrat, lrat_of_drat
from allworlds.studies.ambiguity.solvers import python_sat_is_installed, solve_with_python_sat
from studies.test_proofs import lines


@pytest.mark.skipif(not python_sat_is_installed(), reason="python-sat is not installed")
@pytest.mark.parametrize("seed", range(12))
def test_random_formulas_are_either_solved_or_proved(tmp_path, seed):
    chance = Random(seed)
    variables = 20
    formula = Formula()
    formula.block("x", (variables,), "any")
    formula.section("random")
    for _ in range(110):
        chosen = chance.sample(range(1, variables + 1), 3)
        formula.add(*[chance.choice((1, -1)) * v for v in chosen])
    formula.write(tmp_path / "f.cnf")
    solved = solve_with_python_sat(tmp_path / "f.cnf", tmp_path / "f.drat", None)
    if solved.status == "sat":
        for clause in formula.clauses:
            assert any((literal > 0) == (abs(literal) in solved.model) for literal in clause)
        return
    proof = (tmp_path / "f.drat").read_text().splitlines()
    steps = lrat_of_drat(variables, formula.clauses, proof)
    check_lrat(formula.clauses, lines(steps, tmp_path))
    # Without its clauses nothing follows.
    with pytest.raises(ProofRefused):
        check_lrat(formula.clauses[: len(formula.clauses) // 8], lines(steps, tmp_path))
