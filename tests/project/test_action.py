"""Action, workflows and hook, held to their schemas and executed without the service."""

import json
import re
import sys
from importlib.resources import files
from pathlib import Path

import pytest
from jsonschema import Draft7Validator

import allworlds
from allworlds.explorers.languages import LANGUAGES
from allworlds.outcome import Exit, Facts
from allworlds.studies.init import init
from project.runner import OURS, ROOT, job_in, read

SCHEMAS = files("check_jsonschema") / "builtin_schemas" / "vendor"
STAR = "breaks the law 'map' in a world with 1 edge and 1 vertex"


def validator(name):
    return Draft7Validator(json.loads((SCHEMAS / f"{name}.json").read_text(encoding="utf-8")))


@pytest.fixture
def programs(tmp_path):
    """``allworlds`` and ``python`` under test; what pip is asked for is noted and not done."""
    folder = tmp_path / "bin"
    folder.mkdir()
    source = Path(allworlds.__file__).parents[1]
    run = f'PYTHONPATH="{source}" exec "{sys.executable}"'
    python = f"""#!/bin/sh
if [ "$1 $2 $3" = "-m pip install" ]; then printf '%s\\n' "$*" >> "{tmp_path}/asked"; exit; fi
{run} "$@"
"""
    for name, text in (("python", python), ("allworlds", f'#!/bin/sh\n{run} -m allworlds "$@"\n')):
        (folder / name).write_text(text)
        (folder / name).chmod(0o755)
    return folder


@pytest.fixture
def job(tmp_path, programs):
    """A job in an empty folder."""
    (tmp_path / "work").mkdir()
    return job_in(tmp_path / "work", programs)


def workflow(folder):
    return read(folder / ".github" / "workflows" / "allworlds.yml")


def test_the_action_is_what_the_service_takes():
    validator("github-actions").validate(read(ROOT / "action.yml"))


@pytest.mark.parametrize("lang", LANGUAGES)
def test_a_workflow_is_what_the_service_takes(lang, tmp_path):
    init(tmp_path, lang=lang)
    described = workflow(tmp_path)
    # In YAML 1.2 'on' is a word, in 1.1 it is true; the service reads it as a word.
    validator("github-workflows").validate(described)
    (used,) = [step for step in steps(described) if step.get("uses") == OURS]
    assert set(used["with"]) <= set(read(ROOT / "action.yml")["inputs"])


def test_the_schemas_do_not_take_anything():
    action = read(ROOT / "action.yml")
    del action["runs"]["steps"][0]["shell"]
    assert not validator("github-actions").is_valid(action)
    assert not validator("github-workflows").is_valid({"on": "push", "jobs": {}})


def steps(described):
    (one,) = described["jobs"].values()
    return one["steps"]


def use(**given):
    return [{"uses": OURS, "with": given}]


def test_a_right_explorer_passes(job):
    job.run(use(explorer="algorithm1", edges="2", options="--class simple  --laws map,pose"))
    assert not job.failed
    assert job.outputs == {"verdict": "holds", "exit-code": "0"}
    assert "maps of the class" not in job.log
    assert "laws       map, pose" in job.log
    assert "::notice title=allworlds%3A HOLDS::algorithm1: " in job.log
    assert job.used == []


def test_without_edges_the_worlds_of_a_file_are_checked(job):
    (job.workspace / "plan.json").write_text('{"map": {"sigma": [1, 0], "alpha": [1, 0]}}')
    job.run(use(explorer="algorithm1", options="--worlds plan.json"))
    assert job.outputs == {"verdict": "holds", "exit-code": "0"}, job.log
    assert "map of plan.json" in job.log


@pytest.mark.parametrize(("given", "most"), [({}, 1), ({"edges": "2"}, 2)])
def test_the_bound_of_the_project_stands_unless_another_one_is_given(job, given, most):
    (job.workspace / "pyproject.toml").write_text("[tool.allworlds]\nedges = 1\n")
    job.run(use(explorer="algorithm1", **given))
    assert job.outputs["verdict"] == "holds"
    assert f"with at most {most} edge" in job.log
    assert f"with at most {3 - most} edge" not in job.log


def test_every_file_that_is_asked_for_is_written(job):
    job.run(use(explorer="algorithm1", edges="1", sarif="a b.sarif", junit="j.xml", html="h.html"))
    assert {file.name for file in job.workspace.iterdir()} == {"a b.sarif", "j.xml", "h.html"}


def test_what_is_given_is_no_code(job):
    job.run(use(explorer="algorithm1", edges="1; touch pwned", options="$(touch pwned) `touch p`"))
    assert job.failed
    assert job.outputs["verdict"] == "error"
    assert [*job.workspace.iterdir()] == []


@pytest.mark.parametrize("code", Exit)
def test_an_exit_code_is_told_with_its_verdict(job, programs, code):
    (programs / "allworlds").write_text(f"#!/bin/sh\nexit {code:d}\n")
    job.run(use(explorer="algorithm1"))
    assert job.failed == (code != Exit.HOLDS)
    holds, one = Facts(), ("refuted", "undecided", "vacuous", "disagrees")
    every = (holds, *(holds._replace(**{fact: True}) for fact in one))
    verdicts = {facts.exit: facts.verdict.value for facts in every}
    assert job.outputs == {"verdict": verdicts.get(code, "error"), "exit-code": f"{code:d}"}


def test_without_an_explorer_nothing_is_checked(job):
    job.run(use(edges="1"))
    assert job.failed
    assert "::error::allworlds: one of explorer, exec and native must be given" in job.log


def test_a_build_that_fails_ends_the_job(job):
    job.run(use(native="./explorer.so", build="false | true; touch built"))
    assert job.failed
    assert [*job.workspace.iterdir()] == []
    assert job.outputs == {}


def shown(language):
    """The blocks in a language of the page about CI."""
    page = (ROOT / "docs" / "how-to" / "ci.md").read_text(encoding="utf-8")
    return re.findall(rf"^```{language}\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)


def test_the_workflow_to_be_copied_is_that_of_the_skeleton(tmp_path):
    init(tmp_path)
    written = (tmp_path / ".github" / "workflows" / "allworlds.yml").read_text(encoding="utf-8")
    assert written in shown("yaml")


def test_the_page_tells_every_input_of_the_action():
    page = (ROOT / "docs" / "how-to" / "ci.md").read_text(encoding="utf-8")
    for name in read(ROOT / "action.yml")["inputs"]:
        assert f"`{name}`" in page


# ---------------------------------------------------------------- pre-commit


def test_the_hook_has_what_pre_commit_asks_for():
    (hook,) = read(ROOT / ".pre-commit-hooks.yaml")
    assert {"id", "name", "entry", "language"} <= set(hook)
    known = {"id", "name", "description", "entry", "language", "pass_filenames", "require_serial"}
    assert set(hook) <= known
    assert hook["language"] == "python", "pre-commit installs the project with pip"
    assert hook["pass_filenames"] is False
