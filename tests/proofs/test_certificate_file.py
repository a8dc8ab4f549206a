"""A certificate that someone else has written: all that differs from what is claimed is refused."""

import re
import subprocess
import sys
from pathlib import Path
from random import Random

import pytest

COQ = Path(__file__).parents[2] / "proofs" / "coq"


@pytest.fixture
def files(checkers):
    return checkers("certificate_file")


@pytest.fixture
def mine(checkers):
    """The certificate of Algorithm 1, to one edge."""
    trees = checkers("certified_trees")
    tree = trees.tree_of(trees.built_in("algorithm1"), 1)[0]
    return trees.certificate(tree, 1, "algorithm1")


@pytest.fixture
def verified(files, tmp_path, capsys):
    """The exit code for a file with this text, and what is said."""

    def verify(text, *arguments, claimed="algorithm1", edges=1):
        file = tmp_path / "theirs.v"
        file.write_bytes(text.encode())
        code = files.verify(["--verify", str(file), claimed, "--edges", str(edges), *arguments])
        said = capsys.readouterr()
        return code, said.out + said.err

    return verify


@pytest.fixture
def any_coq(files, monkeypatch):
    """A coqc that accepts everything; the texts that it gets."""
    asked = []
    monkeypatch.setattr(files, "is_built", lambda: True)
    monkeypatch.setattr(files, "asked_of_coq", lambda f: asked.append(f.read_text()) or "accepted")
    return asked


TWELVE = {
    "another m in the comment": ("at most 1 edges.", "at most 9 edges."),
    "another m in the theorem": ("edges W <= 1", "edges W <= 0"),
    "another m in what is computed": ("AllWorlds 1 =", "AllWorlds 0 ="),
    "another class": ("edges W <= 1", "simple_world W -> edges W <= 1"),
    "no isomorphism": ("isomorphic (denote answer) (rooted z)", "True"),
    "a hypothesis": ("answers_as X tree ->", "answers_as X tree -> False ->"),
    "an axiom": (
        "Theorem right",
        "Axiom wish : False.\nTheorem aside : True. Proof. exact: I. Qed.\nTheorem right",
    ),
    "another theorem is looked at": ("Print Assumptions right_in_every_world", "About tree"),
    "no proof": ("Proof. exact: (certified_paper computed). Qed.", "Admitted."),
    "another limit": ("paper_bound (vertices W) (edges W)", "5000"),
    "another meaning of a word": (
        "Definition tree",
        "Definition answers_as (X : nat) (t : branches) := False.\nDefinition tree",
    ),
    "something behind the end": ("world.\n", "world.\nQuit.\n"),
}
"""Changed files, many of which coqc accepts with the line that it prints of a right one."""


@pytest.mark.parametrize("kind", TWELVE)
def test_a_file_that_says_something_else_is_refused_before_coq_is_asked(
    verified, any_coq, mine, kind
):
    before, after = TWELVE[kind]
    changed = mine.replace(before, after)
    assert changed != mine
    code, said = verified(changed)
    assert (code, any_coq) == (1, [])
    assert said.startswith("DIFFERS    ")
    assert "claimed is" in said


def test_what_is_claimed_is_accepted_and_nothing_else(verified, any_coq, mine):
    code, said = verified(mine, "--against", "algorithm1")
    assert (code, any_coq) == (0, [mine])
    assert said.startswith("ACCEPTED   ")
    assert "within paper in every world with at most 1 edges" in said
    assert "; algorithm1 does what the tree says" in said
    for claimed, edges, more in (
        ("algorithm2", 1, []),
        ("algorithm1", 2, []),
        ("algorithm1", 1, ["--universe", "simple"]),
        ("algorithm1", 1, ["--limit", "9"]),
    ):
        code, said = verified(mine, *more, claimed=claimed, edges=edges)
        assert code == 1
        assert "DIFFERS" in said
    assert any_coq == [mine]


FORMS = {
    "no last newline": lambda text: text.removesuffix("\n"),
    "a newline more": lambda text: text + "\n",
    "an empty line before": lambda text: "\n" + text,
    "ends of lines of another system": lambda text: text.replace("\n", "\r\n"),
    "one such end of a line": lambda text: text[:-1] + "\r\n",
    "a comment behind the end": lambda text: text + "(* the end *)",
    "a comment in the tree": lambda text: text.replace("Node 0", "(* so *) Node 0"),
    "a mark of the order of bytes": lambda text: "\ufeff" + text,
    "another tree behind the end": lambda text: text + text[text.index("Definition tree") :],
    "another tree in a comment": lambda text: "(* " + text + " *)\n" + text,
    "an empty tree": lambda text: re.sub(r"\[::\n.*?\]\.\n", "[::].\n", text, flags=re.DOTALL),
    "an empty file": lambda text: "",  # each takes the text
}
"""The ways to write a certificate otherwise that says the same, or nothing."""


@pytest.mark.parametrize("form", FORMS)
def test_in_whatever_form_a_file_is_what_is_judged_is_what_is_played(verified, any_coq, mine, form):
    changed = FORMS[form](mine)
    assert changed != mine
    for played in ("algorithm1", "algorithm1-door", None):
        code, said = verified(changed, *(["--against", played] if played else []))
        assert (code, any_coq) == (1, []), said
        assert said.startswith("DIFFERS    ")
        assert "does what the tree says" not in said


def test_an_explorer_is_played_even_where_the_file_differs(verified, any_coq, mine):
    changed = mine.replace("Node 0", "Node 2", 1).removesuffix("\n")
    code, said = verified(changed, "--against", "algorithm1")
    assert (code, any_coq) == (1, [])
    assert "no line; claimed is ''" in said
    assert "it has motion 2; algorithm1 makes motion 0" in said


def test_the_head_is_that_of_the_files_that_are_already_there(mine):
    *_, second = mine.splitlines()[:2]
    assert second.endswith("at most 1 edges.  Written by proofs/certified.py; coqc checks it.")


def test_an_empty_tree_is_compared_with_nothing_and_so_refused(files, verified, any_coq):
    code, said = verified(files.written({}, 1, "algorithm1"), "--against", "algorithm1")
    assert (code, any_coq) == (1, [])
    assert "the tree is empty" in said


def test_a_tree_that_is_not_what_the_explorer_does_is_seen_where_it_is_played(verified, mine):
    leaf = "Leaf (NumberedMap [:: 0; 1] [:: 1; 0] 1)"
    for before, after, said in (
        ("Node 0", "Node 2", "it has motion 2; algorithm1 makes motion 0"),
        (
            leaf,
            "Node 1 [::\n  ((1, Some 0), Leaf (NumberedMap [:: 0] [:: 0] 0))]",
            "algorithm1 answers Leaf(",
        ),
        (leaf, leaf.replace("1)", "0)"), "here=0); algorithm1 answers Leaf("),
        ("Node 0 [::\n ((1, None), " + leaf + ")]", leaf, "here=1); algorithm1 makes motion 0"),
    ):
        changed = mine.replace(before, after, 1)
        code, told = verified(changed, "--against", "algorithm1")
        assert code == 1, changed
        assert said in told, told


def test_of_a_program_that_is_not_there_or_is_lost_nothing_is_decided(verified, mine, any_coq):
    code, said = verified(mine, "--against", "no-such")
    assert code == 2
    assert "no-such" in said
    code, said = verified(mine, "--against", f"exec:{sys.executable} -c pass")
    assert code == 1
    assert "ends with crash: " in said
    code, said = verified(mine, "--against", "exec:sh -c 'kill -9 $$'")
    assert code == 3
    assert said.startswith("UNDECIDED")
    assert "signal 9" in said
    assert any_coq == []


def test_numbers_that_coq_could_not_hold_are_not_given_to_it(verified, mine, any_coq):
    code, said = verified(mine.replace("Node 0", "Node 1000000000", 1))
    assert (code, any_coq) == (3, [])
    assert said.startswith("UNDECIDED")
    assert "1000000000 is too large" in said


def test_a_tree_is_read_as_it_was_written_however_deep(files):
    for n in (0, 1, 1200):
        tree = end = {}
        for _ in range(n):
            node = files.Node(1)
            end[2, -1], end[3, 4] = node, files.Leaf((), (1, 0), 3)
            end = node.after
        text = files.written(tree, 1, "anyone")
        assert files.written(files.tree_in(text), 1, "anyone") == text


def test_coq_is_judged_by_all_that_it_prints(files, verified, mine, monkeypatch):
    monkeypatch.setattr(files, "is_built", lambda: True)
    good = "Closed under the global context\n"
    for code, out, err, verdict in (
        (0, good, "", 0),
        (0, good + good, "", 3),
        (0, "Axioms:\nwish : False\n", "", 3),
        (0, "", "", 3),
        (1, good, "", 3),
        (1, "", files.REFUSAL, 1),
        (0, "", files.REFUSAL, 3),
        (-9, "", "", 3),
    ):
        run = subprocess.CompletedProcess([], code, out, err)
        monkeypatch.setattr(files.subprocess, "run", lambda *_, run=run, **__: run)
        assert verified(mine)[0] == verdict, (code, out, err)


def test_it_needs_no_package_and_no_other_module(tmp_path, mine):
    file = tmp_path / "theirs.v"
    file.write_text(mine.replace("edges W <= 1", "edges W <= 2"))
    program = [sys.executable, "-I", "-S", "-c", BARE, str(COQ)]
    run = subprocess.run(
        [*program, "--verify", str(file), "algorithm1", "--edges", "1"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert (run.returncode, run.stderr) == (1, "")
    assert run.stdout.startswith("DIFFERS")


BARE = (
    "import sys; sys.path.insert(0, sys.argv.pop(1)); import certified; sys.exit(certified.main())"
)


SNIPPETS = ("False -> ", "True", "Axiom wish : False.\n", "(* ", " *)", '"', "Admitted. ", "1", " ")


def mutated(text, random):
    """The text with one seeded change: of a character, of a few, of a line, of a number."""
    while True:
        at, lines = random.randrange(len(text)), text.splitlines(keepends=True)
        i, j = random.randrange(len(lines)), random.randrange(len(lines))
        numbers = [n for n, sign in enumerate(text) if sign.isdigit()]
        n = random.choice(numbers)
        changed = random.choice(
            (
                text[:at] + random.choice(SNIPPETS) + text[at:],
                text[:at] + text[at + random.randrange(1, 9) :],
                text[:at] + chr(random.randrange(32, 127)) + text[at + 1 :],
                "".join([*lines[:i], lines[j], *lines[i + 1 :]]),
                "".join([*lines[:i], *lines[i + 1 :]]),
                "".join([*lines[:i], lines[j], *lines[i:]]),
                text[:n] + str(random.randrange(10)) + text[n + 1 :],
            )
        )
        if changed != text:
            return changed


def test_seeded_changes_are_refused_by_the_bytes_or_by_the_play_but_for_what_coq_computes(
    files, verified, any_coq, mine
):
    """A tree with a percept that is in no world is refused by coqc alone: a percept is missing."""
    random = Random(1)
    for _ in range(60):
        changed = mutated(mine, random)
        code, _ = verified(changed, "--against", "algorithm1")
        assert code in (1, 3) or seen(files, changed) != seen(files, mine), changed
    assert len(any_coq) <= 6


def seen(files, text):
    """The ways through a tree, as percepts."""
    return {tuple(percepts) for percepts, _, _ in files.ways(files.tree_in(text))}
