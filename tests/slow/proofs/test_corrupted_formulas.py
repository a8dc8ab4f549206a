"""No changed formula is accepted, and no changed proof proves what is not so.

The claims' own checkers are called, which know nothing of digests: so what is asked is whether a
producer that is wrong would be noticed, not whether a file is the one that was committed.
"""

import re

import pytest

from proofs import test_corrupted_formulas as quick
from proofs.test_corrupted_formulas import (
    FORMULAS,
    QUICK,
    joined,
    parts,
    refused_formulas,
    shifted,
    text_of,
    write,
)
from small import slowest

copied = quick.copied
refuted = quick.refuted

LARGE = [name for name in FORMULAS if name not in QUICK]


def sensing(comments):
    """The numbers of the first two clauses that say what related darts sense."""
    (line,) = [c for c in comments if c.endswith("related darts sense the same")]
    first = int(re.match(r"c clauses (\d+)", line)[1])
    return first - 1, first


def contradiction(comments, clauses):
    first, second = sensing(comments)
    clauses[first : second + 1] = ["1 0", "-1 0"]
    return comments, clauses, f"{first + 1} {second + 1}"


def empty_clause(comments, clauses):
    first, _ = sensing(comments)
    clauses[first] = "0"
    return comments, clauses, str(first + 1)


def widened(comments, clauses):
    comments = [
        c if "sense the same" not in c else f"c clauses 1..{len(clauses)}: {c.partition(': ')[2]}"
        for c in comments
    ]
    clauses[:2] = ["1 0", "-1 0"]
    return comments, clauses, "1 2"


def nothing_else(comments, _):
    return comments, ["1 0", "-1 0"], "1 2"


def appended(comments, clauses):
    return comments, [*clauses, "1 0", "-1 0"], f"{len(clauses) + 1} {len(clauses) + 2}"


EASY = [contradiction, empty_clause, widened, nothing_else, appended]
"""A formula that has no model, but not because of what it should say; and its short proof."""


@pytest.mark.slowest
@pytest.mark.parametrize(
    ("name", "damage"),
    [*((name, damage) for name in QUICK for damage in EASY), *((n, contradiction) for n in LARGE)],
)
def test_a_formula_that_contradicts_itself_is_refused(copied, refuted, checkers, name, damage):
    folder = copied(name)
    path = folder / f"{name}.cnf.xz"
    comments, variables, clauses = parts(text_of(path))
    comments, clauses, hints = damage(comments, clauses)
    text = joined(comments, variables, clauses)
    write(path, text)
    proof = f"{len(clauses) + 1} 0 {hints} 0\n"
    write(folder / f"{name}.lrat.xz", proof)
    # the proof itself is right
    lrat = checkers("lrat")
    assert lrat.check(*lrat.read_formula(text), proof.splitlines()) == 1
    with pytest.raises(lrat.Refused, match="of the formula says what it should not"):
        refuted(name, folder)


@pytest.mark.slowest
def test_a_formula_that_excludes_one_rooted_map_of_8162_is_refused(copied, refuted, checkers):
    name = "no-twins-directional/m5"
    maps, lrat, folder = checkers("maps"), checkers("lrat"), copied(name)
    sigma, alpha = list(maps.rooted_maps(5))[4321]
    sigma, alpha = maps.code(sigma, alpha, 0)
    comments, variables, clauses = parts(text_of(folder / f"{name}.cnf.xz"))
    # sigma1 and alpha1 are the first variables
    steps = [-(1 + 10 * x + y) for x, y in enumerate(sigma)]
    steps += [-(101 + 10 * x + y) for x, y in enumerate(alpha)]
    clauses.append(" ".join(map(str, [*steps, 0])))
    text = joined(comments, variables, clauses)
    write(folder / f"{name}.cnf.xz", text)
    proof = list(shifted(text_of(folder / f"{name}.lrat.xz"), len(clauses) - 1, 1))
    write(folder / f"{name}.lrat.xz", "\n".join(proof) + "\n")
    assert lrat.check(*lrat.read_formula(text), proof) > 1000
    with pytest.raises(lrat.Refused, match=r"clause \d+ of the formula says what it should not"):
        refuted(name, folder)


@pytest.mark.parametrize(
    ("name", "other"),
    [
        ("no-twins-directional/m5", "no-twins-directional/m4"),
        ("no-twins-directional/m2", "smallest-pairs/simple-m2"),
        ("smallest-pairs/simple-m5", "smallest-pairs/planar-simple-m5"),
        ("smallest-pairs/simple-m5", "no-twins-directional/m5"),
        ("smallest-pairs/maps-m1", "smallest-pairs/simple-m1"),
        ("smallest-pairs/simple-m2", "smallest-pairs/planar-simple-m2"),
        ("smallest-pairs/planar-simple-m7", "smallest-pairs/planar-simple-m6"),
        ("fig1/search-m8", "no-twins-directional/m5"),
    ],
)
def test_the_formula_of_another_question_is_refused(copied, refuted, checkers, name, other):
    with pytest.raises(checkers("lrat").Refused, match=r"variables, not|says what it should not"):
        refuted(name, copied(other, instead_of=name))


@pytest.mark.slowest
@pytest.mark.parametrize("name", FORMULAS)
def test_no_changed_formula_is_accepted_in_the_long_run(checkers, proofs, refuted, name):
    tries = 20 if name in LARGE else 60 if name[-1] == "3" else 200
    differ, refused = refused_formulas(checkers, proofs, refuted, name, tries)
    assert differ == refused > tries // 2


@pytest.mark.parametrize("tries", [slowest(3000)])
def test_no_proof_however_changed_refutes_a_formula_that_has_a_model(checkers, proofs, tries):
    quick.test_no_proof_however_changed_refutes_a_formula_that_has_a_model(checkers, proofs, tries)
