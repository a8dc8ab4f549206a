import ast
import json
import random
import shutil
import subprocess
import sys
from itertools import pairwise

import pytest

CLAIMS = ["cycles", "fig1", "natural-lighthouse", "no-twins-directional", "smallest-pairs"]


def check(folder, *claims):
    only = [word for claim in claims for word in ("--only", claim)]
    command = [sys.executable, "-E", "-s", "-S", str(folder / "check.py"), *only]
    ran = subprocess.run(command, capture_output=True, text=True, check=False)
    return ran.returncode, ran.stdout + ran.stderr


@pytest.fixture
def copied(proofs, tmp_path):
    """The folder ``proofs``, to be damaged."""
    return shutil.copytree(
        proofs, tmp_path / "proofs", ignore=shutil.ignore_patterns("coq", "__p*")
    )


@pytest.mark.slow
def test_every_claim_holds_by_the_files_alone_and_without_any_package(copied):
    # -S: no site-packages; so neither a solver nor this project can be imported.
    code, said = check(copied)
    assert code == 0, said
    for claim in CLAIMS:
        assert f"\n{claim:<22}holds" in said


def test_checkers_import_the_standard_library_and_each_other_only(proofs):
    own = {"lrat", "lrat_claims", "maps", "meaning"}
    # These two are about the package: one produces, the other compares it with extracted programs.
    others = {"produce.py", "certified.py"}
    for path in [*proofs.glob("*.py"), *proofs.glob("*/checker.py")]:
        if path.name in others:
            continue
        for node in ast.walk(ast.parse(path.read_text())):
            names = []
            if isinstance(node, ast.Import):
                names = [alias.name for alias in node.names]
            elif isinstance(node, ast.ImportFrom):
                names = [node.module]
            for name in names:
                top = name.split(".")[0]
                assert top in own or top in sys.stdlib_module_names, f"{path}: {name}"


def test_less_than_four_megabytes_are_committed(proofs):
    files = [path for claim in CLAIMS for path in (proofs / claim).iterdir() if path.is_file()]
    assert sum(path.stat().st_size for path in files) < 4_000_000


def test_the_manifest_names_every_certificate(proofs):
    named = set(json.loads((proofs / "manifest.json").read_text()))
    kinds = (".xz", ".json", ".smt2")
    there = {
        str(p.relative_to(proofs))
        for p in proofs.glob("*/*")
        if p.suffix in kinds and p.parent.name in CLAIMS
    }
    assert named == there


def test_every_claim_has_its_statement(proofs):
    for claim in CLAIMS:
        assert (proofs / claim / "README.md").read_text().startswith("# ")


def certificates(proofs_):
    return sorted(json.loads((proofs_ / "manifest.json").read_text()))


@pytest.mark.parametrize("seed", range(8))
def test_a_certificate_with_one_byte_changed_makes_the_check_fail(copied, seed):
    chance = random.Random(seed)
    small = [name for name in certificates(copied) if not name.startswith(("fig", "small"))]
    name = chance.choice(small)
    data = bytearray((copied / name).read_bytes())
    data[chance.randrange(len(data))] ^= 1 << chance.randrange(8)
    (copied / name).write_bytes(bytes(data))
    code, said = check(copied, name.split("/")[0])
    assert (code, "FAILS" in said) == (1, True), said


@pytest.mark.parametrize(
    ("name", "line"),
    [("no-twins-directional/m1", 3), ("no-twins-directional/m2", 40)],
)
def test_a_certificate_with_one_line_changed_is_rejected_by_that_line(copied, checkers, name, line):
    lzma = checkers("lzma")
    path = copied / f"{name}.lrat.xz"
    lines = lzma.decompress(path.read_bytes()).decode().splitlines()
    words = lines[line - 1].split()
    del words[-2]
    lines[line - 1] = " ".join(words)
    path.write_bytes(lzma.compress("\n".join(lines).encode()))
    code, said = check(copied, name.split("/")[0])
    assert (code, f"{path.name}: line {line}: " in said) == (1, True), said


def test_a_harmless_change_of_a_certificate_is_rejected_too(copied, checkers):
    lzma = checkers("lzma")
    path = copied / "no-twins-directional" / "m1.lrat.xz"
    path.write_bytes(lzma.compress(lzma.decompress(path.read_bytes()), preset=0))
    code, said = check(copied, "no-twins-directional")
    assert code == 1
    assert "no-twins-directional/m1.lrat.xz is not the file that was committed" in said


def test_a_formula_in_which_one_clause_says_too_much_is_rejected(copied, checkers):
    # The proof still refutes it; but it excludes worlds that are there.
    lrat, meaning = checkers("lrat"), checkers("meaning")
    maps = checkers("maps")
    text = lrat.read(copied / "no-twins-directional" / "m2.cnf.xz")
    _, clauses = lrat.read_formula(text)
    annotated = meaning.read_comments(text)
    worlds = sorted((maps.code(*m, 0) for m in maps.rooted_maps(2)), key=meaning.answers)
    for one, two in pairwise(worlds):
        meaning.require_meaning(annotated, clauses, one, two, "directional")
    first, _ = annotated.blocks["sigma1"]
    bad = [[-(first + 1)] if i == annotated.alike[0] - 2 else c for i, c in enumerate(clauses)]
    one, two = next((a, b) for a, b in pairwise(worlds) if a[0][0] == 1)
    with pytest.raises(lrat.Refused, match="excludes the worlds"):
        meaning.require_meaning(annotated, bad, one, two, "directional")


def test_a_missing_file_is_no_failure_of_a_claim_but_an_error_of_its_own(copied):
    (copied / "natural-lighthouse" / "pair.json").unlink()
    code, said = check(copied, "natural-lighthouse")
    assert (code, "pair.json" in said) == (2, True)
    assert check(copied, "no-such-claim")[0] == 2


@pytest.mark.parametrize("claim", ["fig1", "smallest-pairs", "natural-lighthouse"])
def test_a_pair_whose_second_world_is_the_first_is_rejected(copied, claim):
    path = copied / claim / ("pair.json" if claim.startswith("n") else "pairs.json")
    document = json.loads(path.read_text())
    entries = [document] if "pair" in document else list(document.values())
    for entry in entries:
        entry["pair"][1] = entry["pair"][0]
        entry["bisimulation"][1] = entry["bisimulation"][0]
    path.write_text(json.dumps(document))
    code, said = check(copied, claim)
    assert (code, "the two worlds are the same" in said) == (1, True), said


def test_a_bisimulation_with_one_class_changed_is_rejected(copied):
    path = copied / "natural-lighthouse" / "pair.json"
    document = json.loads(path.read_text())
    document["bisimulation"][1][-1] = document["bisimulation"][1][0]
    path.write_text(json.dumps(document))
    assert "does not behave as its class" in check(copied, "natural-lighthouse")[1]


@pytest.mark.parametrize(
    ("file", "old", "new", "message"),
    [
        ("2-sigma.smt2", "Int (- 1 a)", "Int a", "is not the cycle"),
        ("3-alpha.smt2", "(+ x 1)", "(+ x 2)", "is not the cycle"),
        ("4-percepts.smt2", "(ite (= a 0) 0 1)", "(ite (= a 0) 1 0)", "is not the cycle"),
        ("1-start.smt2", "(= t 0)", "(= t 1)", "the condition fails at"),
        ("2-sigma.smt2", "(= a b)", "(<= a b)", "the condition fails at"),
        ("3-alpha.smt2", "(assert (not (and", "(assert (and (and", "the condition fails at"),
    ],
)
def test_a_condition_on_cycles_that_says_something_false_is_rejected(
    copied, file, old, new, message
):
    path = copied / "cycles" / file
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))
    code, said = check(copied, "cycles")
    assert (code, message in said) == (1, True), said


def test_z3_proves_the_conditions_on_cycles_for_all_sizes(proofs):
    command = [sys.executable, str(proofs / "cycles" / "prove.py")]
    ran = subprocess.run(command, capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stdout
    assert ran.stdout.count("negation unsat, hypotheses sat") == 4
