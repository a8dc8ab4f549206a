"""A paper, and an example, is written against public names, as anybody else's would be."""

import ast
import re
import tomllib
from importlib import import_module
from pathlib import Path

import pytest

from allworlds import claims

ROOT = Path(__file__).parents[2]
PAPERS = ROOT / "papers"
EXAMPLES = sorted((ROOT / "examples").rglob("*.py"))
FILES = [*sorted(path for path in PAPERS.rglob("*.py") if "tests" not in path.parts), *EXAMPLES]
PUBLIC = {
    "allworlds",
    "allworlds.ambiguity",
    "allworlds.claims",
    "allworlds.explorers",
    "allworlds.maps",
    "allworlds.robots",
    "allworlds.strategies",
    "allworlds.testing",
}


def imported(source):
    """Each name that a source imports from the package, as (module, name); no name: all of it."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            yield from ((alias.name, "") for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield from ((node.module, alias.name) for alias in node.names)


def private(source):
    """Those of the imports that are not public names of the package."""
    for module, name in imported(source):
        if module.partition(".")[0] != "allworlds":
            continue
        if module not in PUBLIC or (name and name not in dir(import_module(module))):
            yield f"{module}:{name}"


@pytest.mark.parametrize("path", FILES, ids=lambda path: str(path.relative_to(ROOT)))
def test_a_paper_or_an_example_imports_public_names_alone(path):
    assert [*private(path.read_text(encoding="utf-8"))] == []


@pytest.mark.parametrize(
    "line",
    [
        "import allworlds.engines",
        "from allworlds.judging.laws.bounds import paper_bound",
        "from allworlds.maps import no_such_name",
    ],
)
def test_another_import_is_noticed(line):
    assert [*private(line)]


def test_the_names_that_claims_need_are_twelve_at_most():
    assert len(claims.__all__) <= 12
    for name in claims.__all__:
        assert getattr(claims, name).__doc__


def missing(paper, source):
    """The files that a source names, and that are neither in the project nor beside its ledger."""
    named = re.findall(r"[\w./-]+\.(?:md|v|py|toml)\b", source)
    return [name for name in named if not any((at / name).exists() for at in (ROOT, paper))]


@pytest.mark.parametrize(
    "ledger", sorted(PAPERS.glob("*/ledger.toml")), ids=lambda f: f.parent.name
)
def test_every_source_of_a_ledger_names_files_that_are_there(ledger):
    claims = tomllib.loads(ledger.read_text(encoding="utf-8"))
    for name, claim in claims.items():
        assert missing(ledger.parent, claim["source"]) == [], name
    assert missing(ledger.parent, "a.md; docs/theory.md; README.md (b/C.v)") == ["a.md", "b/C.v"]


def test_every_paper_has_its_parts():
    for paper in sorted(path for path in PAPERS.iterdir() if path.is_dir()):
        for part in ("README.md", "ledger.toml", "claims.py", "tests"):
            assert (paper / part).exists(), f"{paper.name} has no {part}"


THEOREMS = re.compile(r"theorems?:? ([\w, ]+?) \((\S+\.v)\)")
NUMBERED = r"(?:Theorem|Lemma|Proposition) \d+"
PLACES = re.compile(rf"([\w/.-]+\.md), ({NUMBERED})|({NUMBERED}|Corollary) in ([\w/.-]+\.md)")


def unstated(paper, source):
    """The theorems that a source names, and that its file does not state; and numbered ones."""
    for names, file in THEOREMS.findall(source):
        text = (ROOT / file).read_text(encoding="utf-8")
        for name in names.split(", "):
            if not re.search(rf"^(?:Theorem|Corollary|Lemma) {name}\b", text, re.MULTILINE):
                yield name
    for page, number, other, in_page in PLACES.findall(source):
        places = (at / (page or in_page) for at in (paper, ROOT))
        path = next(place for place in places if place.exists())
        text = path.read_text(encoding="utf-8")
        if not re.search(rf"^(?:\*\*|#+ ){number or other}\b", text, re.MULTILINE):
            yield number or other


LEDGERS = sorted(PAPERS.glob("*/ledger.toml"))


@pytest.mark.parametrize("ledger", LEDGERS, ids=lambda file: file.parent.name)
def test_every_theorem_that_a_ledger_names_is_stated_where_it_says(ledger):
    sources = {
        name: claim["source"]
        for name, claim in tomllib.loads(ledger.read_text(encoding="utf-8")).items()
    }
    wrong = {name: [*unstated(ledger.parent, source)] for name, source in sources.items()}
    assert not {name: what for name, what in wrong.items() if what}
    pointing = [source for source in sources.values() if "theorem" in source and ".v" in source]
    assert all(THEOREMS.search(source) for source in pointing)


@pytest.mark.parametrize(
    ("source", "wrong"),
    [
        ("Section V; theorem: variant_rises (proofs/coq/Further.v)", ["variant_rises"]),
        ("theorems: variant_falls, cycles_with (proofs/coq/Further.v)", ["cycles_with"]),
        ("lower-bounds.md, Theorem 99", ["Theorem 99"]),
        ("Theorem 98 in lower-bounds.md", ["Theorem 98"]),
        ("lower-bounds.md, Theorem 4", []),
    ],
)
def test_a_theorem_that_is_not_there_is_noticed(source, wrong):
    assert [*unstated(PAPERS / "lower_bounds", source)] == wrong
