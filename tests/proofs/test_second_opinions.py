"""The SMT-LIB statements are proved by z3 and by cvc5, not vacuous, and false when damaged."""

import importlib
import importlib.util
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import pytest

WITHOUT_CVC5 = "cvc5 is not installed: pip install '.[proofs]'"
needs_cvc5 = pytest.mark.skipif(importlib.util.find_spec("cvc5") is None, reason=WITHOUT_CVC5)

# Each statement with what is damaged in it: the damaged one must not get the expected answer.
MUTANTS = {
    "bound-one-pass": [
        ("(* 2.0 (- s 1.0) tests)", "(* 2.0 s tests)"),  # tests of s steps, there and back
        ("(<= 1.0 s)", "(<= 0.0 s)"),  # v0 need not be known
    ],
    "bound-pass-grows": [("(<= p m)", "(<= p (+ m 1.0))")],  # more edges explored than there are
    "bound-polynomial": [
        ("(* 30.0 m n)", ""),  # 5mn left out, as printed in (3)
        ("(six_sum_1 (- n 1.0))", "(six_sum_1 n)"),  # one term more in (1)
        ("(+ (- m n) 1.0)", "(+ (- n n) 1.0)"),  # the upper limit of (2) as printed
    ],
    "bound-run-step": [
        ("(<= s n)", "(<= s (+ n 1.0))"),  # more vertices known than there are
        ("(<= s (+ p 1.0))", "(<= s (+ p 2.0))"),  # vertices known without an edge to them
        ("(<= cost_pass (pass_bound s p))", "(<= cost_pass (pass_bound s (- p 1.0)))"),
    ],
    "bound-sum-1-step": [("(+ sum (+ q 1.0)", "(+ sum q")],  # the way to e without e
    "bound-sum-2-step": [("(* 2.0 j)", "j")],  # an explored edge counted as one dart
    "bound-terms": [("(least (+ p 1.0) n)", "(least p n)")],  # v0 not counted
    "bound-tests-step": [("(* 2.0 steps)", "(* 3.0 steps)")],  # the path walked three times
    "direction-needed": [
        # both come in by the dart pointed at: then the bearings are equal
        ("(not (= (alpha (sigma y)) pointed))", "(= (alpha (sigma y)) pointed)"),
    ],
    "exit-closed": [
        ("(forall ((x MapDart)) (not (open x)))", "true"),  # U is not empty
        ("(walked (alpha d))", "(walked d)"),  # an edge walked at one end only
    ],
    "exit-map-is-world": [
        ("(forall ((d Dart)) (seen d))", "(seen start)"),  # G is not connected
        ("(= (phi (next x)) (sigma (phi x)))", "(= (phi (next x)) (phi (next x)))"),  # no order
    ],
    "folding-links-forced": [
        ("(merged z x)", "true"),  # linked without a merge
        ("(linked0 z y)", "(merged z y)"),  # two names of one end taken for the two ends
    ],
    "folding-merges-forced": [
        ("(= (bearing x) (bearing y))", "true"),  # merged at v0 without regard to the bearing
        ("(walked u) (walked v)", "(walked u)"),  # merged with a target that was never reached
    ],
    "key-lemma-base": [
        ("(= (bearing x) (bearing y))", "true"),  # no direction
        ("(assert (home y))", ""),
    ],
    "key-lemma-step": [
        ("(= (partner (partner d)) d)", "(= (partner (partner d)) (partner d))"),
        ("(explored (turn p)) (explored (turn q))", "(explored (turn p))"),  # off the map
        ("(= (back (turn d)) d)", "(= (back (turn d)) (turn d))"),  # turning merges darts
    ],
    "loop-keeps-I1": [
        ("(= (alpha (phi e)) (phi h))", "true"),  # the hypothesis was not tested
        ("(ite (= x h) e (partner0 x))", "(partner0 x)"),  # linked in one direction
    ],
    "loop-keeps-I2": [
        ("(not (= x h))", "true"),  # the partner stays in U
        ("(= (alpha (phi e)) (phi h))", "true"),  # the hypothesis was not tested
    ],
    "match-proves-base": [
        ("(= (bearing x) (expected h))", "true"),  # no direction
        ("(= (phi pointed_map) pointed)", "true"),  # S does not know where the marker points
    ],
    "match-proves-step": [
        ("(= (alpha (alpha d)) d)", "true"),  # two ways to one dart
        ("(= (phi (partner e)) (alpha (phi e)))", "true"),  # a wrong edge in S
    ],
    "motion-reversible": [("(= (alpha (alpha x)) x)", "(= (alpha (alpha x)) (alpha x))")],
    "rejected-means-new": [
        ("(not (= (alpha d) d))", "true"),  # an edge with one end: e itself would be the answer
        ("(= (degree_map x) (degree (phi x)))", "true"),  # the true hypothesis is not tested
    ],
    "run-reversible": [
        ("(back (alpha (undo_w y)))", "(back (undo_w y))"),  # turned without crossing back
        ("(back (alpha (undo_w y)))", "(undo_w (back (alpha y)))"),  # undone in the wrong order
    ],
    "start-has-I": [
        ("(= (open x) (known x))", "(= (open x) (and (known x) (not (= x (name start)))))"),
        ("(fresh (sigma d))", "(fresh d)"),  # not numbered clockwise
    ],
    "truth-matches-base": [
        ("(= (home e) (marked (phi e)))", "true"),  # the marker of S is elsewhere
        ("(below (expected e) (degree_map e))", "true"),  # a bearing beyond the degree
    ],
    "truth-matches-step": [
        ("(= (degree_map e) (degree (phi e)))", "true"),  # wrong degrees in S
        ("(= (leads_kw e) (and (explored (turn_map e))", "(= (leads_kw e) (and (known e)"),
    ],
    "turns-carried-over": [("(= (phi (next x)) (sigma (phi x)))", "true")],
    "turns-reversible": [("(back_k (sigma_inv x))", "(sigma_inv (back_k (back_k x)))")],
    "variant-bounds-passes": [
        ("(+ edges_map 1)", "edges_map"),  # a pass that explores nothing
        ("(<= edges_map_after edges_world)", "true"),  # S larger than G
    ],
    "variant-falls": [
        ("(not (= (alpha d) d))", "true"),  # an edge with one end
        ("(not (walked0 (phi x)))", "true"),  # an explored dart in U
    ],
    "vertex-keeps-I1": [
        ("(not (seen0 (alpha (phi0 e))))", "true"),  # a known vertex is added again
        ("(fresh (sigma d))", "(fresh d)"),  # not numbered clockwise
        ("(ite (new x) (degree", "(ite (= x entry) (degree"),  # recorded at one dart only
    ],
    "vertex-keeps-I2": [
        ("(and (new x) (not (= x entry)))", "(new x)"),  # the dart come in by is added to U
        ("(and (open0 x) (not (= x e)))", "(open0 x)"),  # e stays in U
        ("(not (seen0 (alpha (phi0 e))))", "true"),  # a known vertex is added again
    ],
}

# Without one of these a countermodel is infinite: on a finite set one inverse is both.
ONLY_INFINITE = {"turns-reversible"}


@pytest.fixture
def opinions(proofs, monkeypatch):
    """The module of the runner."""
    monkeypatch.syspath_prepend(str(proofs / "second-opinions"))
    monkeypatch.delitem(sys.modules, "check", raising=False)
    yield importlib.import_module("check")
    sys.modules.pop("check", None)


def run(proofs, *arguments):
    # A limit that only a solver without end would reach, whatever else the machine does.
    program = str(proofs / "second-opinions" / "check.py")
    command = [sys.executable, program, "--seconds", "600", *arguments]
    ran = subprocess.run(command, capture_output=True, text=True, check=False)
    return ran.returncode, ran.stdout + ran.stderr


def answers(opinions, questions, seconds):
    """The answer to each question (solver, path, expected answer), in order."""
    with ThreadPoolExecutor(max_workers=4) as pool:
        return [
            opinion.answer
            for opinion in pool.map(lambda question: opinions.ask(*question, seconds), questions)
        ]


@pytest.mark.slow
@pytest.mark.long
def test_z3_proves_every_statement_and_no_statement_is_vacuous(proofs):
    code, said = run(proofs, "--solver", "z3")
    assert code == 0, said
    assert "31 of 31 statements as expected, by z3\n" in said


@pytest.mark.slow
@pytest.mark.long
@needs_cvc5
def test_cvc5_proves_every_statement_and_no_statement_is_vacuous(proofs):
    code, said = run(proofs, "--solver", "cvc5")
    assert code == 0, said
    assert "31 of 31 statements as expected, by cvc5\n" in said


def test_every_statement_has_a_mutant_and_every_mutant_a_statement(opinions):
    assert sorted(MUTANTS) == opinions.statements()


def damaged_statements(opinions, folder):
    """Files with the mutants, each with the answer that the undamaged statement expects."""
    for name, mutants in MUTANTS.items():
        text = (opinions.HERE / f"{name}.smt2").read_text()
        for number, (right, damaged) in enumerate(mutants):
            # The first place is damaged, and the conclusion, which comes last, only if it is one.
            before, found, after = text.partition(right)
            assert found, f"{name}: {right}"
            path = folder / f"{name}.{number}.smt2"
            path.write_text(before + damaged + after)
            yield path, opinions.header(text)[1]


@pytest.mark.slow
def test_z3_proves_no_damaged_statement(opinions, tmp_path):
    damaged = list(damaged_statements(opinions, tmp_path))
    questions = [("z3", path, expected) for path, expected in damaged]
    for (path, expected), answer in zip(damaged, answers(opinions, questions, 1), strict=True):
        other = {"sat": "unsat", "unsat": "sat"}[expected]
        assert answer in {other, "unknown", "timeout"}, path.name


@pytest.mark.slow
@needs_cvc5
def test_cvc5_refutes_every_damaged_statement_by_a_finite_model(opinions, tmp_path):
    damaged = list(damaged_statements(opinions, tmp_path))
    questions = [("cvc5", path, "sat") for path, _ in damaged]
    for (path, expected), answer in zip(damaged, answers(opinions, questions, 600), strict=True):
        assert answer == {"sat": "unsat", "unsat": "sat"}[expected], path.name


@needs_cvc5
@pytest.mark.slow
@pytest.mark.long
def test_without_any_one_hypothesis_there_is_a_finite_countermodel(opinions, tmp_path):
    questions = []
    for name in sorted(set(opinions.statements()) - ONLY_INFINITE):
        text = (opinions.HERE / f"{name}.smt2").read_text()
        commands = list(opinions.commands(text))
        if opinions.header(text)[1] == "sat":
            continue
        for assertion in opinions.assertions(text)[:-1]:
            path = tmp_path / f"{name}.{len(questions)}.smt2"
            path.write_text("\n".join(c for c in commands if c != assertion))
            questions.append(("cvc5", path, "sat"))
    for question, answer in zip(questions, answers(opinions, questions, 600), strict=True):
        assert answer == "sat", question[1].name


@pytest.mark.parametrize(
    ("right", "damaged", "reason"),
    [
        ("(assert (home x))\n", "", "the model has other hypotheses"),
        ("(define-fun x () Dart a1)", "(declare-const x Dart)", "the model leaves a symbol open"),
        ("(define-fun x () Dart a1)", "(define-fun x () Dart b1)", "z3 says of the model: unsat"),
    ],
)
def test_a_model_that_is_none_is_found_out(opinions, monkeypatch, tmp_path, right, damaged, reason):
    text = (opinions.HERE / "key-lemma-base.smt2").read_text()
    model = (opinions.HERE / "key-lemma-base.model.smt2").read_text()
    assert right in model
    (tmp_path / "key-lemma-base.model.smt2").write_text(model.replace(right, damaged))
    (tmp_path / "solve.py").write_text((opinions.HERE / "solve.py").read_text())
    monkeypatch.setattr(opinions, "HERE", tmp_path)
    assert opinions.why_vacuous("key-lemma-base", text, ["z3"], 600) == reason
    (tmp_path / "key-lemma-base.model.smt2").unlink()
    assert opinions.why_vacuous("key-lemma-base", text, ["z3"], 600) == "no model"


@pytest.mark.parametrize(
    ("z3", "cvc5", "vacuous", "code"),
    [
        ("unsat", "unsat", "", 0),
        ("unsat", "unknown", "", 3),
        ("timeout", "unsat", "", 3),
        ("unknown", "timeout", "", 1),
        ("unsat", "sat", "", 1),
        ("unsat", "error: ...", "", 1),
        ("unsat", "unsat", "no model", 1),
    ],
)
def test_the_exit_code_tells_proved_from_proved_by_one_from_wrong(
    opinions, z3, cvc5, vacuous, code
):
    said = {"z3": opinions.Opinion(z3, 0.1), "cvc5": opinions.Opinion(cvc5, 0.1)}
    row = opinions.Row("name", "statement", "unsat", said, vacuous)
    assert opinions.exit_code([row], opinions.SOLVERS) == code


def test_a_solver_is_killed_when_its_time_is_over(opinions, tmp_path):
    # an inverse on one side that is none on the other: an injection with only infinite models
    path = tmp_path / "endless.smt2"
    path.write_text(
        "(set-logic UF)(declare-sort D 0)(declare-fun f (D) D)(declare-fun g (D) D)"
        "(declare-const a D)(assert (forall ((x D)) (= (g (f x)) x)))"
        "(assert (forall ((x D)) (not (= (f x) a))))(check-sat)"
    )
    assert opinions.ask("z3", path, "sat", 1).answer in {"timeout", "unknown"}


@pytest.fixture
def bound(proofs, monkeypatch):
    pytest.importorskip("sympy", reason="sympy is not installed: pip install '.[proofs]'")
    monkeypatch.syspath_prepend(str(proofs / "second-opinions"))
    return importlib.import_module("bound")


@pytest.mark.no_cover
def test_the_bound_is_the_polynomial_exactly(bound):
    assert bound.difference() == 0
    assert (bound.passes() - bound.POLYNOMIAL).expand() == 0


def test_the_printed_expression_leaves_out_5mn_and_more(bound):
    n, m = bound.n, bound.m
    missing = 5 * m * n - 2 * m + 11 * n / 6
    assert (bound.difference(bound.PRINTED_3) - missing).expand() == 0


def test_the_polynomial_is_the_sum_added_up_number_by_number(bound):
    # Section VI, (1) and (2), with plain integers
    for n in range(1, 9):
        for m in range(n - 1, 15):
            total = sum(s + 2 * (s - 1) * (2 * m - 2 * (s - 1)) for s in range(1, n))
            total += sum(
                n + 2 * (n - 1) * (2 * m - 2 * (n - 1) - 2 * (i - 1)) for i in range(1, m - n + 2)
            )
            assert bound.POLYNOMIAL.subs({bound.n: n, bound.m: m}) == total
