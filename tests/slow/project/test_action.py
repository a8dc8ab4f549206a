"""Action, workflows and hook, held to their schemas and executed without the service."""

import re
import shutil
import subprocess

import pytest
from ruamel.yaml import YAML

from allworlds.explorers.languages import LANGUAGES
from allworlds.studies.init import init
from project import test_action as quick
from project.runner import ROOT, read
from project.test_action import STAR, shown, steps, workflow
from small import slowest

job = quick.job
programs = quick.programs


@pytest.mark.slowest
@pytest.mark.parametrize(
    "lang", ["python", *(slowest(lang) for lang in LANGUAGES if lang != "python")]
)
def test_the_job_of_a_skeleton_fails_and_shows_the_picture(lang, job, tmp_path):
    for program in LANGUAGES[lang].needs:
        if shutil.which(program) is None:
            pytest.skip(f"there is no {program}")
    init(job.workspace, lang=lang)
    job.run(steps(workflow(job.workspace)))
    assert job.failed
    assert job.outputs == {"verdict": "refuted", "exit-code": "1"}
    assert (tmp_path / "asked").read_text().splitlines()[0] == f"-m pip install --quiet {ROOT}"
    assert STAR in job.summary
    assert " ╭─╮\n(0 1)\n" in job.summary
    source = (job.workspace / LANGUAGES[lang].explorer).read_text().splitlines()
    first = (i for i, text in enumerate(source, 1) if "there = yield Move(turn)" in text)
    line = next(first) if lang == "python" else 1  # of the first wrong step, if that is known
    place = f"file={LANGUAGES[lang].explorer},line={line}"
    assert re.search(rf"^::error {re.escape(place)},title=.*breaks the law", job.log, re.MULTILINE)
    uploads = [step for step in job.used if step["uses"].startswith("actions/upload-artifact")]
    (kept,) = uploads
    page = (job.workspace / kept["with"]["path"]).read_text(encoding="utf-8")
    assert page.startswith("<!DOCTYPE html>")
    if lang == "python":
        assert "FAILED test_explorer.py::test_explorer_is_right_in_every_world[edges-1]" in job.log


def test_the_hook_runs_its_entry_with_the_arguments_that_the_page_gives(job):
    init(job.workspace)
    (hook,) = read(ROOT / ".pre-commit-hooks.yaml")
    (text,) = [text for text in shown("yaml") if text.startswith("repos:")]
    (repo,) = YAML(typ="safe", pure=True).load(text)["repos"]
    (wanted,) = repo["hooks"]
    assert wanted["id"] == hook["id"]
    assert re.search(wanted["files"], "explorer.py")
    done = subprocess.run(
        [*hook["entry"].split(), *wanted["args"]],
        cwd=job.workspace,
        env={**job.environment, "GITHUB_ACTIONS": "", "GITHUB_STEP_SUMMARY": ""},
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    assert done.returncode == 1
    assert STAR in done.stdout
