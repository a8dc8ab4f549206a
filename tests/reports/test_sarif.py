"""SARIF, held to the schema of the standard (tests/data, of OASIS) and to what the schema leaves
out: that all that is named exists, and that the walk goes along edges of the graph."""

import copy
import json
from pathlib import Path

import pytest
from jsonschema import Draft7Validator

from allworlds.document import replace
from allworlds.judging.laws.law_table import ASKED, PRECEDENCE
from allworlds.outcome import Completed, Disagreed, Interrupted, Stopped
from allworlds.reports.formats import file_of
from allworlds.reports.plain_text import finding_in_words as finding_text
from allworlds.studies.check.exhaustive import check

pytestmark = pytest.mark.usefixtures("without_workers")

SCHEMA = Path(__file__).parents[1] / "support" / "data" / "sarif-schema-2.1.0.json"
EXPLORERS = Path(__file__).parents[1] / "recorded" / "explorers.py"
VALIDATOR = Draft7Validator(
    json.loads(SCHEMA.read_text(encoding="utf-8")), format_checker=Draft7Validator.FORMAT_CHECKER
)


def sarif(report):
    return file_of("sarif", report)


def run_of(report):
    document = json.loads(sarif(report))
    VALIDATOR.validate(document)
    (run,) = document["runs"]
    return run


def test_a_refuted_check_has_a_result_for_each_finding_at_its_explorer(refuted, line):
    run = run_of(refuted)
    assert len(run["results"]) == len(refuted.findings) == 2
    rules = run["tool"]["driver"]["rules"]
    for i, (result, finding) in enumerate(zip(run["results"], refuted.findings, strict=True), 1):
        assert result["ruleId"] == finding.law
        assert finding.law in {rule["id"] for rule in rules}
        assert finding_text(finding, 100, i) in result["message"]["text"]
        assert finding_text(finding, 100, i) in result["message"]["markdown"]
        (location,) = result["locations"]
        place = location["physicalLocation"]
        assert place["region"]["startLine"] >= line  # of its first wrong step
        assert place["artifactLocation"] == {"uri": "mine.py", "uriBaseId": "SRCROOT"}
    assert run["originalUriBaseIds"]["SRCROOT"]["uri"] == Path.cwd().as_uri() + "/"
    assert len({result["partialFingerprints"]["finding/v1"] for result in run["results"]}) == 2
    assert run["invocations"][0]["exitCode"] == 1
    assert run["invocations"][0]["executionSuccessful"] is True


def test_every_law_is_a_rule_in_the_order_of_precedence():
    assert tuple(ASKED) == PRECEDENCE
    rules = run_of(check(edges=1))["tool"]["driver"]["rules"]
    assert [rule["id"] for rule in rules] == [*PRECEDENCE]


@pytest.mark.parametrize(
    ("explorer", "law"),
    [
        ("crashes", "crash"),
        ("says_nonsense", "illegal-action"),
        ("walks_for_ever", "budget"),
        ("first_edge", "map"),
    ],
)
def test_whatever_an_explorer_breaks_is_written_as_the_schema_says(explorer, law):
    (result,) = run_of(check(f"{EXPLORERS}:{explorer}", edges=2))["results"]
    assert result["ruleId"] == law


def test_no_text_of_an_explorer_leaves_its_fence():
    def explore(_):
        raise ValueError("\n```\n# big\n")
        yield

    (result,) = run_of(check(explore, edges=1))["results"]
    fence, *_, last = result["message"]["markdown"].partition("\n\n")[2].splitlines()
    assert (fence, last) == ("````text", "````")


@pytest.mark.parametrize(
    ("ending", "level", "successful"),
    [
        (Completed(), None, True),
        (Completed(("never",)), "error", True),
        (Stopped("the time limit was reached"), "warning", True),
        (Interrupted(), "warning", False),
        (Disagreed("two engines"), "error", False),
    ],
    ids=["holds", "vacuous", "stopped", "interrupted", "error"],
)
def test_a_verdict_without_a_finding_is_a_notification_unless_it_is_good(ending, level, successful):
    run = run_of(replace(check(edges=1), ending=ending))
    (invocation,) = run["invocations"]
    told = [said["level"] for said in invocation["toolExecutionNotifications"]]
    assert told == ([level] if level else [])
    assert invocation["executionSuccessful"] is successful
    assert run["results"] == []


def test_the_schema_is_not_one_that_takes_anything(refuted):
    document = json.loads(sarif(refuted))
    for spoil in (
        lambda run: run["results"][0].pop("message"),
        lambda run: run["results"][0].update(level="loud"),
        lambda run: run["tool"]["driver"].pop("name"),
        lambda run: run["results"][0]["locations"][0].update(line=3),
    ):
        spoilt = copy.deepcopy(document)
        spoil(spoilt["runs"][0])
        assert not VALIDATOR.is_valid(spoilt)


def test_an_explorer_outside_the_project_is_named_by_its_whole_path(refuted, monkeypatch, tmp_path):
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    monkeypatch.setenv("GITHUB_WORKSPACE", str(elsewhere))
    run = run_of(refuted)
    assert run["originalUriBaseIds"]["SRCROOT"]["uri"].endswith("/elsewhere/")
    place = run["results"][0]["locations"][0]["physicalLocation"]
    assert place["artifactLocation"] == {"uri": (tmp_path / "mine.py").resolve().as_uri()}
