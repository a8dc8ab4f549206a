"""SARIF, held to the schema of the standard (tests/data, of OASIS) and to what the schema leaves
out: that all that is named exists, and that the walk goes along edges of the graph."""

import copy
import json
import os
import re
from pathlib import Path
from urllib.parse import unquote

import pytest
from jsonschema import Draft7Validator

from allworlds.documents.document import replace
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


def broken_rules(run, root):
    """What code scanning refuses or does not show: its rules, as its public pages tell them."""
    rules = run["tool"]["driver"]["rules"]
    for rule in rules:
        for name in ("shortDescription", "fullDescription", "help"):
            if not 0 < len(rule.get(name, {}).get("text", "")) <= 1024:
                yield f"{name} of {rule['id']}"
    if not run["results"]:
        yield "no result"
    for result in run["results"]:
        if result["ruleId"] not in {rule["id"] for rule in rules}:
            yield "a result of no rule"
        if not result["message"]["text"] or not result["partialFingerprints"]:
            yield "a result without a message or a fingerprint"
        if not 1 <= len(result.get("locations", ())) <= 10:
            yield "a result refuses the whole file: it has no location"
            continue
        place = result["locations"][0]["physicalLocation"]
        uri = place["artifactLocation"]["uri"]
        file = root / unquote(uri)
        if re.match("[a-z]+:|/", uri) or ".." in uri or not file.is_file():
            yield f"{uri} is no file of the repository"
        elif file.is_symlink() or place["region"]["startLine"] > len(file.read_text().split("\n")):
            yield f"{uri} cannot be shown"
        if not {"startLine", "startColumn", "endLine", "endColumn"} <= {*place["region"]}:
            yield "a region is not whole"


WORKFLOW = "on: push\njobs:\n  one:\n    steps:\n      - run: allworlds check x\n"

KINDS = {
    "file": ("mine.py:explore", "sub/mine.py"),
    "file elsewhere": ("../up.py:explore", "up.py"),
    "module": ("alone_here:explore", "sub/alone_here.py"),
    "shield": ("shield:mine.py:explore", "sub/mine.py"),
    "script": ("exec:node 'a b.js'", "sub/a b.js"),
    "command on the PATH": ("exec:true", ".github/workflows/ci.yml"),
    "command of the repository on the PATH": ("exec:runner --fast", "bin/runner"),
    "python -m": ("exec:python3 -m package", "sub/package/__main__.py"),
    "python -m of a file": ("exec:python3 -u -m package.inner", "sub/package/inner.py"),
    "python -m of Python": ("exec:python3 -m this", ".github/workflows/ci.yml"),
    "built in": ("algorithm1", ".github/workflows/ci.yml"),
    "of this process": ("__main__:explore", ".github/workflows/ci.yml"),
    "library": ("native:./explorer.so", "sub/explorer.rs"),
    "library of a lib": ("native:build/libother.so", "sub/build/other.c"),
    "library without a source": ("native:build/lost.so", ".github/workflows/ci.yml"),
    "installed": ("env/site-packages/other.py:explore", ".github/workflows/ci.yml"),
}
"""Explorers of each kind, and the file at which a finding stands."""


@pytest.fixture(scope="module")
def report():
    return check(f"{EXPLORERS}:first_edge", edges=2, max_findings=2)


@pytest.fixture
def repository(report, tmp_path, monkeypatch):
    """The report of an explorer, and its repository, in a folder of which it is checked."""
    python = ("mine.py", "alone_here.py", "env/site-packages/other.py", "../up.py")
    texts = {
        **{f"sub/{name}": "\n\ndef explore(first):\n    yield\n" for name in python},
        "sub/a b.js": "",
        "sub/package/__main__.py": "",
        "sub/package/inner.py": "",
        "bin/runner": "#!/bin/sh\n",
        "sub/explorer.rs": "",
        "sub/explorer.h": "",
        "sub/build/other.c": "",
        **dict.fromkeys(("sub/explorer.so", "sub/build/libother.so", "sub/build/lost.so"), "\0"),
        ".github/workflows/ci.yml": WORKFLOW,
        ".github/workflows/a.yml": "on: push\n",
        "README.md": "",
        ".git/HEAD": "",
    }
    for name, text in texts.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    (tmp_path / "bin" / "runner").chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path / 'bin'}{os.pathsep}{os.environ['PATH']}")
    monkeypatch.chdir(tmp_path / "sub")
    return replace(report, explorer="mine.py:explore")


@pytest.mark.parametrize("kind", KINDS)
def test_code_scanning_takes_the_findings_of_each_kind_of_explorer(kind, repository, tmp_path):
    name, file = KINDS[kind]
    run = run_of(replace(repository, explorer=name))
    assert [*broken_rules(run, tmp_path)] == []
    (place,) = {json.dumps(each["locations"]) for each in run["results"]}
    where = json.loads(place)[0]["physicalLocation"]
    assert unquote(where["artifactLocation"]["uri"]) == file
    if file.endswith(".py") and "package" not in file:
        assert where["region"]["startLine"] == 3
    if file.endswith("ci.yml"):
        assert where["region"]["startLine"] == 5
        for result in run["results"]:
            assert "no file of this repository" in result["message"]["text"].partition("\n")[0]


def test_the_root_is_that_of_git_or_else_of_the_service(repository, tmp_path, monkeypatch):
    def root():
        return run_of(repository)["originalUriBaseIds"]["SRCROOT"]["uri"]

    monkeypatch.setenv("GITHUB_WORKSPACE", str(tmp_path / "bin"))
    assert root() == tmp_path.as_uri() + "/"
    (tmp_path / ".git" / "HEAD").unlink()
    (tmp_path / ".git").rmdir()
    assert root().endswith("/bin/")
    (tmp_path / ".git").write_text("gitdir: elsewhere")  # of a worktree
    assert root() == tmp_path.as_uri() + "/"
    monkeypatch.chdir("/")
    at_the_file = replace(repository, explorer=f"{tmp_path}/up.py:explore")
    assert [*broken_rules(run_of(at_the_file), tmp_path)] == []


def test_the_workflow_that_runs_comes_first_and_options_before_any_file(
    repository, tmp_path, monkeypatch
):
    def place():
        (one, *_) = run_of(replace(repository, explorer="algorithm1"))["results"]
        return one["locations"][0]["physicalLocation"]["artifactLocation"].get("uri")

    flows = tmp_path / ".github" / "workflows"
    (flows / "z.yml").write_text(WORKFLOW)
    monkeypatch.setenv("GITHUB_WORKFLOW_REF", "me/mine/.github/workflows/z.yml@refs/heads/main")
    assert place() == ".github/workflows/z.yml"
    for file in flows.iterdir():
        file.unlink()
    (tmp_path / "A").mkdir()
    assert place() == "README.md"
    (tmp_path / "pyproject.toml").write_text("[project]\nname = 'x'\n\n[tool.allworlds]\n")
    assert place() == "pyproject.toml"


def test_where_there_is_no_file_at_all_the_location_says_so(refuted, tmp_path, monkeypatch):
    monkeypatch.setenv("GITHUB_WORKSPACE", str(tmp_path / "empty"))
    (tmp_path / "empty").mkdir()
    (result, *_) = run_of(refuted)["results"]
    place = result["locations"][0]["physicalLocation"]
    assert place["artifactLocation"] == {"uri": "no%20file%20associated%20with%20this%20alert"}
    assert place["region"] == {"startLine": 1, "startColumn": 1, "endLine": 1, "endColumn": 2}


def test_the_rules_of_code_scanning_do_not_take_anything(repository, tmp_path):
    good = run_of(repository)
    assert [*broken_rules(good, tmp_path)] == []
    for spoil in (
        lambda run: run["results"][0].pop("locations"),
        lambda run: run["tool"]["driver"]["rules"][3].pop("help"),
        lambda run: run["tool"]["driver"]["rules"].clear(),
        lambda run: artifact(run).update(uri="file:///x/mine.py"),
        lambda run: artifact(run).update(uri="sub/lost.py"),
    ):
        spoilt = copy.deepcopy(good)
        spoil(spoilt)
        assert [*broken_rules(spoilt, tmp_path)]


def artifact(run):
    return run["results"][0]["locations"][0]["physicalLocation"]["artifactLocation"]


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
