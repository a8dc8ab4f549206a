"""The Coq development: what can be seen without Coq, and, with it, that its guards can fail."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

COQ = Path(__file__).parents[2] / "proofs" / "coq"
README = (COQ / "README.md").read_text(encoding="utf-8")
TABLE = README.partition("\n| theorem |")[2].partition("\n\n")[0].splitlines()[2:]
LISTED = [name for name in (COQ / "_CoqProject").read_text().split() if name.endswith(".v")]

needs_coq = pytest.mark.skipif(
    shutil.which("coqc") is None, reason="Coq is not installed (Debian: coq, mathcomp-ssreflect)"
)
needs_programs = pytest.mark.skipif(
    not (COQ / "explorer").exists(), reason="not built: make -C proofs/coq explorer"
)


def without_comments(text):
    """Coq's comments nest; take away the innermost until there are none."""
    while (shorter := re.sub(r"\(\*(?:(?!\(\*|\*\)).)*\*\)", "", text, flags=re.DOTALL)) != text:
        text = shorter
    return text


def test_every_file_is_listed_and_every_listed_file_is_there():
    assert sorted(LISTED) == sorted(path.name for path in COQ.glob("*.v"))


@pytest.mark.parametrize("name", LISTED)
def test_nothing_is_admitted_or_assumed(name):
    code = without_comments((COQ / name).read_text(encoding="utf-8"))
    assert not re.search(r"\b(Admitted|admit|Axiom|Axioms|Parameter|Conjecture)\b", code)


@pytest.mark.parametrize(("name", "at_least"), [("Main.v", 11), ("Further.v", 32)])
def test_the_headline_theorems_are_proved_by_naming_their_proof(name, at_least):
    code = without_comments((COQ / name).read_text(encoding="utf-8"))
    theorems = re.findall(r"^Theorem\b.*?^(?:Proof\..*?)?Qed\.", code, re.MULTILINE | re.DOTALL)
    assert len(theorems) >= at_least
    proofs = [text.partition("Proof.")[2] for text in theorems]
    assert all(0 < len(proof) < 300 for proof in proofs)


def headline_theorems(name):
    return re.findall(r"^Theorem (\w+)", (COQ / name).read_text(encoding="utf-8"), re.MULTILINE)


def test_the_table_names_every_headline_theorem_and_the_main_ones_in_bold():
    rows = [row.split(" | ")[0] for row in TABLE]
    named = [(name, bold != "") for row in rows for bold, name in re.findall(r"(\**)`(\w+)`", row)]
    assert sorted(named) == sorted(
        [(name, True) for name in headline_theorems("Main.v")]
        + [(name, False) for name in headline_theorems("Further.v")]
    )


STATED = re.compile(r"^(?:Theorem|Lemma|Corollary) (\w+)", re.MULTILINE)


def test_the_table_names_the_proofs_and_the_files_that_hold_them():
    """A name without a file stands in the file that was named last in its row."""
    named = 0
    for row in TABLE:
        file = ""
        for where, name in re.findall(r"`(?:(\w+)\.)?(\w+)`", row.split(" | ")[4]):
            file = where or file
            assert name in STATED.findall((COQ / f"{file}.v").read_text(encoding="utf-8")), name
            named += 1
    assert named > 50


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """A copy of the folder, compiled."""
    copy = tmp_path_factory.mktemp("coq") / "coq"
    shutil.copytree(COQ, copy)
    make = subprocess.run(
        ["make", "-C", str(copy), "-j2", "theorems"], capture_output=True, text=True, check=False
    )
    assert make.returncode == 0, make.stderr[-2000:]
    return copy


@needs_coq
@pytest.mark.slow
def test_every_headline_theorem_is_closed_under_the_global_context(built):
    checked = subprocess.run(["make", "-C", str(built), "assumptions"], check=False)
    assert checked.returncode == 0


@needs_coq
@pytest.mark.slow
def test_a_theorem_that_rests_on_an_axiom_is_refused(built, tmp_path):
    copy = tmp_path / "coq"
    shutil.copytree(built, copy)
    with (copy / "Main.v").open("a", encoding="utf-8") as main:
        main.write(
            "\nAxiom wish : 0 = 1.\nTheorem rests_on_a_wish : 0 = 1. Proof. exact wish. Qed.\n"
        )
    checked = subprocess.run(
        ["make", "-C", str(copy), "assumptions"], capture_output=True, check=False
    )
    assert checked.returncode != 0


@needs_coq
@pytest.mark.slow
def test_a_certificate_with_a_changed_class_is_no_theorem(built, tmp_path):
    root = tmp_path / "project"
    for folder in ("fig1", "smallest-pairs", "natural-lighthouse"):
        shutil.copytree(COQ.parent / folder, root / "proofs" / folder)
    shutil.copytree(built, root / "proofs" / "coq")
    shutil.copytree(COQ.parents[1] / "corpus" / "pairs", root / "corpus" / "pairs")
    run = [sys.executable, str(root / "proofs" / "coq" / "certificates.py")]
    assert subprocess.run(run, capture_output=True, check=False).returncode == 0
    pair = root / "corpus" / "pairs" / "two-loops.json"
    text = pair.read_text()
    pair.write_text(text.replace('"bisimulation": [\n  [\n   0', '"bisimulation": [\n  [\n   7'))
    assert pair.read_text() != text
    assert subprocess.run(run, capture_output=True, check=False).returncode == 1


@needs_programs
@pytest.mark.slow
def test_the_certified_programs_agree_with_the_python_ones():
    run = [sys.executable, str(COQ.parent / "certified.py"), "--edges", "3", "--judged-edges", "2"]
    told = subprocess.run(run, capture_output=True, text=True, check=False)
    assert told.returncode == 0, told.stdout
    assert told.stdout.splitlines()[-1] == "AGREE"
