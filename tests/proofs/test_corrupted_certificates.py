"""Certificates for Coq's kernel that say something else than what is right: coqc refuses each.

A certificate of Algorithm 1 is changed, one place at a time and in a fixed order.  A change need
not make it false: of a path with one edge both ends look alike.  So ``allworlds check`` is asked
whether the explorer that does as the changed tree says is still right, and coqc must say the same.
"""

import pytest

from allworlds.maps import rooted_code

EDGES = 2
BOTH = ("accepted", "refused")


@pytest.fixture
def trees(checkers):
    return checkers("certified_trees")


@pytest.fixture
def files(checkers):
    """What asks Coq."""
    return checkers("certificate_file")


# ---- Changes ----


def code(leaf, here=None):
    return rooted_code(leaf.sigma, leaf.alpha, leaf.here if here is None else here)


# ---- What is stated besides the tree ----


OTHER_TEXTS = {
    "the theorem says a larger m": ("edges W <= 2", "edges W <= 3"),
    "the theorem says a smaller limit": ("(paper_bound (vertices W) (edges W))", "(edges W)"),
    "of every explorer": ("answers_as X tree ->", "True ->"),
    "of another tree": ("answers_as X tree ->", "answers_as X one_edge_tree ->"),
    "the world from another dart": ("(rooted z)]", "(rooted (@start W))]"),
    "a larger m is not computed": ("AllWorlds 2 = true", "AllWorlds 3 = AllWorlds 3"),
    "nothing is computed": ("Proof. vm_compute. reflexivity. Qed.", "Admitted."),
    "it is assumed": ("Lemma computed", "Axiom wish : False.\nLemma computed"),
    "it is not said on what it rests": ("Print Assumptions right_in_every_world.", ""),
}


# ---- What stands in the file is compared with what is claimed ----


CONCLUSION = (
    "  exists transcript answer z,\n"
    "  [/\\ episode X (rooted start) (@percept_of W) (paper_bound (vertices W) (edges W))\n"
    "        = (transcript, Some answer, z),\n"
    "      valid answer & isomorphic (denote answer) (rooted z)].\n"
)
PROOF = "Proof. exact: (certified_paper computed). Qed.\nPrint"
NOT_CLAIMED = {
    **OTHER_TEXTS,
    "nothing is concluded": (f"{CONCLUSION}{PROOF}", "  True.\nProof. by []. Qed.\nPrint"),
    "of no world": ("forall W : lighthouse_world,", "forall W : lighthouse_world, False ->"),
    "a word means something else": ("Model DecisionTrees.", "Model DecisionTrees Mine."),
    "the comment ends early": ("what algorithm1 does", "what algorithm1 *) Import Mine. (* does"),
    "another motion": ("Node 0", "Node 1"),
    "more is said at the end": (
        "Assumptions right_in_every_world.\n",
        "Assumptions I.\nPrint I.\n",
    ),
    "lines end otherwise": ("\n", "\r\n"),
}


def checked(trees, file, *arguments):
    return trees.write_certificate(
        ["--check", str(file), "algorithm1", "--edges", str(EDGES), *arguments]
    )


@pytest.mark.parametrize("name", NOT_CLAIMED)
def test_a_file_that_says_something_else_than_is_claimed_differs_and_coqc_is_not_asked(
    trees, files, tmp_path, monkeypatch, capsys, name
):
    file = tmp_path / "certificate.v"
    trees.write_certificate(
        ["--certificate", str(file), "algorithm1", "--edges", str(EDGES)],
    )
    old, new = NOT_CLAIMED[name]
    text = file.read_text()
    assert old in text
    file.write_bytes(text.replace(old, new, 1).encode())
    monkeypatch.setattr(files, "asked_of_coq", lambda _file: "accepted")
    monkeypatch.setattr(files, "is_built", lambda: True)
    capsys.readouterr()
    assert checked(trees, file) == 1
    said = capsys.readouterr().out
    assert said.startswith(f"DIFFERS    {file}, line ")
    assert said.count("\n") == 1


def test_a_file_of_another_claim_differs(trees, files, tmp_path, monkeypatch):
    file = tmp_path / "certificate.v"
    arguments = ["--certificate", str(file), "algorithm1", "--edges", str(EDGES)]
    assert trees.write_certificate(arguments) == 0
    monkeypatch.setattr(files, "asked_of_coq", lambda _file: "accepted")
    monkeypatch.setattr(files, "is_built", lambda: True)
    assert checked(trees, file) == 0
    for other in (["--edges", "1"], ["--limit", "2*m*n"], ["--universe", "simple"]):
        assert checked(trees, file, *other) == 1


def test_a_coqc_that_comes_to_no_verdict_is_neither_accepted_nor_refused(
    trees, files, tmp_path, monkeypatch, capsys
):
    file = tmp_path / "certificate.v"
    arguments = ["--certificate", str(file), "algorithm1", "--edges", str(EDGES)]
    assert trees.write_certificate(arguments) == 0
    coqc = tmp_path / "coqc"
    monkeypatch.setattr(files, "is_built", lambda: True)
    monkeypatch.setenv("PATH", str(tmp_path))
    for script, code, word in (
        ("kill -9 $$", 3, "UNDECIDED"),
        ("echo", 3, "UNDECIDED"),
        (f"echo '{files.REFUSAL}' >&2; exit 1", 1, "REFUSED"),
        ("echo Closed under the global context", 0, "ACCEPTED"),
    ):
        coqc.write_text(f"#!/bin/sh\n{script}\n")
        coqc.chmod(0o755)
        capsys.readouterr()
        assert checked(trees, file) == code
        assert capsys.readouterr().out.startswith(word)
    monkeypatch.undo()
    monkeypatch.setattr(files, "COQ", tmp_path)
    assert checked(trees, file) == 2
    assert "not built: make -C proofs/coq" in capsys.readouterr().err
