"""The Coq development: what can be seen without Coq, and, with it, that its guards can fail."""

import importlib.util
import json
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
builds = pytest.mark.timeout(1200)
"""Of a test whose fixture compiles all of the proofs."""
needs_programs = pytest.mark.skipif(
    not (COQ / "explorer").exists(), reason="not built: make -C proofs/coq explorer"
)


def module(name):
    """A program of the folder, imported from its file."""
    spec = importlib.util.spec_from_file_location(name, COQ / f"{name}.py")
    loaded = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(loaded)
    return loaded


GUARD = module("check_assumptions")
CODE = {name: GUARD.without_comments((COQ / name).read_text(encoding="utf-8")) for name in LISTED}
WORDS = {word for code in CODE.values() for word in re.findall(r"[A-Za-z_][\w']*", code)}


def test_every_file_is_listed_and_every_listed_file_is_there():
    assert sorted(LISTED) == sorted(path.name for path in COQ.glob("*.v"))


@pytest.mark.parametrize("name", LISTED)
def test_nothing_is_admitted_or_assumed(name):
    assert GUARD.suspect((COQ / name).read_text(encoding="utf-8")) == []


@pytest.mark.parametrize(
    "text",
    [
        "Lemma wish : 0 = 1. Proof. Admitted.",
        "Axiom wish : 0 = 1.",
        "Local Parameter wish : 0 = 1.",
        "Variable n : nat.",
        "Section S. Variable n : nat. End S. Hypothesis wish : 0 = 1.",
        "Section S. End S. Context (n : nat).",
        "Unset Guard Checking.",
        "Local Unset Positivity Checking.",
        "Unset Universe Checking.",
        "#[bypass_check(guard)] Fixpoint f (n : nat) : nat := f n.",
        "Next Obligation. Admit Obligations.",
        "Require Import Coq.Logic.Classical_Prop.",
    ],
)
def test_a_text_that_assumes_or_switches_a_check_off_is_seen(text):
    assert GUARD.suspect(f"Set Implicit Arguments.\n{text}\n") != []


def test_what_assumes_nothing_is_not_suspected():
    text = """(* Axiom (* Variable *) *) Set Implicit Arguments.
Unset Strict Implicit. Set Warnings "-abstract-large-number".
Section S. Variables (n : nat). Hypothesis n0 : 0 < n. Let m := n.
Lemma l : m = n. Proof. by []. Qed. End S."""
    assert GUARD.suspect(text) == []


@pytest.mark.parametrize("word", ["Lemma", "Corollary", "Fact", "Definition", "Example"])
def test_a_headline_that_is_no_theorem_is_seen(word):
    text = f"Theorem a : True. Proof. exact: I. Qed.\n{word} b : True. Proof. exact: I. Qed."
    assert GUARD.not_a_theorem(text) == [f"{word} b : True"]
    assert GUARD.not_a_theorem(text.replace(word, "  Theorem")) == []


@pytest.mark.parametrize(("name", "at_least"), [("Main.v", 11), ("Further.v", 32)])
def test_the_headline_theorems_are_proved_by_naming_their_proof(name, at_least):
    theorems = re.findall(
        r"^Theorem\b.*?^(?:Proof\..*?)?Qed\.", CODE[name], re.MULTILINE | re.DOTALL
    )
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


def test_each_headline_theorem_is_stated_once_more():
    text = CODE["Statements.v"]
    stated = GUARD.stated(text)
    assert len(stated) == len(re.findall(r"^Check\b", text, re.MULTILINE))
    assert sorted(stated) == sorted(headline_theorems("Main.v") + headline_theorems("Further.v"))


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


# words of the texts that are no names of Coq: programs, files, make targets, words of its language
NOT_COQ = {"coqc", "coqchk", "make", "python3", "core_speed", "explorer", "judge", "minimality"}
NOT_COQ |= {"checker", "folding"}
NOT_COQ |= {"proofs", "coq", "coqdoc", "Admitted", "Axiom", "Parameter", "Variable"}


@pytest.mark.parametrize("text", ["coq/README.md", "coq/LAYOUT.md", "README.md"])
def test_no_text_names_what_is_not_there(text):
    """Every single word in backticks is in the code, or is the name of a file."""
    path = COQ.parent / text
    python = {w for f in COQ.parent.glob("*.py") for w in re.findall(r"\w+", f.read_text())}
    named = re.findall(r"`([\w.']+)`", path.read_text(encoding="utf-8"))
    files = {file.name for file in COQ.parent.rglob("*")}
    known = WORDS | NOT_COQ | (python if text == "README.md" else set())
    assert [n for n in named if n.split(".")[-1] not in known and n not in files] == []


def test_the_layout_names_every_file_once_and_what_is_stated_there():
    row = re.compile(r"^\| `(\w+\.v)` \|.*\|(.*)\|$", re.MULTILINE)
    rows = row.findall((COQ / "LAYOUT.md").read_text(encoding="utf-8"))
    assert [name for name, _ in rows] == LISTED
    stated = re.compile(
        r"^(?:Theorem|Lemma|Corollary|Example|Definition|Fixpoint|Record|Inductive) (\w+)",
        re.MULTILINE,
    )
    for name, names in rows:
        assert set(re.findall(r"`(\w+)`", names)) <= set(stated.findall(CODE[name])), name


@pytest.mark.parametrize("name", LISTED)
def test_no_glossary_explains_what_is_not_there(name):
    """At the head of a file: the words of the first column, or what they are the beginning of."""
    head = (COQ / name).read_text(encoding="utf-8").partition("*)")[0]
    for line in re.findall(r"^ {5}(\S.*?)(?: {2,}.*)?$", head, re.MULTILINE):
        for part in re.sub(r"\([^)]*\)", "", line).split(","):
            word = re.match(r"\s*([A-Za-z_][\w']*)", part)
            if word:
                begun = any(w.startswith(f"{word[1]}_") for w in WORDS)
                assert word[1] in WORDS or begun, f"{name}: {line}"


def test_the_picture_leaves_out_what_follows_and_refuses_a_circle():
    draw = module("dependencies")
    depend = "A.vo A.glob: A.v \nB.vo B.glob: B.v A.vo\nC.vo C.glob: C.v A.vo B.vo\n"
    arrows = draw.reduced(draw.needs(depend))
    assert arrows == {"A": set(), "B": {"A"}, "C": {"B"}}
    assert draw.rows(arrows) == [["A"], ["B"], ["C"]]
    assert draw.picture(arrows).count("<rect") == 3
    assert draw.picture(arrows).count("<path") == 2
    with pytest.raises(ValueError, match="circle among A, B"):
        draw.reduced({"A": {"B"}, "B": {"A"}})
    with pytest.raises(ValueError, match="not the dependencies"):
        draw.needs("B.vo B.glob: B.v A.vo\n")


def test_the_limit_counts_the_time_of_the_processor_and_says_when_it_was_short():
    limit = str(COQ / "limit")
    short = subprocess.run(
        [limit, "1", sys.executable, "-c", "while True: pass"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert short.returncode in (137, 152)
    assert "limit: out of time after 1 s of CPU" in short.stderr
    assert subprocess.run([limit, "5", "false"], check=False).returncode == 1
    assert subprocess.run([limit, "5", "true"], check=False).returncode == 0


@pytest.mark.slow
def test_a_mutant_is_followed_to_where_it_should_die_first_and_then_to_all_that_rests_on_it(
    monkeypatch,
):
    monkeypatch.chdir(COQ)
    run = module("mutants/run")
    for mutant in json.loads((COQ / "mutants" / "mutants.json").read_text(encoding="utf-8")):
        order = run.in_order(mutant)
        assert sorted(order) == sorted(run.affected(mutant["file"]))
        assert order[0] == mutant["file"]
        dies_in = mutant.get("dies_in", mutant["file"])
        before = order[: order.index(dies_in)]
        assert set(before) < run.needed(dies_in)
        done = set(LISTED) - set(order)
        for name in order:
            assert run.imports(name) <= done, name
            done.add(name)


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
@builds
@pytest.mark.slow
@pytest.mark.long
def test_every_headline_theorem_is_closed_under_the_global_context(built):
    checked = subprocess.run(["make", "-C", str(built), "assumptions"], check=False)
    assert checked.returncode == 0


@needs_coq
@builds
@pytest.mark.slow
@pytest.mark.parametrize(
    ("written", "reason"),
    [
        (
            "Axiom wish : 0 = 1.\nTheorem rests_on_a_wish : 0 = 1. Proof. exact wish. Qed.",
            "Axioms:\nMain.wish : 0 = 1\n",
        ),
        ("Theorem new : True. Proof. exact: I. Qed.", "new: not stated in Statements.v"),
    ],
)
def test_a_theorem_on_an_axiom_or_without_a_statement_is_refused(built, tmp_path, written, reason):
    copy = tmp_path / "coq"
    shutil.copytree(built, copy)
    with (copy / "Main.v").open("a", encoding="utf-8") as main:
        main.write(f"\n{written}\n")
    make = ["make", "-C", str(copy), "theorems"]
    subprocess.run(make, capture_output=True, check=True)
    guard = [sys.executable, "check_assumptions.py", "Main.v", "Further.v"]
    checked = subprocess.run(guard, cwd=copy, capture_output=True, text=True, check=False)
    assert checked.returncode == 1
    assert reason in checked.stdout


@needs_coq
@builds
@pytest.mark.slow
@pytest.mark.parametrize(("claimed", "code"), [("", 0), (" - 1", 1)])
def test_coq_refuses_a_statement_that_is_not_proved(built, tmp_path, claimed, code):
    bound = "reached n C c -> C <= 2 * edges W ^ 2 * vertices W"
    assert CODE["Statements.v"].count(f"{bound})") == 1
    path = tmp_path / "claimed.v"
    path.write_text(CODE["Statements.v"].replace(f"{bound})", f"{bound}{claimed})"))
    command = ["coqc", "-w", "none", "-Q", str(built), "Allworlds", str(path)]
    assert subprocess.run(command, capture_output=True, check=False).returncode == code


@needs_coq
@builds
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
@pytest.mark.long
def test_the_certified_programs_agree_with_the_python_ones():
    low = ("walked", "judged", "checked", "folded")
    limits = [word for name in low for word in (f"--{name}-edges", "2")]
    run = [sys.executable, str(COQ.parent / "certified.py"), "--edges", "3", *limits]
    told = subprocess.run(run, capture_output=True, text=True, check=False)
    assert told.returncode == 0, told.stdout
    assert told.stdout.splitlines()[-1] == "AGREE"
