"""The ledger of a paper: found beside expected, and whatever is changed of that, a claim fails."""

import json
import math
import subprocess
import sys
from xml.etree import ElementTree as ET

import pytest

import allworlds
from allworlds.documents.document import replace
from allworlds.inputs.checks import InputError
from allworlds.outcome import COMPLETED, Exit, Interrupted, Stopped
from allworlds.reports.formats import brief, file_of, text
from allworlds.studies.ledger import (
    FAULTS,
    Found,
    LedgerReport,
    NotChecked,
    Unfinished,
    claims_in,
    entry_with,
    of_check,
)
from listeners import Hears
from processes import PATIENCE

TOML = """
[pairs]
section = "IV"
statement = "Pairs are alike."
method = "algebra"
scope = "every pair up to {edges}"
expected = "holds"
source = "Section IV"
[pairs.quick]
bounds = { edges = 2 }
witnesses = { pairs = 3, others = 1 }
figures = { best = [1, 2], name = "x" }
[pairs.full]
bounds = { edges = 3 }
witnesses = { pairs = 4, others = 1 }

[not-all]
section = "Beyond"
statement = "All are alike."
method = "exhaustive"
scope = "everything"
expected = "refuted"
source = "an erratum"
quick = { witnesses = { worlds = 1 } }

[proof]
section = "V"
statement = "It is proved."
method = "machine-checked proof"
scope = "all sizes"
expected = "holds"
source = "Section V"
quick = { witnesses = { theorems = 1 } }
"""

CLAIMS = """
from allworlds import World, maps
from allworlds.claims import Found, NotChecked, Picture

def pairs(means, *, edges):
    figures = {"best": [1, 2], "name": "x"} if edges == 2 else {}
    return Found("holds", {"pairs": edges + 1, "others": 1}, figures)

def not_all(means):
    loop = World(maps.named_map("loop"), "directional")
    return Found("refuted", {"worlds": 1}, pictures=(Picture("the one", loop),))

def proof(means):
    return NotChecked("Coq is not installed")
"""


@pytest.fixture
def paper(tmp_path):
    (tmp_path / "ledger.toml").write_text(TOML, encoding="utf-8")
    (tmp_path / "claims.py").write_text(CLAIMS, encoding="utf-8")
    return tmp_path


def with_function(paper, name, body):
    """The paper with the body of a function replaced."""
    text_ = (paper / "claims.py").read_text(encoding="utf-8")
    (paper / "claims.py").write_text(f"{text_}\ndef {name}(means, **_):\n    {body}\n")
    return paper


def entries(paper, **options):
    return {one.id: one for one in allworlds.ledger(paper, **options).claims}


def report_of(*claims, required=()):
    """The report of these entries."""
    return LedgerReport(ending=COMPLETED, budget="quick", required=required, claims=claims)


def other(value):
    """Another value of the same kind."""
    match value:
        case [*first, last]:
            return [*first, other(last)]
        case str():
            return value + "?"
        case _:
            return value + 1


def test_a_ledger_is_as_expected(paper):
    report = allworlds.ledger(paper)
    standings = {one.id: one.standing for one in report.claims}
    assert standings == {"pairs": "as-expected", "not-all": "as-expected", "proof": "not-checked"}
    assert report.exit_code == Exit.HOLDS
    assert allworlds.ledger(paper, budget="full").exit_code == Exit.HOLDS
    assert [one.scope for one in report.claims][:1] == ["every pair up to 2"]


@pytest.mark.parametrize("part", ["expected_witnesses", "expected_figures"])
def test_each_expected_number_matters(paper, part):
    one = entries(paper)["pairs"]
    for name, value in getattr(one, part).items():
        changed = replace(one, **{part: {**getattr(one, part), name: other(value)}})
        assert (changed.standing, len(changed.differences)) == ("unexpected", 1)
        assert name in changed.differences[0]


def test_the_expected_verdict_matters(paper):
    for one in [*entries(paper).values()][:2]:
        verdict = {"holds": "refuted", "refuted": "holds"}[one.expected]
        assert replace(one, expected=verdict).standing == "unexpected"


@pytest.mark.parametrize(
    ("body", "standing", "code"),
    [
        ('return Found("refuted", {"worlds": 0})', "vacuous", Exit.VACUOUS),
        ('return Found("refuted", {})', "vacuous", Exit.VACUOUS),
        ('return Found("refuted", {"worlds": 2})', "unexpected", Exit.REFUTED),
        ('return Found("refuted", {"worlds": 1}, {"more": 1})', "unexpected", Exit.REFUTED),
        ('return Found("holds", {"worlds": 1})', "unexpected", Exit.REFUTED),
        ('raise KeyError("so it is")', "unexpected", Exit.INTERNAL),
        ("raise KeyboardInterrupt", None, Exit.INTERRUPTED),
    ],
)
def test_what_is_found_decides(paper, body, standing, code):
    with_function(paper, "not_all", body)
    report = allworlds.ledger(paper)
    found = [one.standing for one in report.claims if one.id == "not-all"]
    assert (found, report.exit_code) == ([standing] if standing else [], code)
    assert report.claims[0].standing == "as-expected"


@pytest.mark.parametrize(
    ("body", "told"),
    [
        ("import sys; sys.exit(0)", "raises SystemExit: 0"),
        ("import os; os._exit(0)", r"raises SystemExit: os\._exit\(0\) would end the process"),
        ("import os; os.execv('/bin/true', ['true'])", r"os\.execv\('/bin/true'\) would end"),
        ("import os; os.execlp('true', 'true')", "would end the process"),
        ("import os; os.execle('/bin/true', 'true', {})", r"os\.execve\('/bin/true'\) would end"),
        ("yield Found('refuted', {'worlds': 1})", "returns <generator object not_all>; legal are"),
        ("return None", "returns None; legal are a Found and a NotChecked"),
        ("return Found('maybe', {})", "verdict 'maybe' is not one of holds, refuted"),
    ],
)
def test_a_claim_that_gives_no_outcome_is_bad_input(paper, body, told):
    with pytest.raises(InputError, match=f"claim 'not-all'.* {told}|claim 'not-all': {told}"):
        allworlds.ledger(with_function(paper, "not_all", body))


@pytest.mark.parametrize(
    "outcomes",
    [
        'Found("holds", {"worlds": 1}), Found("refuted", {"worlds": 1})',
        'Found("refuted", {"worlds": 1}), Found("refuted", {"worlds": 2})',
        'Found("refuted", {"worlds": 1}), Found("refuted", {"worlds": 1}, {"more": 1})',
        'Found("refuted", {"worlds": 1}), NotChecked("no")',
        'Found("refuted", {"worlds": 1}), KeyError("no")',
    ],
)
def test_a_quick_claim_has_the_same_outcome_twice(paper, outcomes, monkeypatch):
    monkeypatch.setattr("allworlds.studies.ledger.QUICK", math.inf)
    with_function(paper, "not_all", "return next(OUTCOMES)")
    with (paper / "claims.py").open("a") as file:
        file.write(f"\nOUTCOMES = iter([{outcomes}])\n")
    told = "claim 'not-all' has two outcomes: .*; then "
    with pytest.raises(InputError, match=told):
        allworlds.ledger(paper)
    monkeypatch.setattr("allworlds.studies.ledger.QUICK", -1)
    assert entries(paper)["not-all"].verdict in ("holds", "refuted")


def test_a_file_of_claims_that_ends_the_process_is_bad_input(paper):
    with (paper / "claims.py").open("a") as file:
        file.write("\nfrom os import _exit\n_exit(0)\n")
    with pytest.raises(InputError, match=r"claims\.py' does not import: SystemExit: os\._exit"):
        allworlds.ledger(paper)


def test_what_a_claim_prints_stands_apart_from_the_document(paper):
    body = """import os, sys
    print("by Python")
    sys.__stdout__.write("beside it")
    os.system("echo by another program")
    return Found("refuted", {"worlds": 1})"""
    with_function(paper, "not_all", body)
    command = [sys.executable, "-m", "allworlds", "ledger", str(paper), "--json"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE, check=True)
    assert json.loads(done.stdout)["budget"] == "quick"
    for printed in ("by Python", "beside it", "by another program"):
        assert printed in done.stderr


@pytest.mark.parametrize("call", ["worst(edges=1)", "check(edges=1, engine='kernel')"])
def test_a_claim_whose_package_is_missing_was_not_checked(paper, call, monkeypatch):
    monkeypatch.setattr("allworlds.inputs.checks.find_spec", lambda _name: None)
    with_function(paper, "not_all", f"import allworlds; return allworlds.{call}")
    one = entries(paper)["not-all"]
    assert (one.standing, one.error) == ("not-checked", "")
    assert "needs numba: in a clone of allworlds, pip install '.[fast]'" in one.told


def test_a_witness_that_was_not_told_is_no_pass(paper):
    found = with_function(paper, "pairs", 'return Found("holds", {"pairs": 3})')
    one = entries(found)["pairs"]
    assert one.verdict == one.standing == "vacuous"


@pytest.mark.parametrize("fault", FAULTS)
def test_a_disagreement_within_the_program_refutes_whatever_is_expected(paper, fault):
    body = f"from {fault.__module__} import {fault.__name__} as Fault; raise Fault('3, and 4')"
    one = entries(with_function(paper, "not_all", body))["not-all"]
    assert (one.verdict, one.standing) == ("refuted", "unexpected")
    assert one.differences == ("the check failed, so the claim counts as refuted: 3, and 4",)


def test_an_error_keeps_its_traceback(paper):
    one = entries(with_function(paper, "not_all", 'raise KeyError("so it is")'))["not-all"]
    assert one.told.startswith("Traceback")
    assert "in not_all" in one.told


def test_what_was_not_checked_neither_passes_nor_fails_unless_it_is_required(paper):
    assert allworlds.ledger(paper, only=["proof"]).exit_code == Exit.VACUOUS
    report = allworlds.ledger(paper, only=["pairs"], require=["proof"])
    assert [one.id for one in report.claims] == ["pairs", "proof"]
    assert report.exit_code == Exit.INCONCLUSIVE
    assert allworlds.ledger(paper, require=["pairs"]).exit_code == Exit.HOLDS


def test_the_line_tells_what_those_need_that_were_not_checked(paper):
    claims = claims_in(paper / "ledger.toml")
    reasons = ("no Coq", "no Coq", "no time")
    some = [entry_with(c, "quick", NotChecked(r)) for c, r in zip(claims, reasons, strict=True)]
    told = brief(report_of(*some), 100)
    assert told.startswith("VACUOUS: 3 claims: 2 not checked (no Coq), 1 not checked (no time)")


def test_an_error_outweighs_an_interrupt_which_outweighs_a_difference(paper):
    (claim, *_) = claims_in(paper / "ledger.toml")
    wrong = entry_with(claim, "quick", Found("refuted", {"pairs": 3, "others": 1}))
    told = report_of(wrong)
    assert told.exit_code == Exit.REFUTED
    assert replace(told, ending=Interrupted()).exit_code == Exit.INTERRUPTED
    failed = entries(with_function(paper, "not_all", "raise KeyError(3)"))["not-all"]
    assert replace(report_of(wrong, failed), ending=Interrupted()).exit_code == Exit.INTERNAL


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ({"only": ["pair"]}, "only 'pair' is no claim; did you mean 'pairs'?"),
        ({"require": ["@"]}, "require '@' is no claim; the first of 3 are pairs, not-all, proof"),
        ({"budget": "large"}, "budget 'large' is not one of quick, full"),
        ({"workers": 0}, "workers 0 is not positive"),
    ],
)
def test_bad_input_is_refused(paper, options, told):
    with pytest.raises(InputError, match=told):
        allworlds.ledger(paper, **options)


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ('method = "algebra"', "", "claim pairs: .*missing required field method"),
        ('expected = "holds"', 'expected = "maybe"', "'maybe' is not one of holds, refuted"),
        ('source = "Section IV"', 'source = "-"\nfrom = "-"', "unknown field from"),
        ("{ worlds = 1 }", "{ worlds = 0 }", "claim not-all: .*expected int >= 1"),
        ("{ worlds = 1 }", "{}", "claim not-all: .*expected object of length >= 1"),
        ("{edges}", "{n}", "scope 'every pair up to {n}' does not fit the bounds edges of quick"),
        ("[proof]", "[2m]", "claim 2m: an id is a letter, and then letters, digits and '-'"),
        ("[proof]", "[more]", "has no 'more'"),
        ('[pairs]\nsection = "IV"', '[pairs\nsection = "IV"', "is not TOML"),
        ("[pairs]\n", "beside = 1\n[pairs]\n", "claim beside: 1 is no table"),
    ],
)
def test_a_ledger_that_cannot_be_meant_is_refused(paper, old, new, told):
    assert old in TOML
    (paper / "ledger.toml").write_text(TOML.replace(old, new), encoding="utf-8")
    with pytest.raises(InputError, match=told):
        allworlds.ledger(paper)


def test_the_files_must_be_there_and_import(paper):
    (paper / "claims.py").write_text("import nowhere", encoding="utf-8")
    with pytest.raises(InputError, match="does not import: ModuleNotFoundError"):
        allworlds.ledger(paper)
    (paper / "claims.py").unlink()
    with pytest.raises(InputError, match=r"there is no file .*claims\.py"):
        allworlds.ledger(paper)
    with pytest.raises(InputError, match=r"ledger\.toml' cannot be read"):
        allworlds.ledger(paper / "elsewhere")


def test_a_refuted_check_names_its_smallest_world():
    found = of_check(allworlds.check("algorithm1", edges=3, bound="1"))
    assert found.verdict == "refuted"
    assert "the law bound is broken in a world with 2 edges" in found.told
    assert len(found.pictures) == 1


# ---------------------------------------------------------------- what is told


def test_each_standing_has_its_sign_and_what_differs_is_told(paper):
    with_function(paper, "not_all", 'return Found("holds", {"worlds": 1})')
    report = allworlds.ledger(paper, require=["proof"])
    told = text(report, 100)
    signs = [line[0] for line in told.splitlines() if line[:1] in "=≠?-" and line[1:2] == " "]
    assert signs[:3] == ["=", "≠", "-"]
    assert "DIFFERS    not-all: verdict: expected refuted, found holds" in told
    assert "REQUIRED   proof must be checked, as --require says, but was not\n" in told
    assert brief(report, 100) == (
        "REFUTED: 3 claims: 1 holds, 1 not as expected, 1 not checked (Coq is not installed)"
    )


def test_one_claim_is_told_at_length_and_drawn(paper):
    told = text(allworlds.ledger(paper, only=["not-all"]), 100)
    assert "The one" in told
    assert "Beyond: not-all" in told
    assert "witnesses  worlds 1" in told
    told = text(allworlds.ledger(paper, only=["pairs"]), 100)
    assert "Section IV: pairs" in told
    assert "figures    best [1, 2], name x" in told


def test_the_cases_of_junit_are_the_claims(paper):
    suite = ET.fromstring(file_of("junit", allworlds.ledger(paper, require=["proof"])))
    assert [case.find("failure").get("type") for case in suite.iter("testcase") if len(case)] == [
        "required"
    ]
    free = ET.fromstring(file_of("junit", allworlds.ledger(paper)))
    assert len([*free.iter("skipped")]) == 1


def test_the_page_has_every_claim_and_draws_its_worlds(paper):
    report = allworlds.ledger(paper)
    page = file_of("html", report)
    assert page.count("<figure") == 1
    assert all(f'id="{one.id}"' in page for one in report.claims)


# ---------------------------------------------------------------- the first ledger


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ({"header": True, "ledger": True}, "not both: ledger given"),
        ({"directory": "x", "lang": "c", "ledger": True}, "lang 'c' has no effect beside ledger"),
    ],
)
def test_a_ledger_is_written_alone(options, told, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError, match=told):
        allworlds.init(**options)


def test_it_is_told_how_many_claims_there_are(paper):
    listener = Hears()
    allworlds.ledger(paper, only=["pairs"], listener=listener)
    assert listener.stages == [("claims", 1, "claims")]


def test_a_check_that_holds_has_its_events_and_figures():
    found = of_check(allworlds.check("algorithm1", edges=2), "loop-edge", "never", best=3)
    assert (found.verdict, found.figures) == ("holds", {"best": 3})
    assert found.witnesses.keys() == {"worlds", "runs", "loop-edge", "never"}
    assert (found.witnesses["worlds"], found.witnesses["never"]) == (12, 0)
    assert found.witnesses["loop-edge"] > 0


def test_a_check_that_is_not_finished_decides_nothing():
    report = replace(allworlds.check("algorithm1", edges=1), ending=Stopped("the time is up"))
    with pytest.raises(Unfinished, match=r"^the check of algorithm1 ended as inconclusive$"):
        of_check(report)
