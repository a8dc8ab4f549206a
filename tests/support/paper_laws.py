"""Tests of any paper's ledger: found beside expected, and whatever is changed, the claim fails."""

import inspect
import re

import pytest

import allworlds
import claims
from allworlds.documents.document import replace
from allworlds.outcome import Exit
from allworlds.studies.ledger import Found, Means, entry_of, entry_with
from paper_claims import BY_NAME, CLAIMS, PAPER, function_of

OF_PROOFS = {"certificate", "theorem", "theorems_in"}
"""Functions that decide several claims."""


def verdict(name, **bounds):
    """The verdict of a claim in this scope."""
    return function_of(BY_NAME[name])(Means(1), **bounds).verdict


def other(value):
    """Another value of the same kind."""
    match value:
        case [*first, last]:
            return [*first, other(last)]
        case str():
            return value + "?"
        case _:
            return value + 1


def changes(entry):
    """The entry with one expected thing changed, each in turn."""
    flipped = {"holds": "refuted", "refuted": "holds"}[entry.expected]
    yield "verdict", replace(entry, expected=flipped)
    for part in ("expected_witnesses", "expected_figures"):
        for name, value in getattr(entry, part).items():
            yield name, replace(entry, **{part: {**getattr(entry, part), name: other(value)}})


def fails_when_changed(entry):
    """Require that each change of one expected thing makes the claim fail; return their number."""
    assert entry.standing == "as-expected", entry
    changed = list(changes(entry))
    for what, one in changed:
        assert one.standing == "unexpected", (one.id, what)
        assert len(one.differences) == 1
        assert what in one.differences[0]
    return len(changed)


def really_fails_when_changed(name):
    """Do the same with what is really found in the quick scope; return the number of changes."""
    claim = BY_NAME[name]
    return fails_when_changed(entry_of(claim, function_of(claim), Means(1)))


@pytest.mark.parametrize("budget", ["quick", "full"])
def test_each_expected_verdict_and_number_matters(budget):
    total = 0
    for claim in CLAIMS:
        scope = claim.scopes[budget]
        found = Found(claim.expected, scope.witnesses, scope.figures)
        total += fails_when_changed(entry_with(claim, budget, found))
    assert total > 2 * len(CLAIMS)


@pytest.mark.slow
def test_the_quick_ledger_is_as_expected_and_no_number_of_it_is_idle():
    report = allworlds.ledger(PAPER, workers=2)
    assert [one.id for one in report.claims] == [*BY_NAME]
    unchecked = {one.id for one in report.claims if one.standing == "not-checked"}
    assert unchecked == {name for name in BY_NAME if name.startswith("coq-")}
    assert [one.differences for one in report.claims if one.differences] == []
    assert report.exit_code == Exit.HOLDS
    for one in report.claims:
        if one.id not in unchecked:
            fails_when_changed(one)


def test_every_claim_has_its_function_and_every_function_its_claim():
    functions = {name for name, _ in inspect.getmembers(claims, inspect.isfunction)}
    public = {name for name in functions if not name.startswith("_")}
    assert public - OF_PROOFS == {claim.function for claim in CLAIMS}


def test_no_function_reads_what_is_expected():
    paths = sorted(PAPER.glob("*.py"))
    assert len(paths) > 10
    for path in paths:
        code = re.sub(r'""".*?"""', "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
        assert not re.search(r"ledger|\btoml", code), path.name


ROOT = PAPER.parents[1]


def stated_in(folder):
    """The theorems that ``Statements.v`` of a folder pins, each with the file that has it."""
    pinned = re.findall(r"^Check \(@(\w+) :", (folder / "Statements.v").read_text(), re.MULTILINE)
    named = {
        name: file.relative_to(ROOT).as_posix()
        for file in (folder / "Main.v", folder / "Further.v")
        if file.exists()
        for name in re.findall(r"^Theorem (\w+)", file.read_text(), re.MULTILINE)
    }
    return {name: named[name] for name in pinned if name in named}


def pointers(source):
    """The theorems that a source names, each with its file."""
    for names, file in re.findall(r"([\w, ]+) \(([\w/]+\.v)\)", source.partition("theorem")[2]):
        for name in re.findall(r"\w+", names):
            yield name, file


def test_a_theorem_that_a_claim_points_to_stands_there_and_is_pinned():
    pinned = {}
    for folder in (ROOT / "proofs" / "coq", PAPER / "coq"):
        if folder.exists():
            pinned |= stated_in(folder)
    met = [(claim.id, *one) for claim in CLAIMS for one in pointers(claim.source)]
    assert [one for one in met if pinned.get(one[1]) != one[2]] == []
    assert len(met) > len(CLAIMS) / 3
    assert all(claim.source.count("theorem") == 1 for claim in CLAIMS if "theorem" in claim.source)
    decided = {name for one in CLAIMS for name in one.quick.bounds.get("names", ())}
    assert decided <= pinned.keys()


REFERS = re.compile(r"(The same|So (does|do|is|are)|It|They|That|These|Those|This|Such|There)\b")
"""The beginnings of a sentence that is understood beside another one alone."""


@pytest.mark.parametrize("name", BY_NAME)
def test_a_statement_says_by_itself_what_is_claimed(name):
    statement = BY_NAME[name].statement
    assert not REFERS.match(statement)
    assert "The same" not in statement
    assert statement.endswith(".")
