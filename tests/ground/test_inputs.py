"""Whatever is given, the answer keeps the law of inputs; and a fault that breaks it is found.

Two thousand cases are drawn from a seed: the same every time, on every machine.  Each is named
``SEED/NUMBER`` and drawn from its name alone.  ``INPUTS_SEED=7 pytest tests/ground -m ''``
draws others.
"""

import json
import os
from contextlib import nullcontext
from types import SimpleNamespace

import pytest

from allworlds.cli.app import call
from allworlds.inputs.checks import InputError, at_most, did_you_mean, show
from allworlds.studies.check.exhaustive import check
from ground.cases import KINDS, cases
from ground.law import LONGEST, Case, Said, said, tried, written, wrong

SEED = int(os.environ.get("INPUTS_SEED", "12"))
QUICK, ALL, PART = 300, 2000, 500

pytestmark = pytest.mark.usefixtures("without_workers")


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """An empty working directory."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_the_cases_are_of_every_kind_and_the_same_every_time():
    drawn = list(cases(SEED, range(QUICK)))
    assert {case.kind for _, case in drawn} == set(KINDS)
    assert drawn == list(cases(SEED, range(QUICK)))
    assert len({str(case) for _, case in drawn}) > QUICK * 0.9


@pytest.mark.parametrize(
    "kind", ["worlds", "findings", "expressions", "lines", "corpus", "options"]
)
def test_some_cases_are_answered_and_not_only_refused(kind, folder):
    """A fuzzer whose inputs are all refused at the door tries the door alone."""
    codes = {_said(case, folder).code for _, case in cases(SEED, range(QUICK)) if case.kind == kind}
    assert codes - {2}
    assert kind == "lines" or 2 in codes


def _said(case, folder):
    with written(case.files, folder):
        return said(case)


def _index_error(*_, **__):
    raise IndexError("tuple index out of range")


# A fault in the program, and the kind of input that must find it.
FAULTS = {
    "a loader that raises what nobody expects": (
        ("allworlds.world.world.lighthouse_from_json", _index_error),
        "worlds",
    ),
    "a start that is looked at after the lighthouse": (
        ("allworlds.world.world.a_start", lambda given, _map: given),
        "worlds",
    ),
    "findings that may be nested as deeply as they like": (
        ("allworlds.studies.findings.parse_json", json.loads),
        "findings",
    ),
    "a corpus of files that are texts": (
        ("allworlds.studies.check.tally_sweep.Finding.from_json", json.loads),
        "corpus",
    ),
    "lines as long as what is in them": (("allworlds.cli.output.LONGEST", 10**9), "options"),
    "what Python thinks of a bound": (
        (
            "allworlds.judging.laws.bounds.warnings",
            SimpleNamespace(catch_warnings=nullcontext, simplefilter=lambda _: None),
        ),
        "expressions",
    ),
    "control characters that come through": (
        ("allworlds.words.escaped", lambda text: text),
        "lines",
    ),
    "an exit code that stands nowhere": (
        ("allworlds.cli.app._refuse", lambda *_: 75),
        "findings",
    ),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_a_planted_fault_is_found(fault, folder, monkeypatch):
    (place, value), kind = FAULTS[fault]
    monkeypatch.setattr(place, value)
    assert any(tried(case, folder) for _, case in cases(SEED, range(ALL)) if case.kind == kind)


GOOD = '{"schema": 2, "made_by": {}}\n'


@pytest.mark.parametrize(
    ("arguments", "told", "broken"),
    [
        (("count", "--json"), Said(0, GOOD, ""), []),
        (("count",), Said(2, "", "allworlds: no\n"), []),
        (("count",), Said(4, "nothing", "allworlds: a notice\n"), []),
        (("replay", "f"), Said(5, "fixed", ""), []),
        (("count",), Said(5, "fixed", ""), ["the exit code 5"]),
        (("check",), Said(70, "a report", ""), ["the exit code 70"]),
        (("check",), Said(130, "a report", ""), ["the exit code 130"]),
        (("count",), Said(2, "", ""), ["no line on stderr, or several"]),
        (
            ("count",),
            Said(2, "", "allworlds: a\nallworlds: b\n"),
            ["no line on stderr, or several"],
        ),
        (("count",), Said(2, "a report", "allworlds: no\n"), ["a refusal with a report"]),
        (("count",), Said(2, "", f"allworlds: {'x' * LONGEST}\n"), ["a line that is too long"]),
        (("count",), Said(2, "", "Warning: no\n"), ["a line on stderr that is not ours"]),
        (("count",), Said(0, "", ""), ["no report"]),
        (("count",), Said(0, "\x1b[31m", ""), ["a control character"]),
        (("count", "--json"), Said(0, "a report", ""), ["a document that is no JSON"]),
        (("count", "--json"), Said(0, "[1]", ""), ["a document that is none of ours"]),
        (("count", "--json"), Said(0, '{"schema": 1}', ""), ["a document that is none of ours"]),
    ],
)
def test_the_law_finds_what_breaks_it(arguments, told, broken):
    assert wrong(arguments, told) == broken


def test_a_traceback_is_found(monkeypatch):
    monkeypatch.setattr("allworlds.cli.output.answered", _index_error)
    case = Case("options", ("count", "--edges", "1"))
    assert wrong(case.arguments, said(case, call))[:2] == ["a traceback", "the exit code 70"]


def test_a_name_that_is_nearly_one_is_told():
    assert did_you_mean("algorthm1", ["folding", "algorithm1"]) == "; did you mean 'algorithm1'?"
    assert did_you_mean("sun", ["folding", "algorithm1"]) == ""
    with pytest.raises(InputError, match="did you mean 'algorithm1'"):
        check("algorthm1", edges=1)


@pytest.mark.parametrize(("letters", "whole"), [(198, True), (199, False)])
def test_of_a_value_two_hundred_characters_are_shown(letters, whole):
    shown = show("x" * letters)
    assert len(shown) == 200
    assert shown == (f"'{'x' * 198}'" if whole else f"'{'x' * 196}...")


def test_what_is_too_big_is_refused_with_the_largest_value():
    at_most("edges", 1000, 1000)
    with pytest.raises(InputError, match=r"^edges = 1001 is too big; at most 1,000 is legal$"):
        at_most("edges", 1001, 1000)
