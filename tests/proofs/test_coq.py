"""The Coq development: what can be seen without Coq, and, with it, that its guards can fail."""

import importlib.util
import re
from pathlib import Path

import pytest

COQ = Path(__file__).parents[2] / "proofs" / "coq"
README = (COQ / "README.md").read_text(encoding="utf-8")
TABLE = README.partition("\n| theorem |")[2].partition("\n\n")[0].splitlines()[2:]
LISTED = [name for name in (COQ / "_CoqProject").read_text().split() if name.endswith(".v")]


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
    python = {w for f in COQ.parent.rglob("*.py") for w in re.findall(r"\w+", f.read_text())}
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
