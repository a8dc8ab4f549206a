from itertools import product

import pytest

from allworlds.studies.ambiguity.proofs import (
    ProofRefused,
    RupChecker,
    check_lrat,
    lrat_of_drat,
    write_lrat,
)
from allworlds.studies.ambiguity.solvers import (
    python_sat_is_installed,
    solve_here,
)

# All eight clauses over three variables: no assignment is left.
ALL = [
    tuple(s * v for s, v in zip(signs, (1, 2, 3), strict=True))
    for signs in product((1, -1), repeat=3)
]
DRAT = ["1 2 0", "1 -2 0", "1 0", "d 1 2 3 0", "-1 2 0", "2 0", "0"]


def lines(steps, tmp_path):
    write_lrat(steps, tmp_path / "p.lrat")
    return (tmp_path / "p.lrat").read_text().splitlines()


def test_what_propagation_proves_becomes_an_lrat_proof(tmp_path):
    steps = lrat_of_drat(3, ALL, DRAT)
    assert steps[-1][1] == ()
    check_lrat(ALL, lines(steps, tmp_path))


def test_a_chain_of_implications_is_written_in_its_order(tmp_path):
    clauses = [(-1, 2), (-2, 3), (-3, 4), (-4, -1), (1, 5), (1, -5)]
    check_lrat(clauses, lines(lrat_of_drat(5, clauses, ["-1 0", "0"]), tmp_path))


@pytest.mark.parametrize(
    ("proof", "message"),
    [
        (["1 0"], "line 1.*unit propagation does not give"),
        (["1 2 0", "d 1 2 -3 -1 0"], "line 2.*no clause at this point"),
        (["1 2 0"], "ends without the empty clause"),
        (["1 4 0"], "line 1.*over the formula's variables"),
        (["1 2"], "line 1.*over the formula's variables"),
        (["1 x 0"], "line 1"),
        ([""], "line 1"),
        (["1 -1 0"], "line 1.*contains"),
        ([*DRAT[:2], "d 1 2 0", "d 1 2 0"], "line 4.*no clause"),
    ],
)
def test_a_line_that_does_not_follow_is_refused_by_its_number(proof, message):
    with pytest.raises(ProofRefused, match=message):
        lrat_of_drat(3, ALL, proof)


def test_a_satisfiable_formula_has_no_proof():
    with pytest.raises(ProofRefused):
        lrat_of_drat(3, ALL[1:], ["1 2 0", "1 -2 0", "1 0", "-1 2 0", "2 0", "0"])


def test_what_is_assumed_for_one_clause_is_not_known_in_the_next():
    checker = RupChecker(3, [(2,), (1, 3)])
    checker.add((1, 2))
    with pytest.raises(ProofRefused, match="unit propagation does not give"):
        checker.add((3,))


def test_a_derived_clause_waits_for_literals_that_are_not_false_yet():
    checker = RupChecker(5, [(-1,), (2, 3, 4), (2, 3, -4), (-2, 5), (-2, -5)])
    for clause in ((1, 2, 3), (3,)):
        checker.add(clause)


@pytest.mark.skipif(not python_sat_is_installed(), reason="python-sat is not installed")
def test_the_child_process_prints_its_verdict_as_solvers_do(tmp_path, capsys):
    formula, proof = tmp_path / "f.cnf", tmp_path / "f.drat"
    formula.write_text("p cnf 2 2\n1 2 0\n-1 0\n")
    solve_here(str(formula), str(proof))
    assert capsys.readouterr().out == "s SATISFIABLE\nv -1 2 0\n"
    formula.write_text("p cnf 1 2\n1 0\n-1 0\n")
    solve_here(str(formula), str(proof))
    assert capsys.readouterr().out == "s UNSATISFIABLE\n"
    assert "0" in proof.read_text().splitlines()


def test_every_lemma_is_new_and_has_the_next_number():
    clauses = [(1,), (-1, 2), (-2, 3, 4), (-3,)]
    checker = RupChecker(4, clauses)
    checker.add((4,))
    assert [*checker.lemmas] == [5, 6, 7]
    assert [clause for clause, _ in checker.lemmas.values()] == [(2,), (4,), (4,)]
