"""The Coq development: what can be seen without Coq, and, with it, that its guards can fail."""

import json
import shutil
import subprocess
import sys

import pytest

from proofs.test_coq import CODE, COQ, LISTED, module

needs_coq = pytest.mark.skipif(
    shutil.which("coqc") is None, reason="Coq is not installed (Debian: coq, mathcomp-ssreflect)"
)


builds = pytest.mark.timeout(1200)
"""Of a test whose fixture compiles all of the proofs."""


needs_programs = pytest.mark.skipif(
    not (COQ / "explorer").exists(), reason="not built: make -C proofs/coq explorer"
)


@pytest.mark.slowest
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
@pytest.mark.slowest
def test_every_headline_theorem_is_closed_under_the_global_context(built):
    checked = subprocess.run(["make", "-C", str(built), "assumptions"], check=False)
    assert checked.returncode == 0


@pytest.mark.slowest
@needs_coq
@builds
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


@pytest.mark.slowest
@needs_coq
@builds
@pytest.mark.parametrize(("claimed", "code"), [("", 0), (" - 1", 1)])
def test_coq_refuses_a_statement_that_is_not_proved(built, tmp_path, claimed, code):
    bound = "reached n C c -> C <= 2 * edges W ^ 2 * vertices W"
    assert CODE["Statements.v"].count(f"{bound})") == 1
    path = tmp_path / "claimed.v"
    path.write_text(CODE["Statements.v"].replace(f"{bound})", f"{bound}{claimed})"))
    command = ["coqc", "-w", "none", "-Q", str(built), "Allworlds", str(path)]
    assert subprocess.run(command, capture_output=True, check=False).returncode == code


@pytest.mark.slowest
@needs_coq
@builds
def test_a_certificate_with_a_changed_class_is_no_theorem(built, tmp_path):
    root = tmp_path / "project"
    for folder in ("fig1", "smallest-pairs", "natural-lighthouse"):
        kept = root / "proofs" / "certificates" / folder
        shutil.copytree(COQ.parent / "certificates" / folder, kept)
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
@pytest.mark.slowest
def test_the_certified_programs_agree_with_the_python_ones():
    low = ("walked", "judged", "checked", "folded")
    limits = [word for name in low for word in (f"--{name}-edges", "2")]
    run = [sys.executable, str(COQ / "certified.py"), "--edges", "3", *limits]
    told = subprocess.run(run, capture_output=True, text=True, check=False)
    assert told.returncode == 0, told.stdout
    assert told.stdout.splitlines()[-1] == "AGREE"


@pytest.mark.slowest
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
