import subprocess
import sys
from pathlib import Path

import pytest

from allworlds.studies.ambiguity.proofs import ProofRefused, check_lrat

DATA = Path(__file__).parents[1] / "support" / "data"
FORMULA = [[1, 2], [1, -2], [-1, 2], [-1, -2]]
PROOF = ["5 1 0 1 2 0", "6 0 5 3 4 0"]


def verdicts(lrat, clauses, proof, variables=2):
    """The verdicts of two checkers: that of the proofs' folder, and that of the search."""
    said = []
    for check in (
        lambda: lrat.check(variables, clauses, proof),
        lambda: check_lrat([tuple(clause) for clause in clauses], proof),
    ):
        try:
            check()
            said.append("verified")
        except (lrat.Refused, ProofRefused) as error:
            said.append(str(error))
    return said


def test_a_right_proof_is_verified_by_both_checkers(checkers):
    assert verdicts(checkers("lrat"), FORMULA, PROOF) == ["verified", "verified"]


@pytest.mark.parametrize(
    ("proof", "line"),
    [
        (["5 1 0 1 0", PROOF[1]], "line 1"),  # a hint is missing: no contradiction
        (["5 1 0 2 2 0", PROOF[1]], "line 1"),
        (["5 1 0 1 2 3 0", PROOF[1]], "line 1"),  # a hint after the contradiction
        (["5 1 0 4 1 2 0", PROOF[1]], "line 1"),  # a hint with two open literals
        (["5 1 0 1 7 0", PROOF[1]], "line 1"),  # no such clause
        (["5 1 0 -1 2 0", PROOF[1]], "line 1"),  # RAT
        (["5 -1 0 1 2 0", PROOF[1]], "line 1"),  # another literal
        (["5 1 -1 0 1 2 0", PROOF[1]], "line 1"),  # always true
        (["4 1 0 1 2 0", PROOF[1]], "line 1"),  # a number that is taken
        (["5 1 0 1 2", PROOF[1]], "line 1"),
        (["5 1 0 1 2 3", PROOF[1]], "line 1"),
        (["5 1 1 2", PROOF[1]], "line 1"),
        (["5 1 0 1 x 0", PROOF[1]], "line 1"),
        (["", *PROOF], "line 1"),
        (["5 d 9 0", *PROOF], "line 1"),  # forgets what there is not
        (["4 d 1 0", *PROOF], "line 2"),  # uses what is forgotten
        (["4 d 3 0", *PROOF], "line 3"),
        (["4 d 3 3 0", *PROOF], "line 1"),
        (["5 d 3", *PROOF], "line 1"),
        (["6 0 1 2 0"], "line 1"),
        (PROOF[:1], "empty clause"),
        ([], "empty clause"),
        (PROOF[1:], "line 1"),
    ],
)
def test_a_damaged_proof_is_refused_and_the_line_is_named(checkers, proof, line):
    for verdict in verdicts(checkers("lrat"), FORMULA, proof):
        assert line in verdict


def test_a_hint_that_says_what_is_true_already_does_no_harm(checkers):
    twice = ["5 1 0 1 1 2 0", PROOF[1]]
    assert verdicts(checkers("lrat"), FORMULA, twice) == ["verified", "verified"]


@pytest.mark.parametrize(
    "proof",
    [
        [*PROOF, "7 2 0 1 0"],  # every line is checked, to the end
        [*PROOF, "nonsense"],
        ["5 3 1 0 1 2 0", PROOF[1]],  # 3 is no variable of the formula
    ],
)
def test_the_checker_of_the_proofs_reads_the_whole_file(checkers, proof):
    assert verdicts(checkers("lrat"), FORMULA, proof)[0].startswith("line")


def test_the_trap_of_a_satisfiable_formula_is_refused(checkers):
    # An empty clause whose hints never conflict; a widely used checker accepts it.
    lrat = checkers("lrat")
    variables, clauses = lrat.read_formula((DATA / "lrat-trap.cnf").read_text())
    proof = (DATA / "lrat-trap.lrat").read_text().splitlines()
    for verdict in verdicts(lrat, clauses, proof, variables):
        assert "line 2" in verdict


def test_a_proof_of_another_formula_is_refused(checkers):
    lrat = checkers("lrat")
    for other in ([[1, 2], [1, -2], [-1, 2], [-1]], FORMULA[:3], [*FORMULA, [1, 2]], FORMULA[::-1]):
        assert verdicts(lrat, other, ["5 1 0 1 2 0", "6 0 5 4 3 0"])[0] != "verified" or any(
            len(clause) == 1 for clause in other
        )


@pytest.mark.parametrize(
    "text",
    [
        "p cnf 2 1\n1 2 0\n1 0\n",
        "p cnf 2 2\n1 2 0\n",
        "p cnf 2 1\n3 0\n",
        "p cnf 2 1\n1 2\n",
        "1 2 0\n",
        "p dnf 2 1\n1 0\n",
        "p cnf x 1\n1 0\n",
        "p cnf 2 1\n1 0 2 0\n",
    ],
)
def test_a_damaged_formula_is_refused(checkers, text):
    lrat = checkers("lrat")
    with pytest.raises(lrat.Refused):
        lrat.read_formula(text)


def test_a_formula_without_variables_is_read_and_refuted_by_its_empty_clause(checkers):
    lrat = checkers("lrat")
    assert lrat.read_formula("p cnf 0 0\n") == (0, [])
    assert lrat.read_formula("c none\np cnf 0 1\n0\n") == (0, [[]])
    assert lrat.check(0, [[]], ["2 0 1 0"]) == 1
    with pytest.raises(lrat.Refused, match="the empty clause is not derived"):
        lrat.check(0, [], [])
    with pytest.raises(lrat.Refused, match="line 1: a literal is no variable"):
        lrat.check(0, [[]], ["2 1 0 1 0"])


@pytest.mark.parametrize(
    "text",
    [
        "p cnf 0 0\np cnf 0 0\n",  # a second header
        "p cnf 0 0\n0\n",
        "p cnf 0 1\n1 0\n",
        "p cnf -1 0\n",
        "p cnf 0 -1\n",
        "p cnf 0 -1\np cnf 0 0\n",
        "p cnf 0\n",
        "",
    ],
)
def test_a_damaged_formula_without_variables_is_refused(checkers, text):
    lrat = checkers("lrat")
    with pytest.raises(lrat.Refused):
        lrat.read_formula(text)


def run(proofs, *arguments):
    command = [sys.executable, str(proofs / "lrat.py"), *map(str, arguments)]
    ran = subprocess.run(command, capture_output=True, text=True, check=False)
    return ran.returncode, ran.stdout


def test_the_command_prints_one_verdict_line(proofs, tmp_path):
    folder = proofs / "no-twins-directional"
    code, out = run(proofs, folder / "m2.cnf.xz", folder / "m2.lrat.xz")
    assert (code, out.splitlines()) == (
        0,
        ["VERIFIED: 71 clauses derived, the empty one among them"],
    )
    code, out = run(proofs, folder / "m2.cnf.xz", folder / "m3.lrat.xz")
    assert (code, out.startswith("REFUSED: m3.lrat.xz: line 1: ")) == (1, True)
    assert run(proofs, folder / "m2.cnf.xz", tmp_path / "none.lrat")[0] == 2
    assert run(proofs, folder / "m2.cnf.xz")[0] == 2
