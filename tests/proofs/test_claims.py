import ast
import hashlib
import json
import lzma
import shutil
import subprocess
import sys

import pytest

CLAIMS = ["cycles", "fig1", "natural-lighthouse", "no-twins-directional", "smallest-pairs"]
DEEP = "[" * 100_000
OF_THE_PACKAGE = {"produce.py"}


def check(folder, *claims):
    only = [word for claim in claims for word in ("--only", claim)]
    command = [sys.executable, "-E", "-s", "-S", str(folder / "check.py"), *only]
    ran = subprocess.run(command, capture_output=True, text=True, check=False)
    return ran.returncode, ran.stdout + ran.stderr


@pytest.fixture
def copied(proofs, tmp_path):
    """The folder of the certificates, to be damaged."""
    return shutil.copytree(proofs, tmp_path / "proofs", ignore=shutil.ignore_patterns("__p*"))


def checkers_of(proofs_):
    """The programs that are trusted: all of the folder but the one that produces."""
    files = [*proofs_.glob("*.py"), *proofs_.glob("*/checker.py")]
    return [path for path in files if path.name not in OF_THE_PACKAGE]


def test_checkers_import_the_standard_library_and_each_other_only(proofs):
    own = {path.stem for path in checkers_of(proofs)}
    assert {"check", "clauses", "lrat", "maps", "twin_clauses", "world_clauses"} <= own
    for path in checkers_of(proofs):
        for node in ast.walk(ast.parse(path.read_text())):
            names = []
            if isinstance(node, ast.Import):
                names = [alias.name for alias in node.names]
            elif isinstance(node, ast.ImportFrom):
                names = [node.module]
            for name in names:
                top = name.split(".")[0]
                assert top in own or top in sys.stdlib_module_names, f"{path}: {name}"


def stretches(path):
    """Every four lines in a row, but for space, comments and lines of a word or two."""
    lines = [line.partition("#")[0].split() for line in path.read_text().splitlines()]
    kept = ["".join(words) for words in lines if len(words) > 2]
    return {tuple(kept[i : i + 4]) for i in range(len(kept) - 3)}


def test_checkers_have_no_four_lines_in_common_with_the_package(proofs):
    package = set().union(*map(stretches, (proofs.parents[1] / "src").rglob("*.py")))
    assert len(package) > 1000
    for path in checkers_of(proofs):
        assert not stretches(path) & package, path


def test_less_than_four_megabytes_are_committed(proofs):
    files = [path for claim in CLAIMS for path in (proofs / claim).iterdir() if path.is_file()]
    assert sum(path.stat().st_size for path in files) < 4_000_000


def test_the_manifest_names_every_certificate(proofs):
    named = set(json.loads((proofs / "manifest.json").read_text()))
    kinds = (".xz", ".json", ".smt2")
    there = {str(p.relative_to(proofs)) for p in proofs.glob("*/*") if p.suffix in kinds}
    assert named == there


def test_every_claim_has_its_statement(proofs):
    for claim in CLAIMS:
        assert (proofs / claim / "README.md").read_text().startswith("# ")


@pytest.mark.parametrize(
    ("name", "line"),
    [("no-twins-directional/m1", 3), ("no-twins-directional/m2", 40)],
)
def test_a_certificate_with_one_line_changed_is_rejected_by_that_line(copied, name, line):
    path = copied / f"{name}.lrat.xz"
    lines = lzma.decompress(path.read_bytes()).decode().splitlines()
    words = lines[line - 1].split()
    del words[-2]
    lines[line - 1] = " ".join(words)
    path.write_bytes(lzma.compress("\n".join(lines).encode()))
    code, said = check(copied, name.split("/")[0])
    assert (code, f"{path.name}: line {line}: " in said) == (1, True), said


def with_right_digests(folder):
    """As after a change that was committed: only what the files say can be wrong."""
    path = folder / "manifest.json"
    names = json.loads(path.read_text())
    digests = {n: hashlib.sha256((folder / n).read_bytes()).hexdigest() for n in names}
    path.write_text(json.dumps(digests))


def test_a_formula_that_says_nothing_is_refused_whatever_the_manifest_says(copied):
    for name in ("m3.cnf.xz", "m3.lrat.xz"):
        path = copied / "no-twins-directional" / name
        lines = lzma.decompress(path.read_bytes()).decode().splitlines()
        if "cnf" in name:
            variables = next(line.split()[2] for line in lines if line[0] == "p")
            comments = [line for line in lines if line[0] == "c"]
            lines = [*comments, f"p cnf {variables} 2", "1 0", "-1 0"]
        else:
            lines = ["3 0 1 2 0"]
        path.write_bytes(lzma.compress("\n".join(lines).encode()))
    with_right_digests(copied)
    code, said = check(copied, "no-twins-directional")
    assert code == 1
    assert "FAILS" in said
    assert "m3.cnf.xz: clause 1 of the formula says what it should not: [1]" in said


def without(*names):
    return lambda manifest: {k: v for k, v in manifest.items() if not k.startswith(names)}


@pytest.mark.parametrize(
    ("damage", "reason"),
    [
        (without("natural-lighthouse/"), "natural-lighthouse/pair.json is not in the manifest"),
        (lambda m: {**m, "natural-lighthouse/x.json": "00"}, "x.json is in the manifest, but it"),
        (lambda m: {**m, "natural-lighthouse/pair.json": "00"}, "is not the file that was"),
        (lambda m: {**m, "natural-lighthouse/pair.json": 0}, "is not the file that was"),
        (lambda m: {k.upper(): v for k, v in m.items()}, "pair.json is not in the manifest"),
        (lambda m: [*m], "manifest.json is no object"),
        (lambda _: DEEP, "manifest.json is nested too deeply to be read"),
        (lambda _: "", "manifest.json is no JSON"),
        (lambda m: json.dumps(m)[:-1] + ', "fig1/pairs.json": ""}', "stands twice in one object"),
    ],
)
def test_a_damaged_manifest_is_refused_in_one_line(copied, damage, reason):
    path = copied / "manifest.json"
    damaged = damage(json.loads(path.read_text()))
    path.write_text(damaged if isinstance(damaged, str) else json.dumps(damaged))
    code, said = check(copied, "natural-lighthouse")
    assert (code, reason in said, len(said.splitlines())) == (1, True, 2), said


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


def test_z3_proves_the_conditions_on_cycles_for_all_sizes(proofs):
    command = [sys.executable, str(proofs / "cycles" / "prove.py")]
    ran = subprocess.run(command, capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stdout
    assert ran.stdout.count("negation unsat, hypotheses sat") == 4
