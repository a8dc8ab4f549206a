"""The files about cycles can say nothing else than they should.

The claims' own checkers are called, which know nothing of digests: so what is asked is whether a
producer that is wrong would be noticed, not whether a file is the one that was committed.
"""

import random
from itertools import product

import pytest

SEED = 18
FILES = ["1-start.smt2", "2-sigma.smt2", "3-alpha.smt2", "4-percepts.smt2"]
SIZES = "(assert (and (<= 3 n1) (<= 3 n2)))"
ALPHA = "(ite (= a 0) (ite (= x (- n 1)) 0 (+ x 1)) (ite (= x 0) (- n 1) (- x 1)))"


@pytest.mark.parametrize(
    ("file", "old", "new"),
    [
        ("2-sigma.smt2", "(and (in-cycle n1 i (sigma-side s))", "(or (in-cycle n1 i s)"),
        ("3-alpha.smt2", SIZES, f"{SIZES} (assert (< n1 0))"),
        ("2-sigma.smt2", SIZES, "(assert (and (<= 3 n1) (= n1 n2)))"),
        ("4-percepts.smt2", SIZES, "(assert (and (<= 3 n1) (<= 3 n2) (<= n1 5) (<= n2 5)))"),
        ("2-sigma.smt2", "Bool (= a b)", "Bool (and (= a b) (not (= a b)))"),
        ("3-alpha.smt2", "(and (<= 0 x) (< x n) (or", "(and (<= 0 x) (< x 0) (or"),
        ("4-percepts.smt2", "(check-sat)", ""),
        ("4-percepts.smt2", "(check-sat)", "(assert false) (check-sat)"),
        ("1-start.smt2", "(check-sat)", "(check-sat) (exit)"),
        ("3-alpha.smt2", ALPHA, f"(ite (< 5 n) x {ALPHA})"),
        ("4-percepts.smt2", "(ite (= a 0) 0 1)", "0"),
        ("4-percepts.smt2", "(= degree degree)", "(= 2 degree)"),
        ("1-start.smt2", "(check-sat)", "(check-sat"),
        ("1-start.smt2", "(check-sat)", "(check-sat))"),
        ("1-start.smt2", "(check-sat)", "(check-sat) sat"),
    ],
)
def test_a_file_that_says_anything_else_of_cycles_is_refused(
    checkers, checker_of, proofs, file, old, new
):
    text = (proofs / "cycles" / file).read_text()
    assert old in text
    with pytest.raises(checkers("lrat").Refused):
        checker_of("cycles")._require_condition(file, text.replace(old, new, 1))


def test_a_file_on_cycles_is_none_in_the_place_of_another(checkers, checker_of, proofs):
    module = checker_of("cycles")
    for file in FILES:
        text = (proofs / "cycles" / file).read_text()
        for other in set(FILES) - {file}:
            with pytest.raises(checkers("lrat").Refused, match=f"^{other}: command "):
                module._require_condition(other, text)


@pytest.mark.parametrize(
    ("file", "old", "new", "message"),
    [
        ("2-sigma.smt2", "Int (- 1 a)", "Int a", "is not the cycle"),
        ("3-alpha.smt2", "(+ x 1)", "(+ x 2)", "is not the cycle"),
        ("4-percepts.smt2", "(ite (= a 0) 0 1)", "(ite (= a 0) 1 0)", "is not the cycle"),
        ("4-percepts.smt2", "degree () Int 2", "degree () Int 3", "is not the cycle"),
        ("1-start.smt2", "(= t 0)", "(= t 1)", "the condition fails at"),
        ("2-sigma.smt2", "(= a b)", "(<= a b)", "the condition fails at"),
        (
            "3-alpha.smt2",
            "(= i (alpha-vertex n1",
            "(= j (alpha-vertex n1",
            "the condition fails at",
        ),
    ],
)
def test_were_a_condition_wrong_in_the_checker_too_it_would_be_noticed(
    checkers, checker_of, monkeypatch, file, old, new, message
):
    module = checker_of("cycles")
    damaged = {
        name: tuple(part.replace(old, new) for part in parts)
        for name, parts in module.CONDITIONS.items()
    }
    monkeypatch.setattr(module, "CONDITIONS", damaged)
    monkeypatch.setattr(module, "DEFINED", module.DEFINED.replace(old, new))
    text = " ".join(map(module._text, module.script(file)))
    with pytest.raises(checkers("lrat").Refused, match=message):
        module._require_condition(file, text)


def test_the_points_of_small_cycles_decide_the_conditions_for_all(checkers, checker_of):
    """README.md's argument, tried: any point behaves as the small one that it is moved to."""
    module, smtlib = checker_of("cycles"), checkers("smtlib")
    chance = random.Random(SEED)
    for file in FILES:
        script = module.script(file)
        defined, asserted = smtlib.definitions(script), smtlib.assertions(script)
        for _ in range(150):
            point, small = {}, {}
            for n, i in (("n1", "i"), ("n2", "j")):
                point[n] = chance.choice([chance.randint(3, 9), chance.randint(3, 10**9)])
                near = chance.choice([0, 1, 2, 3, point[n] - 1, point[n] - 2, point[n] - 3])
                point[i] = chance.choice([near, chance.randrange(point[n])]) % point[n]
                small[i] = min(point[i], 4)
                small[n] = small[i] + min(point[n] - point[i], 4)
                assert 3 <= small[n] <= module.DECIDING
            sides = {"s": chance.randint(0, 1), "t": chance.randint(0, 1)}
            told = [
                [defined.value(term, {**where, **sides}) for term in asserted]
                for where in (point, small)
            ]
            assert told[0] == told[1]


def test_the_numbers_of_cycles_are_those_that_are_said(checker_of, monkeypatch, proofs):
    module = checker_of("cycles")
    met = {"_require_alike": set(), "_require_told_apart": set()}
    for name, pairs in met.items():

        def compared(one, other, *_, pairs=pairs):
            pairs.add((len(one.sigma) // 2, len(other.sigma) // 2))

        monkeypatch.setattr(module, name, compared)
    points = product(range(3, 9), repeat=2)  # of each condition, with both sides of both darts
    a_file = sum(4 * n1 * n2 for n1, n2 in points)
    conditions = iter(
        [module._require_condition(FILES[0], (proofs / "cycles" / FILES[0]).read_text())]
    )
    monkeypatch.setattr(module, "_require_condition", lambda *_: next(conditions, a_file))
    said = module.check(proofs / "cycles")
    every = {(a, b) for a in range(3, 51) for b in range(a + 1, 51)}
    assert met == dict.fromkeys(met, every)
    assert said[:2] == [
        "4 conditions hold for all sizes: at 17,424 points, which decide them",
        "1,128 pairs of cycles up to 50 vertices: alike with a compass",
    ]
