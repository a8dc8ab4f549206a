"""The second opinions can say nothing else than they should.

The claim's own checker is called, which knows nothing of digests: so what is asked is whether a
producer that is wrong would be noticed.  Both files of a statement are changed together wherever
the one would give the other away.
"""

import hashlib
import json
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass

import pytest

from allworlds.document import replace

REFUSALS = (ValueError, KeyError, IndexError, TypeError, AttributeError, RecursionError)
"""Taken for a refusal by ``check.py``, besides ``Refused``."""

BASES = {
    "key-lemma-step": "key-lemma-base",
    "match-proves-step": "match-proves-base",
    "truth-matches-step": "truth-matches-base",
}
OTHERS = {
    "loop-keeps-I1": "start-has-I",
    "loop-keeps-I2": "vertex-keeps-I2",
    "vertex-keeps-I1": "loop-keeps-I1",
    "bound-sum-1-step": "bound-sum-2-step",
    "bound-run-step": "bound-one-pass",
    "folding-merges-forced": "folding-links-forced",
    "exit-map-is-world": "exit-closed",
    "direction-needed": "key-lemma-base",
}


@dataclass(frozen=True)
class Files:
    """A statement and its model, taken apart."""

    remarks: str
    before: tuple[str, ...]
    hypotheses: tuple[str, ...]
    conclusion: tuple[str, ...]
    model: tuple[str, ...]

    @property
    def texts(self):
        asserted = [*self.hypotheses, *self.conclusion]
        lines = [*self.before, *(f"(assert {law})" for law in asserted), "(check-sat)"]
        model = [*self.model, *(f"(assert {law})" for law in self.hypotheses), "(check-sat)"]
        return "\n".join([self.remarks, *lines, ""]), "\n".join([*model, ""])


def shown(term):
    return term if isinstance(term, str) else f"({' '.join(map(shown, term))})"


@pytest.fixture
def opinions(checkers, checker_of):
    """The checker, and how a statement is taken apart."""
    commands = checkers("smtlib").commands
    module = checker_of("second-opinions")

    def taken_apart(folder, name):
        text = (folder / f"{name}.smt2").read_text()
        model = (folder / f"{name}.model.smt2").read_text()
        remarks = "\n".join(line for line in text.splitlines() if line.startswith(";"))
        script = commands(text)
        laws = [shown(command[1]) for command in script if command[0] == "assert"]
        parts = len(laws) if "; Expected: sat" in text else len(laws) - 1
        return Files(
            remarks,
            tuple(shown(c) for c in script if c[0] not in ("assert", "check-sat")),
            tuple(laws[:parts]),
            tuple(laws[parts:]),
            tuple(shown(c) for c in commands(model) if c[0] not in ("assert", "check-sat")),
        )

    module.taken_apart = taken_apart
    return module


def of_the_conclusion(files):
    """Ways to make the conclusion say something else."""
    if not files.conclusion:
        yield "another question", replace(files, conclusion=("true",))
        return
    [denied] = files.conclusion
    meant = denied.removeprefix("(not ").removesuffix(")")
    yield "true", replace(files, conclusion=("(not true)",))
    yield "false", replace(files, conclusion=("(not false)",))
    yield "nothing to prove", replace(files, conclusion=("false",))
    yield "left out", replace(files, conclusion=())
    yield "not denied", replace(files, conclusion=(meant,))
    yield "assumed", replace(files, hypotheses=(*files.hypotheses, meant))
    yield "its first hypothesis", replace(files, conclusion=(f"(not {files.hypotheses[0]})",))
    yield "weakened", replace(files, conclusion=(f"(not (or {meant} (not {meant})))",))


def of_a_hypothesis(files):
    """Ways to assume something else, in the statement and in its model."""
    for i, law in enumerate(files.hypotheses):
        before, after = files.hypotheses[:i], files.hypotheses[i + 1 :]
        changed = {"dropped": (), "true": ("true",), "doubled": (law, law)}
        changed["weakened"] = (f"(or {law} true)",)
        if law.startswith("(forall "):
            changed["somewhere"] = (law.replace("(forall ", "(exists ", 1),)
        if law.startswith("(= "):
            changed["turned round"] = (f"(not {law})",)
        for how, laws in changed.items():
            yield f"{how}, {i + 1}", replace(files, hypotheses=(*before, *laws, *after))
    yield "a contradiction", replace(files, hypotheses=(*files.hypotheses, "false"))


def of_the_rest(files):
    """Ways to mean something else by the same formulas, or to ask another question."""
    logic, *symbols = files.before
    flipped = {"unsat": "sat", "sat": "unsat"}
    other = re.sub(r"Expected: (\w+)", lambda m: f"Expected: {flipped[m[1]]}", files.remarks)
    yield "the other answer", replace(files, remarks=other)
    yield "both answers", replace(files, remarks=f"{files.remarks}\n; Expected: sat")
    yield "another logic", replace(files, before=("(set-logic ALL)", *symbols))
    yield "no symbols", replace(files, before=(logic,))
    for i, command in enumerate(symbols):
        if command.startswith("(define-fun "):
            head = command.partition(" Real ")[0]
            same = [c for c in files.model if c != command]
            empty = f"{head} Real 0.0)"
            left = [*symbols[:i], empty, *symbols[i + 1 :]]
            yield (
                f"{head} is 0",
                replace(files, before=(logic, *left), model=(*same, empty)),
            )
    title, _, rest = files.remarks.partition("\n")
    yield "another title", replace(files, remarks=f"{title}, always\n{rest}")


def corruptions(files):
    for ways in (of_the_conclusion, of_a_hypothesis, of_the_rest):
        for how, damaged in ways(files):
            assert damaged != files, how
            yield f"{ways.__name__}: {how}", damaged


def refused(module, name, texts):
    try:
        module.require_statement(name, *texts)
    except (module.Refused, *REFUSALS):
        return True
    return False


def test_the_files_are_accepted_with_other_spaces_and_without_remarks(opinions, proofs):
    for name in opinions.STATEMENTS:
        files = opinions.taken_apart(proofs / "second-opinions", name)
        opinions.require_statement(name, *files.texts)


def test_no_statement_can_say_anything_else(opinions, proofs):
    accepted, tried = [], 0
    for name in opinions.STATEMENTS:
        files = opinions.taken_apart(proofs / "second-opinions", name)
        for how, damaged in corruptions(files):
            tried += 1
            if not refused(opinions, name, damaged.texts):
                accepted.append(f"{name}: {how}")
    assert accepted == []
    assert tried > 1000


def test_no_statement_stands_in_the_place_of_another(opinions, proofs):
    """A step by its base, or by its neighbour: under its own title, with the model of the other."""
    for name, other in {**BASES, **OTHERS}.items():
        own = opinions.taken_apart(proofs / "second-opinions", name)
        theirs = opinions.taken_apart(proofs / "second-opinions", other)
        assert refused(opinions, name, replace(theirs, remarks=own.remarks).texts)
        assert refused(opinions, name, theirs.texts)


LOGIC = "(set-logic ALL)"
DEGREES = "(declare-datatypes ((Degree 0)) (((two))))"


@pytest.mark.parametrize(
    ("old", "new", "reason"),
    [
        # every equation is true
        (LOGIC, f"{LOGIC}(define-fun = ((p Bool) (q Bool)) Bool true)", "cannot be defined"),
        (LOGIC, f"{LOGIC}(define-fun and ((p Bool) (q Bool)) Bool true)", "cannot be defined"),
        (LOGIC, f"{LOGIC}(define-fun true () Bool false)", "cannot be defined"),
        # a symbol twice: the last one is looked at
        (DEGREES, f"{DEGREES}(define-fun pointed () Dart c0)", "cannot be defined"),
        (DEGREES, f"{DEGREES}{DEGREES}", "cannot be a sort"),
        # a sort without darts, or with a dart too few
        ("(((a0) (a1) (b0) (b1) (c0) (c1)))", "(())", "cannot be a sort"),
        ("(((a0) (a1) (b0) (b1) (c0) (c1)))", "(((a0) (a1) (b0) (b1) (c0)))", "not defined"),
        ("(((two)))", "(((two) (three (of Dart))))", "arguments"),
        # values of another sort
        ("(define-fun pointed () Dart a0)", "(define-fun pointed () Dart two)", "is of sort"),
        ("(define-fun pointed () Dart a0)", "(define-fun pointed () Dart 0)", "is of sort"),
        ("(define-fun pointed () Dart a0)", "(define-fun pointed () Degree two)", "of .'Degree'"),
        ("(define-fun pointed () Dart a0)", "(declare-const pointed Dart)", "in this order"),
        ("(define-fun pointed () Dart a0)", "(define-fun pointed () Dart pointed)", "not defined"),
        ("(define-fun x () Dart b1)", "(define-fun x () Dart c1)", "makes a hypothesis false"),
        ("(define-fun x () Dart b1)", "", "x is not defined"),
        ("(define-fun x () Dart b1)", "(define-fun x ((y Dart)) Dart b1)", "x is not defined"),
        ("(assert (home pointed))", "", "other hypotheses"),
        ("(assert (home pointed))", "(assert (home a0))", "other hypotheses"),
        ("(check-sat)", "(assert true) (check-sat)", "other hypotheses"),
        ("(check-sat)", "", "in this order"),
        ("(check-sat)", "(check-sat) (exit)", "in this order"),
        ("(check-sat)", "() (check-sat)", "in this order"),
    ],
)
def test_a_model_that_is_none_is_refused(opinions, proofs, old, new, reason):
    folder = proofs / "second-opinions"
    text = (folder / "direction-needed.smt2").read_text()
    model = (folder / "direction-needed.model.smt2").read_text()
    assert model.count(old) == 1
    with pytest.raises(opinions.Refused, match=reason):
        opinions.require_statement("direction-needed", text, model.replace(old, new))


@pytest.mark.parametrize(
    ("name", "damage", "reason"),
    [
        ("key-lemma-base", {"conclusion": "(= x pointed)"}, "makes the conclusion false"),
        ("turns-reversible", {"conclusion": "(= d (turn_k d))"}, "makes the conclusion false"),
        ("bound-one-pass", {"conclusion": "(<= cost s)"}, "makes the conclusion false"),
        ("variant-bounds-passes", {"conclusion": "(< t t_after)"}, "makes the conclusion false"),
        ("exit-closed", {"hypotheses": ("(and false false)",)}, "makes a hypothesis false"),
    ],
)
def test_were_a_statement_wrong_in_the_checker_too_its_model_would_say_so(
    opinions, proofs, monkeypatch, name, damage, reason
):
    wrong = replace(opinions.STATEMENTS[name], **damage)
    monkeypatch.setitem(opinions.STATEMENTS, name, wrong)
    files = opinions.taken_apart(proofs / "second-opinions", name)
    conclusion = (f"(not {wrong.conclusion})",)
    damaged = replace(files, hypotheses=wrong.hypotheses, conclusion=conclusion)
    with pytest.raises(opinions.Refused, match=reason):
        opinions.require_statement(name, *damaged.texts)


@pytest.mark.parametrize(
    "law",
    [
        "(= 1 1.0)",
        "(= true 1)",
        "(and true 1)",
        "(not true true)",
        "(ite true 1 true)",
        "(< true false)",
        "(+ 1 2)",
        "(forall ((x Nowhere)) true)",
        "(forall ((x Int) (x Int)) true)",
        "(forall ((x Int)) x)",
        "(forall ((true Int)) true)",
        "(forall true)",
        "(of 1)",
        "(f true)",
        "(f)",
        "f",
        "01",
        "()",
        "((f 1))",
    ],
)
def test_what_has_no_sort_is_refused(checkers, law):
    smtlib = checkers("smtlib")
    script = f"(set-logic ALL)(define-fun f ((x Int)) Bool (= x 1))(assert {law})(check-sat)"
    with pytest.raises((smtlib.Refused, TypeError, ValueError)):
        smtlib.require_well_sorted(smtlib.commands(script))


def test_what_has_a_sort_is_not_refused(checkers):
    smtlib = checkers("smtlib")
    laws = ["(f 1)", "(= (- 1) (+ 1 2))", "(= (ite true 1.0 2.0) (- 3.0 1.5))", "(=> true false)"]
    laws += ["(forall ((x Int) (f Bool)) (or f (< x 3 4)))"]
    script = "".join(f"(assert {law})" for law in laws)
    script = f"(set-logic ALL)(define-fun f ((x Int)) Bool (= x 1)){script}(check-sat)"
    smtlib.require_well_sorted(smtlib.commands(script))


def one_of_each(opinions, folder):
    """Eight corruptions, as they were once accepted: what is removed, and what is written."""
    yield "all statements removed", opinions.STATEMENTS, {}
    for name, how in [
        ("key-lemma-step", "of_the_conclusion: true"),
        ("vertex-keeps-I1", "of_the_conclusion: false"),
        ("bound-polynomial", "of_the_conclusion: assumed"),
        ("folding-merges-forced", "of_a_hypothesis: dropped, 1"),
        ("loop-keeps-I2", "of_the_conclusion: its first hypothesis"),
    ]:
        damaged = dict(corruptions(opinions.taken_apart(folder, name)))[how]
        yield f"{name}: {how}", [], {name: damaged.texts}
    for name, base in list(BASES.items())[:2]:
        files = opinions.taken_apart(folder, base)
        yield f"{name} by its base", [], {name: files.texts}


@pytest.mark.slow
def test_digests_made_anew_do_not_help(opinions, proofs, tmp_path):
    ignored = shutil.ignore_patterns("coq", "__p*")
    copy = shutil.copytree(proofs, tmp_path / "proofs", ignore=ignored)
    folder, manifest = copy / "second-opinions", copy / "manifest.json"
    committed = {path: path.read_text() for path in [manifest, *folder.glob("*.smt2")]}
    kinds = list(one_of_each(opinions, proofs / "second-opinions"))
    assert len(kinds) == 8
    for how, removed, written in [("no corruption", [], {}), *kinds]:
        for path, text in committed.items():
            path.write_text(text)
        for name in removed:
            (folder / f"{name}.smt2").unlink()
            (folder / f"{name}.model.smt2").unlink()
        for name, (text, model) in written.items():
            (folder / f"{name}.smt2").write_text(text)
            (folder / f"{name}.model.smt2").write_text(model)
        digests = {
            name: digest
            for name, digest in json.loads(committed[manifest]).items()
            if not name.startswith("second-opinions/")
        }
        for path in folder.glob("*.smt2"):
            digests[f"second-opinions/{path.name}"] = hashlib.sha256(path.read_bytes()).hexdigest()
        manifest.write_text(json.dumps(digests))
        command = [sys.executable, str(copy / "check.py"), "--only", "second-opinions"]
        ran = subprocess.run(command, capture_output=True, text=True, check=False)
        assert ran.returncode == int(how != "no corruption"), f"{how}: {ran.stdout}"
        assert ("FAILS" in ran.stdout) == (how != "no corruption"), f"{how}: {ran.stdout}"
