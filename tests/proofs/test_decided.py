"""Claims that proofs decide: what the checkers say counts, and nothing else."""

from pathlib import Path

import pytest

from allworlds.studies.ledger import Means, claims_in

ROOT = Path(__file__).parents[2]
PAPERS = sorted(ROOT.glob("papers/*/ledger.toml"))

CHECKER = """
import sys
if {code} == 2:
    print("check.py: a file is missing", file=sys.stderr)
    sys.exit(2)
print("claim verdict seconds what")
print("cycles                holds        0.1  one thing")
print(" " * 40 + "another")
sys.exit({code})
"""

MAKEFILE = """
assumptions:
	@test -f Main.v && test ! -f Main.vo && {command}
"""

FULL = Means(1, "full")


@pytest.fixture
def decided(checkers, monkeypatch, tmp_path):
    """The module, with a folder of proofs in which nothing is."""
    module = checkers("decided")
    monkeypatch.setattr(module, "PROOFS", tmp_path)
    module._assumptions.cache_clear()
    yield module
    module._assumptions.cache_clear()


@pytest.fixture
def certificate(decided, tmp_path):
    """The outcome for a certificate whose checker ends with this code."""

    def found(code):
        folder = tmp_path / "certificates"
        folder.mkdir(exist_ok=True)
        (folder / "check.py").write_text(CHECKER.format(code=code))
        return decided.certificate(Means(1), claim="cycles")

    return found


@pytest.fixture
def coq(decided, tmp_path, monkeypatch):
    """Make a folder with sources, what was compiled of them long ago, and this for a build."""

    def made(command, folder="coq"):
        place = tmp_path / folder
        place.mkdir(parents=True)
        (place / "Makefile").write_text(MAKEFILE.format(command=command))
        (place / "Main.v").touch()
        (place / "Main.vo").touch()
        return place

    monkeypatch.setattr(decided.shutil, "which", lambda name: name)
    return made


def test_a_certificate_counts_as_its_checker_says(certificate):
    found = certificate(0)
    assert (found.verdict, found.witnesses) == ("holds", {"statements": 2})
    assert found.told == "one thing; another"
    assert certificate(1).verdict == "refuted"
    assert certificate(2).reason == "check.py: a file is missing"


def test_without_a_folder_or_coq_or_time_nothing_is_said(decided, monkeypatch):
    assert "check.py" in decided.certificate(Means(1), claim="cycles").reason
    assert "--budget full" in decided.theorem(Means(1), names=["x"]).reason
    monkeypatch.setenv("PATH", "")
    assert decided.theorem(FULL, names=["x"]).reason == "Coq is not installed"


def test_a_theorem_counts_if_it_is_built_anew_and_rests_on_nothing(decided, coq):
    coq("printf 'a: Closed under the global context\\nb: Axioms:\\n'")
    assert decided.theorem(FULL, names=["a"]).verdict == "holds"
    found = decided.theorem(FULL, names=["a", "b", "c"])
    assert (found.verdict, found.told) == ("refuted", "not proved without axioms: b, c")


def test_a_build_that_fails_refutes(decided, coq):
    coq("echo wrong && false")
    found = decided.theorem(FULL, names=["a"])
    assert found.verdict == "refuted"
    assert "wrong" in found.told


def test_the_proofs_of_a_paper_are_built_beside_those_they_rest_on(decided, coq):
    coq("false")
    base = "../../../proofs/coq"
    folder = coq(
        f"test -f {base}/Main.v && test ! -f {base}/Main.vo "
        "&& echo 'a: Closed under the global context'",
        "papers/mine/coq",
    )
    assert decided.theorems_in(FULL, folder, ["a"]).verdict == "holds"


def named(kind, key):
    """The names in claims of this kind, with the folder of their paper."""
    for ledger in PAPERS:
        for claim in claims_in(ledger):
            if claim.id.startswith(kind):
                value = claim.quick.bounds[key]
                for name in [value] if isinstance(value, str) else value:
                    yield ledger.parent, name


def test_every_theorem_that_is_named_is_a_headline():
    theorems = [*named("coq-", "names")]
    assert len(theorems) > 60
    for paper, name in theorems:
        headlines = "".join(
            file.read_text(encoding="utf-8")
            for folder in (ROOT / "proofs" / "coq", paper / "coq")
            for file in (folder / "Main.v", folder / "Further.v")
            if file.exists()
        )
        assert f"Theorem {name} " in headlines or f"Theorem {name}\n" in headlines, name


def test_every_certificate_that_is_named_has_its_checker():
    certificates = [name for _, name in named("cert-", "claim")]
    assert sorted(certificates) == sorted(
        path.parent.name for path in (ROOT / "proofs" / "certificates").glob("*/checker.py")
    )
