"""The Coq files of this paper: what can be seen without Coq; ``make`` sees the rest."""

import importlib.util
import json
import re
from pathlib import Path

import pytest

COQ = Path(__file__).parents[1] / "coq"
BASE = Path(__file__).parents[3] / "proofs" / "coq"
LISTED = [name for name in (COQ / "_CoqProject").read_text().split() if name.endswith(".v")]
LAYOUT, TABLE = (
    [row for row in part.splitlines() if row.startswith("| `")]
    for part in (COQ / "README.md").read_text(encoding="utf-8").split("## What is proved")
)


def module(name):
    """A program of the proofs, imported from its file."""
    spec = importlib.util.spec_from_file_location(Path(name).stem, BASE / f"{name}.py")
    loaded = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(loaded)
    return loaded


GUARD = module("check_assumptions")
CODE = {name: GUARD.without_comments((COQ / name).read_text(encoding="utf-8")) for name in LISTED}
THEOREMS = re.findall(r"^Theorem (\w+)", CODE["Main.v"], re.MULTILINE)
STATED = re.compile(
    r"^(?:Theorem|Lemma|Corollary|Definition|Fixpoint|Record|Inductive) (\w+)", re.MULTILINE
)


def test_every_file_is_listed_and_described_and_every_listed_file_is_there():
    assert sorted(LISTED) == sorted(path.name for path in COQ.glob("*.v"))
    assert [re.match(r"\| `(\w+\.v)`", row)[1] for row in LAYOUT] == LISTED


@pytest.mark.parametrize("name", LISTED)
def test_nothing_is_admitted_or_assumed(name):
    assert GUARD.suspect((COQ / name).read_text(encoding="utf-8")) == []


def test_each_theorem_is_in_the_table_and_stated_once_more():
    assert len(THEOREMS) == 17
    assert GUARD.not_a_theorem(CODE["Main.v"]) == []
    assert GUARD.stated(CODE["Statements.v"]) == THEOREMS
    named = [n for row in TABLE for n in re.findall(r"`(\w+)`", row.split(" | ")[0])]
    assert named == THEOREMS


def test_the_tables_name_what_the_files_state():
    """A name without a file stands in the file that was named last in its row."""
    for row in LAYOUT:
        file, *names = re.findall(r"`([\w.]+)`", row)
        assert set(names) <= set(STATED.findall(CODE[file])), file
    for row in TABLE:
        file = ""
        for where, name in re.findall(r"`(?:(\w+)\.)?(\w+)`", row.split(" | ")[3]):
            file = f"{where}.v" if where else file
            text = CODE[file] if file in CODE else (BASE / file).read_text(encoding="utf-8")
            assert name in STATED.findall(text), name


def test_every_mutant_applies_and_is_followed_to_what_rests_on_it(monkeypatch):
    monkeypatch.chdir(COQ)
    run = module("mutants/run")
    for mutant in json.loads((COQ / "mutants" / "mutants.json").read_text(encoding="utf-8")):
        text = (COQ / mutant["file"]).read_text(encoding="utf-8")
        assert text.count(mutant["old"]) == 1, mutant["name"]
        order = run.in_order(mutant)
        assert order[0] == mutant["file"]
        assert mutant["dies_in"] in order
