"""READMEs of the proofs name only files, theorems, statements and claims that exist."""

import re
from pathlib import Path

import pytest

PROOFS = Path(__file__).parents[2] / "proofs"
READMES = [path for path in sorted(PROOFS.glob("**/README.md")) if path.parent.name != "coq"]
ROOT = PROOFS.parent


def code(text):
    return re.findall(r"`([^`]+)`", text)


def theorems():
    text = "\n".join(path.read_text(encoding="utf-8") for path in PROOFS.glob("coq/*.v"))
    return set(re.findall(r"^(?:Theorem|Lemma|Corollary)\s+(\w+)", text, re.MULTILINE))


def test_each_claim_has_a_readme_and_a_row():
    claims = {path.parent.name for path in PROOFS.glob("certificates/*/checker.py")}
    assert {path.parent.name for path in READMES} == claims | {"proofs"}
    rows = re.findall(
        r"^\| \[([\w-]+)\]\(certificates/([\w-]+)/README.md\)", READMES[0].read_text(), re.MULTILINE
    )
    assert {name for name, _ in rows} == {folder for _, folder in rows} == claims


def test_theorems_that_the_readmes_name_are_there():
    named = set()
    for path in READMES:
        named |= {n for n in code(path.read_text()) if re.fullmatch(r"[a-z]+(_[a-z]+){3,}", n)}
    assert "no_information_is_not_enough" in named
    assert named <= theorems()


@pytest.mark.parametrize("path", READMES, ids=lambda path: path.parent.name)
def test_links_and_files_that_a_readme_names_are_there(path):
    text = path.read_text(encoding="utf-8")
    links = re.findall(r"\]\(([^)#]*)(?:#([\w-]*))?\)", text)
    for link, heading in links:
        target = path.parent / link if link else path
        assert target.exists(), link
        if heading:
            headings = re.findall(r"^#+ (.*)", target.read_text(encoding="utf-8"), re.MULTILINE)
            assert heading in {h.lower().replace(" ", "-").replace(",", "") for h in headings}
    for name in code(text):
        if re.fullmatch(r"[\w/-]+\.(py|json|v)", name):
            folders = (path.parent, PROOFS, PROOFS / "certificates", PROOFS / "coq")
            assert any((folder / name).exists() for folder in folders), name
    for program in re.findall(r"python (proofs/[\w/-]+\.py)", text):
        assert (ROOT / program).exists(), program


def test_the_manifest_and_the_readme_agree_on_how_much_is_kept():
    formulas = sum(path.stat().st_size for path in PROOFS.glob("certificates/*/*.cnf.xz"))
    everything = sum(path.stat().st_size for path in PROOFS.glob("certificates/*/*.xz"))
    assert 400_000 < formulas < 600_000
    assert 3_250_000 < everything < 3_750_000
    text = READMES[0].read_text().replace("\n", " ")
    assert "half a megabyte of three and a half" in text
