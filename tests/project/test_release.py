"""What a release says of itself: version, date, changes, address, bounds; and its workflows."""

import json
import re
import tomllib
from importlib.resources import files
from itertools import chain
from pathlib import Path

import pytest
from jsonschema import Draft7Validator

import allworlds
from project.runner import read

ROOT = Path(__file__).parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
PLACEHOLDER = "OWNER/allworlds"
WORKFLOWS = sorted((ROOT / ".github" / "workflows").glob("*.yml"))
SCHEMAS = files("check_jsonschema") / "builtin_schemas" / "vendor"
BOUNDED: dict[str, str] = {}
"""Upper bounds on versions, each with the test that fails without it."""


def text(name):
    return (ROOT / name).read_text(encoding="utf-8")


def newest():
    """The version, the day, and the lines of the first release in the changelog."""
    _, release, *_ = re.split(r"^## ", text("CHANGELOG.md"), flags=re.MULTILINE)
    head, *lines = release.rstrip().splitlines()
    return (*re.fullmatch(r"\[(\S+)\] - (\d{4}-\d\d-\d\d)", head).groups(), lines)


def test_version_and_day_are_the_same_everywhere():
    version, day, _ = newest()
    assert version == allworlds.__version__
    cited = read(ROOT / "CITATION.cff")
    assert (cited["version"], str(cited["date-released"])) == (version, day)


def test_the_changes_are_short_and_begin_with_what_a_user_must_change():
    _, _, lines = newest()
    assert len(lines) + 1 <= 60
    assert next(line for line in lines if line.startswith("#")) == "### What you must change"


def test_an_upper_bound_has_a_test_that_fails_without_it():
    extras = chain.from_iterable(PROJECT["optional-dependencies"].values())
    every = [*PROJECT["dependencies"], *extras]
    bounded = {re.match(r"[\w-]+", each)[0] for each in every if re.search(r"<|==|~=", each)}
    assert bounded == {*BOUNDED}
    for name in BOUNDED.values():
        file, test = name.split(":")
        assert f"def {test}(" in text(file)
        assert test in text("pyproject.toml")


def test_every_python_that_is_promised_is_tried():
    promised = re.findall(r"Python :: (3\.\d+)", "\n".join(PROJECT["classifiers"]))
    (tried,) = re.findall(r"^PYTHONS = (\[.*\])$", text("noxfile.py"), re.MULTILINE)
    assert promised == json.loads(tried)
    assert (
        promised
        == read(ROOT / ".github/workflows/ci.yml")["jobs"]["wheel"]["strategy"]["matrix"]["python"]
    )


@pytest.mark.parametrize("path", WORKFLOWS, ids=lambda path: path.name)
def test_a_workflow_is_what_the_service_takes(path):
    schema = json.loads((SCHEMAS / "github-workflows.json").read_text(encoding="utf-8"))
    Draft7Validator(schema).validate(read(path))


def test_ci_runs_its_script_and_a_tag_publishes_without_a_password():
    steps = read(ROOT / ".github/workflows/ci.yml")["jobs"]["run"]["steps"]
    assert "bash .ci/run" in [step.get("run") for step in steps]
    publish = read(ROOT / ".github/workflows/publish.yml")
    job = publish["jobs"]["publish"]
    assert (job["needs"], job["permissions"]) == ("build", {"id-token": "write"})
    assert "secrets." not in text(".github/workflows/publish.yml")


def test_there_is_one_placeholder_for_the_address_and_it_is_named():
    assert f"`{PLACEHOLDER}`" in text("CONTRIBUTING.md")
    for name in ("pyproject.toml", "CITATION.cff", "action.yml", "mkdocs.yml", "README.md"):
        assert PLACEHOLDER in text(name)
    assert PLACEHOLDER in text(".github/workflows/publish.yml")
    for path in [ROOT / "README.md", *(ROOT / "docs").rglob("*.md"), *ROOT.glob("*.*")]:
        if path.is_file():
            others = re.findall(r"(?i)\bADDRESS\b(?=  #)|example\.com", path.read_text("utf-8"))
            assert others == [], path
