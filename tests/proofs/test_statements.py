"""The statements of the headline theorems are pinned: a weaker one, or another word, is seen."""

import importlib.util
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

COQ = Path(__file__).parents[2] / "proofs" / "coq"
TABLE = (COQ / "README.md").read_text(encoding="utf-8").partition("\n| theorem |")[2]
BOUND = "reached n C c -> C <= 2 * edges W ^ 2 * vertices W"
COST, PROOF = "Theorem cost_is_O_m2n", "Proof. exact: run_cost_O_m2n. Qed."
DEGREE = "Definition degree d := order sigma d."

needs_coq = pytest.mark.skipif(
    not (COQ / "Statements.vo").exists(), reason="not built: make -C proofs/coq theorems"
)


@pytest.fixture
def statements(monkeypatch):
    """The module ``statements.py``, loaded anew."""
    monkeypatch.syspath_prepend(str(COQ))
    specification = importlib.util.spec_from_file_location("statements", COQ / "statements.py")
    module = importlib.util.module_from_spec(specification)
    # Dataclasses look their module up.
    monkeypatch.setitem(sys.modules, "statements", module)
    specification.loader.exec_module(module)
    return module


@pytest.fixture
def copied(tmp_path):
    """The texts of the development, to be changed."""
    for path in [*COQ.glob("*.v"), COQ / "statements.json"]:
        shutil.copy(path, tmp_path)
    return tmp_path


def amiss(statements, folder):
    """Return how the texts of a folder differ from what is pinned there."""
    development, said = statements.read(folder)
    pinned = json.loads((folder / "statements.json").read_text())
    return said + statements.differences(pinned, development.pinned())


def changed(folder, file, old, new):
    path = folder / file
    text = path.read_text(encoding="utf-8")
    assert text.count(old) == 1, f"{file}: {old}"
    path.write_text(text.replace(old, new), encoding="utf-8")


def test_each_theorem_of_the_table_is_stated_once_and_as_it_is_pinned(statements):
    assert amiss(statements, COQ) == []
    rows = [row.split(" | ")[0] for row in TABLE.partition("\n\n")[0].splitlines()[2:]]
    named = [name for row in rows for name in re.findall(r"`(\w+)`", row)]
    listed = statements.checked((COQ / "Statements.v").read_text(encoding="utf-8"))
    assert sorted(name for name, _ in listed) == sorted(named)
    assert len(named) >= 75


# What is changed, the file, and what must be said of it.
CHANGES = [
    (
        "Main.v",
        f"{COST} (W : lighthouse_world) n C (c : configuration W) :\n  {BOUND}.\n{PROOF}",
        "Theorem cost_is_O_m2n : True.\nProof. exact: I. Qed.",
        "cost_is_O_m2n: states something else than Statements.v says",
    ),
    (
        "Main.v",
        "  paper_bound (vertices W) (edges W) <= budget -> exists",
        "  2 * paper_bound (vertices W) (edges W) <= budget -> exists",
        "explorer_correct: states something else than Statements.v says",
    ),
    ("Main.v", "Theorem cost_is_O_m2n", "Theorem cost", "cost_is_O_m2n: no headline theorem"),
    ("Statements.v", f"{BOUND}).", f"{BOUND} + 1).", "cost_is_O_m2n: states something else"),
    (
        "Statements.v",
        "Check (@cost_is_O_m2n :",
        "Check (@correct_when_done :",
        "correct_when_done: stated twice",
    ),
    ("Model.v", DEGREE, "Definition degree d := 1.", "the definition Model.v degree differs"),
    # a definition that another one is made of, and no statement names
    (
        "Pass.v",
        "Record configuration",
        "Definition tests_cost := 0. Record configuration",
        "the definition Pass.v tests_cost differs",
    ),
    # the type of what is left open in a section
    ("Model.v", "Variable W : lighthouse_world.", "Variable W : void.", "Model.v bearing differs"),
    # a field, and a constructor
    ("Model.v", "alpha_neq : forall d, alpha d != d;", "", "combinatorial_map differs"),
    (
        "Model.v",
        "AllWorlds | SimpleWorlds",
        "AllWorlds | SimpleWorlds | NoWorld",
        "universe differs",
    ),
    # a second definition of an old name, in a file that comes later
    (
        "Policies.v",
        "Set Implicit Arguments.",
        "Set Implicit Arguments. Definition vertices (x : nat) := 5.",
        "the definition Policies.v vertices is new",
    ),
    (
        "Model.v",
        "Set Implicit Arguments.",
        'Set Implicit Arguments. Notation "x <= y" := (x = x).',
        'the definition Model.v Notation "x <= y" := (x = x) is new',
    ),
    (
        "Enumeration.v",
        "Canonical numbered_map_eqType := EqType numbered_map numbered_map_eqMixin.",
        "Canonical numbered_map_eqType := EqType numbered_map other.",
        "Enumeration.v numbered_map_eqType differs",
    ),
    # what a definition takes from a theorem is that theorem's statement
    (
        "Cycles.v",
        "Lemma ring_sigma_inj : injective ring_sigma.",
        "Lemma ring_sigma_inj : injective (ring_sigma \\o id).",
        "Cycles.v ring_sigma_inj differs",
    ),
]


@pytest.mark.no_cover
@pytest.mark.parametrize(("file", "old", "new", "said"), CHANGES)
def test_a_change_of_what_is_said_is_seen(statements, copied, file, old, new, said):
    changed(copied, file, old, new)
    found = amiss(statements, copied)
    assert [line for line in found if said in line], found


def test_the_theorems_that_rest_on_a_changed_definition_are_named_and_no_others(statements, copied):
    changed(copied, "Model.v", "sum_1 n m + sum_2 n m.", "sum_1 n m + sum_2 n m + 1.")
    found = amiss(statements, copied)
    assert found[0] == "the definition Model.v paper_bound differs"
    resting = set(re.findall(r"\w+", found[-1].partition(": ")[2]))
    assert {"explorer_correct", "correct_when_done", "bound_is_polynomial"} <= resting
    assert not resting & {"motion_is_reversible", "position_is_not_enough", "cost_is_O_m2n"}


@pytest.mark.parametrize(
    ("file", "old", "new"),
    [
        ("Model.v", DEGREE, "Definition degree\n  d := (* at v *) order sigma d."),
        ("Main.v", PROOF, "Proof. by apply: run_cost_O_m2n. Qed."),
        (
            "Maps.v",
            "Set Implicit Arguments.",
            "Set Implicit Arguments. Definition a_new_word := 0.",
        ),
    ],
)
def test_a_comment_a_proof_or_a_new_word_changes_nothing(statements, copied, file, old, new):
    changed(copied, file, old, new)
    assert amiss(statements, copied) == []


@pytest.mark.no_cover
def test_what_is_written_on_purpose_is_then_pinned(statements, copied, monkeypatch, capsys):
    changed(copied, "Model.v", "sum_1 n m + sum_2 n m.", "sum_1 n m + sum_2 n m + 1.")
    monkeypatch.setattr(statements, "HERE", copied)
    monkeypatch.setattr(sys, "argv", ["statements.py"])
    assert statements.main() == 1
    assert "the definition Model.v paper_bound differs" in capsys.readouterr().out
    monkeypatch.setattr(sys, "argv", ["statements.py", "--write"])
    assert statements.main() == 0
    assert amiss(statements, copied) == []


def test_a_check_of_another_form_is_refused(statements):
    with pytest.raises(ValueError, match="not of the form"):
        statements.checked("Check cost_is_O_m2n.")
    with pytest.raises(ValueError, match="does not end"):
        list(statements.items_of("A.v", "Section S. Definition a := 1."))


@needs_coq
@pytest.mark.slow
@pytest.mark.long
def test_coq_finds_what_the_texts_do_not_show(statements, monkeypatch, capsys):
    """The reader of the texts is made blind for one file; Coq names what it has overlooked."""
    development, _ = statements.read(COQ)
    seen = {
        name: [item for item in items if item.file != "Pass.v"]
        for name, items in development.items.items()
    }
    blind = statements.Development(development.statements, seen, development.unnamed)
    found = statements.asked_of_coq(blind)
    assert "Coq: the statements rest on Pass.v reached, which was not found" in found
    assert int(re.search(r"rest on (\d+) names", capsys.readouterr().out)[1]) > 400


@needs_coq
@pytest.mark.slow
def test_coq_refuses_a_statement_that_is_not_proved(tmp_path):
    text = (COQ / "Statements.v").read_text(encoding="utf-8")
    command = ["coqc", "-w", "none", "-Q", str(COQ), "Allworlds"]
    for name, old, new in [("right", "", ""), ("wrong", f"{BOUND}).", f"{BOUND} - 1).")]:
        path = tmp_path / f"{name}.v"
        path.write_text(text.replace(old, new) if old else text)
        run = subprocess.run([*command, str(path)], capture_output=True, check=False)
        assert (run.returncode == 0) == (name == "right")
